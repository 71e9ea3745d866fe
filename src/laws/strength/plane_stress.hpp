#pragma once

#include "math/lanes.hpp"

namespace corpuscle {

/// Stress of a shell's point in the shell's own axes; the stress across the shell is 0. [Pa]
template <class Real>
struct PlaneStress {
    Real xx = 0.0, yy = 0.0, xy = 0.0, yz = 0.0, zx = 0.0;
};

/// Strain increment of a shell's point; shears are engineering shears (twice the tensor's). [1]
template <class Real>
struct PlaneStrain {
    Real xx = 0.0, yy = 0.0, xy = 0.0, yz = 0.0, zx = 0.0;
};

/// Von Mises' equivalent of a plane stress. [Pa]
template <class Real>
Real von_mises(const PlaneStress<Real>& s)
{
    return square_root(s.xx * s.xx + s.yy * s.yy - s.xx * s.yy + 3.0 * (s.xy * s.xy + s.yz * s.yz + s.zx * s.zx));
}

/// Isotropic elasticity under plane stress, made from Young's modulus and Poisson's ratio.
class PlaneStiffness {
public:
    PlaneStiffness(double young_modulus, double poisson_ratio)
        : young_(young_modulus),
          poisson_(poisson_ratio),
          plane_(young_modulus / (1.0 - poisson_ratio * poisson_ratio)),
          shear_(young_modulus / (2.0 * (1.0 + poisson_ratio)))
    {
    }

    [[nodiscard]] double young() const { return young_; }      ///< E [Pa]
    [[nodiscard]] double poisson() const { return poisson_; }  ///< nu [1]
    [[nodiscard]] double plane() const { return plane_; }      ///< E / (1 - nu^2) [Pa]
    [[nodiscard]] double shear() const { return shear_; }      ///< G [Pa]

    /// Stress after an elastic strain increment.
    template <class Real>
    [[nodiscard]] PlaneStress<Real> stretched(const PlaneStress<Real>& s, const PlaneStrain<Real>& e) const
    {
        return {s.xx + plane_ * (e.xx + poisson_ * e.yy), s.yy + plane_ * (e.yy + poisson_ * e.xx), s.xy + shear_ * e.xy,
                s.yz + shear_ * e.yz, s.zx + shear_ * e.zx};
    }

    /// Elastic strain across the shell that goes with a change of stress. [1]
    template <class Real>
    [[nodiscard]] Real thickness_strain(const PlaneStress<Real>& before, const PlaneStress<Real>& after) const
    {
        return (-poisson_ / young_) * (after.xx - before.xx + after.yy - before.yy);
    }

private:
    double young_, poisson_, plane_, shear_;
};

/// What a point of a shell remembers.
template <class Real>
struct PlanePoint {
    PlaneStress<Real> stress;       ///< [Pa]
    PlaneStress<Real> back_stress;  ///< centre of the yield surface, as a plane stress [Pa]; only with kinematic hardening
    Real plastic_strain = 0.0;      ///< equivalent plastic strain [1]
    Real heat = 0.0;                ///< rise of temperature by plastic work [K]
    Real damage = 0.0;              ///< share of the strain at failure used up [1]
};

/// What a strength law tells of a strain increment besides the new stress.
template <class Real>
struct PlaneResponse {
    Real thickness_strain = 0.0;  ///< increment across the shell [1]
    Real plastic_work = 0.0;      ///< increment per volume [J/m3]
};

}  // namespace corpuscle
