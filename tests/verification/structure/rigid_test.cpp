#include <gtest/gtest.h>

#include <numbers>

#include "../../unit/structure/blocks.hpp"
#include "base/error.hpp"

namespace corpuscle {
namespace {

PartDescription rigid_block(std::array<int, 3> n, const Vector3d& size)
{
    PartDescription d = block(brick_mesh(n, size), elastic_steel());
    d.element = ElementKind::rigid;
    return d;
}

/// Mass and inertia of a box are exact for any mesh of it: two Gauss points each way.
TEST(RigidPart, BoxHasItsExactInertia)
{
    for (const int n : {1, 3}) {
        Structure s;
        add_part(s, rigid_block({n, n, n}, {0.3, 0.2, 0.1}));
        const RigidBody& b = s.nodes.bodies[0];
        const double mass = 7838.0 * 0.3 * 0.2 * 0.1;
        EXPECT_NEAR(b.mass, mass, 1e-12 * mass);
        EXPECT_NEAR(b.inertia_at_start.xx, mass / 12 * (0.04 + 0.01), 1e-12 * mass);
        EXPECT_NEAR(b.inertia_at_start.zz, mass / 12 * (0.09 + 0.04), 1e-12 * mass);
        EXPECT_NEAR(norm(b.center - Vector3d{0.15, 0.1, 0.05}), 0, 1e-14);
    }
}

/// A box thrown spinning about an axis of symmetry comes back to where its nodes were after a whole number of turns, displaced by its
/// flight, to the second order of the step; momentum and energy stay.
TEST(RigidPart, SpinningBoxFliesOn)
{
    Structure s;
    PartDescription d = rigid_block({2, 2, 2}, {0.3, 0.2, 0.1});
    d.velocity = {10, 0, -5};
    d.spin = {0, 0, 2 * std::numbers::pi * 100};
    add_part(s, d);
    const double start = energy(s).kinetic;
    const Vector3d before = momentum(s);
    Clock clock;
    for (int i = 0; i < 1000; ++i) step(s, clock, 1e-5);
    EXPECT_NEAR(energy(s).kinetic, start, 1e-10 * start);
    EXPECT_LT(norm(momentum(s) - before), 1e-12 * norm(before));
    for (std::size_t i = 0; i < s.nodes.size(); ++i)
        EXPECT_LT(norm(s.nodes.position[i] - s.nodes.reference[i] - Vector3d{0.1, 0, -0.05}), 1e-9);
}

/// Impulses on its nodes, one after the other: each is worth its mean velocity's work, the sum of momenta is the body's, moments about the
/// center turn it; a held direction gives to the support.
TEST(RigidPart, TakesImpulsesOnNodes)
{
    Structure s;
    PartDescription d = rigid_block({2, 2, 2}, {0.3, 0.2, 0.1});
    std::vector<std::uint32_t> all(d.mesh.nodes.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    Hold along_x{all, {true, false, false}, {}};
    d.holds = {along_x};
    add_part(s, d);
    double work = 0;
    Vector3d given;
    for (std::uint32_t i = 0; i < 8; ++i) {
        const Vector3d push{1.0 + i, 2.0 - i, 3.0};
        const Vector3d v = s.nodes.contact_velocity(i);
        s.nodes.push(i, push);
        work += 0.5 * dot(push, v + s.nodes.contact_velocity(i));
        given += push;
    }
    EXPECT_NEAR(energy(s).kinetic, work, 1e-12 * work);
    Clock clock;
    clock.begin_step(1e-6);
    const std::vector<Transfer> support = accelerate(s, clock);
    EXPECT_NEAR(support[0].momentum.x, -given.x, 1e-12);
    EXPECT_NEAR(momentum(s).y, given.y, 1e-12);
    EXPECT_NEAR(momentum(s).z, given.z, 1e-12);
    EXPECT_EQ(momentum(s).x, 0);
    EXPECT_NEAR(energy(s).kinetic, work, 1e-12 * work);
}

TEST(RigidPart, PointMassesShiftTheCenter)
{
    Structure s;
    PartDescription d = rigid_block({1, 1, 1}, {0.1, 0.1, 0.1});
    d.rigid.mass = 2.0;
    d.point_masses = {{{0}, 2.0}};  // as much again in the corner at the origin
    add_part(s, d);
    EXPECT_NEAR(s.nodes.bodies[0].mass, 4.0, 1e-12);
    EXPECT_NEAR(norm(s.nodes.bodies[0].center - Vector3d{0.025, 0.025, 0.025}), 0, 1e-14);
}

/// Half a box with its cut held in a plane of symmetry moves as the half of the whole box does under pushes that are mirror images: to
/// round-off, which 200 steps of turning add up.
TEST(RigidPart, HalfOnAPlaneOfSymmetryMovesAsTheWhole)
{
    PartDescription whole = rigid_block({4, 2, 2}, {0.3, 0.2, 0.1}), half = rigid_block({2, 2, 2}, {0.15, 0.2, 0.1});
    for (Vector3d& place : whole.mesh.nodes) place.x -= 0.15;
    std::vector<std::uint32_t> cut;
    for (std::uint32_t i = 0; i < half.mesh.nodes.size(); ++i)
        if (half.mesh.nodes[i].x == 0) cut.push_back(i);
    half.holds = {symmetry(cut, 0)};
    Structure all, part;
    add_part(all, whole);
    add_part(part, half);
    const RigidBody &a = all.nodes.bodies[0], &h = part.nodes.bodies[0];
    EXPECT_NEAR(h.mass, 0.5 * a.mass, 1e-12 * a.mass);
    EXPECT_NEAR(h.inertia_at_start.xx, 0.5 * a.inertia_at_start.xx, 1e-12 * a.inertia_at_start.xx);
    EXPECT_EQ(h.center.x, 0);
    const auto node_at = [](const Structure& s, const Vector3d& place) {
        std::uint32_t i = 0;
        while (norm(s.nodes.reference[i] - place) > 1e-9) ++i;
        return i;
    };
    const std::uint32_t corner = node_at(part, {0.15, 0.2, 0.1});
    Clock clock, other;
    for (int k = 0; k < 200; ++k) {
        part.nodes.push(corner, {3, 1, 2});
        all.nodes.push(node_at(all, {0.15, 0.2, 0.1}), {3, 1, 2});
        all.nodes.push(node_at(all, {-0.15, 0.2, 0.1}), {-3, 1, 2});
        step(part, clock, 1e-4);
        step(all, other, 1e-4);
    }
    EXPECT_GT(norm(part.nodes.position[corner] - part.nodes.reference[corner]), 0.05);
    for (std::size_t i = 0; i < part.nodes.size(); ++i) {
        const std::uint32_t same = node_at(all, part.nodes.reference[i]);
        EXPECT_LT(norm(part.nodes.position[i] - all.nodes.position[same]), 1e-10) << i;
    }
    EXPECT_NEAR(energy(part).kinetic, 0.5 * energy(all).kinetic, 1e-10 * energy(all).kinetic);
}

/// Nodes that are held along an axis alone, or inside the body, make a hinge, not a plane of symmetry.
TEST(RigidPart, RefusesHinges)
{
    for (const double plane : {0.0, 0.15}) {
        PartDescription d = rigid_block({4, 2, 2}, {0.3, 0.2, 0.1});
        std::vector<std::uint32_t> some;
        for (std::uint32_t i = 0; i < d.mesh.nodes.size(); ++i)
            if (std::abs(d.mesh.nodes[i].x - plane) < 1e-9) some.push_back(i);
        d.holds = {plane > 0 ? symmetry(some, 0) : Hold{some, {true, false, false}, {}}};
        Structure s;
        EXPECT_THROW(add_part(s, d), InputError);
    }
}

}  // namespace
}  // namespace corpuscle
