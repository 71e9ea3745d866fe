#include "math/student.hpp"

#include <cmath>
#include <numbers>

#include "math/root.hpp"

namespace corpuscle {

namespace {

/// The same probability by the angle of tan(angle) = t/sqrt(degrees).
double within_angle(double angle, int degrees)
{
    const bool odd = degrees % 2 == 1;
    const double cosine = std::cos(angle), squared = cosine * cosine;
    double term = odd ? cosine : 1, series = 0;
    for (int k = odd ? 1 : 0; k <= degrees - 2; k += 2) {
        series += term;
        term *= squared * (k + 1) / (k + 2);
    }
    if (!odd) return std::sin(angle) * series;
    return 2 / std::numbers::pi * (angle + std::sin(angle) * series);
}

}  // namespace

double student_within(double t, int degrees)
{
    return std::copysign(within_angle(std::atan(std::abs(t) / std::sqrt(degrees)), degrees), t);
}

double student_limit(double confidence, int degrees)
{
    const double angle = find_root([&](double a) { return within_angle(a, degrees) - confidence; }, 0.0, 0.5 * std::numbers::pi);
    return std::sqrt(degrees) * std::tan(angle);
}

}  // namespace corpuscle
