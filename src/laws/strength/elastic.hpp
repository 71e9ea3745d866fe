#pragma once

#include "laws/strength/plane_stress.hpp"
#include "laws/strength/solid_stress.hpp"

namespace corpuscle {

/// Hooke's law: no yield.
struct Elastic {
    [[nodiscard]] static constexpr bool yields() { return false; }
    [[nodiscard]] static constexpr bool has_back_stress() { return false; }

    /// New stress of the point after the strain increment `strain`; `duration` [s] does not matter.
    template <class Real>
    PlaneResponse<Real> stretch(const PlaneStiffness& stiffness, PlanePoint<Real>& point, const PlaneStrain<Real>& strain, double) const
    {
        const PlaneStress<Real> before = point.stress;
        point.stress = stiffness.stretched(before, strain);
        return {stiffness.thickness_strain(before, point.stress), 0.0};
    }

    /// The same for a solid's point.
    template <class Real>
    SolidResponse<Real> stretch(const SolidStiffness& stiffness, SolidPoint<Real>& point, const SolidStrain<Real>& strain, double) const
    {
        point.stress = stiffness.stretched(point.stress, strain);
        return {};
    }
};

}  // namespace corpuscle
