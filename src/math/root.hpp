#pragma once

#include <cmath>
#include <limits>

namespace corpuscle {

/// Root of a continuous function between two points where its signs differ, to the last bits of a double.
/// Chandrupatla's method (Adv. Eng. Software 28 (1997) 145): inverse quadratic interpolation where it is safe, else bisection.
/// Returns NaN if the signs agree.
template <class Function>
double find_root(const Function& function, double low, double high)
{
    double a = high, b = low, c = high;
    double fa = function(a), fb = function(b), fc = fa;
    if (fa == 0) return a;
    if (fb == 0) return b;
    if (!(std::signbit(fa) != std::signbit(fb))) return std::numeric_limits<double>::quiet_NaN();
    double share = 0.5;
    for (int iteration = 0; iteration < 200; ++iteration) {
        const double x = a + share * (b - a);
        const double fx = function(x);
        if (std::signbit(fx) == std::signbit(fa)) {
            c = a, fc = fa;
        } else {
            c = b, fc = fb;
            b = a, fb = fa;
        }
        a = x, fa = fx;
        const double best = std::abs(fa) < std::abs(fb) ? a : b;
        const double tolerance = std::numeric_limits<double>::epsilon() * std::abs(best) + std::numeric_limits<double>::min();
        const double limit = tolerance / std::abs(b - a);
        if (limit > 0.5 || fa == 0) return best;
        const double xi = (a - b) / (c - b), phi = (fa - fb) / (fc - fb);
        const bool safe = phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi;
        share = safe ? fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb) : 0.5;
        share = std::fmin(std::fmax(share, limit), 1 - limit);
    }
    return a;
}

}  // namespace corpuscle
