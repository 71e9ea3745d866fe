#include <gtest/gtest.h>

#include <cstdio>

#include "verification/gas/kinetics/relaxation.hpp"

namespace corpuscle {
namespace {

/// Molecules like nitrogen's, translation at 10000 K and rotation at 100 K, come to (3 * 10000 + 2 * 100)/5 = 6040 K, both; 4 sigma.
TEST(Relaxation, both_temperatures_come_to_6040_kelvin)
{
    const RelaxationFound found = relax({.gamma = 1.4, .relaxation = 2, .count = 40000});
    std::printf("translation %.1f K, rotation %.1f K, sigma %.1f K; energy %.1e\n", found.translational, found.internal, found.error,
                found.energy_error);
    EXPECT_NEAR(found.translational, 6040, 4 * found.error);
    EXPECT_NEAR(found.internal, 6040, 4 * 1.5 * found.error);  // the rest of a fixed sum, by freedoms 3 to 2
    EXPECT_NEAR(found.energy_error, 0, 1e-6);
}

/// The rate per collision against its derivation (relaxation_rate), 4 sigma. That takes the velocities for Maxwellian, which those of
/// particles that exchange are not: of the particles' collisions a share 1/Z shifts them, so the rest is of the order of 1/Z of the rate
/// (4 % measured at Z = 1, see docs/validation.md), and large Z is taken here.
TEST(Relaxation, rate_is_that_of_borgnakke_and_larsen)
{
    for (const double gamma : {1.4, 1.3}) {
        const Relaxation set{.gamma = gamma, .relaxation = 10, .count = 40000, .to_the_end = false};
        const RelaxationFound found = relax(set);
        const double expected = relaxation_rate(internal_freedoms(gamma), set.relaxation);
        std::printf("gamma %.1f: rate %.5f a collision (%.5f, sigma %.5f)\n", gamma, found.rate, expected, found.rate_error);
        EXPECT_NEAR(found.rate, expected, 4 * found.rate_error);
        EXPECT_LT(found.rate_error, 0.02 * expected);
    }
}

}  // namespace
}  // namespace corpuscle
