#include "schema/range.hpp"

#include <cmath>

#include <fmt/format.h>

namespace corpuscle {

bool Range::holds(double value) const
{
    const bool high_enough = low_itself ? value >= low : value > low;
    const bool low_enough = high_itself ? value <= high : value < high;
    return std::isfinite(value) && high_enough && low_enough;
}

bool Range::unlimited() const
{
    return std::isinf(low) && std::isinf(high);
}

std::string Range::text() const
{
    if (unlimited()) return "";
    if (std::isinf(high)) return fmt::format("{} {}", low_itself ? ">=" : ">", low);
    if (std::isinf(low)) return fmt::format("{} {}", high_itself ? "<=" : "<", high);
    if (low_itself && high_itself) return fmt::format("{} to {}", low, high);
    return fmt::format("{} {} and {} {}", low_itself ? ">=" : ">", low, high_itself ? "<=" : "<", high);
}

Range any_number()
{
    return {};
}

Range above(double low)
{
    Range range;
    range.low = low;
    range.low_itself = false;
    return range;
}

Range at_least(double low)
{
    Range range;
    range.low = low;
    return range;
}

Range from_to(double low, double high)
{
    return {low, high, true, true};
}

Range between(double low, double high)
{
    return {low, high, false, false};
}

}  // namespace corpuscle
