#pragma once

#include "laws/strength/law_traits.hpp"
#include "laws/strength/plane_stress.hpp"
#include "laws/strength/solid_stress.hpp"

// The implicit return to von Mises' yield surface at the end of a step, of shells (stress across exactly 0, after Simo and Taylor 1986,
// transverse shears included) and of solids (Wilkins 1964), for any law that says how its yield stress grows.

namespace corpuscle {

/// The elastic trial state. With flow parameter f = 1.5 * (plastic strain) / (equivalent stress) the sum xx + yy of a shell's stress
/// shrinks by 1 / (1 + f sum_rate), the rest (of a solid: its whole deviator) by 1 / (1 + f rest_rate).
template <class Real>
struct FlowTrial {
    Real sum_part, rest_part;    ///< their shares of the squared equivalent stress [Pa2]
    double sum_rate, rest_rate;  ///< [1]/[1/Pa], that is [Pa]

    [[nodiscard]] Real squared() const { return sum_part + rest_part; }
};

/// Equivalent stress [Pa] and plastic strain increment [1] for a flow parameter, with slopes.
template <class Real>
struct Flowed {
    Real equivalent, equivalent_slope, plastic, plastic_slope;
};

template <class Real>
[[gnu::always_inline]] inline Flowed<Real> flowed(const FlowTrial<Real>& trial, const Real& flow)
{
    const Real sum_shrink = 1.0 / (1.0 + trial.sum_rate * flow), rest_shrink = 1.0 / (1.0 + trial.rest_rate * flow);
    const Real sum_part = trial.sum_part * sum_shrink * sum_shrink, rest_part = trial.rest_part * rest_shrink * rest_shrink;
    const Real equivalent = square_root(sum_part + rest_part + 1e-30);
    const Real slope = -(trial.sum_rate * sum_shrink * sum_part + trial.rest_rate * rest_shrink * rest_part) / equivalent;
    return {equivalent, slope, (2.0 / 3.0) * flow * equivalent, (2.0 / 3.0) * (equivalent + flow * slope)};
}

/// The same for no flow.
template <class Real>
[[gnu::always_inline]] inline Flowed<Real> at_rest(const FlowTrial<Real>& trial)
{
    const Real equivalent = square_root(trial.squared() + 1e-30);
    return {equivalent, -(trial.sum_rate * trial.sum_part + trial.rest_rate * trial.rest_part) / equivalent, 0.0, (2.0 / 3.0) * equivalent};
}

namespace mises {

template <class Real>
PlaneStress<Real> difference(const PlaneStress<Real>& a, const PlaneStress<Real>& b)
{
    return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy, a.yz - b.yz, a.zx - b.zx};
}

template <class Real>
SolidStress<Real> difference(const SolidStress<Real>& a, const SolidStress<Real>& b)
{
    return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.yz - b.yz, a.zx - b.zx};
}

/// Trial of a shell's stress `r` relative to the back stress.
template <class Real>
FlowTrial<Real> trial_of(const PlaneStiffness& stiffness, const PlaneStress<Real>& r, double back_modulus)
{
    const Real sum = r.xx + r.yy, gap = r.xx - r.yy;
    return {0.25 * sum * sum, 0.75 * gap * gap + 3.0 * (r.xy * r.xy + r.yz * r.yz + r.zx * r.zx),
            stiffness.young() / (3.0 * (1.0 - stiffness.poisson())) + back_modulus, 2.0 * stiffness.shear() + back_modulus};
}

/// Trial of a solid's stress `r` relative to the back stress.
template <class Real>
FlowTrial<Real> trial_of(const SolidStiffness& stiffness, const SolidStress<Real>& r, double back_modulus)
{
    return {0.0, equivalent_squared(r), 0.0, 2.0 * stiffness.shear() + back_modulus};
}

/// Stress `r` after the flow.
template <class Real>
PlaneStress<Real> shrunk(const FlowTrial<Real>& trial, const Real& flow, const PlaneStress<Real>& r)
{
    const Real sum = (r.xx + r.yy) / (1.0 + trial.sum_rate * flow), shrink = 1.0 / (1.0 + trial.rest_rate * flow);
    const Real gap = (r.xx - r.yy) * shrink;
    return {0.5 * (sum + gap), 0.5 * (sum - gap), r.xy * shrink, r.yz * shrink, r.zx * shrink};
}

template <class Real>
SolidStress<Real> shrunk(const FlowTrial<Real>& trial, const Real& flow, const SolidStress<Real>& r)
{
    const Real mean = mean_stress(r), shrink = 1.0 / (1.0 + trial.rest_rate * flow);
    return {mean + (r.xx - mean) * shrink,
            mean + (r.yy - mean) * shrink,
            mean + (r.zz - mean) * shrink,
            r.xy * shrink,
            r.yz * shrink,
            r.zx * shrink};
}

/// The back stress goes `drag` times the stress `now`; returns the stress as seen from nothing.
template <class Real>
PlaneStress<Real> drag_back_stress(PlaneStress<Real>& back, const Real& drag, const PlaneStress<Real>& now)
{
    back = {back.xx + drag * now.xx, back.yy + drag * now.yy, back.xy + drag * now.xy, back.yz + drag * now.yz, back.zx + drag * now.zx};
    return {now.xx + back.xx, now.yy + back.yy, now.xy + back.xy, now.yz + back.yz, now.zx + back.zx};
}

