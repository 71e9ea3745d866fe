#pragma once

#include <cmath>
#include <numbers>

#include "verification/gas/kinetics/mixture.hpp"

namespace corpuscle {

/// A charge burns in the middle of a rigid closed cube of 1 m3, in air or in nothing.
struct Vessel {
    EquationOfState law;
    double density = 1630;       ///< of the explosive [kg/m3]
    double energy = 7e9 / 1630;  ///< [J/kg]
    double expansion = 10;       ///< the vessel's volume over the charge's
    double air_density = 0;      ///< [kg/m3]; 0: no air
    std::size_t count = 10000;
    double duration = 15;  ///< in crossings of the vessel at the products' thermal speed
    std::uint64_t seed = 1;
};

/// Pressure on the walls over the law's at rest, all energy thermal and shared by all freedoms.
struct VesselFound {
    double pressure = 0, error = 0;
    double expected = 0;     ///< [Pa]
    double first_share = 1;  ///< of the products in all energy, over that of equilibrium
    std::uint64_t steps = 0;
};

inline Gas vessel(const Vessel& set)
{
    Gas gas;
    gas.domain.box = unit_box;
    gas.settings.seed = set.seed;
    const double volume = 1 / set.expansion;
    const Shape ball = Shape::sphere({0.5, 0.5, 0.5}, std::cbrt(0.75 * volume / std::numbers::pi));
    const bool air = set.air_density > 0;
    const double charge_mass = set.density * volume, air_mass = set.air_density * (1 - volume);
    const std::size_t products = air ? share_particles({charge_mass, air_mass}, set.count)[0] : set.count;
    gas.species.push_back(species_of(set.law, charge_mass / static_cast<double>(products)));
    gas.charges.push_back({"charge", 0, 6930, set.energy, set.density, {{{0.5, 0.5, 0.5}, 0}}});
    fill(gas, {ball, {}, 0, set.density, set.energy, {}, 0}, products);
    if (air) {
        gas.species.push_back(species_of(IdealGas{1.4}, air_mass / static_cast<double>(set.count - products)));
        fill(gas, {Shape::box(unit_box), {ball}, 1, set.air_density, 0.253e6 / 1.2, {}, -1}, set.count - products);
    }
    return gas;
}

/// Lets it burn and settle, then takes the pressure in ten parts of as long again.
inline VesselFound burn_in_vessel(const Vessel& set)
{
    Gas gas = vessel(set);
    const double crossing = 1 / std::sqrt(2 * set.energy * translational_share(heat_capacity_ratio(set.law)));
    Clock clock;
    while (clock.time() < set.duration * crossing) advance(gas, clock);
    const GasContents held = contents(gas);
    std::array<std::size_t, 2> count{};
    for (const Particle& p : gas.particles) ++count[particle_tag::species(p.tag)];
    const Shared expected = shared_equilibrium(gas, count, 1, held.gas.energy);
    std::vector<double> parts;
    const double start = clock.time();
    for (int part = 0; part < 10; ++part) {
        const double impulse = wall_impulse(gas), from = clock.time();
        while (clock.time() < start + set.duration * crossing * (part + 1) / 10) advance(gas, clock);
        parts.push_back((wall_impulse(gas) - impulse) / (6 * (clock.time() - from)) / expected.pressure);
    }
    const BatchMean mean(parts);
    VesselFound found{mean.mean, mean.error, expected.pressure};
    const auto [first, second] = energies(gas);
    found.first_share = first / (first + second) / expected.first;
    found.steps = clock.step();
    return found;
}

}  // namespace corpuscle
