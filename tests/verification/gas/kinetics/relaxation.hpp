#pragma once

#include <cmath>
#include <numbers>

#include "unit/gas/gas_samples.hpp"

namespace corpuscle {

/// Rotational relaxation after Borgnakke and Larsen: gas at rest whose translation and rotation have temperatures of their own.
struct Relaxation {
    double gamma = 1.4;
    double relaxation = 2;       ///< collisions of a particle between two exchanges, Z
    double translational = 1e4;  ///< [K]
    double internal = 100;       ///< [K]
    std::size_t count = 100000;
    std::uint64_t seed = 1;
    bool to_the_end = true;  ///< follow it to equilibrium, not only for its rate
};

/// Rate at which the difference of the temperatures falls, per collision of a particle:
///     d(T_t - T_i)/dtau = -r (T_t - T_i),   r = (1 + zeta/3) 4/(Z (zeta + 4)) (1 - zeta/(2 Z (zeta + 4))).
/// A pair of hard spheres meets with a mean energy of 2 k T_t; a particle that exchanges holds zeta/(zeta + 4) of the common energy after
/// it. Of its partner, which draws after it, it has then changed the energy: the last factor. Exact where the velocities are Maxwellian.
inline double relaxation_rate(double internal_freedoms, double relaxation)
{
    const double zeta = internal_freedoms;
    return (1 + zeta / 3) * 4 / (relaxation * (zeta + 4)) * (1 - zeta / (2 * relaxation * (zeta + 4)));
}

/// What it shows.
struct RelaxationFound {
    double rate = 0, rate_error = 0;             ///< r measured, and its standard error
    double translational = 0, internal = 0;      ///< temperatures at last, averaged [K]
    double error = 0;                            ///< standard error of the translational one [K]
    double energy_error = 0;                     ///< relative, of the whole
    std::vector<double> collisions, difference;  ///< of a particle; of the temperatures over that at the start
};

/// Temperatures of translation and rotation, where unit temperature is one of energy per freedom and particle.
inline std::pair<double, double> temperatures(const Gas& gas)
{
    const double mass = gas.species[0].particle_mass, zeta = gas.species[0].internal_freedoms;
    double moving = 0, internal = 0;
    for (const Particle& p : gas.particles) {
        moving += mass * norm_squared(Vector3d(p.velocity)) / 3;
        internal += 2 * static_cast<double>(p.energy) / zeta;
    }
    const auto count = static_cast<double>(gas.particles.size());
    return {moving / count, internal / count};
}

/// Gas of molecules of nitrogen's mass, in lumps, at the two temperatures.
inline Gas gas_of_two_temperatures(const Relaxation& set)
{
    constexpr double gas_constant = 8.314462618 / 0.0280134;  // [J/(kg K)]
    Gas gas = filled_box(unit_box, IdealGas{set.gamma}, 1, gas_constant / (set.gamma - 1), set.count);
    gas.settings.relaxation = set.relaxation;
    gas.settings.seed = set.seed;
    const auto faster = static_cast<float>(std::sqrt(set.translational)), hotter = static_cast<float>(set.internal);
    for (Particle& p : gas.particles) {
        p.velocity = faster * p.velocity;
        p.energy *= hotter;
    }
    return gas;
}

/// Lets the temperatures come together; the rate is read where the difference falls from 0.9 to `left` of its start.
inline RelaxationFound relax(const Relaxation& set, double left = 0.1)
{
    constexpr double boltzmann = 8.314462618 / 0.0280134;
    Gas gas = gas_of_two_temperatures(set);
    const double zeta = gas.species[0].internal_freedoms, total = contents(gas).gas.energy,
                 kelvin = gas.species[0].particle_mass * boltzmann;
    const auto count = static_cast<double>(set.count);
    const double equilibrium = (3 * set.translational + zeta * set.internal) / (3 + zeta), start = set.translational - set.internal;
    RelaxationFound found;
    Clock clock;
    double first = 0, first_at = 0, last = 0, last_at = 0;
    const double slowest = relaxation_rate(zeta, set.relaxation);
    double looks = 0, settled = 0;
    for (;;) {
        advance(gas, clock);
        const auto [translation, rotation] = temperatures(gas);
        const double collisions = 2 * static_cast<double>(gas.collisions) / count, difference = (translation - rotation) / kelvin / start;
        found.collisions.push_back(collisions);
        found.difference.push_back(difference);
        if (first_at == 0 && difference < 0.9) first = difference, first_at = collisions;
        if (last_at == 0 && difference < left) last = difference, last_at = collisions;
        if (!set.to_the_end && last_at > 0) break;
        if (collisions * slowest < 10) continue;
        if (settled == 0) settled = collisions;
        found.translational += translation / kelvin;
        found.internal += rotation / kelvin;
        ++looks;
        if ((collisions - settled) * slowest > 20) break;
    }
    found.translational /= std::max(1.0, looks);
    found.internal /= std::max(1.0, looks);
    // Samples of equilibrium: of two freedoms' shares in a fixed energy; moments e-fold in 1/r, so 20 of them hold 10 new ones.
    const double share = 3 / (3 + zeta);
    found.error = equilibrium / share * std::sqrt(2 * share * (1 - share) / ((3 + zeta) * count) / 10);
    found.rate = std::log(first / last) / (last_at - first_at);
    const double spread = equilibrium / start * std::sqrt((2 / 3.0 + 2 / zeta) / count);  // of the difference, at equilibrium
    found.rate_error = spread * std::sqrt(1 - std::pow(last / first, 2)) / last / (last_at - first_at);
    found.energy_error = contents(gas).gas.energy / total - 1;
    return found;
}

}  // namespace corpuscle
