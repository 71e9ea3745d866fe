#include <gtest/gtest.h>

#include <cmath>

#include "unit/euler/euler_samples.hpp"

namespace corpuscle {
namespace {

/// A lopsided charge, lit off its middle, in a box with air; `turn` permutes the axes.
EulerGrid lopsided(int turn, EulerEdge edge, std::size_t cells)
{
    EulerMaterial tnt = plain("tnt", tnt_products);
    const auto turned = [&](const Vector3d& x) {
        Vector3d y;
        for (int d = 0; d < 3; ++d) y[(d + turn) % 3] = x[d];
        return y;
    };
    tnt.explosive = {tnt_energy, 0, 6930, {{turned({0.4, 0.45, 0.55}), 0}}, 0};
    EulerGrid grid = unit_grid(cells, cells, cells, edge, {tnt, plain("air", IdealGas{1.4})});
    fill(grid, {{Shape::box({{0, 0, 0}, {1, 1, 1}}), {1, 1.2, 101325}},
                {Shape::ellipsoid(turned({0.45, 0.5, 0.55}), turned({0.2, 0.15, 0.1})), {0, 1630, 101325, {}, 0, true}}});
    return grid;
}

/// A closed box keeps each gas' mass and the whole energy, with what the explosive holds, to round-off; the walls have got the momentum.
/// So does an open one with what left. Round-off: 1e5 sums of a step, 60 steps, each of 1e-16.
TEST(EulerConservation, holds_to_round_off)
{
    for (const EulerEdge edge : {EulerEdge::rigid, EulerEdge::open}) {
        EulerGrid grid = lopsided(0, edge, 24);
        const EulerContents before = contents(grid);
        Clock clock;
        run_until(grid, clock, 1.5e-4);
        const EulerContents after = contents(grid);
        EulerAmount passed;
        for (const EulerAmount& face : grid.passages) passed += face;
        const EulerAmount &was = before.gas, &is = after.gas;
        EXPECT_NEAR((is.mass[0] + after.explosive.mass[0] + passed.mass[0]) / (was.mass[0] + before.explosive.mass[0]), 1, 1e-12);
        EXPECT_NEAR((is.mass[1] + passed.mass[1]) / was.mass[1], 1, 1e-12);
        EXPECT_NEAR((is.energy + after.explosive.energy + passed.energy) / (was.energy + before.explosive.energy), 1, 1e-12);
        const double scale = std::sqrt(2 * is.energy * is.whole_mass());
        for (int d = 0; d < 3; ++d) EXPECT_NEAR((is.momentum[d] + passed.momentum[d]) / scale, 0, 1e-12);
        EXPECT_EQ(passed.whole_mass() == 0, edge == EulerEdge::rigid);
        EXPECT_EQ(after.explosive.whole_mass(), 0);
    }
}

/// Two charges of unlike size and explosive that burst at once and run into one another, air between them: three gases in a cell.
EulerGrid two_charges(std::size_t cells)
{
    const Jwl other{778.3e9, 7.071e9, 4.2, 1.0, 0.3, 1891};
    EulerGrid grid =
        unit_grid(cells, cells, 1, EulerEdge::rigid, {plain("tnt", tnt_products), plain("air", IdealGas{1.4}), plain("hmx", other)});
    fill(grid, {{Shape::box({{0, 0, 0}, {1, 1, 1}}), {1, 1.2, 101325}},
                {Shape::cylinder({0.3, 0.4, 0.5}, 0.06, 1.0, {0, 0, 1}), {0, 1630, 0, {}, tnt_energy}},
                {Shape::cylinder({0.7, 0.52, 0.5}, 0.04, 1.0, {0, 0, 1}), {2, 1891, 0, {}, 10.5e9 / 1891}}});
    return grid;
}

/// No gas gives more than it has, on coarse cells either: each keeps its mass to round-off and a share between none and all, and no cell
/// is faster than the detonations' own matter could ever get (11 km/s: all of 5.5 MJ/kg, and the double for its front).
TEST(EulerConservation, three_gases_in_a_cell_stay_within_their_bounds)
{
    for (const std::size_t cells : {20u, 50u}) {
        EulerGrid grid = two_charges(cells);
        const EulerContents before = contents(grid);
        Clock clock;
        while (clock.time() < 4e-4) {
            run_until(grid, clock, clock.time() + 2e-5);
            for (std::size_t c = 0; c < grid.cells(); ++c) {
                const EulerCell cell = look(grid, c);
                ASSERT_LT(norm(cell.velocity), 11e3) << cells << " cells, cell " << c << " at " << clock.time();
                for (std::size_t m = 0; m < 3; ++m) {
                    ASSERT_GE(cell.share[m], -1e-15);
                    ASSERT_GE(grid.now.mass[m][c], -1e-12 * cell.density);
                }
            }
        }
        const EulerContents after = contents(grid);
        for (std::size_t m = 0; m < 3; ++m) EXPECT_NEAR(after.gas.mass[m] / before.gas.mass[m], 1, 1e-12) << m;
        EXPECT_NEAR(after.gas.energy / before.gas.energy, 1, 1e-12);
    }
}

/// Where two equal charges meet, whose products have each their own number, gas does what it does at a rigid wall in their middle.
TEST(EulerSymmetry, a_second_charge_is_a_mirror)
{
    const auto impulse = [](bool both) {
        const double low = both ? -1 : 0;
        std::array<EulerEdge, euler_face_count> edges;
        edges.fill(EulerEdge::open);
        if (!both) edges[0] = EulerEdge::rigid;
        const std::size_t across = both ? 80 : 40;
        EulerGrid grid = make_grid(EulerSpace::planar, {even_faces(low, 1, across), even_faces(0, 1, 40), even_faces(0, 1, 1)}, edges,
                                   {plain("tnt", tnt_products), plain("air", IdealGas{1.4}), plain("its mirror", tnt_products)});
        std::vector<EulerFill> fills{{Shape::box({{-1, 0, 0}, {1, 1, 1}}), {1, 1.2, 101325}},
                                     {Shape::cylinder({0.3, 0.5, 0.5}, 0.06, 1.0, {0, 0, 1}), {0, 1630, 0, {}, tnt_energy}}};
        if (both) fills.push_back({Shape::cylinder({-0.3, 0.5, 0.5}, 0.06, 1.0, {0, 0, 1}), {2, 1630, 0, {}, tnt_energy}});
        fill(grid, fills);
        Clock clock;
        double sum = 0;
        while (clock.time() < 4e-4) {
            run_until(grid, clock, clock.time() + 5e-6);
            for (std::size_t j = 0; j < 40; ++j) sum += look(grid, grid.cell(both ? 40 : 0, j, 0)).pressure * 5e-6 / 40;
        }
        return sum;
    };
    EXPECT_NEAR(impulse(true) / impulse(false), 1, 0.02);
}

/// Turning all axes turns the answer: the largest difference of density after a detonation, over the mean, is round-off, grown by the
/// flow's own instability.
TEST(EulerSymmetry, axes_are_alike)
{
    EulerGrid straight = lopsided(0, EulerEdge::open, 20), turned = lopsided(1, EulerEdge::open, 20);
    Clock clock, other;
    run_until(straight, clock, 5e-5);
    run_until(turned, other, 5e-5);
    EXPECT_EQ(clock.step(), other.step());
    double most = 0, mean = 0;
    for (std::size_t c = 0; c < straight.cells(); ++c) {
        const auto at = straight.place(c);
        const EulerCell here = look(straight, c), there = look(turned, turned.cell(at[2], at[0], at[1]));
        most = std::max(most, std::abs(here.density - there.density));
        mean += here.density / static_cast<double>(straight.cells());
    }
    EXPECT_LT(most / mean, 1e-9);
}

/// A ball in the corner of three mirrors: the answer is the same along the three axes, and the same as the octant of a whole box.
TEST(EulerSymmetry, a_corner_of_mirrors_is_an_octant)
{
    EulerMaterial tnt = plain("tnt", tnt_products);
    const std::array<EulerEdge, euler_face_count> mirrors{EulerEdge::rigid, EulerEdge::open,  EulerEdge::rigid,
                                                          EulerEdge::open,  EulerEdge::rigid, EulerEdge::open};
    std::array<EulerEdge, euler_face_count> open;
    open.fill(EulerEdge::open);
    const auto made = [&](double low, std::size_t cells, const std::array<EulerEdge, euler_face_count>& edges) {
        const std::vector<double> faces = even_faces(low, 1, cells);
        EulerGrid grid = make_grid(EulerSpace::planar, {faces, faces, faces}, edges, {tnt, plain("air", IdealGas{1.4})});
        fill(grid,
             {{Shape::box({{-1, -1, -1}, {1, 1, 1}}), {1, 1.2, 101325}}, {Shape::sphere({0, 0, 0}, 0.3), {0, 1630, 0, {}, tnt_energy}}});
        return grid;
    };
    EulerGrid octant = made(0, 12, mirrors), whole = made(-1, 24, open);
    Clock clock, other;
    run_until(octant, clock, 4e-5);
    run_until(whole, other, 4e-5);
    for (std::size_t c = 0; c < octant.cells(); ++c) {
        const auto at = octant.place(c);
        const double density = look(octant, c).density;
        EXPECT_NEAR(look(whole, whole.cell(at[0] + 12, at[1] + 12, at[2] + 12)).density / density, 1, 1e-9);
        EXPECT_NEAR(look(octant, octant.cell(at[1], at[2], at[0])).density / density, 1, 1e-9);
    }
}

/// Cold thin gas beside hot dense gas, density ratio 1e4 and pressure ratio 1e6, and gas torn apart at twice its escape speed: densities,
/// pressures stay above nothing, energy is kept.
TEST(EulerPositivity, survives_large_ratios)
{
    const EulerMaterial air = plain("air", IdealGas{1.4}), products = plain("products", tnt_products);
    for (const int which : {0, 1, 2}) {
        EulerGrid grid = unit_grid(32, 32, 1, EulerEdge::rigid, {products, air});
        fill(grid, [&](const Vector3d& x) {
            const bool inside = std::hypot(x.x - 0.45, x.y - 0.52) < 0.21;
            if (which == 0) return inside ? EulerSample{0, 1630, 1e11} : EulerSample{1, 0.163, 1e5};
            if (which == 1) return inside ? EulerSample{1, 1e4, 1e11} : EulerSample{1, 1, 1e5};
            return EulerSample{1, 1, 1e5, {x.x < 0.5 ? -3700.0 : 3700.0, x.y < 0.5 ? -3700.0 : 3700.0, 0}};
        });
        const EulerContents before = contents(grid);
        Clock clock;
        for (int s = 0; s < 200; ++s) {
            clock.begin_step(stable_step(grid));
            flow(grid, clock);
            clock.end_step();
        }
        for (std::size_t c = 0; c < grid.cells(); ++c) {
            const EulerCell cell = look(grid, c);
            ASSERT_GT(cell.density, 0) << which;
            ASSERT_GT(cell.energy, which == 0 ? -1e300 : 0) << which;  // the JWL law's cold energy may be below nothing
            ASSERT_GT(cell.pressure, 0) << which;
            ASSERT_LT(cell.pressure, 1e12) << which;
        }
        EXPECT_NEAR(contents(grid).gas.energy / before.gas.energy, 1, 1e-12);
    }
}

}  // namespace
}  // namespace corpuscle
