#pragma once

#include <cmath>
#include <numbers>

#include "unit/gas/gas_samples.hpp"

namespace corpuscle {

/// Two gases in one closed box: each fills all of it, with its own law, density and particle mass; the second starts hotter or colder.
struct Mixture {
    std::array<EquationOfState, 2> law{IdealGas{1.4}, IdealGas{1.4}};
    std::array<double, 2> density{1, 1};             ///< partial, at the start [kg/m3]
    std::array<double, 2> energy{1, 1};              ///< specific, at the start [J/kg]
    std::array<std::size_t, 2> count{10000, 10000};  ///< particles: with the densities they set the particle masses
    std::uint64_t seed = 1;
    GasSettings settings = {};
};

/// What they share at equilibrium: every freedom of every particle has the same energy, and each gas the pressure of its own law at its
/// own partial density (Dalton).
struct Shared {
    double pressure = 0;              ///< on the walls [Pa]
    std::array<double, 2> partial{};  ///< of each gas [Pa]
    double first = 0;                 ///< share of the first gas in all energy [1]
};

/// Energy per two freedoms, k T of a lump, of gases with so many particles [J].
inline double lump_temperature(const Gas& gas, const std::array<std::size_t, 2>& count, double energy)
{
    double halves = 0;
    for (std::size_t s = 0; s < gas.species.size(); ++s)
        halves += 0.5 * static_cast<double>(count[s]) * (3 + gas.species[s].internal_freedoms);
    return energy / halves;
}

inline Shared shared_equilibrium(const Gas& gas, const std::array<std::size_t, 2>& count, double volume, double energy)
{
    Shared shared;
    const double temperature = lump_temperature(gas, count, energy);
    for (std::size_t s = 0; s < gas.species.size(); ++s) {
        const auto particles = static_cast<double>(count[s]);
        const double kinetic = particles * temperature / volume, density = particles * gas.species[s].particle_mass / volume;
        shared.partial[s] = kinetic + virial_pressure(gas.species[s].law, density, kinetic);
        shared.pressure += shared.partial[s];
    }
    shared.first = 0.5 * static_cast<double>(count[0]) * (3 + gas.species[0].internal_freedoms) * temperature / energy;
    return shared;
}

/// Impulse that all rigid faces have got [N s].
inline double wall_impulse(const Gas& gas)
{
    double sum = 0;
    for (int face = 0; face < face_count; ++face) sum += std::abs(gas.passages.face[face].momentum[face / 2]);
    return sum;
}

/// Energy of each species [J].
inline std::array<double, 2> energies(const Gas& gas)
{
    std::array<double, 2> sum{};
    for (const Particle& p : gas.particles) {
        const std::uint32_t s = particle_tag::species(p.tag);
        sum[s] += 0.5 * gas.species[s].particle_mass * norm_squared(Vector3d(p.velocity)) + static_cast<double>(p.energy);
    }
    return sum;
}

inline Gas mixture(const Mixture& set)
{
    Gas gas;
    gas.domain.box = unit_box;
    gas.settings = set.settings;
    gas.settings.seed = set.seed;
    for (int s = 0; s < 2; ++s) gas.species.push_back(species_of(set.law[s], set.density[s] / static_cast<double>(set.count[s])));
    for (std::uint32_t s = 0; s < 2; ++s) fill(gas, {Shape::box(unit_box), {}, s, set.density[s], set.energy[s], {}, -1}, set.count[s]);
    return gas;
}

/// A mean over batches and its standard error.
struct BatchMean {
    double mean = 0, error = 0;

    explicit BatchMean(const std::vector<double>& batches)
    {
        const Statistics statistics(batches);
        mean = statistics.mean;
        error = statistics.error() * std::sqrt(statistics.count / (statistics.count - 1));
    }
};

/// What a mixture shows once it has settled: means over batches, and whether the split still moves.
struct Mixed {
    double pressure = 0, pressure_error = 0;  ///< on the walls, over Dalton's
    double split = 0, split_error = 0;        ///< the first gas's share of energy, over equipartition's
    double drift = 0, drift_error = 0;        ///< of that ratio, from the first half of the time to the second
    double energy_error = 0;                  ///< relative
    double momentum_error = 0;                ///< of sqrt(2 M E), walls' impulse included
    double collisions = 0;                    ///< of a particle
    bool counts_kept = true;
};

/// Lets the mixture settle for `settle` steps, then looks at it for `batches` times `each` steps.
inline Mixed mix(const Mixture& set, int settle, int batches, int each)
{
    Gas gas = mixture(set);
    const Passage before = contents(gas).gas;
    const Shared expected = shared_equilibrium(gas, set.count, 1, before.energy);
    Clock clock;
    for (int i = 0; i < settle; ++i) advance(gas, clock);
    std::vector<double> pressures, splits;
    for (int b = 0; b < batches; ++b) {
        const double impulse = wall_impulse(gas), start = clock.time();
        double split = 0;
        for (int i = 0; i < each; ++i) {
            advance(gas, clock);
            const auto [first, second] = energies(gas);
            split += first / (first + second) / expected.first / each;
        }
        pressures.push_back((wall_impulse(gas) - impulse) / (6 * (clock.time() - start)) / expected.pressure);
        splits.push_back(split);
    }
    const BatchMean pressure(pressures), split(splits);
    const auto half = splits.begin() + batches / 2;
    const BatchMean early({splits.begin(), half}), late({half, splits.end()});
    const Passage after = contents(gas).gas;
    Passage given;
    for (const Passage& passage : gas.passages.face) given += passage;
    Mixed found{pressure.mean, pressure.error, split.mean, split.error, late.mean - early.mean, std::hypot(early.error, late.error)};
    found.energy_error = after.energy / before.energy - 1;
    found.momentum_error = norm(after.momentum + given.momentum - before.momentum) / std::sqrt(2 * before.mass * before.energy);
    found.collisions = 2 * static_cast<double>(gas.collisions) / static_cast<double>(gas.particles.size());
    std::array<std::size_t, 2> count{};
    for (const Particle& p : gas.particles) ++count[particle_tag::species(p.tag)];
    found.counts_kept = count == set.count && std::abs(after.mass / before.mass - 1) < 1e-12;
    return found;
}

/// Collisions of a particle until the difference of two ideal gases' temperatures has fallen to 1/e.
inline double collisions_to_equal_temperatures(const Mixture& set)
{
    Gas gas = mixture(set);
    const auto difference = [&] {
        const std::array<double, 2> energy = energies(gas);
        std::array<double, 2> temperature{};
        for (int s = 0; s < 2; ++s)
            temperature[s] = energy[s] / (static_cast<double>(set.count[s]) * (3 + gas.species[s].internal_freedoms));
        return temperature[0] - temperature[1];
    };
    const double start = difference();
    Clock clock;
    while (std::abs(difference()) > std::abs(start) / std::numbers::e && clock.step() < 200000) advance(gas, clock);
    return 2 * static_cast<double>(gas.collisions) / static_cast<double>(gas.particles.size());
}

}  // namespace corpuscle
