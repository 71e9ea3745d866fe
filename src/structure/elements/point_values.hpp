#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "laws/strength/plane_stress.hpp"
#include "laws/strength/solid_stress.hpp"
#include "structure/elements/element_values.hpp"

namespace corpuscle {

/// Largest principal stress of a shell's point, its transverse shears left out. [Pa]
inline double largest_principal(const PlaneStress<double>& s)
{
    return std::max(0.5 * (s.xx + s.yy) + std::hypot(0.5 * (s.xx - s.yy), s.xy), 0.0);
}

/// Largest principal stress of a solid's point, from the invariants of its deviator. [Pa]
inline double largest_principal(const SolidStress<double>& s)
{
    const double mean = mean_stress(s), equivalent = von_mises(s);
    if (!(equivalent > 0)) return mean;
    const double x = s.xx - mean, y = s.yy - mean, z = s.zz - mean;
    const double determinant = x * (y * z - s.yz * s.yz) - s.xy * (s.xy * z - s.yz * s.zx) + s.zx * (s.xy * s.yz - y * s.zx);
    const double cosine = std::clamp(13.5 * determinant / (equivalent * equivalent * equivalent), -1.0, 1.0);
    return mean + (2.0 / 3.0) * equivalent * std::cos(std::acos(cosine) / 3.0);
}

inline double pressure_of(const PlaneStress<double>& s)
{
    return -(s.xx + s.yy) / 3.0;
}
inline double pressure_of(const SolidStress<double>& s)
{
    return -mean_stress(s);
}

/// What an element of `count` points shows; point_at(p) is one of them, lowest first.
template <class PointAt>
ElementValues values_of_points(int count, const PointAt& point_at)
{
    ElementValues v;
    for (int p = 0; p < count; ++p) {
        const auto at = point_at(p);
        const double stress = von_mises(at.stress), principal = largest_principal(at.stress);
        v.von_mises = std::max(v.von_mises, stress);
        v.plastic_strain = std::max(v.plastic_strain, at.plastic_strain);
        v.heat = std::max(v.heat, at.heat);
        v.least_plastic_strain = p == 0 ? at.plastic_strain : std::min(v.least_plastic_strain, at.plastic_strain);
        v.damage = p == 0 ? at.damage : std::min(v.damage, at.damage);
        v.principal_stress = p == 0 ? principal : std::min(v.principal_stress, principal);
        v.pressure += pressure_of(at.stress) / count;
        if (p == 0) v.von_mises_lower = stress;
        if (p == count / 2) v.von_mises_middle = stress;
        v.von_mises_upper = stress;
    }
    return v;
}

}  // namespace corpuscle
