#include <numbers>

#include <gmock/gmock.h>

#include "input/build.hpp"
#include "model/grid_books.hpp"
#include "unit/input/euler_case.hpp"

using namespace corpuscle;
using ::testing::HasSubstr;
using ::testing::SizeIs;

namespace {

std::string refused(const CaseDescription& description)
{
    try {
        static_cast<void>(build(description));
    } catch (const InputError& error) {
        EXPECT_TRUE(error.place().known()) << error.what();
        return error.what();
    }
    return "";
}

std::string gauge(const std::string& place)
{
    return "[[gauge]]\nname = \"g\"\n" + place + "\nevery = 1e-6\n";
}

}  // namespace

/// Mass and energy are exact in every symmetry: an eighth of the ball in the octant, half of it in rings, all of it in shells.
TEST(EulerCase, TheGridHoldsTheChargesMassAndEnergy)
{
    struct Part {
        const std::string& grid;
        double share, volume;
    };
    const double pi = std::numbers::pi;
    for (const Part& part : {Part{octant_grid, 0.125, 0.4 * 0.4 * 0.4}, Part{ring_grid, 0.5, pi * 0.4 * 0.4 * 0.5},
                             Part{shell_grid, 1, 4 * pi / 3 * 0.4 * 0.4 * 0.4}}) {
        const auto model = build(grid_case(part.grid));
        ASSERT_THAT(model->euler.materials, SizeIs(2));
        EXPECT_EQ(model->euler.materials[1].name, "tnt");
        const EulerContents held = contents(model->euler);
        EXPECT_NEAR(held.explosive.mass[1], part.share, 1e-7 * part.share);
        EXPECT_NEAR(held.explosive.energy, part.share * 7e9 / 1630, 1e-7 * part.share * 7e9 / 1630);
        EXPECT_NEAR(held.gas.mass[0], 1.2 * (part.volume - part.share / 1630), 1e-6 * part.volume);
        EXPECT_TRUE(model->gas.particles.empty());
    }
}

TEST(EulerCase, CellsAndEdgesAreAsAskedFor)
{
    const auto model = build(grid_case(ring_grid, "", {"euler.cfl=0.5", "euler.sleep=false"}));
    const EulerGrid& grid = model->euler;
    EXPECT_EQ(grid.axes[0].cells(), 40u);
    EXPECT_EQ(grid.axes[1].cells(), 50u);
    EXPECT_TRUE(grid.axes[2].inert());
    EXPECT_EQ(grid.edges[1], EulerEdge::open);
    EXPECT_EQ(grid.edges[2], EulerEdge::rigid);
    EXPECT_EQ(grid.settings.cfl, 0.5);
    EXPECT_FALSE(grid.settings.skip_quiet);
    // On an axis there is no edge, whatever the case says of it.
    EXPECT_EQ(build(grid_case(shell_grid))->euler.edges[0], EulerEdge::rigid);
}

/// Unnamed gases of one law are one gas, or the face between them would be kept apart.
TEST(EulerCase, FillsOfOneLawAreOneGas)
{
    const std::string text = R"(end_time = 0.2
[euler]
box = [[0, 1], [0, 1], [0, 1]]
cells = [100, 1, 1]
[[fill]]
gas = { gamma = 1.4 }
shape = { box = [[-1, 2], [-1, 2], [-1, 2]] }
density = 0.125
pressure = 0.1
[[fill]]
gas = { gamma = 1.4 }
shape = { box = [[-1, 0.5], [-1, 2], [-1, 2]] }
density = 1.0
pressure = 1.0
[[fill]]
gas = { gamma = 1.3 }
shape = { box = [[-1, 0.25], [-1, 2], [-1, 2]] }
density = 1.0
pressure = 1.0
velocity = [3, 0, 0]
)";
    const auto model = build(read_case_text(text, "tube.toml"));
    ASSERT_THAT(model->euler.materials, SizeIs(2));
    const Holding held = corpuscle::held(model->euler);
    EXPECT_NEAR(held.mass, 0.5 * 1 + 0.5 * 0.125, 1e-14);
    EXPECT_NEAR(held.momentum.x, 0.25 * 3, 1e-14);
}

