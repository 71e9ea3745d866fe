#include "structure/rigid_body.hpp"

#include <gtest/gtest.h>

namespace corpuscle {
namespace {

RigidBody cross_of_masses()
{
    const std::vector<Vector3d> places{{1, 0, 0}, {-1, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 0.5}, {0, 0, -0.5}};
    const std::vector<double> masses{1, 1, 2, 2, 3, 3};
    return rigid_body_of(places, masses);
}

TEST(RigidBody, MassAndInertiaAreThoseOfItsPoints)
{
    const RigidBody b = cross_of_masses();
    EXPECT_DOUBLE_EQ(b.mass, 12);
    EXPECT_NEAR(norm(b.center), 0, 1e-15);
    EXPECT_DOUBLE_EQ(b.inertia_at_start.xx, 2 * 2 * 4 + 2 * 3 * 0.25);
    EXPECT_DOUBLE_EQ(b.inertia_at_start.yy, 2 * 1 + 2 * 3 * 0.25);
    EXPECT_DOUBLE_EQ(b.inertia_at_start.zz, 2 * 1 + 2 * 2 * 4);
}

TEST(RigidBody, AnImpulseIsWorthItsWorkAtTheMeanVelocity)
{
    RigidBody b = cross_of_masses();
    b.velocity = {1, -2, 0.5};
    b.spin_momentum = {3, 1, -2};
    const Vector3d place{0.3, 0.7, -0.2}, push{2, -1, 4};
    const double before = b.kinetic_energy();
    const Vector3d velocity = b.velocity_at(place);
    b.push(place, push);
    EXPECT_NEAR(b.kinetic_energy() - before, 0.5 * dot(push, velocity + b.velocity_at(place)), 1e-12);
    const Vector3d along = normalized(push);
    EXPECT_NEAR(dot(along, b.velocity_at(place) - velocity), b.inverse_mass_at(place, along) * norm(push), 1e-12);
}

/// Free rotation about no principal axis: momentum is kept exactly, energy to second order in the angle of a step.
TEST(RigidBody, FreeSpinKeepsMomentumAndEnergy)
{
    for (const double duration : {0.02, 0.01}) {
        RigidBody b = cross_of_masses();
        b.spin_momentum = {10, 20, 15};
        const double start = b.kinetic_energy();
        double worst = 0;
        for (double t = 0; t < 20; t += duration) {
            b.advance(duration);
            worst = std::max(worst, std::abs(b.kinetic_energy() / start - 1));
        }
        EXPECT_EQ(b.spin_momentum.x, 10);
        EXPECT_LT(worst, 10 * duration * duration);
        EXPECT_NEAR(norm(b.axis_z), 1, 1e-12);
        EXPECT_NEAR(dot(b.axis_x, b.axis_y), 0, 1e-12);
    }
}

TEST(RigidBody, HeldDirectionsGiveToTheSupport)
{
    RigidBody b = cross_of_masses();
    b.free = {0, 0, 1};
    b.free_turn = {0, 0, 1};
    b.push({1, 0, 0}, {5, 2, -3});
    const Vector3d support = b.advance(0.1);
    EXPECT_EQ(support.x, -5);
    EXPECT_EQ(support.y, -2);
    EXPECT_EQ(support.z, 0);
    EXPECT_DOUBLE_EQ(b.velocity.z, -3.0 / 12);
    EXPECT_DOUBLE_EQ(b.velocity.x, 0);
    EXPECT_DOUBLE_EQ(b.spin().z, 2.0 / b.inertia_at_start.zz);
    EXPECT_EQ(b.spin().x, 0);
    EXPECT_NEAR(b.placed({1, 0, 0}).z, -0.1 * 3 / 12, 1e-15);
}

}  // namespace
}  // namespace corpuscle
