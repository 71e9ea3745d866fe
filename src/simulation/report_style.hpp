#pragma once

#include <string_view>

namespace corpuscle {

/// The report's style sheet: light and dark by the reader's choice, narrow and wide screens, paper.
[[nodiscard]] std::string_view report_style();

/// The report's script: a read-out under the pointer on every chart. Without it the report loses nothing else.
[[nodiscard]] std::string_view report_script();

}  // namespace corpuscle
