#include "laws/blast/sedov.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/error.hpp"
#include "math/quadrature.hpp"
#include "math/root.hpp"

namespace corpuscle {

namespace {

/// Landau and Lifshitz' closed form. All is a function of V, and V = (1 + x)/gamma with x from 0 in the centre to (gamma-1)/(gamma+1) at
/// the front; each bracket is 1 at the front. xi = r/R, density rho G, c^2 = (2 r/(5 t))^2 Z, u = (2 r/(5 t)) V.
struct Similarity {
    double gamma;

    [[nodiscard]] double front() const { return (gamma - 1) / (gamma + 1); }
    [[nodiscard]] double velocity(double x) const { return (1 + x) / gamma; }

    [[nodiscard]] double log_bracket(double x) const { return std::log((gamma + 1) / (7 - gamma) * (5 - (3 * gamma - 1) * velocity(x))); }
    [[nodiscard]] double power_1() const { return -(13 * gamma * gamma - 7 * gamma + 12) / ((3 * gamma - 1) * (2 * gamma + 1)); }
    [[nodiscard]] double power_2() const { return 5 * (gamma - 1) / (2 * gamma + 1); }

    /// 5 ln xi.
    [[nodiscard]] double log_place(double x) const
    {
        return -2 * std::log(0.5 * (gamma + 1) * velocity(x)) + power_1() * log_bracket(x) + power_2() * std::log(x / front());
    }
    /// x d(5 ln xi)/dx.
    [[nodiscard]] double place_slope(double x) const
    {
        const double v = velocity(x), by_v = -2 / v - power_1() * (3 * gamma - 1) / (5 - (3 * gamma - 1) * v);
        return power_2() + x * by_v / gamma;
    }
    /// ln G.
    [[nodiscard]] double log_density(double x) const
    {
        return std::log(1 / front()) + 3 / (2 * gamma + 1) * std::log(x / front()) - power_1() / (2 - gamma) * log_bracket(x) -
               2 / (2 - gamma) * std::log((1 - velocity(x)) / front());
    }
    /// Z x, which stays finite in the centre.
    [[nodiscard]] double heat_by_x(double x) const
    {
        const double v = velocity(x);
        return gamma * (gamma - 1) * (1 - v) * v * v / 2;
    }
};

/// Integral of G (V^2/2 + Z/(gamma (gamma - 1))) xi^4 over xi from 0 to 1: the energy in units of rho (2/(5 t))^2 4 pi R^5. In s = (x/x of
/// the front)^q, q = (3 gamma - 3)/(2 gamma + 1), the integrand is smooth: 40 points give ten digits.
double energy_integral(const Similarity& similarity)
{
    const double gamma = similarity.gamma, q = 3 * (gamma - 1) / (2 * gamma + 1);
    double total = 0;
    for (const QuadraturePoint& point : gauss_rule(40)) {
        const double s = 0.5 * (1 + point.position);
        const double x = similarity.front() * std::pow(s, 1 / q);
        const double v = similarity.velocity(x);
        const double energy_by_x = x * v * v / 2 + similarity.heat_by_x(x) / (gamma * (gamma - 1));
        // d(xi^5)/5 = xi^5 (x d(5 ln xi)/dx) ds/(5 q s); everything but energy_by_x as one power of e, for x may be tiny
        const double weight = std::exp(similarity.log_density(x) + similarity.log_place(x) - std::log(x)) / s;
        total += 0.5 * point.weight * weight * energy_by_x * similarity.place_slope(x) / (5 * q);
    }
    return total;
}

}  // namespace

SedovBlast::SedovBlast(double gamma, double density, double energy) : gamma_(gamma), density_(density), energy_(energy), beta_(0)
{
    if (!(gamma > 1 && gamma < 2 && density > 0 && energy > 0))
        throw InputError(
            fmt::format("point blast: gamma {:g}, density {:g}, energy {:g} have no similarity solution", gamma, density, energy),
            "give 1 < gamma < 2, density > 0 and energy > 0");
    beta_ = std::pow(16 * std::numbers::pi / 25 * energy_integral({gamma}), -0.2);
}

double SedovBlast::radius(double time) const
{
    return beta_ * std::pow(energy_ * time * time / density_, 0.2);
}

double SedovBlast::front_speed(double time) const
{
    return 0.4 * radius(time) / time;
}

BlastFlow SedovBlast::behind_front(double time) const
{
    const double speed = front_speed(time);
    return {density_ * (gamma_ + 1) / (gamma_ - 1), 2 / (gamma_ + 1) * speed, 2 / (gamma_ + 1) * density_ * speed * speed};
}

BlastFlow SedovBlast::at(double radius, double time) const
{
    const double front = this->radius(time);
    if (radius > front) return {density_, 0, 0};
    const Similarity similarity{gamma_};
    const double place = 5 * std::log(radius / front);
    const auto miss = [&](double log_x) { return similarity.log_place(std::exp(log_x)) - place; };
    const double last = std::log(similarity.front());
    const double deepest = last + 2 * (place - 10) / similarity.power_2();
    const double x = miss(last) > 0 ? std::exp(find_root(miss, std::fmax(deepest, -600.0), last)) : similarity.front();
    const double scale = 0.4 * radius / time, relative_density = std::exp(similarity.log_density(x));
    return {density_ * relative_density, scale * similarity.velocity(x),
            density_ * std::exp(similarity.log_density(x) - std::log(x)) * similarity.heat_by_x(x) * scale * scale / gamma_};
}

}  // namespace corpuscle
