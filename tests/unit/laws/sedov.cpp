#include "laws/blast/sedov.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace corpuscle {
namespace {

constexpr double gammas[] = {1.2, 1.4, 1.5, 5.0 / 3};

TEST(SedovBlast, front_of_gamma_1_4_is_at_one_after_a_second)
{
    // Kamm & Timmes, LA-UR-07-2849: the energy 0.851072 that puts the front at 1; six digits.
    const SedovBlast blast(1.4, 1, 0.851072);
    EXPECT_NEAR(blast.radius(1), 1, 0.5e-6 / 0.851072 / 5 + 1e-9);
    EXPECT_NEAR(blast.front_speed(1), 0.4, 1e-6);
    EXPECT_NEAR(blast.radius(32), 4, 1e-5);
}

TEST(SedovBlast, behind_the_front_is_the_strong_shock)
{
    for (const double gamma : gammas) {
        const SedovBlast blast(gamma, 1.2, 3);
        const double speed = blast.front_speed(0.5);
        const BlastFlow peak = blast.behind_front(0.5), near = blast.at(blast.radius(0.5) * (1 - 1e-12), 0.5);
        EXPECT_NEAR(near.density / peak.density, 1, 1e-9);
        EXPECT_NEAR(near.velocity / peak.velocity, 1, 1e-9);
        EXPECT_NEAR(near.pressure / peak.pressure, 1, 1e-9);
        EXPECT_NEAR(1.2 * speed / (peak.density * (speed - peak.velocity)), 1, 1e-14);                             // mass
        EXPECT_NEAR(1.2 * speed * peak.velocity / peak.pressure, 1, 1e-14);                                        // momentum
        EXPECT_NEAR(peak.pressure / ((gamma - 1) * peak.density) / (0.5 * std::pow(peak.velocity, 2)), 1, 1e-13);  // energy
        EXPECT_EQ(blast.at(blast.radius(0.5) * 1.0001, 0.5).density, 1.2);
    }
}

TEST(SedovBlast, holds_the_mass_it_has_swept_and_the_energy_released)
{
    for (const double gamma : gammas) {
        const SedovBlast blast(gamma, 1.2, 3);
        constexpr int pieces = 20000;
        double mass = 0, energy = 0;
        for (int k = 0; k < pieces; ++k) {
            const double r = blast.radius(2) * (k + 0.5) / pieces;
            const BlastFlow flow = blast.at(r, 2);
            const double volume = 4 * std::numbers::pi * r * r * blast.radius(2) / pieces;
            mass += flow.density * volume;
            energy += (0.5 * flow.density * flow.velocity * flow.velocity + flow.pressure / (gamma - 1)) * volume;
        }
        EXPECT_NEAR(mass / (4 * std::numbers::pi / 3 * std::pow(blast.radius(2), 3) * 1.2), 1, 1e-6) << gamma;
        EXPECT_NEAR(energy / 3, 1, 1e-6) << gamma;
    }
}

TEST(SedovBlast, obeys_eulers_equations)
{
    for (const double gamma : gammas) {
        const SedovBlast blast(gamma, 1.2, 3);
        for (const double share : {0.3, 0.6, 0.9, 0.98}) {
            const double t = 1.5, r = share * blast.radius(t), h = 1e-4;
            const BlastFlow here = blast.at(r, t);
            const auto by_place = [&](auto member) {
                return (blast.at(r * (1 + h), t).*member - blast.at(r * (1 - h), t).*member) / (2 * h * r);
            };
            const auto by_time = [&](auto member) {
                return (blast.at(r, t * (1 + h)).*member - blast.at(r, t * (1 - h)).*member) / (2 * h * t);
            };
            const auto along = [&](auto member) { return by_time(member) + here.velocity * by_place(member); };
            const double divergence = by_place(&BlastFlow::velocity) + 2 * here.velocity / r;
            EXPECT_NEAR(along(&BlastFlow::density) / (here.density * divergence), -1, 1e-4) << gamma << " " << share;
            EXPECT_NEAR(along(&BlastFlow::velocity) * here.density / by_place(&BlastFlow::pressure), -1, 1e-3) << gamma << " " << share;
            EXPECT_NEAR(along(&BlastFlow::pressure) / (gamma * here.pressure * divergence), -1, 1e-4) << gamma << " " << share;
        }
    }
}

TEST(SedovBlast, centre_is_empty_hot_and_at_a_steady_pressure)
{
    const SedovBlast blast(1.4, 1, 0.851072);
    const BlastFlow a = blast.at(1e-2, 1), b = blast.at(1e-6, 1);
    EXPECT_LT(b.density, 1e-10);
    EXPECT_NEAR(a.pressure / b.pressure, 1, 1e-5);
    EXPECT_NEAR(b.velocity / (0.4e-6 / 1.4), 1, 1e-9);
}

TEST(SedovBlast, refuses_what_has_no_similarity)
{
    EXPECT_THROW(SedovBlast(2, 1, 1), InputError);
    EXPECT_THROW(SedovBlast(1, 1, 1), InputError);
    EXPECT_THROW(SedovBlast(1.4, 0, 1), InputError);
    EXPECT_THROW(SedovBlast(1.4, 1, -1), InputError);
}

}  // namespace
}  // namespace corpuscle
