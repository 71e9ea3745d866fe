#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>
#include <vector>

#include "../../unit/structure/plates.hpp"
#include "mesh/generators.hpp"
#include "mesh/selection.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {
namespace {

constexpr double radius = 0.5, thickness = 0.01, young = 212e9, poisson = 0.28, density = 7838.0;
const double rigidity = young * thickness * thickness * thickness / (12.0 * (1.0 - poisson * poisson));  // D [N m]

/// A quarter of a clamped circular elastic plate.
Structure clamped_quarter(double element_size)
{
    set_thread_count(1);  // too small to share
    PartDescription d = plate(disk_mesh(radius, element_size, true), elastic_steel(), thickness);
    d.holds = {clamp(select_nodes(d.mesh, "rim")), symmetry(select_nodes(d.mesh, "x=0"), 0), symmetry(select_nodes(d.mesh, "y=0"), 1)};
    Structure structure;
    add_part(structure, d);
    return structure;
}

std::size_t centre_of(const Structure& structure)
{
    for (std::size_t i = 0; i < structure.nodes.size(); ++i)
        if (norm(structure.nodes.reference[i]) < 1e-9) return i;
    return structure.nodes.size();
}

/// Lowest natural frequency (angular) of a thin clamped circular plate (Leissa 1969). [rad/s]
double kirchhoff_frequency()
{
    return 10.2158 / (radius * radius) * std::sqrt(rigidity / (density * thickness));
}

/// Deflection of the centre under a static pressure: the load is on from the start, the motion damped at its lowest frequency.
double static_deflection(double element_size, double pressure)
{
    Structure structure = clamped_quarter(element_size);
    Nodes& n = structure.nodes;
    const std::size_t centre = centre_of(structure);
    const double frequency = kirchhoff_frequency();
    Clock clock;
    while (clock.time() * frequency < 16.0) {
        const double duration = stable_step(structure), keep = std::exp(-1.6 * frequency * duration);
        for (std::size_t i = 0; i < n.size(); ++i) {
            n.impulse[i].z += pressure * duration * n.mass[i] / (density * thickness);
            n.velocity[i] *= keep;
            n.angular_velocity[i] *= keep;
        }
        step(structure, clock, duration);
    }
    return n.position[centre].z;
}

TEST(CircularPlate, DeflectionUnderPressureConvergesToTheory)
{
    const double pressure = 1000.0, shear = young / (2.0 * (1.0 + poisson));
    const double bending = pressure * std::pow(radius, 4) / (64.0 * rigidity);
    const double exact = bending + pressure * radius * radius / (4.0 * 5.0 / 6.0 * shear * thickness);  // 0.25 % of it by transverse shear
    std::vector<double> errors;
    for (const double element_size : {radius / 5, radius / 10, radius / 20}) {
        errors.push_back(std::abs(static_deflection(element_size, pressure) / exact - 1.0));
        std::printf("elements of R/%.0f: deflection off by %.3f %%\n", radius / element_size, 100.0 * errors.back());
    }
    EXPECT_LT(errors[0], 0.01);
    EXPECT_LT(errors[1], 0.5 * errors[0]);
    EXPECT_LT(errors[2], 0.001);
}

TEST(CircularPlate, SuddenPressureSwingsToTwiceTheStaticDeflection)
{
    Structure structure = clamped_quarter(radius / 12);
    Nodes& n = structure.nodes;
    const std::size_t centre = centre_of(structure);
    const double pressure = 1000.0, still = pressure * std::pow(radius, 4) / (64.0 * rigidity);
    Clock clock;
    double highest = 0;
    while (clock.time() * kirchhoff_frequency() < 5.0) {
        const double duration = stable_step(structure);
        for (std::size_t i = 0; i < n.size(); ++i) n.impulse[i].z += pressure * duration * n.mass[i] / (density * thickness);
        step(structure, clock, duration);
        highest = std::max(highest, n.position[centre].z);
    }
    EXPECT_NEAR(highest / still, 2.0, 0.12);  // higher modes swing along
}

TEST(CircularPlate, RingsAtItsNaturalFrequencyAndKeepsItsEnergy)
{
    Structure structure = clamped_quarter(radius / 16);
    Nodes& n = structure.nodes;
    const std::size_t centre = centre_of(structure);
    for (std::size_t i = 0; i < n.size(); ++i) {
        const double square = norm_squared(n.reference[i]) / (radius * radius);
        if (n.inverse_mass[i].z > 0) n.velocity[i].z = 0.01 * (1.0 - square) * (1.0 - square);
    }
    const double start = energy(structure).kinetic;
    Clock clock;
    std::vector<double> crossings;  // upward, of the centre
    double worst = 0;
    while (crossings.size() < 11) {
        step(structure, clock, stable_step(structure));
        const double before = n.previous[centre].z, after = n.position[centre].z;
        if (before < 0 && after >= 0) crossings.push_back(clock.time() - clock.previous_duration() * after / (after - before));
        const StructureEnergy e = energy(structure);
        worst = std::max(worst, std::abs(e.kinetic + e.internal + e.hourglass - start));
        ASSERT_NEAR(e.total(), start, 1e-9 * start);
        ASSERT_LT(clock.time() * kirchhoff_frequency(), 100.0);
    }
    const double frequency = 2.0 * std::numbers::pi * 10.0 / (crossings.back() - crossings.front());
    std::printf("frequency %.2f rad/s, Kirchhoff %.2f; energy off by at most %.2e\n", frequency, kirchhoff_frequency(), worst / start);
    EXPECT_NEAR(frequency / kirchhoff_frequency(), 1.0, 0.003);  // rotary inertia and shear take about 0.1 %
    EXPECT_LT(worst, 0.01 * start);                              // half a step's work in transit, of the order of frequency * step
}

}  // namespace
}  // namespace corpuscle