TEST(EulerCase, ChargesBurnOnTheirOwn)
{
    const auto model = build(grid_case(octant_grid, R"([[charge]]
explosive = "tnt"
shape = { box = [[0.2, 0.3], [0.2, 0.3], [0.2, 0.3]] }
detonation = [{ point = [0.25, 0.25, 0.25], time = "20 us" }]
)"));
    // One gas of products for both; each lighting lights its own charge alone.
    const EulerGrid& grid = model->euler;
    ASSERT_THAT(grid.materials, SizeIs(2));
    const EulerExplosive& tnt = grid.materials[1].explosive;
    ASSERT_THAT(tnt.lightings, SizeIs(2));
    EXPECT_DOUBLE_EQ(tnt.lightings[1].time, 20e-6);
    EXPECT_NEAR(contents(grid).explosive.mass[1], 1.63 + 0.125, 1e-6);
    for (std::size_t c = 0; c < grid.cells(); ++c) {
        if (!(grid.now.unburnt[1][c] > 0)) continue;
        const bool second = lights(grid, tnt, tnt.lightings[1], c);
        EXPECT_NE(second, lights(grid, tnt, tnt.lightings[0], c));
        EXPECT_DOUBLE_EQ(burn_time(grid, tnt, c), (second ? 20e-6 : 0) + norm(grid.middle(c) - tnt.lightings[second ? 1 : 0].point) / 6930);
        EXPECT_EQ(second, norm(grid.middle(c)) > 0.25);
    }
}

TEST(EulerCase, GaugesFindTheirCells)
{
    const auto model = build(grid_case(octant_grid, gauge("sphere = { center = [0.2, 0.2, 0.2], radius = 0.06 }")));
    const auto& ball = std::get<GridRegionGauge>(model->gauges[0].place);
    double volume = 0;
    for (const double part : ball.volumes) volume += part;
    // 6 points along an axis of a cell, 18 along the radius: a few in a hundred.
    EXPECT_NEAR(volume, 4 * std::numbers::pi / 3 * 0.06 * 0.06 * 0.06, 0.02 * volume);
    // A ball between the points: the cell around its middle. In rings a place is turned into the half plane.
    const auto small = build(grid_case(ring_grid, gauge("sphere = { center = [0.06, 0.08, 0.203], radius = 1e-6 }")));
    const auto& point = std::get<GridRegionGauge>(small->gauges[0].place);
    ASSERT_THAT(point.cells, SizeIs(1));
    EXPECT_EQ(point.cells[0], small->euler.cell(10, 20, 0));
    const auto same = build(grid_case(ring_grid, gauge("point = [0.06, 0.08, 0.203]")));
    EXPECT_EQ(std::get<GridRegionGauge>(same->gauges[0].place).cells, point.cells);
    const auto floor = build(grid_case(ring_grid, gauge("face = \"z-\"")));
    EXPECT_EQ(std::get<GridFaceGauge>(floor->gauges[0].place).face, 2);
    EXPECT_NEAR(face_area(floor->euler, 2), std::numbers::pi * 0.16, 1e-12);
    EXPECT_NEAR(face_area(build(grid_case(shell_grid))->euler, 1), 4 * std::numbers::pi * 0.16, 1e-12);
}

TEST(EulerCase, MeaningIsChecked)
{
    const auto octant = [](const std::vector<std::string>& settings) { return refused(grid_case(octant_grid, "", settings)); };
    const auto rings = [](const std::vector<std::string>& settings) { return refused(grid_case(ring_grid, "", settings)); };
    EXPECT_THAT(octant({"euler.box=[[0, 1]]"}), HasSubstr("has 1 ranges, its symmetry leaves 3"));
    EXPECT_THAT(octant({"euler.box=[[0, 0.4], [0.4, 0], [0, 0.4]]"}), HasSubstr("along y; expected the lower end first"));
    EXPECT_THAT(octant({"euler.cell_size=0.2"}), HasSubstr("2 cells along x: too few"));
    EXPECT_THAT(octant({"euler.cell_size=1e-6"}), HasSubstr("more than 4e9 cells"));
    EXPECT_THAT(octant({"euler.cell_size=0.3 mm"}), HasSubstr("cells and 0 elements need about"));
    EXPECT_THAT(octant({"charge.0.center=[0.39, 0, 0]"}), HasSubstr("sticks"));
    EXPECT_THAT(octant({"charge.0.center=[9, 0, 0]"}), HasSubstr("lies outside the gas box; expected it within the box of [euler]"));
    EXPECT_THAT(rings({"charge.0.center=[0.1, 0, 0]"}), HasSubstr("not symmetric about the z axis"));
    EXPECT_THAT(rings({"charge.0.shape=cylinder", "charge.0.axis=[1, 0, 0]"}), HasSubstr("not symmetric about the z axis"));
    EXPECT_THAT(rings({"charge.0.detonation=[{ point = [0.01, 0, 0] }]"}), HasSubstr("off the axis"));
    EXPECT_THAT(rings({"euler.edges.y=[\"rigid\", \"open\"]"}), HasSubstr("along y, an axis that its symmetry does not leave"));
    EXPECT_THAT(rings({"euler.box=[[0.1, 0.4], [0, 0.5]]"}), HasSubstr("begins at 0.1 m; expected 0"));
    EXPECT_THAT(refused(grid_case(shell_grid, "", {"charge.0.center=[0, 0, 0.1]"})), HasSubstr("not symmetric about the point 0"));
    EXPECT_THAT(refused(grid_case(octant_grid, gauge("face = \"x+\""))), HasSubstr("not rigid"));
    EXPECT_THAT(refused(grid_case(ring_grid, gauge("face = \"y-\""))), HasSubstr("a face that the grid has not"));
    EXPECT_THAT(refused(grid_case(octant_grid, gauge("sphere = { center = [1, 1, 1], radius = 0.1 }"))), HasSubstr("outside the gas box"));
    CaseDescription bare = grid_case(octant_grid);
    bare.euler->fill.reset();
    EXPECT_THAT(refused(bare), HasSubstr("no gas surrounds the charge"));
    bare.charges.clear();
    EXPECT_THAT(refused(bare), HasSubstr("nothing would happen"));
}

TEST(EulerCase, TheGridStandsAlone)
{
    EXPECT_THAT(refused(grid_case(octant_grid, "[gas]\nbox = [[0, 1], [0, 1], [0, 1]]\nparticles = 1000\n")),
                HasSubstr("both [gas] and [euler]"));
    EXPECT_THAT(refused(grid_case(ring_grid, R"([[part]]
name = "plate"
mesh = { rectangle = { edge_1 = [1, 0, 0], edge_2 = [0, 1, 0], element_size = 0.1 } }
element = "rigid"
)")),
                HasSubstr("part 'plate' stands beside [euler] with a symmetry"));
    CaseDescription many = grid_case(octant_grid);
    many.ensemble = 2;
    EXPECT_THAT(refused(many), HasSubstr("an ensemble without gas of particles"));
}
