#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace corpuscle {

/// Text as it may stand in HTML, also within an attribute's quotes.
[[nodiscard]] std::string escaped(std::string_view text);

/// "displacement_z" -> "displacement z".
[[nodiscard]] std::string spaced(std::string name);

/// "displacement" -> "Displacement".
[[nodiscard]] std::string capitalized(std::string name);

/// A whole number in groups of three: 1,234,567.
[[nodiscard]] std::string grouped(std::uint64_t number);

/// A number of `digits` significant digits without needless zeros; "-" if it is not a number.
[[nodiscard]] std::string rounded(double value, int digits = 4);

/// A fraction as a percentage ("0.32 %"), or in powers of ten where it is tiny ("4.1e-13").
[[nodiscard]] std::string percentage(double fraction);

}  // namespace corpuscle
