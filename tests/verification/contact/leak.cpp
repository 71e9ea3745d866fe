#include <gtest/gtest.h>

#include <cstdio>
#include <numeric>

#include "closed_walls.hpp"
#include "gas/fly.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {
namespace {

/// Closed walls that move as they like with gas in them that does not collide.
struct Enclosure {
    Enclosure(const ClosedWalls& walls_, std::size_t particles) : walls(walls_)
    {
        structure = bare_structure(walls.surface, walls.nodes, 0);
        place_nodes(0);
        structure.nodes.previous = structure.nodes.position;
        gas = empty_gas({{-3, -3, -3}, {3, 3, 3}}, 1e-3);
        Random random(12, Purpose::contact, 0, 0);
        while (gas.particles.size() < particles) {
            const Vector3f p(middle_at(0) + uniform_vector(random));
            const Vector3f v{static_cast<float>(800 * random.normal()), static_cast<float>(800 * random.normal()),
                             static_cast<float>(800 * random.normal())};
            if (within(walls, structure.nodes.position, middle_at(0), Vector3d(p))) gas.particles.push_back(particle_at(p, v));
        }
    }

    void place_nodes(double time)
    {
        for (std::size_t n = 0; n < structure.nodes.size(); ++n) structure.nodes.position[n] = node_at(walls, n, time);
    }

    /// Moves the walls and lets the gas fly.
    void step(GasStructureContact& contact, double duration)
    {
        clock.begin_step(duration);
        structure.nodes.previous = structure.nodes.position;
        place_nodes(clock.end());
        for (std::size_t n = 0; n < structure.nodes.size(); ++n)
            structure.nodes.velocity[n] = (structure.nodes.position[n] - structure.nodes.previous[n]) / duration;
        contact.follow();
        fly(gas, clock, contact.tree());
        contact.apply(clock);
        clock.end_step();
    }

    /// Particles that are not strictly within the walls.
    [[nodiscard]] std::size_t outside() const
    {
        const Vector3d middle = middle_at(clock.time());
        const double sure = 0.999 * sure_radius(walls, structure.nodes.position, middle);
        return sum<std::size_t>(gas.particles.size(), [&](std::size_t i) {
            const Vector3d p(gas.particles[i].position);
            return std::size_t{norm(p - middle) < sure || within(walls, structure.nodes.position, middle, p) ? 0u : 1u};
        });
    }

    ClosedWalls walls;
    Structure structure;
    Gas gas;
    Clock clock;
};

/// Flies particles until there have been so many hits; none may ever be outside.
void fly_in(const ClosedWalls& walls, std::uint64_t hits_wanted, double duration)
{
    Enclosure enclosure(walls, 20000);
    GasStructureContact contact(enclosure.gas, enclosure.structure);
    std::uint64_t hits = 0;
    while (hits < hits_wanted) {
        enclosure.step(contact, duration);
        hits = std::accumulate(contact.facet_hits().begin(), contact.facet_hits().end(), std::uint64_t{0});
        const bool look = enclosure.clock.step() % 5 == 0;
        ASSERT_EQ(look ? enclosure.outside() : 0u, 0u) << walls.name << " after " << hits << " hits";
        ASSERT_LT(enclosure.clock.step(), 20000u);
    }
    EXPECT_EQ(enclosure.outside(), 0u);
    EXPECT_EQ(contact.trapped(), 0u);
    std::printf("%s: %llu hits in %llu steps, none outside\n", walls.name.c_str(), static_cast<unsigned long long>(hits),
                static_cast<unsigned long long>(enclosure.clock.step()));
}

TEST(Leak, moving_cube)
{
    fly_in(cube(), 2'500'000, 2e-4);
}
TEST(Leak, moving_wedge_with_acute_creases)
{
    fly_in(wedge(), 5'000'000, 5e-5);
}
TEST(Leak, moving_ball)
{
    fly_in(ball(), 2'500'000, 2e-4);
}
TEST(Leak, moving_star_with_swinging_nodes)
{
    fly_in(star(), 1'000'000, 5e-5);
}

/// The state after some steps in the star, its nodes' impulses included.
std::pair<std::vector<Particle>, std::vector<Vector3d>> flown_with(int threads)
{
    const int before = thread_count();
    set_thread_count(threads);
    Enclosure enclosure(star(), 10000);
    for (Vector3d& inverse : enclosure.structure.nodes.inverse_mass) inverse = {0.3, 0.5, 0};
    GasStructureContact contact(enclosure.gas, enclosure.structure);
    for (int i = 0; i < 20; ++i) enclosure.step(contact, 5e-5);
    set_thread_count(before);
    return {enclosure.gas.particles, contact.facet_impulse()};
}

TEST(Leak, threads_change_not_one_bit)
{
    const auto [particles, impulses] = flown_with(1);
    for (const int threads : {2, 3}) {
        const auto [other_particles, other_impulses] = flown_with(threads);
        ASSERT_EQ(particles.size(), other_particles.size());
        for (std::size_t i = 0; i < particles.size(); ++i) {
            ASSERT_EQ(particles[i].position, other_particles[i].position);
            ASSERT_EQ(particles[i].velocity, other_particles[i].velocity);
        }
        EXPECT_EQ(impulses, other_impulses);
    }
}

}  // namespace
}  // namespace corpuscle
