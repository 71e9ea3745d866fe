#pragma once

#include <algorithm>
#include <cmath>

namespace corpuscle {

/// Displacement length of a collision whose sum over a step's collisions gives the virial pressure (consistent universal
/// Boltzmann algorithm; Alexander, Garcia and Alder, PRL 74 (1995) 5212): p_v = sum(mu |g' - g|) l/(6 V dt). [m]
template <class Real>
Real displacement_length(Real virial_pressure, Real volume, Real duration, Real velocity_change_sum)
{
    return 6 * virial_pressure * volume * duration / velocity_change_sum;
}

/// Mean relative speed of pairs of a Maxwellian gas of equal masses with this root mean square speed [m/s].
template <class Real>
Real mean_relative_speed(Real thermal_speed)
{
    return Real(1.3029400) * thermal_speed;  // 4/sqrt(3 pi)
}

/// Share of the momentum flux of displacements that later collisions of the same step leave. A particle that was displaced along
/// its new velocity and collides again before it has flown gives half of what is left of that velocity back to the place it came
/// from. With nu collisions of a particle a step, evenly spread, the mean of 2^-k over its later ones is (1 - exp(-nu/2))/(nu/2).
template <class Real>
Real surviving_displacement(Real collisions)
{
    const Real half = Real(0.5) * collisions;
    return half > Real(1e-3) ? -std::expm1(-half) / half : Real(1) - Real(0.5) * half;
}

/// Virial pressure of a law at the density of a cell of few particles, such that its mean over cells is the law's at the mean
/// density. The number of particles in a cell fluctuates by sqrt(n chi), chi = p_k/(dp/dln rho) at constant temperature (1 in an
/// ideal gas, small in a stiff one), and the law is convex: half its second difference over that width is taken off.
template <class Law, class Real>
Real mean_virial_pressure(const Law& law, Real density, Real kinetic_pressure, Real particles)
{
    const auto at = [&](Real factor) { return law.virial_pressure(density * factor, kinetic_pressure * factor); };
    const Real here = at(Real(1));
    if (!(here > 0) || !(kinetic_pressure > 0)) return here;
    constexpr Real probe = Real(0.05);
    const Real slope = (at(Real(1) + probe) - at(Real(1) - probe)) / (2 * probe);
    const Real width = std::min(Real(0.9), std::sqrt(kinetic_pressure / (std::max(Real(0), slope) + kinetic_pressure) / particles));
    return std::max(Real(0), Real(2) * here - Real(0.5) * (at(Real(1) + width) + at(Real(1) - width)));
}

}  // namespace corpuscle
