#include <gtest/gtest.h>

#include <cstdio>

#include "verification/gas/kinetics/normal_shock.hpp"

namespace corpuscle {
namespace {

/// Structure of a normal shock in a gas of hard spheres, gamma 5/3: the mean free path before it over the density-slope thickness is 0.255
/// at M 2 and 0.435 at M 8 (direct simulation, Bird 1994; +-3 % between sources). Bounds: 4 %, that is these 3 and 1 for cells of at most 4
/// (1.4 spacings wide) at a path of 8 spacings (Alexander, Garcia and Alder: 16/(45 pi) L^2/lambda^2 of the viscosity, 0.4 % before and 1.2
/// % behind the strong shock) and the cubic that reads the slope (0.7 %); and 4 sigma of the blocks that the profiles come in.
void expect_thickness(const NormalShock& set, double expected)
{
    const double mach = set.mach;
    const ShockFound found = run(set);
    const ShockJump jump(mach);
    std::printf("M %.0f: path/thickness %.4f (%.3f), sigma %.4f; density behind %.3f (%.3f), speed %.3f, %zu profiles\n", mach,
                found.thickness_ratio, expected, found.error, found.density_ratio, jump.density, found.speed, found.profiles);
    EXPECT_NEAR(found.thickness_ratio, expected, 0.04 * expected + 4 * found.error);
    EXPECT_LT(found.error, 0.05 * expected);
    EXPECT_NEAR(found.speed / mach, 1, 0.03);  // Rankine and Hugoniot
    EXPECT_NEAR(found.density_ratio / jump.density, 1, 0.03);
}

TEST(NormalShock, mach_2)
{
    expect_thickness({.mach = 2, .path = 8, .width = 18, .formed = 10, .end = 32}, 0.255);
}
TEST(NormalShock, mach_8)
{
    expect_thickness({.mach = 8, .path = 8, .width = 10, .formed = 11, .end = 22}, 0.435);
}

}  // namespace
}  // namespace corpuscle
