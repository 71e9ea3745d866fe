#include <gtest/gtest.h>

#include <cstdio>

#include "sphere_box.hpp"

namespace corpuscle {
namespace {

/// Hard spheres in a closed cube: pressure against Carnahan and Starling with what the walls take (`expected_pressure`).
///
/// Bound: 0.5 % of systematic rest plus 4 standard errors. The rest: Carnahan-Starling itself (0.3 % against computed spheres; Erpenbeck
/// and Wood 1984), scaled particle theory for what the walls take (some % of at most 12 % of the pressure), the edges of the cube
/// (of the order of f D^2/L^2, 1e-3). The mean over batches by bounces is far less noisy than by hits of the walls; both must agree.
void expect_carnahan_starling(double packing, double gamma)
{
    const SphereBox box = measure_box({packing, gamma, 0.4, 4000, 100, 50, 12});
    const double share = translational_share(gamma);
    std::printf("packing %.2f gamma %.2f: law %.4f, walls %.4f (%.4f), bounces %.4f (%.4f), translational %.4f, bounces a step %.2f\n",
                packing, gamma, box.law, box.wall.mean, box.wall.error, box.bounces.mean, box.bounces.error, box.translational.mean,
                box.met_a_step);
    EXPECT_NEAR(box.bounces.mean, box.law, 0.005 * box.law + 4 * box.bounces.error);
    EXPECT_NEAR(box.wall.mean, box.law, 0.005 * box.law + 4 * box.wall.error);
    EXPECT_LT(box.bounces.error, 0.004 * box.law);
    EXPECT_LT(box.wall.error, 0.015 * box.law);
    EXPECT_NEAR(box.translational.mean, share, 1e-6 + 4 * box.translational.error);
    EXPECT_LT(std::abs(box.energy_error), 1e-6);  // rounding: 2^-24 a bounce without a preferred sign
}

TEST(HardSpheres, pressure_of_carnahan_and_starling)
{
    for (const double packing : {0.01, 0.05, 0.1, 0.2, 0.3}) expect_carnahan_starling(packing, 5.0 / 3);
}
TEST(HardSpheres, exchange_of_internal_energy_leaves_the_pressure)
{
    expect_carnahan_starling(0.05, 1.2);
    expect_carnahan_starling(0.1, 1.3);
    expect_carnahan_starling(0.2, 1.4);
}

/// Two kinds of spheres of masses 1 to 7 and unlike radii and gamma, the light hot and the heavy cold, until they share one temperature.
/// Energy and momentum to round-off as for the default rule; the heat of motion by number, kT 3/2 a sphere, and zeta/2 kT inside.
/// Bound: 4 sigma of the share of n independent spheres, sqrt(2/(3 n)) and sqrt(2/(zeta n)), averaged over 40 samples a few
/// bounces apart (counted as 10 independent ones).
TEST(HardSpheres, mixture_comes_to_one_temperature_and_keeps_all)
{
    Gas gas = sphere_box({0.05, 1.4, 0.4, 3000, 0, 0, 0});
    gas.species.push_back(species_of(IdealGas{1.25}, 7 * gas.species[0].particle_mass));
    gas.species[1].radius = 1.7 * gas.species[0].radius;
    fill(gas, {Shape::box(unit_box), {}, 1, 2000 * gas.species[1].particle_mass, 2e4, {}, -1}, 2000);
    const Passage before = contents(gas).gas;
    Clock clock;
    for (int i = 0; i < 800; ++i) advance(gas, clock);
    std::array<double, 2> motion{}, inside{};
    for (int sample = 0; sample < 40; ++sample) {
        for (int i = 0; i < 10; ++i) advance(gas, clock);
        for (const Particle& p : gas.particles) {
            const std::uint32_t s = particle_tag::species(p.tag);
            motion[s] += norm_squared(Vector3d(p.velocity)) * gas.species[s].particle_mass / (3 * 40);
            inside[s] += 2 * static_cast<double>(p.energy) / gas.species[s].internal_freedoms / 40;
        }
    }
    const Passage after = contents(gas).gas;
    Passage given;
    for (const Passage& passage : gas.passages.face) given += passage;
    const std::array<double, 2> count{3000, 2000};
    double freedoms = 0;
    for (int s = 0; s < 2; ++s) freedoms += count[s] * (3 + gas.species[s].internal_freedoms);
    const double temperature = 2 * after.energy / freedoms;
    for (int s = 0; s < 2; ++s) {
        std::printf("species %d: kT of motion %.4f, inside %.4f of the whole's\n", s, motion[s] / count[s] / temperature,
                    inside[s] / count[s] / temperature);
        EXPECT_NEAR(motion[s] / count[s], temperature, 4 * temperature * std::sqrt(2 / (3 * count[s] * 10)));
        EXPECT_NEAR(inside[s] / count[s], temperature, 4 * temperature * std::sqrt(2 / (gas.species[s].internal_freedoms * count[s] * 10)));
    }
    EXPECT_NEAR(after.mass, before.mass, 1e-12 * before.mass);
    EXPECT_NEAR(after.energy, before.energy, 1e-6 * before.energy);
    EXPECT_LT(norm(after.momentum + given.momentum - before.momentum), 1e-6 * std::sqrt(2 * before.mass * before.energy));
}

/// Air of spheres in a box with six ambient edges keeps its mass: beyond a face no spheres push, so gas comes in with the density that
/// gives all of the spheres' pressure by motion alone, Z times theirs.
/// Bound: 2 %; without the factor the mass would fall by about 8 %. What is left: newcomers may overlap
/// spheres within D/2 of an edge, a twentieth of the box, where packing differs by its own order (0.02), 1e-3; and 4 sigma of the number of
/// spheres in an open box, sqrt(n S), S = 0.85: 1.2 % each, 8 samples.
TEST(HardSpheres, still_air_stays)
{
    Gas gas = sphere_box({0.02, 1.4, 0.4, 6000, 0, 0, 0});
    gas.domain.edges.fill(Edge::ambient);
    gas.ambient = ambient_like(gas.species[0], carnahan_starling(0.02), 1e6);
    Clock clock;
    std::vector<double> share;
    for (int i = 0; i < 800; ++i) {
        advance(gas, clock);
        if (i % 100 == 99) share.push_back(contents(gas).gas.mass);
    }
    const Statistics mass(share);
    std::printf("mass %.4f of the start, deviation %.4f; bounces %.1f a sphere\n", mass.mean, std::sqrt(mass.variance),
                2 * static_cast<double>(gas.collisions) / 6000);
    EXPECT_NEAR(mass.mean, 1, 0.02);
}

Gas charge_in_air(int threads)
{
    const WithThreads with(threads);
    Gas gas;
    gas.settings.rule = CollisionRule::hard_spheres;
    gas.domain = {unit_box, {Edge::rigid, Edge::ambient, Edge::rigid, Edge::open, Edge::rigid, Edge::ambient}};
    const Shape ball = Shape::sphere({0, 0, 0}, 0.2);
    gas.species = {species_of(IdealGas{1.4}, 1.2 / 5000),
                   species_of(NobleAbel{1.3, 0.3, 1630}, 1630 * ball.volume_within(unit_box) / 5000)};
    gas.species[0].radius = sphere_radius(gas.species[0], 0.01, 1.2);
    gas.species[1].radius = sphere_radius(gas.species[1], 0.01, 1630);
    gas.charges.push_back({"charge", 1, 6930, 4.29e6, 1630, {{{0, 0, 0}, 0}}, 0});
    gas.ambient = ambient_like(gas.species[0], 1.2 * carnahan_starling(0.01), 2.1e5);
    fill(gas, {Shape::box(unit_box), {ball}, 0, 1.2, 2.1e5, {}, -1}, 5000);
    fill(gas, {ball, {}, 1, 1630, 4.29e6, {}, 0}, 5000);
    Clock clock;
    for (int i = 0; i < 150; ++i) advance(gas, clock, 1e-5);
    return gas;
}

TEST(HardSpheres, threads_change_not_one_bit)
{
    const Gas one = charge_in_air(1);
    for (const int threads : {2, 3, 7}) {
        const Gas other = charge_in_air(threads);
        EXPECT_TRUE(same_bits(one.particles, other.particles)) << threads;
        EXPECT_EQ(one.step_limit, other.step_limit) << threads;
        EXPECT_EQ(one.collisions, other.collisions) << threads;
        for (int face = 0; face < face_count; ++face) EXPECT_TRUE(same_bits(one.passages.face[face], other.passages.face[face])) << threads;
    }
    EXPECT_GT(one.collisions, 5000u);
    EXPECT_EQ(one.charges[0].unburnt, 0u);
}

}  // namespace
}  // namespace corpuscle
