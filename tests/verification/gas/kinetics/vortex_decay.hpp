#pragma once

#include <cmath>
#include <numbers>

#include "unit/gas/gas_samples.hpp"

namespace corpuscle {

/// Viscosity of the particle gas from a vortex that decays (Taylor and Green 1937), between mirrors:
///     u = A sin(k x) cos(k y), v = -A cos(k x) sin(k y), k = pi/side, A ~ exp(-2 nu k^2 t).
struct VortexDecay {
    double mean_free_path = 1;  ///< kappa [spacings]
    double side = 40;           ///< of the square, in spacings
    double height = 40;         ///< in spacings
    double gamma = 5.0 / 3;     ///< monatomic: no internal freedoms
    double mach = 0.3;          ///< A at the start, over the speed of sound
    std::uint64_t seed = 1;
    std::uint32_t cell_limit = 16;
    double cfl = 0.4;
    std::uint32_t partners = 1;
};

/// What the vortex shows. Speeds in sigma, the deviation of a velocity component; lengths in spacings.
struct VortexFound {
    double viscosity = 0;      ///< nu/(sigma spacing)
    double error = 0;          ///< one standard error of it
    double kinetic = 0;        ///< what hard spheres of that mean free path have (Chapman and Enskog) at the rate of collisions counted
    double cells = 0;          ///< what partners at a distance add, from the pairs' mean squared distance along an axis
    double path = 0;           ///< mean free path counted, in spacings
    double pair_distance = 0;  ///< mean squared distance of partners along one axis, in spacings squared
    double rate = 0;           ///< collisions of a particle and step
    std::uint64_t steps = 0;

    [[nodiscard]] double expected() const { return kinetic + cells; }
};

/// nu of hard spheres, 5 sqrt(2 pi)/16 lambda sigma, over lambda sigma: Chapman and Cowling, first approximation, and the factor 1.016034
/// of the whole series.
inline constexpr double hard_sphere_viscosity = 1.016034 * 0.78333;

/// Mean squared distance along one axis of partners drawn at random from cells: L^2/6 of each axis, pairs weighted as they are drawn [m2].
inline double pair_distance_squared(const Gas& gas)
{
    double sum = 0, weight = 0;
    for (const Cell& cell : gas.cells.cells) {
        if (cell.count < 2) continue;
        const Vector3d size = gas.cells.curve.cell(0, static_cast<int>(cell.depth)).size();
        // Pairs drawn: (n - 1)/(V/n)^(1/3).
        const double drawn = (cell.count - 1.0) * std::cbrt(cell.count / gas.cells.curve.volume(static_cast<int>(cell.depth)));
        sum += drawn * (size.x * size.x + size.y * size.y) / 12;
        weight += drawn;
    }
    return sum / weight;
}

/// Gas in a box of mirrors with the vortex on it; the spacing is 1 m, the density 1 kg/m3, sigma 1 m/s.
inline Gas vortex(const VortexDecay& set)
{
    const Box box{{0, 0, 0}, {set.side, set.side, set.height}};
    Gas gas = filled_box(box, IdealGas{set.gamma}, 1, 1 / (set.gamma - 1), static_cast<std::size_t>(box.volume()));
    gas.settings.mean_free_path = set.mean_free_path;
    gas.settings.seed = set.seed;
    gas.settings.cell_limit = set.cell_limit;
    gas.settings.cfl = set.cfl;
    gas.settings.partners = set.partners;
    const double k = std::numbers::pi / set.side, amplitude = set.mach * std::sqrt(set.gamma);
    for (Particle& p : gas.particles) {
        const double x = k * static_cast<double>(p.position.x), y = k * static_cast<double>(p.position.y);
        p.velocity.x += static_cast<float>(amplitude * std::sin(x) * std::cos(y));
        p.velocity.y -= static_cast<float>(amplitude * std::cos(x) * std::sin(y));
    }
    return gas;
}

/// Amplitude of the vortex [m/s]: the velocities' share in its pattern, whose mean square is 1/2.
inline double vortex_amplitude(const Gas& gas, double side)
{
    const double k = std::numbers::pi / side;
    double sum = 0;
    for (const Particle& p : gas.particles) {
        const double x = k * static_cast<double>(p.position.x), y = k * static_cast<double>(p.position.y);
        sum +=
            static_cast<double>(p.velocity.x) * std::sin(x) * std::cos(y) - static_cast<double>(p.velocity.y) * std::cos(x) * std::sin(y);
    }
    return 2 * sum / static_cast<double>(gas.particles.size());
}

/// Lets the vortex decay to `left` of what it was once it has settled.
inline VortexFound decay(const VortexDecay& set, double settled = 0.9, double left = 0.35)
{
    Gas gas = vortex(set);
    const double start = vortex_amplitude(gas, set.side), k = std::numbers::pi / set.side;
    const auto count = static_cast<double>(gas.particles.size());
    VortexFound found;
    Clock clock;
    double first = 0, last = start, travelled = 0, distance = 0;
    std::uint64_t collisions = 0;
    while (last > left * start) {
        advance(gas, clock);
        last = vortex_amplitude(gas, set.side);
        if (first == 0) {
            if (last < settled * start) first = last, collisions = gas.collisions;
            continue;
        }
        // The gas warms as the vortex decays: time is counted in sigma, which the energy that is left over gives.
        const double sigma = std::sqrt(1 + (set.gamma - 1) / 4 * (start * start - last * last));
        travelled += sigma * clock.duration();
        distance += pair_distance_squared(gas);
        ++found.steps;
    }
    const auto steps = static_cast<double>(found.steps);
    const double each = 2 * static_cast<double>(gas.collisions - collisions) / count;  // of a particle
    found.viscosity = std::log(first / last) / (2 * k * k * travelled);
    found.error = std::sqrt(2 / count * (1 - std::pow(last / first, 2))) / last / (2 * k * k * travelled);
    found.path = std::sqrt(8 / std::numbers::pi) * travelled / each;
    found.rate = each / steps;
    found.pair_distance = distance / steps;
    found.kinetic = hard_sphere_viscosity * found.path;
    found.cells = std::sqrt(8 / std::numbers::pi) / 3 * found.pair_distance / found.path;
    return found;
}

}  // namespace corpuscle
