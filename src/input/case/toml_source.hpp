#pragma once

#include <string>
#include <vector>

#include "schema/value.hpp"

namespace corpuscle {

/// A TOML document as a value, each key and value with its place in `file`. Errors: InputError at the place where it is no TOML.
[[nodiscard]] Value parse_toml(const std::string& text, const std::string& file);

/// Reads and parses a file. Errors: InputError if it cannot be read or is no TOML.
[[nodiscard]] Value read_toml(const std::string& file);

/// Applies "charge.0.mass=20 kg" (the right side as TOML, or as a text without its quotes) to a document. Tables on the way are
/// made; a list's next index adds an entry. The value's place is "--set charge.0.mass". Errors: InputError.
void apply_setting(Value& document, const std::string& setting);

}  // namespace corpuscle
