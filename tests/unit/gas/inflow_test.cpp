#include "gas/inflow.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "gas/faces.hpp"

#include "gas_samples.hpp"

namespace corpuscle {
namespace {

constexpr double density = 1.2, heat = 2.1e5, duration = 2e-6;
constexpr int steps = 200;

/// An empty box in still gas after some steps of inflow alone: nobody gets across it in one step.
struct Intake {
    Gas gas;
    double sigma, particle_mass;

    Intake(double gamma, const std::array<Edge, face_count>& edges)
    {
        gas.domain = {{{0, 0, 0}, {1, 1.5, 2}}, edges};
        particle_mass = 2e-4;
        gas.species.push_back(species_of(IdealGas{gamma}, particle_mass));
        gas.ambient = ambient_like(gas.species[0], density, heat);
        sigma = std::sqrt(gas.ambient.velocity_variance);
        Clock clock;
        for (int i = 0; i < steps; ++i) {
            clock.begin_step(duration);
            flow_in(gas, clock, nullptr);
            clock.end_step();
        }
    }
    [[nodiscard]] double expected_count(double area) const
    {
        return density / particle_mass * sigma / std::sqrt(2 * std::numbers::pi) * area * steps * duration;
    }
};
constexpr Edge A = Edge::ambient;
constexpr std::array<double, face_count> areas{3, 3, 2, 2, 1.5, 1.5};

/// Fractions of particles are carried from step to step, so the count is the flux to within one particle.
TEST(Inflow, brings_the_flux_of_a_maxwellian_through_every_face)
{
    for (int face = 0; face < face_count; ++face) {
        std::array<Edge, face_count> edges{};
        edges[face] = A;
        const Intake intake(1.4, edges);
        const double count = -intake.gas.passages.face[face].mass / intake.particle_mass;
        ASSERT_GT(intake.expected_count(areas[face]), 100);
        EXPECT_NEAR(count, intake.expected_count(areas[face]), 1.001) << "face " << face;
        EXPECT_NEAR(static_cast<double>(intake.gas.particles.size()), count, 1e-6) << "face " << face;
    }
}

/// Through a face comes kT a particle of energy along the normal (exponential law), kT across, kT zeta/2 within (Gamma law).
TEST(Inflow, brings_the_energy_of_a_maxwellian)
{
    for (const double gamma : {1.3, 1.4, 5.0 / 3}) {
        const Intake intake(gamma, {A, A, A, A, A, A});
        const double kt = intake.particle_mass * intake.sigma * intake.sigma, half_freedoms = 0.5 * intake.gas.species[0].internal_freedoms;
        std::vector<double> internal;
        double energy = 0, stayed = 0;
        for (const Particle& p : intake.gas.particles) {
            internal.push_back(static_cast<double>(p.energy));
            energy += carried(intake.gas, p).energy;
            if (!(p.tag & particle_tag::gone)) stayed += carried(intake.gas, p).energy;  // near an edge some leave at once
        }
        const auto count = static_cast<double>(internal.size());
        EXPECT_NEAR(energy / count, (2 + half_freedoms) * kt, 4 * std::sqrt((2 + half_freedoms) / count) * kt) << "gamma " << gamma;
        EXPECT_NEAR(Statistics(internal).mean, half_freedoms * kt, 4 * std::sqrt(half_freedoms / count) * kt + 1e-12 * kt);
        double given = 0;
        for (const Passage& passage : intake.gas.passages.face) given -= passage.energy;
        EXPECT_NEAR(given, stayed, 1e-9 * energy);
    }
}

/// Through one face only: normal speeds have Rayleigh's law, the others are normal; entry times are spread evenly over the step.
TEST(Inflow, comes_from_a_face_with_the_right_speeds_and_places)
{
    for (const int face : {0, 5}) {
        std::array<Edge, face_count> edges{};
        edges[face] = A;
        edges[(face + 1) % face_count] = Edge::open;
        const Intake intake(1.4, edges);
        const int axis = face / 2;
        const double sigma = intake.sigma, inward = face % 2 == 0 ? 1 : -1;
        const Box& box = intake.gas.domain.box;
        std::vector<double> normal, across, depth, place;
        for (const Particle& p : intake.gas.particles) {
            ASSERT_TRUE(box.contains(Vector3d(p.position)) || (p.tag & particle_tag::gone));
            normal.push_back(inward * static_cast<double>(p.velocity[axis]));
            across.push_back(static_cast<double>(p.velocity[(axis + 1) % 3]));
            depth.push_back(std::abs(static_cast<double>(p.position[axis]) - (face % 2 == 0 ? box.lower : box.upper)[axis]));
            place.push_back(static_cast<double>(p.position[(axis + 1) % 3]) / box.size()[(axis + 1) % 3]);
        }
        const double count = static_cast<double>(normal.size()), mean = sigma * std::sqrt(std::numbers::pi / 2);
        ASSERT_GT(count, 100);
        EXPECT_GT(*std::min_element(normal.begin(), normal.end()), 0);
        EXPECT_NEAR(Statistics(normal).mean, mean, 4 * Statistics(normal).error());
        EXPECT_NEAR(Statistics(normal).variance, sigma * sigma * (2 - std::numbers::pi / 2),
                    4 * 0.43 * sigma * sigma * std::sqrt(2.25 / count));
        EXPECT_NEAR(Statistics(across).mean, 0, 4 * sigma / std::sqrt(count));
        EXPECT_NEAR(Statistics(across).variance, sigma * sigma, 4 * sigma * sigma * std::sqrt(2 / count));
        EXPECT_NEAR(Statistics(depth).mean, 0.5 * duration * mean, 4 * Statistics(depth).error());
        EXPECT_NEAR(Statistics(place).mean, 0.5, 4 / std::sqrt(12 * count));
    }
}

TEST(Inflow, does_not_come_through_rigid_or_open_faces_or_out_of_vacuum)
{
    EXPECT_TRUE(Intake(1.4, {Edge::rigid, Edge::open, Edge::rigid, Edge::open, Edge::rigid, Edge::open}).gas.particles.empty());
    Gas gas;
    gas.domain = {unit_box, {A, A, A, A, A, A}};
    gas.species.push_back(species_of(IdealGas{1.4}, 1e-5));
    Clock clock;
    clock.begin_step(1e-3);
    flow_in(gas, clock, nullptr);
    EXPECT_TRUE(gas.particles.empty());
}

}  // namespace
}  // namespace corpuscle
