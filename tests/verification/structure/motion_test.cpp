#include <gtest/gtest.h>

#include <numbers>

#include "../../unit/structure/plates.hpp"

namespace corpuscle {
namespace {

/// Turns a vector about a unit axis (Rodrigues).
Vector3d turned(const Vector3d& v, const Vector3d& axis, double angle)
{
    return v * std::cos(angle) + cross(axis, v) * std::sin(angle) + axis * (dot(axis, v) * (1.0 - std::cos(angle)));
}

/// A distorted and warped sheet.
Mesh crumpled()
{
    Mesh mesh = square_mesh(4, 0.4, 0.2);
    for (Vector3d& x : mesh.nodes) x.z = 0.02 * std::sin(40.0 * x.x) * std::cos(30.0 * x.y) + 0.1 * x.x * x.y;
    return mesh;
}

double largest_stress(const Structure& structure)
{
    double most = 0;
    const auto& shells = std::get<QuadrilateralShells>(structure.parts[0].elements);
    for (std::size_t e = 0; e < shells.size(); ++e) most = std::max(most, shells.values(e).von_mises);
    return most;
}

/// Stress after a turn through `angle` in `steps` steps, nodes led exactly along the rotation.
double stress_after_turn(const Vector3d& axis, double angle, int steps)
{
    Structure structure;
    add_part(structure, plate(crumpled(), elastic_steel(), 0.01));
    Nodes& n = structure.nodes;
    Clock clock;
    for (int k = 1; k <= steps; ++k) {
        clock.begin_step(1.0);
        for (std::size_t i = 0; i < n.size(); ++i) {
            n.previous[i] = n.position[i];
            n.position[i] = turned(n.reference[i], axis, angle * k / steps);
            n.velocity[i] = n.position[i] - n.previous[i];
            n.angular_velocity[i] = axis * (angle / steps);
        }
        resist(structure, clock);
        clock.end_step();
    }
    return largest_stress(structure);
}

TEST(Motion, LargeRotationLeavesNoStress)
{
    const Vector3d axis = normalized(Vector3d{0.3, -0.5, 0.8});
    const double angle = 0.5 * std::numbers::pi;
    const double coarse = stress_after_turn(axis, angle, 100), fine = stress_after_turn(axis, angle, 200);
    EXPECT_LT(fine, 1e-5 * 212e9);
    EXPECT_NEAR(coarse / fine, 4.0, 0.3);  // what is left is of second order in the angle of a step
    for (int a = 0; a < 3; ++a) {
        Vector3d along;
        along[a] = 1.0;
        EXPECT_LT(stress_after_turn(along, angle, 1000), 1e-6 * 212e9) << a;
    }
}

/// Angular momentum about the origin.
Vector3d angular_momentum(const Nodes& n)
{
    Vector3d total;
    for (std::size_t i = 0; i < n.size(); ++i)
        total += n.mass[i] * cross(n.position[i], n.velocity[i]) + n.inertia[i] * n.angular_velocity[i];
    return total;
}

TEST(Motion, FreeSheetKeepsMomentumSpinAndEnergy)
{
    Structure structure;
    add_part(structure, plate(crumpled(), elastic_steel(), 0.01));
    Nodes& n = structure.nodes;
    for (std::size_t i = 0; i < n.size(); ++i) {
        n.angular_velocity[i] = {300.0, 100.0, 200.0};
        n.velocity[i] = Vector3d{10.0, -20.0, 5.0} + cross(n.angular_velocity[i], n.position[i]);
    }
    Clock clock;
    const Vector3d momentum_0 = momentum(structure), spin_0 = angular_momentum(n);
    const double energy_0 = energy(structure).total(), duration = 0.8 * stable_step(structure);
    double strayed = 0;
    for (int i = 0; i < 2000; ++i) {
        step(structure, clock, duration);
        strayed = std::max(strayed, norm(angular_momentum(n) - spin_0));
    }
    const StructureEnergy e = energy(structure);
    EXPECT_NEAR(norm(momentum(structure) - momentum_0), 0.0, 1e-11 * norm(momentum_0));
    EXPECT_LT(strayed, 1e-9 * norm(spin_0));
    EXPECT_NEAR(e.total(), energy_0, 1e-11 * energy_0);
    EXPECT_LT(std::abs(e.integration), 1e-3 * energy_0);
}

/// Number of ways a lone elastic element can move at no cost, found from its stiffness by elimination.
int free_modes(const HourglassControl& hourglass)
{
    constexpr int size = 24;
    double stiffness[size][size];
    Mesh mesh;
    mesh.nodes = {{0, 0, 0}, {0.11, 0.01, 0}, {0.12, 0.1, 0}, {-0.01, 0.09, 0}};
    mesh.elements = {{ElementShape::quadrilateral, {0, 1, 2, 3}}};
    const double length = 0.1, small = 1e-7;
    for (int j = 0; j < size; ++j) {
        Structure structure;
        PartDescription d = plate(mesh, elastic_steel(), 0.1);
        d.hourglass = hourglass;
        add_part(structure, d);
        Clock clock;
        clock.begin_step(1.0);
        Nodes& n = structure.nodes;
        (j < 12 ? n.velocity[j / 3][j % 3] : n.angular_velocity[(j - 12) / 3][j % 3]) = j < 12 ? small * length : small;
        for (int i = 0; i < 4; ++i) n.position[i] += 0.5 * n.velocity[i];  // read the loads in the middle of the step
        resist(structure, clock);
        for (int i = 0; i < size; ++i)
            stiffness[i][j] =
                -(i < 12 ? n.force[i / 3][i % 3] * length : n.moment[(i - 12) / 3][i % 3]) / (small * 212e9 * length * length * length);
    }
    int rank = 0;
    bool used[size] = {};
    for (int column = 0; column < size; ++column) {
        int pivot = -1;
        for (int row = 0; row < size; ++row)
            if (!used[row] && (pivot < 0 || std::abs(stiffness[row][column]) > std::abs(stiffness[pivot][column]))) pivot = row;
        if (pivot < 0 || std::abs(stiffness[pivot][column]) < 1e-5) continue;
        used[pivot] = true;
        ++rank;
        for (int row = 0; row < size; ++row) {
            if (used[row]) continue;
            const double factor = stiffness[row][column] / stiffness[pivot][column];
            for (int k = column; k < size; ++k) stiffness[row][k] -= factor * stiffness[pivot][k];
        }
    }
    return size - rank;
}

TEST(Motion, OnlyRigidAndDrillingModesAreFree)
{
    EXPECT_EQ(free_modes({}), 6 + 3);                     // rigid motion, and turning of each node about the normal
    EXPECT_EQ(free_modes({0.0, 0.0, 0.0, 0.0}), 10 + 6);  // what hourglass control is for
    EXPECT_EQ(free_modes({0.05, 0.05, 0.0, 0.0}), 10 + 2);
}

/// Amplitude of in-plane, rotation and transverse hourglass motion of the four elements of a sheet after being set moving.
TEST(Motion, HourglassMotionIsHeldAndStable)
{
    for (const double viscosity : {0.0, 0.05}) {
        Structure structure;
        PartDescription d = plate(square_mesh(2, 0.2), elastic_steel(), 0.01);
        d.hourglass.viscosity = viscosity;
        add_part(structure, d);
        Nodes& n = structure.nodes;
        for (int i = 0; i < 9; ++i) {
            const double sign = i % 2 == 0 ? 1.0 : -1.0;  // a checkerboard: every element in its hourglass modes
            n.velocity[i] = Vector3d{0.1, 0.05, 0.1} * sign;
            n.angular_velocity[i] = Vector3d{1.0, 2.0, 0.0} * sign;
        }
        const double start = energy(structure).kinetic;
        Clock clock;
        double farthest = 0;
        const double duration = stable_step(structure);
        for (int i = 0; i < 4000; ++i) {
            step(structure, clock, duration);
            const Vector3d centre = n.position[4] - n.reference[4];
            farthest = std::max(farthest, norm(centre));
        }
        const StructureEnergy e = energy(structure);
        EXPECT_LT(farthest, 2e-4);  // free of control it would have gone millimetres
        EXPECT_NEAR(e.total(), start, 1e-11 * start);
        EXPECT_NEAR(e.integration, work_in_transit(structure, duration), 1e-10 * start);
        EXPECT_GE(e.hourglass, 0.0);
        if (viscosity > 0) {
            EXPECT_LT(e.kinetic, 0.2 * start);
        }
    }
}

}  // namespace
}  // namespace corpuscle
