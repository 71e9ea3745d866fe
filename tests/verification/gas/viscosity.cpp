#include <gtest/gtest.h>

#include <cstdio>

#include "verification/gas/kinetics/vortex_decay.hpp"

namespace corpuscle {
namespace {

/// A vortex decays with the viscosity of hard spheres and what partners at a distance add to it (docs/theory/gas.md). Bound: 4 sigma of the
/// vortex's own thermal noise, and what theory leaves out: squares of k times the mean free path, k lambda = 0.08 and 0.16 (Burnett), and
/// of A over the speed of sound, 0.09 at the start and falling (the flow is not quite without compression): 3 % each.
TEST(Viscosity, is_that_of_hard_spheres_and_of_partners_at_a_distance)
{
    for (const double path : {1.0, 2.0}) {
        const VortexFound found = decay({.mean_free_path = path, .side = 40, .height = 60});
        std::printf("kappa %.2f: nu %.3f sigma spacings, sigma %.3f; theory %.3f: spheres %.3f, cells %.3f\n", path, found.viscosity,
                    found.error, found.expected(), found.kinetic, found.cells);
        EXPECT_NEAR(found.viscosity / found.expected(), 1, 4 * found.error / found.expected() + 0.06);
        EXPECT_LT(found.error, 0.04 * found.viscosity);
        EXPECT_GT(found.viscosity, found.kinetic);  // or the second part would go unseen
    }
}

/// Smaller cells make a thinner gas, and so do nearer partners: at half a spacing of mean free path most of the viscosity is the cells'.
TEST(Viscosity, falls_with_smaller_cells_and_nearer_partners)
{
    const VortexFound large = decay({.mean_free_path = 0.5, .side = 40, .height = 60, .cell_limit = 16});
    const VortexFound small = decay({.mean_free_path = 0.5, .side = 40, .height = 60, .cell_limit = 4});
    const VortexFound near = decay({.mean_free_path = 0.5, .side = 40, .height = 60, .cell_limit = 16, .partners = 4});
    std::printf("cells of up to 16: %.3f, of up to 4: %.3f, nearest of 4 partners: %.3f\n", large.viscosity, small.viscosity,
                near.viscosity);
    EXPECT_LT(near.viscosity, large.viscosity - 4 * std::hypot(near.error, large.error));
    EXPECT_LT(small.viscosity, large.viscosity - 4 * std::hypot(small.error, large.error));
}

}  // namespace
}  // namespace corpuscle
