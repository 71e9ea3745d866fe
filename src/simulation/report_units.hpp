#pragma once

#include <string>

namespace corpuscle {

/// How values of an SI unit are shown: divided by `factor`, with `unit` behind.
struct ShownUnit {
    double factor = 1;
    std::string unit;  ///< "mm", "kPa s", "" for a pure number
};

/// The prefix that brings `size` (the greatest absolute value, SI) between 1 and 1000. Only units that begin with a bare m, s, Pa, J, N or
/// W take one; others are shown as they are.
[[nodiscard]] ShownUnit shown_unit(const std::string& unit, double size);

/// A value with its unit and 4 significant digits: (0.0431, "m") -> "43.1 mm"; "-" if it is not a number.
[[nodiscard]] std::string shown_value(double value, const std::string& unit);

}  // namespace corpuscle
