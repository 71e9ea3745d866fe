#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "grid_walls.hpp"

namespace corpuscle {
namespace {

constexpr std::size_t cells = 40;
constexpr double width = 1.0 / cells, middle = 14.5 * width, rim = 20.48 * width, slit = 0.09 * width;
constexpr std::uint32_t pieces = 10;
/// Of the charge above the surface, in cells.
constexpr double distance = 12;

/// A plate and, beyond a slit, a frame, both flat and at one height. A line through cells' middles passes the slit, where the plate alone
/// reaches over to it: the faces that close the slit must stay shut.
struct PlateAndFrame {
    MovingSurface surface;
    std::size_t frame = 0;  ///< its first facet
};
PlateAndFrame plate_and_frame(double height)
{
    PlateAndFrame both;
    add_sheet(both.surface, {-0.1, height, -1}, {rim + 0.1, 0, 0}, {0, 0, 3}, pieces);
    both.frame = add_sheet(both.surface, {rim + slit, height, -1}, {2, 0, 0}, {0, 0, 3});
    return both;
}

/// Impulses of the gas on plate and frame, and the mass that passed them in part of what lay above.
struct Felt {
    double plate = 0, frame = 0, passed = 0;
};

/// A round charge bursts above; the plate's nodes between its ends tremble between `lower` and `upper`, in cells, from step to step.
Felt burst_over(double height, double lower, double upper)
{
    EulerGrid grid = unit_grid(cells, cells, 1, EulerEdge::open, {plain("above", IdealGas{1.4}), plain("below", IdealGas{1.4})});
    const Vector3d charge{0, middle + distance * width, 0.5};
    fill(grid, [&](const Vector3d& x) {
        const double parted = height > middle ? middle + 0.25 * width : middle - 0.25 * width;  // as the walls part the cells
        const bool burst = std::hypot(x.x, x.y - charge.y) < 4 * width;
        return EulerSample{x.y < parted ? std::size_t{1} : std::size_t{0}, burst ? 20.0 : 1.0, burst ? 100.0 : 1.0, {}};
    });
    const PlateAndFrame both = plate_and_frame(height);
    WalledGas gas(std::move(grid), both.surface, 0);
    const EulerAmount first = contents(gas.grid).gas;
    const double end = 0.35;
    while (gas.clock.time() < end * (1 - 1e-12)) {
        const double limit = std::min({stable_step(gas.grid), gas.walls.stable_step(), end - gas.clock.time()});
        const double to = height + width * (gas.clock.step() % 2 == 0 ? lower : upper);
        for (std::uint32_t n = 0; n < 2 * (pieces + 1); ++n) {
            const bool held = n % (pieces + 1) == 0 || n % (pieces + 1) == pieces;
            gas.structure.nodes.velocity[n].y = held ? 0.0 : (to - gas.structure.nodes.position[n].y) / limit;
        }
        gas.step(limit);
    }
    Felt felt;
    const std::vector<Vector3d>& impulse = gas.walls.facet_impulse();
    for (std::size_t f = 0; f < impulse.size(); ++f) (f < both.frame ? felt.plate : felt.frame) -= impulse[f].y;
    for (std::size_t c = 0; c < gas.grid.cells(); ++c) {
        const double off = gas.grid.middle(c).y - middle;
        if (std::abs(off) > 0.5 * width) felt.passed += gas.grid.volume(c) * gas.grid.now.mass[off > 0 ? 1 : 0][c];
    }
    felt.passed /= first.mass[0];
    return felt;
}

void show(const char* what, const Felt& felt)
{
    std::printf("%-34s plate %.6f, frame %.6f, passed %.1e\n", what, felt.plate, felt.frame, felt.passed);
}

/// A plate in the very middles of cells that trembles by some 1e-5 of a cell below them feels what one at rest a fiftieth of a cell lower
/// feels, and so does the frame beyond its rim: no wall stands up where the rim reaches over. The bound: what a round burst does on the
/// way d falls no faster than d^-2 in a plane, so a fiftieth of a cell in 12 changes it by 2/600; the trembling's own speed adds 1e-4 of
/// the gas' pressure back and forth.
TEST(GridTremble, a_plate_in_the_cells_middles_feels_what_one_beside_them_does)
{
    const double off = 0.02, bound = 2 * off / distance + 1e-4, tremble = 2e-5;
    const Felt lower = burst_over(middle - off * width, 0, 0), below = burst_over(middle, -tremble, 0);
    show("at rest, lower", lower);
    show("trembles below the middles", below);
    EXPECT_NEAR(below.plate / lower.plate, 1, bound);
    EXPECT_NEAR(below.frame / lower.frame, 1, bound);
    for (const Felt& felt : {lower, below}) EXPECT_EQ(felt.passed, 0);
}

/// A plate that trembles across the middles, so that its cells change sides in each step, lets no gas pass, nor does the slit; nor does a
/// plate a hair above the middles whose frame lies a hair below, in cells of its own side. Both plates feel what one at rest a fiftieth of
/// a cell higher feels, by the bound above. The frame's own share is shown: it changes by some per cent with the side of the middles it is
/// on.
TEST(GridTremble, a_plate_that_passes_the_cells_middles_to_and_fro_is_tight)
{
    const double off = 0.02, bound = 2 * off / distance + 1e-4, tremble = 2e-5;
    const Felt higher = burst_over(middle + off * width, 0, 0), across = burst_over(middle, -tremble, tremble),
               apart = burst_over(middle, tremble, tremble);
    show("at rest, higher", higher);
    show("trembles across the middles", across);
    show("a hair above, frame a hair below", apart);
    for (const Felt& felt : {across, apart}) {
        EXPECT_EQ(felt.passed, 0);
        EXPECT_NEAR(felt.plate / higher.plate, 1, bound);
    }
}

}  // namespace
}  // namespace corpuscle
