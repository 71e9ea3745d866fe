#pragma once

#include <vector>

#include "../../unit/gas/gas_samples.hpp"
#include "gas/hard_spheres.hpp"
#include "laws/collision/hard_spheres.hpp"

namespace corpuscle {

/// A closed cube of 1 m full of hard spheres.
struct SphereBoxCase {
    double packing = 0.1;
    double gamma = 5.0 / 3;
    double cfl = 0.4;
    std::size_t count = 20000;
    int warm_steps = 200;
    int steps_a_batch = 40;
    int batches = 16;
};

/// A mean over batches and its standard error.
struct Measured {
    double mean = 0, error = 0;
};

/// What was measured, pressures over that of the same gas without radius.
struct SphereBox {
    double packing_middle = 0;  ///< in the middle of the box: at the walls spheres stand closer
    double law = 0;             ///< expected: see `expected_pressure`
    Measured wall, bounces;     ///< by the impulse of the walls; by the number of bounces between spheres
    Measured translational;     ///< share of the energy
    double met_a_step = 0;      ///< bounces of a sphere in a step
    double energy_error = 0;    ///< relative
};

/// Surface tension of hard spheres at a wall that their centres bounce off, times D^2/kT (scaled particle theory; Reiss, Frisch,
/// Helfand and Lebowitz, J. Chem. Phys. 32 (1960) 119). Its first term, -(9/2 pi) f^2, is exact: a sphere at the wall has
/// less space taken from it by others.
inline double wall_tension(double packing)
{
    return -4.5 / std::numbers::pi * packing * packing * (1 + packing) / std::pow(1 - packing, 3);
}

/// Spheres gathered at such a wall, times D^2: -d(tension)/d(chemical potential), with n d(potential) = d(pressure) (Gibbs).
inline double wall_excess(double packing)
{
    const double step = 1e-5, above = packing + step, below = packing - step;
    const double pressure_slope = (above * carnahan_starling(above) - below * carnahan_starling(below)) / (2 * step);
    return -(wall_tension(above) - wall_tension(below)) / (2 * step) * packing / pressure_slope;
}

/// Pressure on the walls of the closed unit cube over that of the same gas without radius: six walls take N_w = 6 excess/D^2 of the
/// spheres, the others have the law's pressure, and the walls of a cube that grows get p - tension dA/dV = p - 4 tension/L. Edges
/// (second order in D/L) are left out.
inline double expected_pressure(double packing, std::size_t count)
{
    const double n = static_cast<double>(count), squared = std::pow(6 * packing / std::numbers::pi / n, 2.0 / 3);
    double middle = packing;
    for (int i = 0; i < 100; ++i) middle = packing * (1 - 6 * wall_excess(middle) / squared / n);
    return middle / packing * carnahan_starling(middle) - 4 * wall_tension(middle) / squared / n;
}

inline Gas sphere_box(const SphereBoxCase& wanted)
{
    constexpr double energy_per_mass = 1e6;
    Gas gas = filled_box(unit_box, IdealGas{wanted.gamma}, 1, energy_per_mass, wanted.count);
    gas.settings.rule = CollisionRule::hard_spheres;
    gas.settings.cfl = wanted.cfl;
    gas.species[0].radius = std::cbrt(wanted.packing / (4 * std::numbers::pi / 3) / static_cast<double>(wanted.count));
    return gas;
}

inline Measured batch_mean(const std::vector<double>& values)
{
    const Statistics s(values);
    return {s.mean, s.error() * std::sqrt(s.count / (s.count - 1))};
}

inline double translational_energy(const Gas& gas)
{
    double sum = 0;
    for (const Particle& p : gas.particles) sum += 0.5 * gas.species[0].particle_mass * norm_squared(Vector3d(p.velocity));
    return sum;
}

inline double count_in_middle(const Gas& gas)
{
    double count = 0;
    for (const Particle& p : gas.particles)
        if (std::max({std::abs(p.position.x - 0.5f), std::abs(p.position.y - 0.5f), std::abs(p.position.z - 0.5f)}) < 0.3f) count += 1;
    return count;
}

inline double wall_impulse(const Gas& gas)
{
    double sum = 0;
    for (int face = 0; face < face_count; ++face) sum += std::abs(gas.passages.face[face].momentum[face / 2]);
    return sum;
}

/// Runs the box. The virial of a bounce is J D, with J = 2 mu g_n; at equilibrium the mean of J over bounces is sqrt(2 pi mu kT), with
/// or without exchange of internal energy, so their number gives p_v = N D sqrt(2 pi mu kT)/(3 V t).
inline SphereBox measure_box(const SphereBoxCase& wanted)
{
    Gas gas = sphere_box(wanted);
    const double energy = contents(gas).gas.energy, mass = gas.species[0].particle_mass, n = static_cast<double>(wanted.count);
    Clock clock;
    for (int i = 0; i < wanted.warm_steps; ++i) advance(gas, clock);
    std::vector<double> wall, bounces, middle, translational;
    const std::uint64_t met_before = gas.collisions;
    for (int b = 0; b < wanted.batches; ++b) {
        const double start = clock.time(), impulse = wall_impulse(gas);
        const std::uint64_t met = gas.collisions;
        double moving = 0;
        for (int i = 0; i < wanted.steps_a_batch; ++i) {
            advance(gas, clock);
            middle.push_back(count_in_middle(gas));
            moving += translational_energy(gas) / wanted.steps_a_batch;
        }
        const double duration = clock.time() - start, kinetic = 2 * moving / 3, temperature = kinetic / n;
        wall.push_back((wall_impulse(gas) - impulse) / (6 * duration) / kinetic);
        const double virial = static_cast<double>(gas.collisions - met) * 2 * gas.species[0].radius *
                              std::sqrt(std::numbers::pi * mass * temperature) / (3 * duration);
        bounces.push_back(1 + virial / kinetic);
        translational.push_back(moving / energy);
    }
    SphereBox box;
    box.packing_middle = wanted.packing * Statistics(middle).mean / (0.6 * 0.6 * 0.6) / n;
    box.law = expected_pressure(wanted.packing, wanted.count);
    box.wall = batch_mean(wall);
    box.bounces = batch_mean(bounces);
    box.translational = batch_mean(translational);
    box.met_a_step = 2 * static_cast<double>(gas.collisions - met_before) / n / (wanted.batches * wanted.steps_a_batch);
    box.energy_error = contents(gas).gas.energy / energy - 1;
    return box;
}

}  // namespace corpuscle
