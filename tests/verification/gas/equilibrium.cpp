#include <gtest/gtest.h>

#include <cstdio>

#include "../../unit/gas/gas_samples.hpp"

namespace corpuscle {
namespace {

constexpr std::size_t count = 20000;
constexpr int snapshots = 6;

/// Gas as far from equilibrium as can be: two beams along x, nothing within, all at the places of a quiet start.
Gas beams(double gamma)
{
    Gas gas = filled_box(unit_box, IdealGas{gamma}, 1, 2e5, count);
    const float speed = std::sqrt(2 * 2e5f);
    for (std::size_t i = 0; i < count; ++i) {
        gas.particles[i].velocity = {i % 2 == 0 ? speed : -speed, 0, 0};
        gas.particles[i].energy = 0;
    }
    return gas;
}

/// Moments that a gas shows, averaged over moments of time far enough apart to be new ones.
struct Shown {
    double share = 0;                              ///< translational, of all energy
    std::array<double, 3> variance{}, kurtosis{};  ///< of each component, variance over 2/3 of the translational energy a mass
    double internal_variance = 0;                  ///< over the square of the mean

    void add(const Gas& gas)
    {
        const double mass = gas.species[0].particle_mass;
        double moving = 0;
        std::vector<double> internal;
        for (const Particle& p : gas.particles) {
            moving += 0.5 * mass * norm_squared(Vector3d(p.velocity));
            internal.push_back(static_cast<double>(p.energy));
        }
        const Statistics energy(internal);
        share += moving / (moving + energy.mean * energy.count) / snapshots;
        if (energy.mean > 0) internal_variance += energy.variance / (energy.mean * energy.mean) / snapshots;
        const double each = 2 * moving / (3 * mass * energy.count);
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<double> component;
            for (const Particle& p : gas.particles) component.push_back(static_cast<double>(p.velocity[axis]));
            variance[axis] += Statistics(component).variance / each / snapshots;
            kurtosis[axis] += Statistics(component).kurtosis / snapshots;
        }
    }
};

/// A particle collides 0.15 times a step (the step is that of the quickest cell); the slowest of the moments loses a factor of e within
/// about 4 collisions (relaxation number 2). 300 steps leave 1e-5 of the start, 60 make moments new to a tenth. Bounds are 4 sigma of the
/// sampled equilibrium: share: Beta(3N/2, zeta N/2); variance of a component, their sum given: 2/N (1 - 1/3) of its square; kurtosis 24/N;
/// variance of Gamma(k): (2 + 6/k)/N of its square; each over the snapshots, of which a tenth is not new. Nothing else is allowed for: the
/// method has the laws of equilibrium exactly, whatever the step and the cells.
void relax(double gamma)
{
    Gas gas = beams(gamma);
    const double total = contents(gas).gas.energy;
    Clock clock;
    for (int i = 0; i < 300; ++i) advance(gas, clock);
    const double rate = 2 * static_cast<double>(gas.collisions) / static_cast<double>(count) / 300;
    ASSERT_GT(rate, 0.14);
    Shown shown;
    for (int i = 0; i < snapshots; ++i) {
        for (int k = 0; k < 60; ++k) advance(gas, clock);
        shown.add(gas);
    }
    const double xi = translational_share(gamma), zeta = gas.species[0].internal_freedoms;
    const double samples = static_cast<double>(count) * snapshots / 1.2;
    const double share_sigma = std::sqrt(2 * xi * (1 - xi) / (3 + zeta) / samples);
    std::printf(
        "gamma %.3f: share %.5f (%.5f, sigma %.5f), kurtosis %.4f %.4f %.4f (sigma %.4f), component variances %.4f %.4f %.4f, "
        "internal variance %.4f (%.4f), collisions a particle and step %.3f\n",
        gamma, shown.share, xi, share_sigma, shown.kurtosis[0], shown.kurtosis[1], shown.kurtosis[2], std::sqrt(24 / samples),
        shown.variance[0], shown.variance[1], shown.variance[2], shown.internal_variance, zeta > 0 ? 2 / zeta : 0.0, rate);
    EXPECT_NEAR(shown.share, xi, 4 * share_sigma + 1e-6);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(shown.variance[axis], 1, 4 * std::sqrt(4.0 / 3 / samples)) << "axis " << axis;
        EXPECT_NEAR(shown.kurtosis[axis], 3, 4 * std::sqrt(24 / samples)) << "axis " << axis;
    }
    if (zeta > 1e-9) {
        EXPECT_NEAR(shown.internal_variance, 2 / zeta, 4 * 2 / zeta * std::sqrt((2 + 12 / zeta) / samples));
    }
    EXPECT_NEAR(contents(gas).gas.energy, total, 1e-6 * total);
}

TEST(Equilibrium, gamma_1_2)
{
    relax(1.2);
}
TEST(Equilibrium, gamma_1_3)
{
    relax(1.3);
}
TEST(Equilibrium, gamma_1_4)
{
    relax(1.4);
}
TEST(Equilibrium, gamma_5_3)
{
    relax(5.0 / 3);
}

/// Unlike masses share the same temperature: each species has 3/2 N kT of motion and zeta/2 N kT within, from a start where one has
/// everything. The share of one species' motion in all energy is Beta distributed by the freedoms.
TEST(Equilibrium, unlike_masses_come_to_one_temperature)
{
    Gas gas = filled_box(unit_box, IdealGas{1.4}, 1, 2e5, count / 2);
    gas.species.push_back(species_of(IdealGas{1.3}, 10 * gas.species[0].particle_mass));
    fill(gas, {Shape::box(unit_box), {}, 1, 10, 1, {}, -1}, count / 2);
    Clock clock;
    for (int i = 0; i < 600; ++i) advance(gas, clock);
    std::array<double, 2> moving{}, internal{};
    for (int look = 0; look < snapshots; ++look) {
        for (int k = 0; k < 60; ++k) advance(gas, clock);
        for (const Particle& p : gas.particles) {
            const std::uint32_t s = particle_tag::species(p.tag);
            moving[s] += 0.5 * gas.species[s].particle_mass * norm_squared(Vector3d(p.velocity)) / snapshots;
            internal[s] += static_cast<double>(p.energy) / snapshots;
        }
    }
    const double all = moving[0] + moving[1] + internal[0] + internal[1];
    const double freedoms = 6 + gas.species[0].internal_freedoms + gas.species[1].internal_freedoms,
                 each = 0.5 * static_cast<double>(count);
    const auto expect_part = [&](double energy, double own, const char* what) {
        const double share = own / freedoms, sigma = std::sqrt(2 * share * (1 - share) / (freedoms * each * snapshots / 1.2));
        std::printf("%s: %.5f of all (%.5f, sigma %.5f)\n", what, energy / all, share, sigma);
        EXPECT_NEAR(energy / all, share, 4 * sigma + 1e-6) << what;
    };
    expect_part(moving[0], 3, "motion of the light");
    expect_part(moving[1], 3, "motion of the heavy");
    expect_part(internal[0], gas.species[0].internal_freedoms, "within the light");
    expect_part(internal[1], gas.species[1].internal_freedoms, "within the heavy");
}

}  // namespace
}  // namespace corpuscle
