#pragma once

#include <limits>
#include <string>

namespace corpuscle {

/// The numbers a parameter may have, in its SI unit.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_itself = true;   ///< is `low` allowed?
    bool high_itself = true;  ///< is `high` allowed?

    [[nodiscard]] bool holds(double value) const;
    [[nodiscard]] bool unlimited() const;
    [[nodiscard]] std::string text() const;  ///< "> 0", "0 to 1", "" if unlimited
};

[[nodiscard]] Range any_number();
[[nodiscard]] Range above(double low);
[[nodiscard]] Range at_least(double low);
[[nodiscard]] Range from_to(double low, double high);  ///< ends allowed
[[nodiscard]] Range between(double low, double high);  ///< ends refused

}  // namespace corpuscle
