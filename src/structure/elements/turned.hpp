#pragma once

#include "laws/strength/solid_stress.hpp"
#include "math/vector3.hpp"

namespace corpuscle {

/// A rotation by a step's mean spin, after Hughes and Winget 1980 (Int. J. Numer. Methods Eng. 15, 1862): exact for a rigid turn whose
/// spin is read in the middle of the step, however large.
template <class Real>
class StepRotation {
public:
    /// `spin` is the axial vector of the antisymmetric part of the displacement's gradient. [rad]
    explicit StepRotation(const Vector3<Real>& spin) : half_(spin * Real(0.5)), factor_(2.0 / (1.0 + dot(half_, half_))) {}

    [[nodiscard]] Vector3<Real> operator*(const Vector3<Real>& v) const
    {
        const Vector3<Real> first = cross(half_, v);
        return v + (first + cross(half_, first)) * factor_;
    }

    /// The stress of what has turned: R s R^T.
    [[nodiscard]] SolidStress<Real> operator*(const SolidStress<Real>& s) const
    {
        const Vector3<Real> a = *this * Vector3<Real>{s.xx, s.xy, s.zx}, b = *this * Vector3<Real>{s.xy, s.yy, s.yz},
                            c = *this * Vector3<Real>{s.zx, s.yz, s.zz};  // columns of R s
        const Vector3<Real> x = *this * Vector3<Real>{a.x, b.x, c.x}, y = *this * Vector3<Real>{a.y, b.y, c.y},
                            z = *this * Vector3<Real>{a.z, b.z, c.z};
        return {x.x, y.y, z.z, x.y, y.z, z.x};
    }

private:
    Vector3<Real> half_;
    Real factor_;
};

}  // namespace corpuscle
