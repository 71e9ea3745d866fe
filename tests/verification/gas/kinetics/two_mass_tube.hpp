#pragma once

#include <cmath>

#include "laws/riemann/riemann.hpp"
#include "unit/gas/gas_samples.hpp"

namespace corpuscle {

/// Sod's tube, ideal gas gamma 1.4, whose two halves have particles of different mass; the whole number is the same, and Euler's
/// solution does not know of it.
struct TwoMassTube {
    double ratio = 1;  ///< particle mass of the dense, hot half over that of the thin one
    std::size_t count = 40000;
    double end = 0.18;  ///< [s] in a tube of 1 m
    std::uint64_t seed = 1;
};

/// L1 errors over Euler's solution (whole tube) and how deep the gases have mixed.
struct TubeErrors {
    double density = 0, velocity = 0, pressure = 0;
    double mixing = 0;   ///< integral of 4 f (1 - f), f the mass share of the dense half's gas [m]
    double contact = 0;  ///< where the mass shares are even, less Euler's contact [m]
    double warmth = 0;   ///< greatest ratio of the two gases' temperatures where both are, over 1
    std::uint64_t steps = 0;
};

/// Sums of one slab and species.
struct SlabSums {
    double mass = 0, momentum = 0, energy = 0, count = 0;
};

inline TubeErrors run_two_mass_tube(const TwoMassTube& set)
{
    constexpr double width = 0.12;
    constexpr int bins = 60;
    Gas gas;
    gas.domain.box = {{0, 0, 0}, {1, width, width}};
    gas.settings.seed = set.seed;
    const double area = width * width, dense = 0.5 * area, thin = 0.125 * 0.5 * area;
    // m0 N0 = dense, m1 N1 = thin, m0 = ratio m1, N0 + N1 = count.
    const double light = (dense / set.ratio + thin) / static_cast<double>(set.count);
    gas.species = {species_of(IdealGas{1.4}, set.ratio * light), species_of(IdealGas{1.4}, light)};
    const std::array<std::size_t, 2> count{static_cast<std::size_t>(std::lround(dense / (set.ratio * light))),
                                           static_cast<std::size_t>(std::lround(thin / light))};
    gas.species[0].particle_mass = dense / static_cast<double>(count[0]);
    gas.species[1].particle_mass = thin / static_cast<double>(count[1]);
    fill(gas, {Shape::box({{0, 0, 0}, {0.5, width, width}}), {}, 0, 1, 2.5, {}, -1}, count[0]);
    fill(gas, {Shape::box({{0.5, 0, 0}, {1, width, width}}), {}, 1, 0.125, 2.0, {}, -1}, count[1]);
    Clock clock;
    while (clock.time() < set.end * (1 - 1e-9)) advance(gas, clock, set.end - clock.time());

    std::array<std::array<SlabSums, 2>, bins> slab{};
    for (const Particle& p : gas.particles) {
        const std::uint32_t s = particle_tag::species(p.tag);
        const double mass = gas.species[s].particle_mass;
        const int bin = std::clamp(static_cast<int>(static_cast<double>(p.position.x) * bins), 0, bins - 1);
        SlabSums& own = slab[bin][s];
        own.mass += mass;
        own.momentum += mass * static_cast<double>(p.velocity.x);
        own.energy += 0.5 * mass * norm_squared(Vector3d(p.velocity)) + static_cast<double>(p.energy);
        own.count += 1;
    }
    const RiemannSolution exact({1, 0, 1, 1.4, 0}, {0.125, 0, 0.1, 1.4, 0});
    TubeErrors found;
    found.steps = clock.step();
    double pushed = 0;
    for (int b = 0; b < bins; ++b) {
        const SlabSums &a = slab[b][0], &c = slab[b][1];
        const double mass = a.mass + c.mass, volume = area / bins, u = (a.momentum + c.momentum) / mass;
        const double pressure = 0.4 * (a.energy + c.energy - 0.5 * mass * u * u) / volume;
        RiemannSide mean{0, 0, 0, 1.4, 0};
        constexpr int points = 20;
        for (int k = 0; k < points; ++k) {
            const RiemannSide at = exact.at((((b + (k + 0.5) / points) / bins) - 0.5) / set.end);
            mean.density += at.density / points, mean.velocity += at.density * at.velocity / points, mean.pressure += at.pressure / points;
        }
        found.density += std::abs(mass / volume - mean.density) / bins;
        found.velocity += std::abs(u - mean.velocity / mean.density) / bins;
        found.pressure += std::abs(pressure - mean.pressure) / bins;
        const double share = a.mass / mass;
        found.mixing += 4 * share * (1 - share) / bins;
        pushed += share / bins;
        if (a.count > 200 && c.count > 200) {
            const double hot = (a.energy - 0.5 * a.momentum * a.momentum / a.mass) / a.count;
            const double cold = (c.energy - 0.5 * c.momentum * c.momentum / c.mass) / c.count;
            found.warmth = std::max(found.warmth, std::abs(std::log(hot / cold)));
        }
    }
    found.contact = pushed - 0.5 - exact.star_velocity() * set.end;
    return found;
}

}  // namespace corpuscle
