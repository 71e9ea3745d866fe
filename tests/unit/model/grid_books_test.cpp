#include "model/grid_books.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "euler/fill.hpp"
#include "euler/flow.hpp"
#include "model/model.hpp"

namespace corpuscle {
namespace {

/// A pipe of rings in which gas rises along the axis.
EulerGrid rising(EulerEdge top)
{
    EulerGrid grid = make_grid(EulerSpace::axisymmetric, {even_faces(0, 0.5, 5), even_faces(0, 1, 10), {}},
                               {EulerEdge::rigid, EulerEdge::rigid, EulerEdge::rigid, top, EulerEdge::rigid, EulerEdge::rigid},
                               {{"air", IdealGas{1.4}, {}, 0}});
    fill(grid, [](const Vector3d& at) { return EulerSample{0, 1.2, 1e5, {0, 100 * at.y, 0}, 0, false}; });
    return grid;
}

/// Radial momentum sums to nothing round the axis; along it, the books close with what the edges got.
TEST(GridBooks, OfRingsHoldMomentumAlongTheAxisAlone)
{
    for (const EulerEdge top : {EulerEdge::rigid, EulerEdge::open}) {
        EulerGrid grid = rising(top);
        const Holding before = held(grid);
        EXPECT_EQ(before.momentum.x, 0);
        EXPECT_NEAR(before.momentum.z, before.mass * 50, 1e-9);
        Clock clock;
        for (int step = 0; step < 20; ++step) {
            clock.begin_step(stable_step(grid));
            flow(grid, clock);
            clock.end_step();
        }
        Holding after = held(grid);
        for (const Transfer& given : given_to_edges(grid, {})) {
            after += {given.mass, given.momentum, given.energy};
            EXPECT_EQ(given.from, "gas");
        }
        EXPECT_NEAR(after.mass, before.mass, 1e-13 * before.mass);
        EXPECT_NEAR(after.energy, before.energy, 1e-13 * before.energy);
        EXPECT_NEAR(norm(after.momentum - before.momentum), 0, 1e-12 * before.mass * 300);
    }
}

TEST(GridBooks, VectorsOfRingsAndShellsInSpace)
{
    EXPECT_EQ(in_space(EulerSpace::planar, {1, 2, 3}), (Vector3d{1, 2, 3}));
    EXPECT_EQ(in_space(EulerSpace::axisymmetric, {1, 2, 0}), (Vector3d{1, 0, 2}));
    EXPECT_EQ(in_space(EulerSpace::spherical, {1, 0, 0}), (Vector3d{1, 0, 0}));
}

/// A model without a grid steps, holds nothing, gives nothing.
TEST(GridBooks, AnEmptyGridIsLegal)
{
    EulerGrid none;
    prepare(none);
    Clock clock;
    clock.begin_step(1);
    EXPECT_EQ(flow(none, clock).energy, 0);
    EXPECT_EQ(stable_step(none), std::numeric_limits<double>::infinity());
    EXPECT_EQ(held(none).energy, 0);
    EXPECT_TRUE(given_to_edges(none, {}).empty());
    EXPECT_EQ(none.worked, 0u);
}

}  // namespace
}  // namespace corpuscle
