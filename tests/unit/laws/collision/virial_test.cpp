#include "laws/collision/virial.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "laws/collision/hard_sphere.hpp"
#include "laws/eos/ideal_gas.hpp"
#include "laws/eos/jwl.hpp"
#include "laws/eos/noble_abel.hpp"

namespace corpuscle {
namespace {

TEST(HardSphere, candidates_are_those_of_the_cross_section_of_the_mean_free_path)
{
    const double n = 17, fastest = 900, dt = 3e-6, path = 0.02, volume = 1.7e-4;
    const double section = volume / (std::sqrt(2.0) * n * path);
    EXPECT_NEAR(candidate_pairs(n, fastest, dt, path), n * (n - 1) / 2 * section * fastest * dt / volume, 1e-9);
    EXPECT_EQ(candidate_pairs(1.0, fastest, dt, path), 0);
}

TEST(Virial, displacement_gives_its_pressure_back)
{
    const double pressure = 3e9, volume = 2e-6, dt = 1e-7, changes = 5;
    EXPECT_NEAR(changes * displacement_length(pressure, volume, dt, changes) / (6 * volume * dt), pressure, 1e-6 * pressure);
}

/// Mean relative speed 4 sqrt(kT/(pi m)) over root mean square sqrt(3 kT/m).
TEST(Virial, mean_relative_speed_is_maxwells)
{
    EXPECT_NEAR(mean_relative_speed(1.0), 4 / std::sqrt(3 * std::numbers::pi), 1e-7);
}

/// Later collisions of a particle are Poisson distributed with mean nu (1 - s) at the moment s of the step: mean of 2^-k.
double surviving_by_sums(double nu)
{
    constexpr int moments = 2000;
    double mean = 0;
    for (int i = 0; i < moments; ++i) {
        const double left = nu * (1 - (i + 0.5) / moments);
        double chance = std::exp(-left);
        for (int k = 0; k < 60; ++k, chance *= left / k) mean += chance * std::ldexp(1.0, -k) / moments;
    }
    return mean;
}

TEST(Virial, surviving_displacement_is_the_mean_over_later_collisions)
{
    for (const double nu : {1e-5, 1.9e-3, 2.1e-3, 0.1, 1.0, 4.0})
        EXPECT_NEAR(surviving_displacement(nu), surviving_by_sums(nu), 1e-6) << nu;
    EXPECT_EQ(surviving_displacement(0.0), 1);
}

/// Laws whose virial pressure is a power of density, for which the correction can be worked out.
struct Power {
    double exponent;
    [[nodiscard]] double virial_pressure(double density, double /*kinetic*/) const { return 7 * std::pow(density, exponent); }
};

TEST(Virial, mean_leaves_straight_laws_alone)
{
    EXPECT_EQ(mean_virial_pressure(IdealGas{1.4}, 2.0, 3.0, 10.0), 0);
    EXPECT_NEAR(mean_virial_pressure(Power{1}, 2.0, 3.0, 10.0), 14, 1e-12);
}

/// A square law over a density that varies by the share w, w^2 = p_k/(p_k + 2 p_v)/n: its mean is p_v (1 + w^2), so p_v (1 - w^2).
TEST(Virial, mean_of_a_square_law_loses_its_variance)
{
    for (const double n : {8.0, 40.0}) {
        const double virial = 7 * 4.0, kinetic = 3, squared = kinetic / (2 * virial + kinetic) / n;
        EXPECT_NEAR(mean_virial_pressure(Power{2}, 2.0, kinetic, n), virial * (1 - squared), 1e-9 * virial);
    }
}

/// Mean error over densities spread normally by the width that the correction assumes, over the law at the mean: plain and corrected.
template <class Law>
std::pair<double, double> mean_errors(const Law& law, double density, double kinetic, double n)
{
    const auto plain = [&](double factor) { return law.virial_pressure(density * factor, kinetic * factor); };
    const double slope = (plain(1.001) - plain(0.999)) / 0.002, width = std::sqrt(kinetic / (slope + kinetic) / n);
    double total = 0, of_plain = 0, of_mean = 0;
    for (int i = -400; i <= 400; ++i) {
        const double deviation = i / 100.0, weight = std::exp(-0.5 * deviation * deviation), factor = 1 + width * deviation;
        total += weight;
        of_plain += weight * plain(factor);
        of_mean += weight * mean_virial_pressure(law, density * factor, kinetic * factor, n * factor);
    }
    return {of_plain / total / plain(1) - 1, of_mean / total / plain(1) - 1};
}

/// The second order is taken off; what is left is of fourth order, so a small part of what was there.
TEST(Virial, correction_takes_off_most_of_the_convexity)
{
    const Jwl jwl{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630};
    const auto small = [](std::pair<double, double> errors, const char* what) {
        EXPECT_GT(errors.first, 0) << what;
        EXPECT_LT(std::abs(errors.second), 0.25 * errors.first + 1e-6)
            << what << ": plain " << errors.first << ", corrected " << errors.second;
    };
    for (const double n : {20.0, 40.0, 60.0}) {
        small(mean_errors(jwl, 1630.0, 2.1e9, n), "JWL at V 1");
        small(mean_errors(jwl, 815.0, 1.0e9, n), "JWL at V 2");
        small(mean_errors(NobleAbel{1.3, 0.3, 1630}, 1086.0, 1.4e9, n), "Noble-Abel b 0.3");
        small(mean_errors(NobleAbel{1.3, 0.6, 1630}, 1358.0, 1.7e9, n), "Noble-Abel b 0.6");
    }
}

}  // namespace
}  // namespace corpuscle
