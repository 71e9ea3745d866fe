#include <gtest/gtest.h>

#include <cstdio>

#include "../../unit/gas/gas_samples.hpp"

namespace corpuscle {
namespace {

/// A ball of heavy, stiff, hot gas that flies through light air in a closed box.
Gas mixture()
{
    Gas gas = filled_box({{0, 0, 0}, {1, 0.7, 1.3}}, IdealGas{1.4}, 1.2, 2e5, 12000);
    gas.species.push_back(species_of(NobleAbel{1.3, 0.3, 40}, 7 * gas.species[0].particle_mass));
    const Shape ball = Shape::sphere({0.4, 0.3, 0.5}, 0.2);
    const double density = 8000 * gas.species[1].particle_mass / ball.volume();
    fill(gas, {ball, {}, 1, density, 1e6, {400, -200, 100}, -1}, 8000);
    return gas;
}

std::array<std::size_t, 2> numbers(const Gas& gas)
{
    std::array<std::size_t, 2> count{};
    for (const Particle& p : gas.particles) ++count[particle_tag::species(p.tag)];
    return count;
}

/// Masses are counts times one number: exact. A pair's momentum and energy are kept to the rounding of floats, 2^-24 each time and
/// without a preferred sign: over C collisions of N particles a relative error of the order of sqrt(C/N) 1e-7/sqrt(N), some 1e-8; the
/// bound of 1e-6 is reached only by a bias of 1e-8 a collision. Momentum is measured by sqrt(2 M E).
TEST(Conservation, closed_box_of_two_gases)
{
    Gas gas = mixture();
    const Passage before = contents(gas).gas;
    const auto count = numbers(gas);
    Clock clock;
    for (int i = 0; i < 400; ++i) advance(gas, clock);
    const Passage after = contents(gas).gas;
    Passage given;
    for (const Passage& passage : gas.passages.face) given += passage;
    const double scale = std::sqrt(2 * before.mass * before.energy);
    const double momentum_error = norm(after.momentum + given.momentum - before.momentum) / scale;
    const double each = 2 * static_cast<double>(gas.collisions) / static_cast<double>(gas.particles.size());
    std::printf("%.0f collisions a particle: energy %.2e, momentum %.2e of sqrt(2 M E); walls took %.3f\n", each,
                after.energy / before.energy - 1, momentum_error, norm(given.momentum) / scale);
    EXPECT_GT(each, 40);
    EXPECT_GT(norm(given.momentum), 0.1 * norm(before.momentum));
    EXPECT_EQ(numbers(gas), count);
    EXPECT_NEAR(after.mass, before.mass, 1e-12 * before.mass);  // counts are equal: only the order of the sum is another
    EXPECT_NEAR(after.energy, before.energy, 1e-6 * before.energy);
    EXPECT_LT(momentum_error, 1e-6);
    EXPECT_EQ(given.mass, 0);
    EXPECT_EQ(given.energy, 0);
    for (const Particle& p : gas.particles) ASSERT_TRUE(gas.domain.box.contains(Vector3d(p.position)));
}

/// A charge that burns in air with all kinds of edges, after some steps.
Gas run_with(int threads)
{
    const WithThreads with(threads);
    Gas gas;
    gas.domain = {unit_box, {Edge::rigid, Edge::ambient, Edge::rigid, Edge::open, Edge::rigid, Edge::ambient}};
    const Shape ball = Shape::sphere({0, 0, 0}, 0.2);
    gas.species = {species_of(IdealGas{1.4}, 1.2 / 15000),
                   species_of(Jwl{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630}, 1630 * ball.volume_within(unit_box) / 15000)};
    gas.charges.push_back({"charge", 1, 6930, 4.29e6, 1630, {{{0, 0, 0}, 0}}});
    gas.ambient = ambient_like(gas.species[0], 1.2, 2.1e5);
    fill(gas, {Shape::box(unit_box), {ball}, 0, 1.2, 2.1e5, {}, -1}, 15000);
    fill(gas, {ball, {}, 1, 1630, 4.29e6, {}, 0}, 15000);
    Clock clock;
    for (int i = 0; i < 200; ++i) advance(gas, clock, 1e-5);
    return gas;
}

TEST(Threads, change_not_one_bit)
{
    const Gas one = run_with(1);
    for (const int threads : {2, 3, 4, 7}) {
        const Gas other = run_with(threads);
        EXPECT_TRUE(same_bits(one.particles, other.particles)) << threads;
        EXPECT_EQ(one.step_limit, other.step_limit) << threads;
        EXPECT_EQ(one.collisions, other.collisions) << threads;
        for (int face = 0; face < face_count; ++face) EXPECT_TRUE(same_bits(one.passages.face[face], other.passages.face[face])) << threads;
    }
    EXPECT_GT(one.collisions, 50000u);
    EXPECT_EQ(one.charges[0].unburnt, 0u);
}

}  // namespace
}  // namespace corpuscle
