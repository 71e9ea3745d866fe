#include "laws/eos/chapman_jouguet.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace corpuscle {
namespace {

const Jwl tnt{371.2e9, 3.231e9, 4.15, 0.95, 0.30, 1630};
constexpr double tnt_energy = 7e9 / 1630;

TEST(ChapmanJouguet, ideal_gas_has_the_textbook_front)
{
    // D^2 = 2 (gamma^2 - 1) e, p = rho0 D^2/(gamma + 1), rho = rho0 (gamma + 1)/gamma, u = D/(gamma + 1).
    for (const double gamma : {1.2, 1.4, 5.0 / 3}) {
        const ChapmanJouguet front = chapman_jouguet(IdealGas{gamma}, 1500, 4e6);
        const double velocity = std::sqrt(2 * (gamma * gamma - 1) * 4e6);
        EXPECT_NEAR(front.detonation_velocity / velocity, 1, 1e-12) << gamma;
        EXPECT_NEAR(front.pressure / (1500 * velocity * velocity / (gamma + 1)), 1, 1e-12) << gamma;
        EXPECT_NEAR(front.density / (1500 * (gamma + 1) / gamma), 1, 1e-12) << gamma;
        EXPECT_NEAR(front.particle_velocity / (velocity / (gamma + 1)), 1, 1e-12) << gamma;
    }
}

TEST(ChapmanJouguet, co_volume_raises_the_speed_by_one_over_one_less_b)
{
    for (const double b : {0.1, 0.3, 0.649, 0.9}) {
        const ChapmanJouguet front = chapman_jouguet(NobleAbel{1.3, b, 1630}, 1630, tnt_energy);
        EXPECT_NEAR(front.detonation_velocity / (std::sqrt(2 * (1.69 - 1) * tnt_energy) / (1 - b)), 1, 1e-12) << b;
    }
}

TEST(ChapmanJouguet, front_keeps_mass_momentum_energy_and_leaves_at_the_speed_of_sound)
{
    const ChapmanJouguet front = chapman_jouguet(tnt, 1630, tnt_energy);
    const double leaving = front.detonation_velocity - front.particle_velocity;
    EXPECT_NEAR(front.density * leaving / (1630 * front.detonation_velocity), 1, 1e-13);
    EXPECT_NEAR(front.pressure / (1630 * front.detonation_velocity * front.particle_velocity), 1, 1e-13);
    EXPECT_NEAR((front.energy - tnt_energy) / (0.5 * front.particle_velocity * front.particle_velocity), 1, 1e-12);
    EXPECT_NEAR(tnt.pressure(front.density, front.energy) / front.pressure, 1, 1e-12);
    EXPECT_NEAR(leaving / tnt.sound_speed(front.density, front.energy), 1, 1e-12);
}

TEST(ChapmanJouguet, refuses_an_explosive_that_cannot_detonate)
{
    EXPECT_THROW((void)chapman_jouguet(NobleAbel{1.3, 0.3, 480}, 1630, tnt_energy), InputError);
    EXPECT_THROW((void)chapman_jouguet(IdealGas{1.4}, 1630, -1), InputError);
}

TEST(Isentrope, jwl_follows_its_closed_form)
{
    // On an isentrope E = A/R1 exp(-R1 V) + B/R2 exp(-R2 V) + C/w V^-w.
    const auto cold = [](double v) { return 371.2e9 / 4.15 * std::exp(-4.15 * v) + 3.231e9 / 0.95 * std::exp(-0.95 * v); };
    const ChapmanJouguet front = chapman_jouguet(tnt, 1630, tnt_energy);
    const double first = 1630 / front.density;
    const double c_over_w = (1630 * front.energy - cold(first)) * std::pow(first, 0.3);
    EXPECT_NEAR(0.3 * c_over_w, 1.0452e9, 0.0001e9);  // the published C
    for (const double v : {1.0, 2.2, 10.0, 100.0}) {
        const double expected = (cold(v) + c_over_w * std::pow(v, -0.3)) / 1630;
        EXPECT_NEAR(energy_on_isentrope(tnt, front.density, front.energy, 1630 / v) / expected, 1, 1e-8) << v;
    }
}

TEST(Isentrope, noble_abel_keeps_energy_times_free_volume_to_a_power)
{
    const NobleAbel law{1.3, 0.3, 1630};
    const double energy = energy_on_isentrope(law, 1630, 4e6, 163);
    EXPECT_NEAR(energy / (4e6 * std::pow((1 - 0.3) / (10 - 0.3), 0.3)), 1, 1e-9);
}

TEST(Isentrope, lost_energy_is_the_work_of_pressure)
{
    // Simpson's sum of p dv along the states, over volume where the integrator goes over log density.
    const ChapmanJouguet front = chapman_jouguet(tnt, 1630, tnt_energy);
    const double last = 1630 / 3.0;
    constexpr int pieces = 400;
    const double step = (1 / last - 1 / front.density) / pieces;
    const auto pressure_at = [&](double k) {
        const double density = 1 / (1 / front.density + k * step);
        return tnt.pressure(density, energy_on_isentrope(tnt, front.density, front.energy, density, 200));
    };
    double work = 0;
    for (int i = 0; i < pieces; ++i) work += step / 6 * (pressure_at(i) + 4 * pressure_at(i + 0.5) + pressure_at(i + 1));
    EXPECT_NEAR(work / (front.energy - energy_on_isentrope(tnt, front.density, front.energy, last)), 1, 1e-8);
}

TEST(Isentrope, there_and_back)
{
    const double out = energy_on_isentrope(tnt, 1630, 4e6, 16);
    EXPECT_NEAR(energy_on_isentrope(tnt, 16, out, 1630) / 4e6, 1, 1e-8);
}

}  // namespace
}  // namespace corpuscle
