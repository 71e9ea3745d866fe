#include <gtest/gtest.h>

#include <cstdio>

#include "verification/gas/kinetics/vacuum.hpp"

namespace corpuscle {
namespace {

/// Gas flies into a vacuum at 2 s0/(gamma - 1), whatever its co-volume. The gas of particles is viscous: over the fan's depth h = c0 t the
/// error is of first order in the mean free path over h, and more for a dense gas, whose groups of up to 64 particles collide as one
/// cell 3.6 spacings wide (4 % of 80). So the bound is that width over the gas's length, in both directions, and 4 sigma; and both readings
/// must come nearer to theory with a gas twice as long.
TEST(Vacuum, escape_speed_knows_no_co_volume)
{
    for (const double filled : {0.0, 0.3, 0.6}) {
        const Escape found = escape({.filled = filled, .length = 80, .width = 14});
        std::printf("phi %.1f: edge %.4f of theory, sigma %.4f; u + 2 s/(gamma - 1) %.4f\n", filled, found.edge, found.edge_error,
                    found.invariant);
        EXPECT_NEAR(found.edge, 1, 3.6 / 80 + 4 * found.edge_error) << filled;
        EXPECT_NEAR(found.invariant, 1, 3.6 / 80) << filled;
        EXPECT_LT(found.edge_error, 0.015) << filled;
    }
}

TEST(Vacuum, invariant_of_the_fan_comes_nearer_with_more_particles)
{
    const Escape coarse = escape({.filled = 0.3, .length = 40, .width = 14}), fine = escape({.filled = 0.3, .length = 160, .width = 10});
    std::printf("u + 2 s/(gamma - 1): %.4f and %.4f of theory\n", coarse.invariant, fine.invariant);
    EXPECT_LT(std::abs(fine.invariant - 1), 0.6 * std::abs(coarse.invariant - 1));
}

}  // namespace
}  // namespace corpuscle
