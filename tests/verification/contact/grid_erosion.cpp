#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "grid_walls.hpp"
#include "laws/riemann/general_riemann.hpp"

namespace corpuscle {
namespace {

void erode(WalledGas& gas, const std::function<bool(std::size_t)>& which)
{
    std::vector<std::uint8_t>& hidden = gas.structure.surface.hidden;
    hidden.resize(gas.structure.surface.facets.size());
    for (std::size_t f = 0; f < hidden.size(); ++f)
        if (which(f)) hidden[f] = 1;
}

/// A wall between gases at rest in one state that is taken away facet by facet leaves them at rest, at any angle.
TEST(GridErosion, a_wall_that_erodes_in_gas_at_rest_disturbs_nothing)
{
    for (const Vector3d& n : {Vector3d{1, 0, 0}, Vector3d{1, 0.37, 0}, Vector3d{1, 0.6, 0.35}}) {
        EulerGrid grid = unit_grid(16, 16, 16, EulerEdge::rigid, {plain("air", IdealGas{1.4})});
        fill(grid, [&](const Vector3d&) { return EulerSample{0, 1, 1, {}}; });
        const Vector3d b = normalized(cross(n, Vector3d{0, 0, 1})), c = normalized(cross(n, b));
        MovingSurface wall;
        add_sheet(wall, Vector3d{0.509, 0.5, 0.5} - 2.0 * b - 2.0 * c, 4.0 * b, 4.0 * c, 24, 24);
        WalledGas gas(std::move(grid), wall, 0);
        double off = 0;
        for (int step = 0; step < 24; ++step) {
            erode(gas, [&](std::size_t f) { return f % 30 == static_cast<std::size_t>(step); });
            gas.step(1);
            for (std::size_t cell = 0; cell < gas.grid.cells(); ++cell) off = std::max(off, std::abs(look(gas.grid, cell).pressure - 1));
        }
        std::printf("normal (%g, %g, %g): pressure off by %.2e\n", n.x, n.y, n.z, off);
        EXPECT_LT(off, 1e-12);
    }
}

/// Mean error of the density along a tube of Sod's gases, parted at `place`, at a time after they meet.
double density_error(const EulerGrid& grid, double place, double time)
{
    const GeneralRiemannSolution exact({IdealGas{1.4}, 1, 0, 1}, {IdealGas{1.4}, 0.125, 0, 0.1});
    double error = 0;
    const std::size_t cells = grid.cells();
    for (std::size_t c = 0; c < cells; ++c)
        error += std::abs(look(grid, c).density - exact.at((grid.middle(c).x - place) / time).density) / double(cells);
    return error;
}

/// A wall that holds Sod's gases apart, in no middle or face of a cell, and erodes all at once: nothing happens before, and after it the
/// shock tube's flow, as well as where the gases meet on a face of the grid without a wall. The bound: half a cell of gas at most lies on
/// the wrong side of the wall, which moves so much of the jump.
TEST(GridErosion, a_wall_that_erodes_at_once_leaves_a_shock_tube)
{
    const std::size_t n = 200;
    const double time = 0.15;
    const auto tube = [&](double place) {
        EulerGrid grid = unit_grid(n, 1, 1, EulerEdge::rigid, {plain("air", IdealGas{1.4})});
        fill(grid, [&](const Vector3d& x) { return x.x < place ? EulerSample{0, 1, 1, {}} : EulerSample{0, 0.125, 0.1, {}}; });
        return grid;
    };
    EulerGrid plain_grid = tube(0.5);
    prepare(plain_grid);
    Clock clock;
    run_until(plain_grid, clock, time);
    const double without = density_error(plain_grid, 0.5, time);
    for (const double off : {0.05, 0.3, 0.45, 0.7, 0.95}) {
        const double place = 0.5 + off / double(n);
        MovingSurface wall;
        add_sheet(wall, {place, -1, -1}, {0, 3, 0}, {0, 0, 3});
        WalledGas gas(tube(off < 0.5 ? 0.5 : 0.5 + 1 / double(n)), wall, 0);
        const EulerAmount first = contents(gas.grid).gas;
        gas.run_to(0.1);
        double moved = 0;
        for (std::size_t c = 0; c < n; ++c) moved = std::max(moved, norm(look(gas.grid, c).velocity));
        EXPECT_LT(moved, 1e-13);
        erode(gas, [](std::size_t) { return true; });
        gas.run_to(0.1 + time);
        const EulerAmount last = contents(gas.grid).gas;
        const double error = density_error(gas.grid, place, time);
        std::printf("wall %.2f of a cell from a face: density off by %.5f in the mean, %.5f without a wall\n", off, error, without);
        EXPECT_LT(error, without + 0.5 * 0.875 / double(n));
        EXPECT_NEAR(last.whole_mass(), first.whole_mass(), 1e-13 * first.whole_mass());
        EXPECT_NEAR(last.energy, first.energy, 1e-12 * first.energy);
    }
}

/// A wall askew to the grid between gas of high and of low pressure loses its middle, piece by piece: gas passes the hole, nowhere before,
/// and at the rate of a choked orifice, whose coefficient lies between that of an incompressible jet from a slit, pi/(pi + 2) (Kirchhoff),
/// and 1. Mass and energy of the whole are kept: walls that stand do no work.
TEST(GridErosion, gas_passes_the_hole_and_no_other_place)
{
    const std::size_t n = 80;
    const double slope = 0.2, high = 20, sound = std::sqrt(1.4 * high);
    EulerGrid grid = unit_grid(n, n, 1, EulerEdge::rigid, {plain("high", IdealGas{1.4}), plain("low", IdealGas{1.4})});
    const Vector3d along = normalized(Vector3d{slope, 1, 0}), middle{0.503, 0.506, 0.5};
    fill(grid, [&](const Vector3d& x) {
        const bool left = x.x - middle.x < slope * (x.y - middle.y);
        return left ? EulerSample{0, 1, high, {}} : EulerSample{1, 0.05, 1, {}};
    });
    MovingSurface wall;
    add_sheet(wall, middle - along - Vector3d{0, 0, 1}, 2 * along, {0, 0, 3}, 40);
    WalledGas gas(std::move(grid), wall, 0);
    for (std::size_t c = 0; c < gas.grid.cells(); ++c) {  // cells that the wall crosses hold the gas of their middles alone
        const Vector3d x = gas.grid.middle(c);
        const bool left = x.x - middle.x < slope * (x.y - middle.y);
        gas.grid.now.mass[0][c] = left ? 1 : 0, gas.grid.now.mass[1][c] = left ? 0 : 0.05;
        gas.grid.now.share[0][c] = left ? 1 : 0, gas.grid.now.energy[c] = (left ? high : 1.0) / 0.4;
    }
    prepare(gas.grid);
    const auto behind = [&] {
        double mass = 0;
        for (std::size_t c = 0; c < gas.grid.cells(); ++c) {
            const Vector3d x = gas.grid.middle(c);
            if (x.x - middle.x > slope * (x.y - middle.y)) mass += gas.grid.volume(c) * gas.grid.now.mass[0][c];
        }
        return mass;
    };
    const EulerAmount first = contents(gas.grid).gas;
    gas.run_to(0.02);
    EXPECT_EQ(behind(), 0);
    const double hole = 0.1;  // two of the forty pieces
    erode(gas, [](std::size_t f) { return f == 38 || f == 39; });
    gas.run_to(0.03);
    erode(gas, [](std::size_t f) { return f == 40 || f == 41; });
    const double choked = sound * std::pow(2 / 2.4, 0.5 * 2.4 / 0.4);
    gas.run_to(0.07);
    const double before = behind(), duration = 0.06;
    gas.run_to(0.07 + duration);
    const double rate = (behind() - before) / duration, drained = 0.5 * (before + behind()) / first.mass[0];
    const double coefficient = rate / (hole * choked * std::pow(1 - drained, 1.2));  // density times sound of the isentrope
    const EulerAmount last = contents(gas.grid).gas;
    std::printf("coefficient %.3f, %.3f drained; mass %.1e off, energy %.1e off\n", coefficient, drained,
                last.whole_mass() / first.whole_mass() - 1, last.energy / first.energy - 1);
    EXPECT_GT(coefficient, 3.14159265 / (3.14159265 + 2));
    EXPECT_LT(coefficient, 1);
    EXPECT_NEAR(last.whole_mass(), first.whole_mass(), 1e-13 * first.whole_mass());
    EXPECT_NEAR(last.energy, first.energy, 1e-12 * first.energy);
    EXPECT_EQ(gas.to_structure.energy, 0);
}

}  // namespace
}  // namespace corpuscle