/// As for shells; only the deviator of `now` drags.
template <class Real>
SolidStress<Real> drag_back_stress(SolidStress<Real>& back, const Real& drag, const SolidStress<Real>& now)
{
    const Real mean = mean_stress(now);
    back = {back.xx + drag * (now.xx - mean), back.yy + drag * (now.yy - mean), back.zz + drag * (now.zz - mean),
            back.xy + drag * now.xy,          back.yz + drag * now.yz,          back.zx + drag * now.zx};
    return {now.xx + back.xx, now.yy + back.yy, now.zz + back.zz, now.xy + back.xy, now.yz + back.yz, now.zx + back.zx};
}

/// Plastic strain increment: the flow times the deviator of the stress `r` relative to the back stress.
template <class Real>
PlaneStrain<Real> plastic_strain_of(const Real& flow, const PlaneStress<Real>& r)
{
    return {flow * (2.0 * r.xx - r.yy) * (1.0 / 3.0), flow * (2.0 * r.yy - r.xx) * (1.0 / 3.0), 2.0 * flow * r.xy, 2.0 * flow * r.yz,
            2.0 * flow * r.zx};
}

template <class Real>
SolidStrain<Real> plastic_strain_of(const Real& flow, const SolidStress<Real>& r)
{
    const Real mean = mean_stress(r);
    return {flow * (r.xx - mean), flow * (r.yy - mean), flow * (r.zz - mean), 2.0 * flow * r.xy, 2.0 * flow * r.yz, 2.0 * flow * r.zx};
}

template <class Real>
Real mean_work(const PlaneStress<Real>& a, const PlaneStress<Real>& b, const PlaneStrain<Real>& e)
{
    return 0.5 * ((a.xx + b.xx) * e.xx + (a.yy + b.yy) * e.yy + (a.xy + b.xy) * e.xy + (a.yz + b.yz) * e.yz + (a.zx + b.zx) * e.zx);
}

template <class Real>
Real mean_work(const SolidStress<Real>& a, const SolidStress<Real>& b, const SolidStrain<Real>& e)
{
    return 0.5 * (work(a, e) + work(b, e));
}

template <class Real>
Real mean_of(const PlaneStress<Real>& s)
{
    return (s.xx + s.yy) * (1.0 / 3.0);
}

template <class Real>
Real mean_of(const SolidStress<Real>& s)
{
    return mean_stress(s);
}

template <class Real>
PlaneResponse<Real> response(const PlaneStiffness& stiffness, const PlaneStress<Real>& before, const PlaneStress<Real>& after,
                             const PlaneStrain<Real>& plastic, const Real& plastic_work)
{
    return {stiffness.thickness_strain(before, after) - (plastic.xx + plastic.yy), plastic_work};
}

template <class Real>
SolidResponse<Real> response(const SolidStiffness&, const SolidStress<Real>&, const SolidStress<Real>&, const SolidStrain<Real>&,
                             const Real& plastic_work)
{
    return {plastic_work};
}

}  // namespace mises

/// New stress and history of a point of a shell or solid after a strain increment within `duration` [s] > 0. The law says
///     back_modulus()                          (2/3) of its kinematic hardening modulus [Pa]
///     yield_of(point)                         yield stress at no rate, at the start of the step [Pa]
///     flow(trial, point, duration)            flow parameter f >= 0 at which the equivalent stress is the yield stress; 0 where elastic
///     remember(point, plastic strain, mean stress, equivalent stress, plastic work, duration)     if it keeps more than plastic strain
template <class Law, class Stiffness, class Point, class Strain>
auto mises_stretch(const Law& law, const Stiffness& stiffness, Point& point, const Strain& strain, double duration)
{
    using Real = decltype(point.plastic_strain);
    const auto before = point.stress;
    point.stress = stiffness.stretched(before, strain);
    const auto relative = mises::difference(point.stress, point.back_stress);
    const FlowTrial<Real> trial = mises::trial_of(stiffness, relative, law.back_modulus());
    const Real yield = law.yield_of(point);
    Real plastic_work = 0.0;
    Strain plastic;
    if (any(trial.squared() > yield * yield)) {
        const Real flow = law.flow(trial, point, duration);
        const Flowed<Real> state = flowed(trial, flow);
        const auto now = mises::shrunk(trial, flow, relative);
        point.stress = mises::drag_back_stress(point.back_stress, Real(law.back_modulus() * flow), now);
        point.plastic_strain = point.plastic_strain + state.plastic;
        plastic = mises::plastic_strain_of(flow, now);
        plastic_work = mises::mean_work(before, point.stress, plastic);
        if constexpr (requires { law.remember(point, plastic_work, plastic_work, plastic_work, plastic_work, duration); })
            law.remember(point, state.plastic, mises::mean_of(point.stress), state.equivalent, plastic_work, duration);
    }
    return mises::response(stiffness, before, point.stress, plastic, plastic_work);
}

}  // namespace corpuscle
