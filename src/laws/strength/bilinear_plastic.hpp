#pragma once

#include <cmath>

#include "laws/strength/plane_stress.hpp"

namespace corpuscle {

/// Von Mises plasticity with linear hardening and the rate factor of Cowper and Symonds (1957):
///     sigma_y = (yield_stress + (1 - k) H eps_p) (1 + (rate / C)^(1/p)),     back stress rate = (2/3) k H * plastic strain rate
/// with k the kinematic fraction and `rate` the equivalent PLASTIC strain rate of the step, so the overstress is viscous and
/// needs no filtered total rate. Stress is brought back to the yield surface at the end of the step with the stress across
/// the shell exactly 0 (implicit, after Simo and Taylor 1986, transverse shears included). Small strains within a step.
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

    /// New stress, back stress and plastic strain of the point after the strain increment `strain` within `duration` [s] > 0.
    template <class Real>
    PlaneResponse<Real> stretch(const PlaneStiffness& stiffness, PlanePoint<Real>& point, const PlaneStrain<Real>& strain,
                                double duration) const
    {
        const PlaneStress<Real> before = point.stress;
        point.stress = stiffness.stretched(before, strain);
        const PlaneStress<Real> relative = difference(point.stress, point.back_stress);
        const Trial<Real> trial = make_trial(stiffness, relative, point.plastic_strain);
        Real plastic_work = 0.0, plastic_thickness = 0.0;
        if (any(trial.sum_part + trial.rest_part > trial.yield * trial.yield)) {
            const Real flow = solve(trial, duration);
            const PlaneStress<Real> back = give_way(trial, flow, relative, point);
            const PlaneStrain<Real> plastic = plastic_strain_of(flow, back);
            plastic_thickness = -(plastic.xx + plastic.yy);
            plastic_work = 0.5 * work_of(before, point.stress, plastic);
        }
        return {stiffness.thickness_strain(before, point.stress) + plastic_thickness, plastic_work};
    }

private:
    /// The elastic trial state. With flow parameter f = 1.5 * (plastic strain) / (equivalent stress), the stress sum xx + yy
    /// shrinks by 1 / (1 + f sum_rate), the difference xx - yy and the shears by 1 / (1 + f rest_rate).
    template <class Real>
    struct Trial {
        Real sum_part, rest_part;    ///< their shares of the squared equivalent stress [Pa2]
        double sum_rate, rest_rate;  ///< [Pa]
        Real yield;                  ///< without rate effect, at the start of the step [Pa]
    };

    /// Equivalent stress and plastic strain for a flow parameter, with slopes.
    template <class Real>
    struct Yielded {
        Real equivalent, equivalent_slope, plastic, plastic_slope;
    };

    [[nodiscard]] double isotropic_modulus() const { return (1.0 - kinematic_fraction) * hardening_modulus; }
    [[nodiscard]] double back_modulus() const { return kinematic_fraction * hardening_modulus * 2.0 / 3.0; }

