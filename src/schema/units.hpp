#pragma once

#include <string>

namespace corpuscle {

/// "15 kg" in the unit asked for ("g" -> 15000). Errors: InputError (without place) that says whether the number, the unit's
/// name or its dimension is wrong, and what would be right. Units are those of UDUNITS-2: prefixes, products, powers ("kg/m3").
[[nodiscard]] double convert(const std::string& text, const std::string& unit);

/// "mass", "length", ... of a unit; "quantity in <unit>" for those without a name of their own, "pure number" for "1" or "".
[[nodiscard]] std::string dimension_name(const std::string& unit);

/// Units people write for the same dimension: "kg, g, t, lb"; the unit itself where no list is known.
[[nodiscard]] std::string usual_units(const std::string& unit);

/// The number with its unit as a case would have it, shortest text that reads back to the same bits: "0.7 m".
[[nodiscard]] std::string with_unit(double value, const std::string& unit);

}  // namespace corpuscle
