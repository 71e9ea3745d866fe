#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "grid_walls.hpp"

namespace corpuscle {
namespace {

/// A large sheet through a place, across a normal.
MovingSurface sheet_across(const Vector3d& place, const Vector3d& normal)
{
    const Vector3d a = normalized(cross(normal, std::abs(normal.z) < 0.9 ? Vector3d{0, 0, 1} : Vector3d{1, 0, 0})),
                   b = cross(normalized(normal), a);
    MovingSurface sheet;
    add_sheet(sheet, place - 3.0 * a - 3.0 * b, 6.0 * a, 6.0 * b);
    return sheet;
}

/// A stream that meets a wall across it: behind the shock that the wall sends back, and behind the wall, where it leaves, the pressures
/// that bring gas to rest; with the wall along the grid, across a plane's diagonal, and askew in space. The bound is what one calls
/// resolved here, 3 %; the scatter over the wall's cells is shown.
TEST(GridOblique, a_stream_is_stopped_by_a_wall_at_any_angle)
{
    const double sound = std::sqrt(1.4), speed = sound, part = 0.25 * 2.4 * speed;
    const double pushed = 1 + speed * (part + std::hypot(part, sound)), drawn = std::pow(1 - 0.2 * speed / sound, 7);
    const Vector3d place{0.497, 0.503, 0.501};
    for (const Vector3d& towards : {Vector3d{1, 0, 0}, Vector3d{1, 1, 0}, Vector3d{1, 0.6, 0.35}, Vector3d{1, 1, 1}}) {
        const Vector3d n = normalized(towards);
        EulerGrid grid = unit_grid(40, 40, 40, EulerEdge::open, {plain("air", IdealGas{1.4})});
        fill(grid, [&](const Vector3d&) { return EulerSample{0, 1, 1, speed * n}; });
        WalledGas gas(std::move(grid), sheet_across(place, n), 0);
        gas.run_to(0.2);
        const auto seen = [&](const Vector3d& x) { return norm(x - place) < 0.2; };
        const auto [before, scatter_before] = gas.pressure_on(seen, -n);
        const auto [behind, scatter_behind] = gas.pressure_on(seen, n);
        std::printf("towards (%g, %g, %g): stopped %.4f of theory, scatter %.4f; drawn %.4f, scatter %.4f\n", towards.x, towards.y,
                    towards.z, before / pushed, scatter_before / pushed, behind / drawn, scatter_behind / drawn);
        EXPECT_NEAR(before / pushed, 1, 0.03);
        EXPECT_NEAR(behind / drawn, 1, 0.03);
    }
}

/// A stream along a wall askew in a plane goes on as it is, but for the 1e-6 of a cell by which walls see the middles aside, where nothing
/// of the grid's edges has come: a staircase of cells is no rough wall.
TEST(GridOblique, a_stream_along_a_wall_is_not_disturbed)
{
    const double speed = 2;
    for (const double slope : {0.0, 0.1, 0.37, 0.5, 0.93, 1.0, 2.7}) {
        const Vector3d along = normalized(Vector3d{1, slope, 0});
        EulerGrid grid = unit_grid(40, 40, 1, EulerEdge::open, {plain("air", IdealGas{1.4})});
        fill(grid, [&](const Vector3d&) { return EulerSample{0, 1, 1, speed * along}; });
        WalledGas gas(std::move(grid), sheet_across({0.497, 0.503, 0.5}, {-along.y, along.x, 0}), 0);
        gas.run_to(0.03);  // in some 10 steps, each of which carries word of the edges by two cells
        double most = 0, all = 0;
        for (std::size_t c = 0; c < gas.grid.cells(); ++c) {
            const double off = std::abs(look(gas.grid, c).pressure - 1);
            if (norm(gas.grid.middle(c) - Vector3d{0.5, 0.5, 0.5}) < 0.1) most = std::max(most, off);
            all = std::max(all, off);
        }
        std::printf("slope %.2f, %d steps: pressure off by %.2e, at the edges by %.2e\n", slope, int(gas.clock.step()), most, all);
        EXPECT_LT(most, 1e-5);  // that 1e-6 of a cell, times rho c u, each step until the first ones have gone by
    }
}

}  // namespace
}  // namespace corpuscle
