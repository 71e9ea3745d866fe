#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "laws/strength/flow_root.hpp"

namespace corpuscle {

/// Von Mises plasticity with a yield stress from curves over the plastic strain, straight between their points and level beyond the last:
/// one curve, or one for each of several plastic strain rates, with which the stress goes evenly in log(rate) (level beyond the first and
/// last); on request times the factor of Cowper and Symonds, 1 + (rate / C)^(1/p). The rate is the plastic one of the step. Isotropic.
struct CurvePlastic {
    struct Point {
        double plastic_strain = 0;  ///< [1]
        double stress = 0;          ///< true stress [Pa]
    };
    struct Curve {
        double rate = 0;            ///< at which it was measured [1/s]
        std::vector<Point> points;  ///< strains from 0 upward, stresses not falling
    };

    std::vector<Curve> curves;  ///< rates upward
    double rate_constant = 0;   ///< C [1/s]; 0: no such factor
    double rate_exponent = 1;   ///< p >= 1 [1]

    [[nodiscard]] static constexpr bool yields() { return true; }
    [[nodiscard]] static constexpr bool has_back_stress() { return false; }
    [[nodiscard]] static constexpr double back_modulus() { return 0.0; }

    /// Yield stress at a plastic strain and plastic strain rate [1/s]; the temperature does not matter. [Pa]
    [[nodiscard]] double yield_stress(double plastic_strain, double rate, double /*heat*/) const
    {
        return yield_with_slope(plastic_strain, rate, 0.0, 1.0).value;
    }

    /// The same and its slope in a step of `duration` [s].
    [[nodiscard]] YieldStress yield_with_slope(double plastic_strain, double rate, double /*heat*/, double duration) const
    {
        const YieldStress table = of_table(plastic_strain, rate, duration);
        if (!(rate_constant > 0)) return table;
        const double power = std::pow(rate / rate_constant, 1.0 / rate_exponent), factor = 1.0 + power;
        const double growth = rate > 0 ? power / (rate_exponent * rate * duration) : 0.0;
        return {table.value * factor, table.slope * factor + table.value * growth};
    }

    template <class At>
    auto yield_of(const At& point) const
    {
        return each_lane([this](double strain) { return yield_stress(strain, 0.0, 0.0); }, point.plastic_strain);
    }

    template <class Real, class At>
    Real flow(const FlowTrial<Real>& trial, const At& point, double duration) const
    {
        return solve_flow(*this, trial, point, duration);
    }

    template <class Stiffness, class At, class Strain>
    auto stretch(const Stiffness& stiffness, At& point, const Strain& strain, double duration) const
    {
        return mises_stretch(*this, stiffness, point, strain, duration);
    }

private:
    static YieldStress on_curve(const std::vector<Point>& points, double strain)
    {
        const auto after =
            std::upper_bound(points.begin(), points.end(), strain, [](double s, const Point& p) { return s < p.plastic_strain; });
        if (after == points.end()) return {points.back().stress, 0.0};
        if (after == points.begin()) return {points.front().stress, 0.0};
        const Point &a = *(after - 1), &b = *after;
        const double slope = (b.stress - a.stress) / (b.plastic_strain - a.plastic_strain);
        return {a.stress + slope * (strain - a.plastic_strain), slope};
    }

    [[nodiscard]] YieldStress of_table(double strain, double rate, double duration) const
    {
        const auto after = std::upper_bound(curves.begin(), curves.end(), rate, [](double r, const Curve& c) { return r < c.rate; });
        if (after == curves.begin()) return on_curve(curves.front().points, strain);
        if (after == curves.end()) return on_curve(curves.back().points, strain);
        const Curve &below = *(after - 1), &above = *after;
        const YieldStress a = on_curve(below.points, strain), b = on_curve(above.points, strain);
        const double decades = std::log(above.rate / below.rate), share = std::log(rate / below.rate) / decades;
        return {a.value + share * (b.value - a.value),
                a.slope + share * (b.slope - a.slope) + (b.value - a.value) / (decades * rate * duration)};
    }
};

}  // namespace corpuscle
