#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include "laws/strength/mises_return.hpp"

namespace corpuscle {

/// A yield stress and how it grows with the plastic strain of a step of given duration, its rate with it. [Pa]
struct YieldStress {
    double value = 0;
    double slope = 0;  ///< [Pa], of the plastic strain
};

/// The flow parameter at which the equivalent stress has come down to a yield stress that grows with plastic strain and rate: the root of
/// a falling function between no flow and the flow that ends at the yield stress at rest, by Newton's method kept within that bracket.
/// yield_at(plastic strain increment) is a YieldStress, not falling. [1/Pa]
template <class YieldAt>
double flow_root(const FlowTrial<double>& trial, double yield_at_rest, const YieldAt& yield_at)
{
    const double over = std::sqrt(trial.squared()) / yield_at_rest - 1.0;
    if (!(over > 0)) return 0.0;
    const double slowest = trial.sum_part > 0 ? std::min(trial.sum_rate, trial.rest_rate) : trial.rest_rate;
    double low = 0, high = over / slowest, flow = high;
    constexpr int most_steps = 80;
    for (int i = 0; i < most_steps; ++i) {
        const Flowed<double> state = flowed(trial, flow);
        const YieldStress yield = yield_at(state.plastic);
        const double excess = state.equivalent - yield.value;
        (excess > 0 ? low : high) = flow;
        if (std::abs(excess) <= 1e-9 * yield.value || high - low <= 1e-12 * high) break;
        const double newton = flow - excess / (state.equivalent_slope - yield.slope * state.plastic_slope);
        flow = newton > low && newton < high ? newton : 0.5 * (low + high);
    }
    return flow;
}

/// The same for a law with yield_stress(plastic strain, rate, heat) and its slope, for one point or for lanes of them.
template <class Law, class Point>
double solve_flow(const Law& law, const FlowTrial<double>& trial, const Point& point, double duration)
{
    const double plastic = point.plastic_strain, heat = point.heat;
    return flow_root(trial, law.yield_stress(plastic, 0.0, heat),
                     [&](double increment) { return law.yield_with_slope(plastic + increment, increment / duration, heat, duration); });
}

/// Lanes one by one: the curves of such laws are tables or powers.
template <class Law, class Point>
    requires(!std::same_as<decltype(Point::plastic_strain), double>)
Lanes solve_flow(const Law& law, const FlowTrial<Lanes>& trial, const Point& point, double duration)
{
    struct OnePoint {
        double plastic_strain, heat;
    };
    return Lanes([&](auto lane) {
        const FlowTrial<double> own{trial.sum_part[lane], trial.rest_part[lane], trial.sum_rate, trial.rest_rate};
        return solve_flow(law, own, OnePoint{point.plastic_strain[lane], point.heat[lane]}, duration);
    });
}

/// A function of a number, for one point or for lanes of them.
template <class Function>
double each_lane(const Function& function, double a)
{
    return function(a);
}
template <class Function>
Lanes each_lane(const Function& function, const Lanes& a)
{
    return Lanes([&](auto lane) { return function(double(a[lane])); });
}
template <class Function>
double each_lane(const Function& function, double a, double b)
{
    return function(a, b);
}
template <class Function>
Lanes each_lane(const Function& function, const Lanes& a, const Lanes& b)
{
    return Lanes([&](auto lane) { return function(double(a[lane]), double(b[lane])); });
}

}  // namespace corpuscle
