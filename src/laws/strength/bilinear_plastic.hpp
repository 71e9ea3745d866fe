#pragma once

#include <cmath>

#include "laws/strength/mises_return.hpp"

namespace corpuscle {

/// Von Mises plasticity with linear hardening and the rate factor of Cowper and Symonds (1957):
///     sigma_y = (yield_stress + (1 - k) H eps_p) (1 + (rate / C)^(1/p)),     back stress rate = (2/3) k H * plastic strain rate
/// with k the kinematic fraction and `rate` the equivalent PLASTIC strain rate of the step, so the overstress is viscous and
/// needs no filtered total rate. Stress is brought back to the yield surface at the end of the step with the stress across
/// a shell exactly 0 (implicit; `mises_return.hpp`). Small strains within a step.
struct BilinearPlastic {
    double yield_stress = 0;        ///< sigma0 [Pa]
    double hardening_modulus = 0;   ///< H, of stress over plastic strain [Pa]
    double rate_constant = 0;       ///< C [1/s]; 0: no rate effect
    double rate_exponent = 1;       ///< p >= 1 [1]
    double kinematic_fraction = 0;  ///< k in 0..1: 0 isotropic, 1 kinematic hardening [1]

    [[nodiscard]] static constexpr bool yields() { return true; }
    [[nodiscard]] bool has_back_stress() const { return kinematic_fraction > 0; }

    /// Yield stress of the isotropic part at a plastic strain and plastic strain rate [1/s]. [Pa]
    [[nodiscard]] double yield_at(double plastic_strain, double rate) const
    {
        const double factor = rate_constant > 0 ? 1.0 + std::pow(rate / rate_constant, 1.0 / rate_exponent) : 1.0;
        return (yield_stress + isotropic_modulus() * plastic_strain) * factor;
    }

    /// New stress, back stress and plastic strain of a shell's or solid's point after a strain increment within `duration` [s] > 0.
    template <class Stiffness, class Point, class Strain>
    auto stretch(const Stiffness& stiffness, Point& point, const Strain& strain, double duration) const
    {
        return mises_stretch(*this, stiffness, point, strain, duration);
    }

    /// Of the back stress: (2/3) k H. [Pa]
    [[nodiscard]] double back_modulus() const { return kinematic_fraction * hardening_modulus * 2.0 / 3.0; }

    /// Without rate effect, at the start of the step. [Pa]
    template <class Point>
    auto yield_of(const Point& point) const
    {
        return yield_stress + isotropic_modulus() * point.plastic_strain;
    }

    /// The flow parameter at which stress and yield stress agree; 0 where the step is elastic.
    template <class Real, class Point>
    Real flow(const FlowTrial<Real>& trial, const Point& point, double duration) const
    {
        const Real yield = yield_of(point);
        const auto plastic = trial.squared() > yield * yield;
        constexpr int most_steps = 100;
        constexpr double last_step = 1e-6;  // of the flow: the error falls by squares, so after it nothing is left but rounding
        Real flow = 0.0;
        Flowed<Real> state = at_rest(trial);
        for (int i = 0; i < most_steps; ++i) {
            const Real step = select(plastic, rate_constant > 0 ? rate_step(yield, state, duration) : plain_step(yield, state), Real(0.0));
            flow = flow + step;
            if (!any(magnitude(step) > last_step * flow)) break;
            state = flowed(trial, flow);
        }
        return flow;
    }

private:
    [[nodiscard]] double isotropic_modulus() const { return (1.0 - kinematic_fraction) * hardening_modulus; }

    /// Newton's step for the yield condition without rate: equivalent - yield = 0, convex and falling, so that it comes from below.
    template <class Real>
    Real plain_step(const Real& yield, const Flowed<Real>& y) const
    {
        const double hardening = isotropic_modulus();
        return (y.equivalent - yield - hardening * y.plastic) / (hardening * y.plastic_slope - y.equivalent_slope);
    }

    /// Newton's step for the plastic strain the overstress asks for: plastic / (C dt) - (equivalent / yield - 1)^p = 0, concave
    /// and rising, so that it too comes from below; no root of a vanishing rate is ever taken.
    template <class Real>
    Real rate_step(const Real& yield, const Flowed<Real>& y, double duration) const
    {
        const double hardening = isotropic_modulus(), scale = 1.0 / (rate_constant * duration);
        const Real inverse_yield = 1.0 / (yield + hardening * y.plastic);
        const Real ratio = y.equivalent * inverse_yield;
        const Real over = larger(ratio - 1.0, Real(0.0));
        const Real power_below = over_power(over);
        const Real over_slope = (y.equivalent_slope - ratio * hardening * y.plastic_slope) * inverse_yield;
        return (over * power_below - scale * y.plastic) / (scale * y.plastic_slope - rate_exponent * power_below * over_slope);
    }

    /// over^(p - 1), by multiplication where p is a small whole number.
    template <class Real>
    Real over_power(const Real& over) const
    {
        const double exponent = rate_exponent - 1.0;
        const int whole = static_cast<int>(exponent);
        return exponent == whole && whole < 12 ? integer_power(over, whole) : power(over, exponent);
    }
};

}  // namespace corpuscle
