#pragma once

#include <algorithm>

#include "laws/strength/plane_stress.hpp"

namespace corpuscle {

/// Thin cloth: elastic in tension, without resistance to compression, in which it wrinkles (tension field, Reissner 1938; Roddeman et al.
/// 1987, J. Appl. Mech. 54, 884). The elastic stress of the whole strain is remembered where other laws keep their back stress; of it
///     both principal stresses above 0: the stress is that one (taut),
///     the larger principal strain above 0: a tension of E times it along it (wrinkled),
///     else nothing (slack).
/// For shells without bending (membranes).
struct Fabric {
    [[nodiscard]] static constexpr bool yields() { return false; }
    [[nodiscard]] static constexpr bool has_back_stress() { return true; }
    [[nodiscard]] static constexpr bool for_solids() { return false; }

    /// New stress of the point after the strain increment `strain`; `duration` [s] does not matter.
    template <class Real>
    PlaneResponse<Real> stretch(const PlaneStiffness& stiffness, PlanePoint<Real>& point, const PlaneStrain<Real>& strain, double) const
    {
        const PlaneStress<Real> before = point.stress;
        point.back_stress = stiffness.stretched(point.back_stress, {strain.xx, strain.yy, strain.xy, 0.0, 0.0});
        point.stress = tension_field(stiffness, point.back_stress);
        return {stiffness.thickness_strain(before, point.stress), 0.0};
    }

    /// What is left of an elastic stress in cloth.
    template <class Real>
    static PlaneStress<Real> tension_field(const PlaneStiffness& stiffness, const PlaneStress<Real>& s)
    {
        const Real half = 0.5 * (s.xx + s.yy), gap = 0.5 * (s.xx - s.yy);
        const Real radius = square_root(gap * gap + s.xy * s.xy + 1e-30), upper = half + radius, lower = half - radius;
        // the principal strains over 1/E: upper - nu lower; a wrinkled cloth carries E times the larger one along it
        const Real pull = larger(upper - stiffness.poisson() * lower, Real(0.0));
        const Real cosine = gap / radius, sine = s.xy / radius;
        const PlaneStress<Real> wrinkled{0.5 * pull * (1.0 + cosine), 0.5 * pull * (1.0 - cosine), 0.5 * pull * sine, 0.0, 0.0};
        const auto taut = lower > 0.0;
        return {select(taut, s.xx, wrinkled.xx), select(taut, s.yy, wrinkled.yy), select(taut, s.xy, wrinkled.xy), 0.0, 0.0};
    }
};

}  // namespace corpuscle