    template <class Real>
    static PlaneStress<Real> difference(const PlaneStress<Real>& a, const PlaneStress<Real>& b)
    {
        return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy, a.yz - b.yz, a.zx - b.zx};
    }

    template <class Real>
    Trial<Real> make_trial(const PlaneStiffness& stiffness, const PlaneStress<Real>& r, const Real& plastic_strain) const
    {
        const Real sum = r.xx + r.yy, gap = r.xx - r.yy;
        return {0.25 * sum * sum, 0.75 * gap * gap + 3.0 * (r.xy * r.xy + r.yz * r.yz + r.zx * r.zx),
                stiffness.young() / (3.0 * (1.0 - stiffness.poisson())) + back_modulus(), 2.0 * stiffness.shear() + back_modulus(),
                yield_stress + isotropic_modulus() * plastic_strain};
    }

    template <class Real>
    static Yielded<Real> yielded(const Trial<Real>& trial, const Real& flow)
    {
        const Real sum_shrink = 1.0 / (1.0 + trial.sum_rate * flow), rest_shrink = 1.0 / (1.0 + trial.rest_rate * flow);
        const Real sum_part = trial.sum_part * sum_shrink * sum_shrink, rest_part = trial.rest_part * rest_shrink * rest_shrink;
        const Real equivalent = square_root(sum_part + rest_part + 1e-30);
        const Real slope = -(trial.sum_rate * sum_shrink * sum_part + trial.rest_rate * rest_shrink * rest_part) / equivalent;
        return {equivalent, slope, (2.0 / 3.0) * flow * equivalent, (2.0 / 3.0) * (equivalent + flow * slope)};
    }

    /// Newton's step for the yield condition without rate: equivalent - yield = 0, convex and falling, so that it comes from below.
    template <class Real>
    Real plain_step(const Trial<Real>& trial, const Yielded<Real>& y) const
    {
        const double hardening = isotropic_modulus();
        return (y.equivalent - trial.yield - hardening * y.plastic) / (hardening * y.plastic_slope - y.equivalent_slope);
    }

    /// Newton's step for the plastic strain the overstress asks for: plastic / (C dt) - (equivalent / yield - 1)^p = 0, concave
    /// and rising, so that it too comes from below; no root of a vanishing rate is ever taken.
    template <class Real>
    Real rate_step(const Trial<Real>& trial, const Yielded<Real>& y, double duration) const
    {
        const double hardening = isotropic_modulus(), scale = 1.0 / (rate_constant * duration);
        const Real inverse_yield = 1.0 / (trial.yield + hardening * y.plastic);
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

    template <class Real>
    Real solve(const Trial<Real>& trial, double duration) const
    {
        const auto plastic = trial.sum_part + trial.rest_part > trial.yield * trial.yield;
        constexpr int most_steps = 100;
        Real flow = 0.0;
        for (int i = 0; i < most_steps; ++i) {
            const Yielded<Real> state = yielded(trial, flow);
            const Real step = select(plastic, rate_constant > 0 ? rate_step(trial, state, duration) : plain_step(trial, state), Real(0.0));
            flow = flow + step;
            if (!any(magnitude(step) > 1e-9 * flow)) break;
        }
        return flow;
    }

    /// Stress, back stress and plastic strain after the flow; returns the new stress relative to the back stress.
    template <class Real>
    PlaneStress<Real> give_way(const Trial<Real>& trial, const Real& flow, const PlaneStress<Real>& r, PlanePoint<Real>& point) const
    {
        const Yielded<Real> state = yielded(trial, flow);
        const Real sum = (r.xx + r.yy) / (1.0 + trial.sum_rate * flow), shrink = 1.0 / (1.0 + trial.rest_rate * flow);
        const Real gap = (r.xx - r.yy) * shrink;
        const PlaneStress<Real> now{0.5 * (sum + gap), 0.5 * (sum - gap), r.xy * shrink, r.yz * shrink, r.zx * shrink};
        const Real drag = back_modulus() * flow;
        PlaneStress<Real>& back = point.back_stress;
        back = {back.xx + drag * now.xx, back.yy + drag * now.yy, back.xy + drag * now.xy, back.yz + drag * now.yz,
                back.zx + drag * now.zx};
        point.stress = {now.xx + back.xx, now.yy + back.yy, now.xy + back.xy, now.yz + back.yz, now.zx + back.zx};
        point.plastic_strain = point.plastic_strain + state.plastic;
        return now;
    }

    /// Plastic strain increment: the flow times the deviator of the relative stress.
    template <class Real>
    static PlaneStrain<Real> plastic_strain_of(const Real& flow, const PlaneStress<Real>& r)
    {
        return {flow * (2.0 * r.xx - r.yy) * (1.0 / 3.0), flow * (2.0 * r.yy - r.xx) * (1.0 / 3.0), 2.0 * flow * r.xy, 2.0 * flow * r.yz,
                2.0 * flow * r.zx};
    }

    template <class Real>
    static Real work_of(const PlaneStress<Real>& a, const PlaneStress<Real>& b, const PlaneStrain<Real>& e)
    {
        return (a.xx + b.xx) * e.xx + (a.yy + b.yy) * e.yy + (a.xy + b.xy) * e.xy + (a.yz + b.yz) * e.yz + (a.zx + b.zx) * e.zx;
    }
};

}  // namespace corpuscle
