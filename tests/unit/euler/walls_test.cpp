#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "../mesh/facet_tree_surfaces.hpp"
#include "euler/cut.hpp"
#include "euler/wall_flux.hpp"
#include "euler_samples.hpp"

namespace corpuscle {
namespace {

EulerGrid still_air(std::size_t nx, std::size_t ny, std::size_t nz, EulerEdge edge = EulerEdge::rigid)
{
    EulerGrid grid = unit_grid(nx, ny, nz, edge, {plain("air", IdealGas{1.4})});
    fill(grid, [](const Vector3d&) { return EulerSample{0, 1, 1, {}}; });
    return grid;
}

std::vector<WallCrossing> crossings_of(const EulerGrid& grid, const MovingSurface& body)
{
    return find_crossings(grid, body.surface, free_edges(body.surface), body.start);
}

MovingSurface sphere_at(const Vector3d& middle, double radius, bool solid)
{
    MovingSurface sphere = sphere_surface(radius, 3);
    for (Vector3d& p : sphere.start) p += middle;
    for (Facet& facet : sphere.surface.facets) facet.solid = solid;
    return sphere;
}

/// The areas about each cell, outward: open faces, edges of the grid, walls, corners.
std::vector<Vector3d> areas_about(const EulerGrid& grid)
{
    std::vector<Vector3d> sum(grid.cells());
    for (std::size_t c = 0; c < grid.cells(); ++c) {
        const auto at = grid.place(c);
        for (int d = 0; d < 3; ++d) {
            const auto axis = static_cast<std::size_t>(d);
            const double face = grid.whole_volume(c) / grid.axes[axis].width(at[axis]);
            auto upper = at;
            ++upper[axis];
            for (const int side : {0, 1}) {
                const std::size_t number = grid.face_number(d, side == 0 ? at : upper);
                if (grid.walls.shut[axis][number] < 0) sum[c][d] += (side == 0 ? -1 : 1) * face * grid.walls.open[axis][number];
            }
        }
    }
    for (const WallFace& face : grid.walls.faces) {
        if (face.lower != no_cell) sum[face.lower] += face.area;
        if (face.upper != no_cell) sum[face.upper] -= face.area;
    }
    for (const WallCorner& corner : grid.walls.corners) {
        sum[corner.from] += corner.area;
        sum[corner.to] -= corner.area;
    }
    return sum;
}

TEST(Walls, CrossingsLieWhereLinesMeetTheFacet)
{
    const EulerGrid grid = still_air(10, 10, 10);
    MovingSurface sheet;
    sheet.start = {{0.37, -2, -2}, {0.37, 4, -2}, {0.37, -2, 4}};
    sheet.surface.facets = {{{0, 1, 2}, 0, 0}};
    const auto found = crossings_of(grid, sheet);
    ASSERT_EQ(found.size(), 100u);  // each line along x, none along the sheet
    for (const WallCrossing& crossing : found) {
        EXPECT_EQ(crossing.axis, 0);
        EXPECT_EQ(crossing.face % 11, 4u);  // between the cells about 0.35 and 0.45
        EXPECT_NEAR(crossing.place, 0.37, 1e-12);
        EXPECT_NEAR(crossing.weight[0] + crossing.weight[1] + crossing.weight[2], 1, 1e-12);
    }
}

TEST(Walls, ARimReachesOverSlitsBelowATwentiethOfACell)
{
    for (const auto& [gap, rows, shut] : {std::tuple{0.004, 10u, 100u}, std::tuple{0.02, 10u, 90u}, std::tuple{0.004, 1u, 10u},
                                          std::tuple{0.02, 1u, 9u}}) {  // two halves of a sheet with a slit along a row of lines
        const EulerGrid grid = still_air(10, 10, rows);
        const double line = grid.axes[1].middle(4);
        MovingSurface halves;
        halves.start = {{0.37, line - gap, -20}, {0.37, line - gap, 20}, {0.37, -30, 0},
                        {0.37, line + gap, -20}, {0.37, line + gap, 20}, {0.37, 30, 0}};
        halves.surface.facets = {{{0, 1, 2}, 0, 0}, {{3, 4, 5}, 0, 0}};
        EulerGrid cut_grid = grid;
        cut_first(cut_grid, crossings_of(grid, halves));
        EXPECT_EQ(cut_grid.walls.faces.size(), shut) << gap;
    }
}

/// Whatever the surface, the areas about each cell close: a uniform pressure moves nothing.
TEST(Walls, AreasAboutEachCellClose)
{
    for (const EulerEdge edge : {EulerEdge::rigid, EulerEdge::open}) {
        std::vector<MovingSurface> bodies{sphere_at({0.52, 0.49, 0.47}, 0.3, false), sphere_at({0.1, 0.9, 0.5}, 0.3, false)};
        MovingSurface triangles = random_surface(60, 0, 5);
        for (Vector3d& p : triangles.start) p = 0.5 * (p + Vector3d{1, 1, 1});
        bodies.push_back(triangles);
        for (const MovingSurface& body : bodies) {
            EulerGrid grid = still_air(12, 10, 14, edge);
            cut_first(grid, crossings_of(grid, body));
            ASSERT_FALSE(grid.walls.faces.empty());
            for (const Vector3d& sum : areas_about(grid)) EXPECT_LT(norm(sum), 1e-15);
        }
    }
}

TEST(Walls, SolidsTakeTheirVolumeAlsoAcrossTheEdge)
{
    const double radius = 0.3;
    for (const Vector3d& middle : {Vector3d{0.5, 0.5, 0.5}, Vector3d{0, 0.5, 0.5}, Vector3d{0, 0, 0.5}}) {
        EulerGrid grid = still_air(24, 24, 24);
        const MovingSurface body = sphere_at(middle, radius, true);
        cut_first(grid, crossings_of(grid, body));
        double room = 0, inside = 4 * 3.14159265 / 3 * radius * radius * radius;
        for (std::size_t c = 0; c < grid.cells(); ++c) room += grid.volume(c);
        for (int d = 0; d < 3; ++d) inside *= middle[d] == 0 ? 0.5 : 1;
        EXPECT_NEAR((1 - room) / inside, 1, 0.03);  // the mesh itself lacks 1 to 2 % of its ball
    }
}

TEST(Walls, PressureOnAWallIsThatOfShockOrRarefaction)
{
    const EulerCell air{1.2, {}, 1e5, 2.5e5, std::sqrt(1.4 * 1e5 / 1.2), {}};
    EXPECT_DOUBLE_EQ(wall_pressure(air, 0), 1e5);
    const double small = 1e-3;
    EXPECT_NEAR((wall_pressure(air, small) - wall_pressure(air, -small)) / (2 * small), air.density * air.sound_speed, 1e-6 * 410);
    EXPECT_NEAR(wall_pressure(air, 1e6) / (1.2 * 1e12), 1.2, 1e-5);  // (gamma + 1)/2 rho u^2
    EXPECT_EQ(wall_pressure(air, -10 * air.sound_speed), 0);         // it outruns the gas
}

}  // namespace
}  // namespace corpuscle
