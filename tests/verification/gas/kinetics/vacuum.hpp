#pragma once

#include <cmath>

#include "unit/gas/gas_samples.hpp"
#include "verification/gas/kinetics/line_fit.hpp"

namespace corpuscle {

/// Gas at rest in the lower end of a tube whose rest is empty. The rarefaction's edge flies at 2 c0 (1 - phi0)/(gamma - 1) =
/// 2 s0/(gamma - 1), s = sqrt(gamma (gamma - 1) e): no co-volume in it. In the fan u + 2 s/(gamma - 1) is that speed everywhere.
struct VacuumTube {
    double gamma = 1.4;
    double filled = 0;      ///< phi0, share of the gas's volume that its molecules keep for themselves
    double length = 80;     ///< of the gas [spacings]
    double width = 20;      ///< of the tube [spacings]
    double duration = 0.9;  ///< of the time that the rarefaction's head takes to the tube's end
    std::uint64_t seed = 1;
};

/// Escape speed over theory, read in two ways.
struct Escape {
    double edge = 0;        ///< from velocities alone: where the straight line of u against q, the power of the mass ahead that it falls
                            ///< with, comes to q = 0
    double edge_error = 0;  ///< its standard error, from the scatter about the line
    double invariant = 0;   ///< from velocities and heat: mean of u + 2 s/(gamma - 1)
    std::size_t slices = 0;
    std::vector<double> ahead, velocity, heat_speed;  ///< q, u over the escape speed, s over s0 of the slices
};

/// Flow velocity and thermal energy of neighbours along x: the velocity's own slope across the slice is not heat.
struct Slice {
    double velocity = 0, energy = 0;

    Slice(const std::vector<Particle>& sorted, std::size_t from, std::size_t to, double mass)
    {
        const auto n = static_cast<double>(to - from);
        double x = 0, xx = 0, xu = 0, uu = 0, rest = 0, y = 0, z = 0;
        const double x0 = static_cast<double>(sorted[from].position.x);
        for (std::size_t i = from; i < to; ++i) {
            const Vector3d v(sorted[i].velocity);
            const double dx = static_cast<double>(sorted[i].position.x) - x0;
            x += dx / n, velocity += v.x / n, xx += dx * dx / n, xu += dx * v.x / n, uu += v.x * v.x / n;
            y += v.y / n, z += v.z / n;
            rest += (0.5 * (v.y * v.y + v.z * v.z) + static_cast<double>(sorted[i].energy) / mass) / n;
        }
        const double slope = (xu - x * velocity) / (xx - x * x);
        const double about = uu - velocity * velocity - slope * slope * (xx - x * x);
        energy = 0.5 * about * n / (n - 2) + rest - 0.5 * (y * y + z * z);
    }
};

/// Reads the edge's speed from the fan. The mass m ahead of a place in it is m0 s^((gamma + 1)/(gamma - 1)), m0 = rho0 c0 t, and
/// u = 2 (s0 - s)/(gamma - 1): u falls in a straight line with q = (m/m0)^((gamma - 1)/(gamma + 1)) = s/s0. Neither the corner at the head
/// is taken, which viscosity rounds, nor the foremost particles, which no longer collide.
inline Escape read_edge(const Gas& gas, const VacuumTube& set, double limit)
{
    std::vector<Particle> sorted = gas.particles;
    std::sort(sorted.begin(), sorted.end(), [](const Particle& a, const Particle& b) { return a.position.x > b.position.x; });
    const auto all = static_cast<double>(sorted.size());
    const std::size_t each = sorted.size() / 400;
    Escape found;
    LineFit line;
    for (std::size_t from = 0; from + each <= sorted.size(); from += each) {
        const Slice slice(sorted, from, from + each, 1);
        const double mass = (static_cast<double>(from) + 0.5 * static_cast<double>(each)) / all / set.duration;
        const double q = std::pow(mass, (set.gamma - 1) / (set.gamma + 1)), u = slice.velocity / limit;
        if (q < 0.35 || q > 0.92) continue;
        found.ahead.push_back(q);
        found.velocity.push_back(u);
        found.heat_speed.push_back(std::sqrt(slice.energy));
        found.invariant += u + found.heat_speed.back();
        line.add(q, u);
    }
    found.slices = found.ahead.size();
    found.invariant /= static_cast<double>(found.slices);
    found.edge = line.at_zero();
    found.edge_error = line.error_at_zero();
    return found;
}

/// Lets the gas out and reads the edge's speed from the fan.
inline Escape escape(const VacuumTube& set)
{
    const NobleAbel law{set.gamma, set.filled, 1};
    constexpr double energy = 1;
    const double s0 = std::sqrt(set.gamma * (set.gamma - 1) * energy), limit = 2 * s0 / (set.gamma - 1);
    const double end = set.duration * set.length * (1 - set.filled) / s0;
    Gas gas;
    gas.domain = {{{0, 0, 0}, {set.length + 1.5 * limit * end, set.width, set.width}}, {}};
    gas.domain.edges[1] = Edge::open;
    gas.species.push_back(species_of(law, 1));
    gas.settings.seed = set.seed;
    const Box box{{0, 0, 0}, {set.length, set.width, set.width}};
    fill(gas, {Shape::box(box), {}, 0, 1, energy, {}, -1}, static_cast<std::size_t>(box.volume()));
    Clock clock;
    while (clock.time() < end) advance(gas, clock, end - clock.time() + 1e-9);

    return read_edge(gas, set, limit);
}

}  // namespace corpuscle
