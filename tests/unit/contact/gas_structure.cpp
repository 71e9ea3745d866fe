#include "contact/gas_structure.hpp"

#include <gtest/gtest.h>

#include "gas_structure_bodies.hpp"

namespace corpuscle {
namespace {

const Box room{{-2, -2, -2}, {2, 2, 2}};

/// A square wall z = 0, 2 m wide, of two facets, normals up.
MovingSurface square_wall()
{
    MovingSurface wall;
    wall.start = wall.end = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    wall.surface.facets = {{{0, 1, 2}, 0, 0}, {{0, 2, 3}, 0, 0}};
    return wall;
}

/// One step of `duration` [s] in which everything is pending.
std::vector<Transfer> step(Gas& gas, GasStructureContact& contact, double duration, const Vector3f& displacement = {})
{
    Clock clock;
    clock.begin_step(duration);
    contact.follow();
    for (std::size_t i = 0; i < gas.particles.size(); ++i) gas.pending.push_back({static_cast<std::uint32_t>(i), 0.0f, displacement});
    return contact.apply(clock);
}

TEST(GasStructure, a_particle_bounces_off_a_held_wall_like_light_off_a_mirror)
{
    const MovingSurface wall = square_wall();
    Structure structure = bare_structure(wall.surface, wall.start, 0);
    Gas gas = empty_gas(room, 0.5);
    gas.particles = {particle_at({0.3f, 0.1f, 0.25f}, {100, 0, -1000}), particle_at({0.3f, 0.1f, -0.25f}, {100, 0, 1000})};
    GasStructureContact contact(gas, structure);
    const std::vector<Transfer> given = step(gas, contact, 1e-3);
    EXPECT_EQ(gas.particles[0].velocity, Vector3f(100, 0, 1000));
    EXPECT_EQ(gas.particles[1].velocity, Vector3f(100, 0, -1000));
    EXPECT_NEAR(gas.particles[0].position.z, 0.75, 3e-6);
    EXPECT_NEAR(gas.particles[1].position.z, -0.75, 3e-6);
    EXPECT_NEAR(gas.particles[0].position.x, 0.4, 2e-6);
    ASSERT_EQ(given.size(), 1u);
    EXPECT_NEAR(given[0].momentum.z, 0, 1e-9);
    EXPECT_EQ(given[0].energy, 0);
    EXPECT_EQ(contact.facet_hits()[0] + contact.facet_hits()[1], 2u);
    EXPECT_TRUE(gas.pending.empty());
}

/// The impulse on a facet scatters by the squares of its parts: two bounces from opposite sides push against each other, but their
/// noise adds up.
TEST(GasStructure, squares_of_impulses_add_up_whatever_their_side)
{
    const MovingSurface wall = square_wall();
    Structure structure = bare_structure(wall.surface, wall.start, 0);
    Gas gas = empty_gas(room, 0.5);
    gas.particles = {particle_at({0.3f, 0.1f, 0.25f}, {100, 0, -1000}), particle_at({0.3f, 0.1f, -0.25f}, {100, 0, 1000})};
    GasStructureContact contact(gas, structure);
    step(gas, contact, 1e-3);
    Vector3d impulse, squares;
    for (const Vector3d& facet : contact.facet_impulse()) impulse += facet;
    for (const Vector3d& facet : contact.facet_squares()) squares += facet;
    EXPECT_NEAR(norm(impulse), 0, 1e-9);
    EXPECT_NEAR(squares.z, 2 * 1000.0 * 1000.0, 1e-6);
    EXPECT_EQ(squares.x, 0);
}

/// Sides are told apart, and so are parts: two particles from above on one facet, a lighter one from below on the other.
TEST(GasStructure, each_side_and_part_has_its_own_account)
{
    MovingSurface wall = square_wall();
    wall.surface.facets[1].part = 1;
    Structure structure = bare_structure(wall.surface, wall.start, 2.0);
    Gas gas = empty_gas(room, 0.5);
    gas.species.push_back(gas.species[0]);
    gas.species[1].particle_mass = 0.25;
    gas.particles = {particle_at({0.3f, 0.1f, 0.25f}, {0, 0, -1000}), particle_at({0.5f, -0.5f, 0.25f}, {50, 0, -800}),
                     particle_at({-0.5f, 0.5f, -0.25f}, {0, 70, 600})};
    gas.particles[2].tag = particle_tag::make(1);
    GasStructureContact contact(gas, structure);
    const std::vector<Transfer> given = step(gas, contact, 1e-3);
    const FacetPress& press = contact.facet_press();
    EXPECT_GT(press.upper[0], 0.5 * (1000 + 800));  // more than if the particles had stopped
    EXPECT_EQ(press.lower[0], 0);
    EXPECT_EQ(press.upper[1], 0);
    EXPECT_GT(press.lower[1], 0.25 * 600);
    EXPECT_NEAR(press.upper[0], -contact.facet_impulse()[0].z, 1e-9);
    EXPECT_NEAR(press.lower[1], contact.facet_impulse()[1].z, 1e-9);
    const PartsGiven& parts = contact.given_to_parts();
    ASSERT_EQ(parts.work.size(), 2u);
    EXPECT_NEAR(parts.impulse[0].z, -press.upper[0], 1e-9);
    EXPECT_NEAR(parts.impulse[1].z, press.lower[1], 1e-9);
    EXPECT_NEAR(parts.work[0] + parts.work[1], given[0].energy, 1e-9 * given[0].energy);
    EXPECT_GT(parts.work[0], 0);
}

/// A particle in the edge of two walls, at right angles, that hits both in a step: each has its own square. Between two parallel walls the
/// second bounce takes back what the first gave, and so does its noise: the sum over both is that of the particle's whole impulse.
TEST(GasStructure, what_a_particle_gives_in_one_step_counts_as_one)
{
    MovingSurface wall = square_wall();
    const auto nodes = static_cast<std::uint32_t>(wall.start.size());
    const std::vector<Facet> facets = wall.surface.facets;
    for (Facet facet : facets) {
        for (std::uint32_t& node : facet.node) node += nodes;
        wall.surface.facets.push_back(facet);
    }
    for (std::uint32_t n = 0; n < nodes; ++n) wall.start.push_back(wall.start[n] + Vector3d{0, 0, 0.5});
    Structure structure = bare_structure(wall.surface, wall.start, 0);
    Gas gas = empty_gas(room, 0.5);
    gas.particles = {particle_at({0.3f, 0.1f, 0.25f}, {0, 0, -1000})};
    GasStructureContact contact(gas, structure);
    step(gas, contact, 1e-3);
    Vector3d squares;
    std::uint64_t hits = 0;
    for (std::size_t f = 0; f < contact.facet_squares().size(); ++f) {
        squares += contact.facet_squares()[f];
        hits += contact.facet_hits()[f];
    }
    EXPECT_EQ(hits, 2u);
    EXPECT_NEAR(squares.z, 0, 1e-6);
}

TEST(GasStructure, every_bounce_keeps_momentum_and_energy_of_the_pair)
{
    Random random(1, Purpose::contact, 0, 0);
    const MovingSurface wall = square_wall();
    for (int i = 0; i < 500; ++i) {
        Structure structure = bare_structure(wall.surface, wall.start, 0.1 + 3 * random.uniform_double());
        for (std::size_t n = 0; n < 4; ++n) structure.nodes.velocity[n] = 300 * uniform_vector(random);
        move_freely(structure.nodes, 1e-4);
        Gas gas = empty_gas(room, 0.02 + random.uniform_double());
        const double side = random.uniform() < 0.5f ? -1 : 1;
        gas.particles = {particle_at(Vector3f(Vector3d{0, 0, 0.1 * side} + 0.02 * uniform_vector(random)),
                                     Vector3f(Vector3d{0, 0, -3000 * side} + 500 * uniform_vector(random)))};
        const double mass = gas.species[0].particle_mass;
        const Vector3d momentum = momentum_of(structure.nodes), velocity(gas.particles[0].velocity);
        const double energy = kinetic_energy(structure.nodes);
        GasStructureContact contact(gas, structure);
        const Transfer given = step(gas, contact, 1e-4)[0];
        const Vector3d after(gas.particles[0].velocity);
        EXPECT_EQ(contact.facet_hits()[0] + contact.facet_hits()[1], 1u);
        const double carried = 0.5 * mass * norm_squared(velocity);
        EXPECT_LT(norm(momentum + mass * velocity - momentum_of(structure.nodes) - mass * after), 1e-12 * mass * norm(velocity));
        EXPECT_NEAR(energy + carried, kinetic_energy(structure.nodes) + 0.5 * mass * norm_squared(after), 1e-6 * carried);
        EXPECT_NEAR(given.energy, carried - 0.5 * mass * norm_squared(after), 1e-12 * carried);
        EXPECT_LT(norm(given.momentum - mass * (velocity - after)), 1e-12 * mass * norm(velocity));
    }
}

TEST(GasStructure, held_directions_are_infinitely_heavy)
{
    MovingSurface wall = square_wall();
    Structure structure = bare_structure(wall.surface, wall.start, 2);
    for (Vector3d& inverse : structure.nodes.inverse_mass) inverse = {0.5, 0.5, 0};
    Gas gas = empty_gas(room, 0.5);
    gas.particles = {particle_at({0.3f, 0.1f, 0.25f}, {0, 0, -1000})};
    GasStructureContact contact(gas, structure);
    const Transfer given = step(gas, contact, 1e-3)[0];
    EXPECT_EQ(gas.particles[0].velocity, Vector3f(0, 0, 1000));
    EXPECT_DOUBLE_EQ(given.momentum.z, -1000);
    EXPECT_DOUBLE_EQ(
        structure.nodes.impulse[0].z + structure.nodes.impulse[1].z + structure.nodes.impulse[2].z + structure.nodes.impulse[3].z, -1000);
    EXPECT_EQ(kinetic_energy(structure.nodes), 0);
}

TEST(GasStructure, a_wall_hits_a_particle_at_rest)
{
    const MovingSurface wall = square_wall();
    Structure structure = bare_structure(wall.surface, wall.start, 0);
    for (Vector3d& v : structure.nodes.velocity) v = {0, 0, 200};
    move_freely(structure.nodes, 1e-3);
    Gas gas = empty_gas(room, 0.5);
    gas.particles = {particle_at({0.3f, 0.1f, 0.05f}, {0, 0, 0})};
    GasStructureContact contact(gas, structure);
    step(gas, contact, 1e-3);
    EXPECT_EQ(gas.particles[0].velocity, Vector3f(0, 0, 400));
    EXPECT_NEAR(gas.particles[0].position.z, 0.05 + 0.75e-3 * 400, 2e-6);
}

TEST(GasStructure, a_displacement_is_mirrored_together_with_the_velocity)
{
    const MovingSurface wall = square_wall();
    Structure structure = bare_structure(wall.surface, wall.start, 0);
    Gas gas = empty_gas(room, 0.5);
    gas.particles = {particle_at({0.3f, 0.1f, 0.1f}, {0, 0, 100})};
    GasStructureContact contact(gas, structure);
    step(gas, contact, 1e-3, {0.05f, 0, -0.4f});  // to z = 0.3, velocity turned to -100, then 0.1 on
    EXPECT_EQ(gas.particles[0].velocity, Vector3f(0, 0, -100));
    EXPECT_NEAR(gas.particles[0].position.z, 0.2, 2e-6);
    EXPECT_NEAR(gas.particles[0].position.x, 0.35, 2e-6);
}

TEST(GasStructure, a_wall_that_keeps_up_carries_the_particle)
{
    const MovingSurface wall = square_wall();
    Structure structure = bare_structure(wall.surface, wall.start, 1);
    for (Vector3d& v : structure.nodes.velocity) v = {0, 0, 200};
    move_freely(structure.nodes, 1e-3);
    for (Vector3d& j : structure.nodes.impulse) j = {0, 0, -1000};  // an earlier blow of this step has turned the wall round
    Gas gas = empty_gas(room, 0.5);
    gas.particles = {particle_at({0.3f, 0.1f, 0.05f}, {0, 0, 50})};
    GasStructureContact contact(gas, structure);
    const Transfer given = step(gas, contact, 1e-3)[0];
    EXPECT_EQ(gas.particles[0].velocity, Vector3f(0, 0, 50));
    EXPECT_GT(gas.particles[0].position.z, 0.2f);
    EXPECT_NEAR(gas.particles[0].position.z, 0.2, 4e-6);
    EXPECT_EQ(given.momentum, Vector3d());
    EXPECT_EQ(contact.trapped(), 0u);
}

TEST(GasStructure, faces_of_the_domain_are_met_in_their_turn)
{
    const MovingSurface wall = square_wall();
    Structure structure = bare_structure(wall.surface, wall.start, 0);
    Gas gas = empty_gas({{-0.5, -2, -2}, {0.5, 2, 0.5}}, 0.5);
    gas.domain.edges[5] = Edge::open;
    gas.particles = {particle_at({0.3f, 0.1f, 0.25f}, {500, 0, -200}), particle_at({0, 0, 0.1f}, {0, 0, -1000})};
    GasStructureContact contact(gas, structure);
    step(gas, contact, 2e-3);
    EXPECT_EQ(gas.particles[0].velocity, Vector3f(-500, 0, 200));
    EXPECT_NEAR(gas.particles[0].position.x, -0.3, 4e-6);
    EXPECT_NEAR(gas.particles[0].position.z, 0.15, 4e-6);
    EXPECT_DOUBLE_EQ(gas.passages.face[1].momentum.x, 500);
    EXPECT_TRUE(gas.particles[1].tag & particle_tag::gone);
    EXPECT_DOUBLE_EQ(gas.passages.face[5].mass, 0.5);
    EXPECT_DOUBLE_EQ(gas.passages.face[5].momentum.z, 500);
}

TEST(GasStructure, a_flight_that_begins_late_flies_only_the_rest_of_the_step)
{
    const MovingSurface wall = square_wall();
    Structure structure = bare_structure(wall.surface, wall.start, 0);
    Gas gas = empty_gas(room, 0.5);
    gas.particles = {particle_at({0.3f, 0.1f, 0.1f}, {0, 0, -1000})};
    GasStructureContact contact(gas, structure);
    contact.follow();
    gas.pending = {{0, 0.75f, {}}};
    Clock clock;
    clock.begin_step(1e-3);
    contact.apply(clock);
    EXPECT_NEAR(gas.particles[0].position.z, 0.15, 2e-6);
}

TEST(GasStructure, a_crease_that_shuts_keeps_its_particle)
{
    MovingSurface crease;  // two walls that meet in the y axis like an open book, and shut from 20 degrees to 0.02
    crease.start = {{0, -1, 0}, {0, 1, 0}, {1, 0, 0.36}, {1, 0, 0}};
    crease.surface.facets = {{{0, 1, 2}, 0, 0}, {{1, 0, 3}, 0, 0}};
    Structure structure = bare_structure(crease.surface, crease.start, 0);
    structure.nodes.previous = crease.start;
    structure.nodes.position[2].z = 0.00036;
    Gas gas = empty_gas(room, 0.5);
    Random random(2, Purpose::contact, 0, 0);
    for (int i = 0; i < 500; ++i) {
        const double x = 0.02 + 0.9 * random.uniform_double(), y = (1 - x) * (random.uniform_double() - 0.5);
        gas.particles.push_back(particle_at(Vector3f(Vector3d{x, y, 0.36 * x * (0.1 + 0.8 * random.uniform_double())}),
                                            Vector3f(1500 * uniform_vector(random))));
        gas.particles.back().velocity.y = 0;
        gas.particles.back().velocity.x = -std::abs(gas.particles.back().velocity.x);
    }
    GasStructureContact contact(gas, structure);
    step(gas, contact, 1e-5);
    int within = 0;
    for (const Particle& particle : gas.particles) {
        const Vector3d p(particle.position);
        const bool in = p.z > 0 && p.z < 0.00036 * p.x;
        const bool gone_through_the_open_side = std::abs(p.y) > 1 - p.x;
        EXPECT_TRUE(in || gone_through_the_open_side) << p.x << ' ' << p.y << ' ' << p.z;
        within += in;
    }
    EXPECT_GT(within, 450);
    EXPECT_EQ(contact.trapped(), 0u);
}

TEST(GasStructure, nothing_happens_without_facets)
{
    Structure structure;
    Gas gas = empty_gas(room, 0.5);
    gas.particles = {particle_at({0, 0, 0}, {1, 2, 3})};
    GasStructureContact contact(gas, structure);
    contact.follow();
    const std::vector<Transfer> given = contact.apply(Clock());
    EXPECT_EQ(given[0].energy, 0);
    EXPECT_EQ(gas.particles[0].position, Vector3f());
    EXPECT_EQ(contact.tree().clearance({0, 0, 0}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace corpuscle
