#pragma once

#include "math/lanes.hpp"

namespace corpuscle {

/// Stress of a solid's point, tension positive. [Pa]
template <class Real>
struct SolidStress {
    Real xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, yz = 0.0, zx = 0.0;
};

/// Strain increment of a solid's point; shears are engineering shears (twice the tensor's). [1]
template <class Real>
struct SolidStrain {
    Real xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, yz = 0.0, zx = 0.0;
};

/// Mean of the three normal stresses: minus the pressure. [Pa]
template <class Real>
Real mean_stress(const SolidStress<Real>& s)
{
    return (s.xx + s.yy + s.zz) * (1.0 / 3.0);
}

/// Growth of volume. [1]
template <class Real>
Real volume_strain(const SolidStrain<Real>& e)
{
    return e.xx + e.yy + e.zz;
}

/// The same stress with `mean` added to the three normal stresses.
template <class Real>
SolidStress<Real> with_mean_added(const SolidStress<Real>& s, const Real& mean)
{
    return {s.xx + mean, s.yy + mean, s.zz + mean, s.xy, s.yz, s.zx};
}

/// Square of von Mises' equivalent of a stress. [Pa2]
template <class Real>
Real equivalent_squared(const SolidStress<Real>& s)
{
    const Real a = s.xx - s.yy, b = s.yy - s.zz, c = s.zz - s.xx;
    return 0.5 * (a * a + b * b + c * c) + 3.0 * (s.xy * s.xy + s.yz * s.yz + s.zx * s.zx);
}

/// Von Mises' equivalent of a stress. [Pa]
template <class Real>
Real von_mises(const SolidStress<Real>& s)
{
    return square_root(equivalent_squared(s));
}

/// Work per volume of a stress on a strain. [J/m3]
template <class Real>
Real work(const SolidStress<Real>& s, const SolidStrain<Real>& e)
{
    return s.xx * e.xx + s.yy * e.yy + s.zz * e.zz + s.xy * e.xy + s.yz * e.yz + s.zx * e.zx;
}

/// Isotropic elasticity of a solid, made from Young's modulus and Poisson's ratio.
class SolidStiffness {
public:
    SolidStiffness(double young_modulus, double poisson_ratio)
        : bulk_(young_modulus / (3.0 * (1.0 - 2.0 * poisson_ratio))), shear_(young_modulus / (2.0 * (1.0 + poisson_ratio)))
    {
    }

    [[nodiscard]] double bulk() const { return bulk_; }                           ///< K [Pa]
    [[nodiscard]] double shear() const { return shear_; }                         ///< G [Pa]
    [[nodiscard]] double lame() const { return bulk_ - 2.0 * shear_ / 3.0; }      ///< lambda [Pa]
    [[nodiscard]] double uniaxial() const { return bulk_ + 4.0 * shear_ / 3.0; }  ///< K + 4 G/3, that of plane waves [Pa]

    /// Stress after an elastic strain increment.
    template <class Real>
    [[nodiscard]] SolidStress<Real> stretched(const SolidStress<Real>& s, const SolidStrain<Real>& e) const
    {
        const double twice = 2.0 * shear_;
        const Real all = lame() * volume_strain(e);
        return {s.xx + all + twice * e.xx, s.yy + all + twice * e.yy, s.zz + all + twice * e.zz,
                s.xy + shear_ * e.xy,      s.yz + shear_ * e.yz,      s.zx + shear_ * e.zx};
    }

private:
    double bulk_, shear_;
};

/// What a point of a solid remembers.
template <class Real>
struct SolidPoint {
    SolidStress<Real> stress;       ///< [Pa]
    SolidStress<Real> back_stress;  ///< centre of the yield surface, a deviator [Pa]; only with kinematic hardening
    Real plastic_strain = 0.0;      ///< equivalent plastic strain [1]
    Real heat = 0.0;                ///< rise of temperature by plastic work [K]
    Real damage = 0.0;              ///< share of the strain at failure used up [1]
    Real volume = 1.0;              ///< over that at the start [1]; only with an equation of state
    Real energy = 0.0;              ///< internal, per volume at the start [J/m3]; only with an equation of state
};

/// What a strength law tells of a strain increment of a solid's point besides the new stress.
template <class Real>
struct SolidResponse {
    Real plastic_work = 0.0;  ///< increment per volume [J/m3]
};

}  // namespace corpuscle
