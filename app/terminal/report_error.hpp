#pragma once

#include <string>

#include "base/error.hpp"

namespace corpuscle {

/// Tells errors on standard error, each with the line of the file it is about and a mark under the place; flushed.
void report_error(const Error& error);

/// The line of a file with a caret under the column, ready to print; empty if the place has none.
[[nodiscard]] std::string quoted_source(const Place& place);

}  // namespace corpuscle
