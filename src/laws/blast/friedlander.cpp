#include "laws/blast/friedlander.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "math/root.hpp"

namespace corpuscle {

namespace {

/// Decay at which a pulse starts with slope zero: below it the pressure would rise first.
constexpr double fullest = -1;

/// (1 - exp(-y))/y, the mean of exp(-y s) over s in [0, 1].
double mean_decay(double y)
{
    return y == 0 ? 1.0 : -std::expm1(-y) / y;
}

/// (1 - (1 + y) exp(-y))/y^2, the integral of s exp(-y s) over s in [0, 1]; by its series near zero.
double first_moment(double y)
{
    if (std::abs(y) > 1) return (1 - (1 + y) * std::exp(-y)) / (y * y);
    double term = 1, total = 0;
    for (int n = 0; n < 22; ++n) {
        total += term / (n + 2);
        term *= -y / (n + 1);
    }
    return total;
}

/// Integral of (1 - s) exp(-decay s) over s in [0, x].
double share_until(double x, double decay)
{
    return x * mean_decay(decay * x) - x * x * first_moment(decay * x);
}

}  // namespace

double Friedlander::pressure(double time) const
{
    const double x = time / duration;
    return x >= 0 && x <= 1 ? peak * (1 - x) * std::exp(-decay * x) : 0.0;
}

double Friedlander::impulse(double time) const
{
    return peak * duration * share_until(std::clamp(time / duration, 0.0, 1.0), decay);
}

Friedlander fit_friedlander(double peak, double duration, double impulse)
{
    if (!(peak > 0 && duration > 0 && impulse > 0)) {
        throw InputError(
            fmt::format("blast pulse: peak {:g} Pa, duration {:g} s and impulse {:g} Pa s must all be positive", peak, duration, impulse),
            "give a pulse that pushes");
    }
    const double share = impulse / (peak * duration);
    if (share > share_until(1, fullest)) {
        throw InputError(
            fmt::format("blast pulse: impulse {:g} Pa s is too large for a peak of {:g} Pa over {:g} s", impulse, peak, duration),
            "give a longer duration or a higher peak");
    }
    const double decay = find_root([&](double d) { return share_until(1, d) - share; }, fullest, 1 / share);
    return {peak, duration, decay};
}

}  // namespace corpuscle
