#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "euler/thinc.hpp"
#include "unit/euler/euler_samples.hpp"

namespace corpuscle {
namespace {

constexpr double pi = 3.14159265358979323846;

TEST(EulerAxis, volumes_of_shells_and_rings_add_up)
{
    const EulerMaterial air = plain("air", IdealGas{1.4});
    const std::array<EulerEdge, 6> edges{};
    const EulerGrid ball = make_grid(EulerSpace::spherical, {graded_faces(0, 2, 0.02, 0.1), {}, {}}, edges, {air});
    const EulerGrid can = make_grid(EulerSpace::axisymmetric, {even_faces(0, 2, 10), even_faces(1, 4, 7), {}}, edges, {air});
    double in_ball = 0, in_can = 0;
    for (std::size_t c = 0; c < ball.cells(); ++c) in_ball += ball.volume(c);
    for (std::size_t c = 0; c < can.cells(); ++c) in_can += can.volume(c);
    EXPECT_NEAR(in_ball / (4.0 / 3 * pi * 8), 1, 1e-13);
    EXPECT_NEAR(in_can / (pi * 4 * 3), 1, 1e-13);
}

TEST(EulerAxis, a_fine_part_has_even_cells_and_wider_ones_on_either_side)
{
    const std::vector<double> faces = faces_with_fine_part(-2, 3, {-0.5, 1}, 0.1, 0.4);
    EXPECT_EQ(faces.front(), -2);
    EXPECT_EQ(faces.back(), 3);
    double last = 0;
    for (std::size_t i = 1; i < faces.size(); ++i) {
        const double width = faces[i] - faces[i - 1];
        ASSERT_GT(width, 0);
        const bool fine = faces[i - 1] > -0.5 - 1e-9 && faces[i] < 1 + 1e-9;
        EXPECT_NEAR(width, fine ? 0.1 : width, 1e-12);
        EXPECT_LT(i > 1 ? std::abs(std::log(width / last)) : 0, 0.3);  // no jump
        last = width;
    }
    EXPECT_NEAR(last, 0.4, 0.04);
    EXPECT_EQ(faces_with_fine_part(0, 1, {0, 1}, 0.25, 1).size(), 5U);
}

TEST(EulerAxis, graded_faces_grow_by_one_ratio_between_the_widths_asked_for)
{
    const std::vector<double> faces = graded_faces(1, 3, 0.01, 0.1);
    EXPECT_EQ(faces.front(), 1);
    EXPECT_EQ(faces.back(), 3);
    const double ratio = (faces[2] - faces[1]) / (faces[1] - faces[0]);
    for (std::size_t i = 2; i + 1 < faces.size(); ++i) EXPECT_NEAR((faces[i + 1] - faces[i]) / (faces[i] - faces[i - 1]), ratio, 1e-9);
    EXPECT_NEAR(faces[1] - faces[0], 0.01, 0.0005);
    EXPECT_NEAR(faces.back() - faces[faces.size() - 2], 0.1, 0.005);
}

TEST(EulerGrid, refuses_what_is_no_grid)
{
    const EulerMaterial air = plain("air", IdealGas{1.4});
    const std::array<EulerEdge, 6> edges{};
    const std::vector<double> line = even_faces(0, 1, 8);
    EXPECT_THROW((void)make_grid(EulerSpace::planar, {std::vector<double>{0, 1, 0.5, 2, 3}, {0, 1}, {0, 1}}, edges, {air}), InputError);
    EXPECT_THROW((void)make_grid(EulerSpace::planar, {even_faces(0, 1, 3), {0, 1}, {0, 1}}, edges, {air}), InputError);
    EXPECT_THROW((void)make_grid(EulerSpace::planar, {line, {0, 1}, {0, 1}}, edges, {}), InputError);
    EXPECT_THROW((void)make_grid(EulerSpace::spherical, {even_faces(-1, 1, 8), {0, 1}, {0, 1}}, edges, {air}), InputError);
    EXPECT_THROW((void)make_grid(EulerSpace::planar, {line, {0, 1}, {0, 1}}, edges, {air}, {1.5}), InputError);
    EXPECT_THROW((void)make_grid(EulerSpace::planar, {line, {0, 1}, {0, 1}}, edges, {plain("bad", IdealGas{0.9})}), InputError);
}

/// The smooth step has the cell's mean, whatever the steepness; what leaves at the fuller side is fuller than what leaves at the other.
TEST(EulerStep, keeps_the_mean_of_its_cell)
{
    for (const double share : {1e-7, 0.03, 0.5, 0.8, 1 - 1e-7}) {
        for (const double steepness : {0.05, 0.7, 2.35}) {
            for (const bool rising : {true, false}) {
                const SmoothStep step(rising ? 0 : 1, share, rising ? 1 : 0, steepness);
                EXPECT_NEAR(step.mean_near(true, 1), share, 1e-11);
                EXPECT_NEAR(step.mean_near(false, 1), share, 1e-11);
                EXPECT_NEAR(0.3 * step.mean_near(false, 0.3) + 0.7 * step.mean_near(true, 0.7), share, 1e-11);
                EXPECT_EQ(step.mean_near(true, 0.2) > step.mean_near(false, 0.2), rising);
                EXPECT_NEAR(step.mean_near(true, 0), step.mean_near(true, 2e-5), 1e-4);
            }
        }
    }
}

TEST(EulerFill, lays_out_shapes_with_exact_mass)
{
    EulerMaterial tnt = plain("tnt", tnt_products);
    tnt.explosive = {tnt_energy, 0, 6930, {{{0, 0, 0}, 0}}};
    EulerGrid grid = unit_grid(20, 20, 20, EulerEdge::rigid, {tnt, plain("air", IdealGas{1.4})});
    const EulerSample charge{0, 1630, 1e5, {}, 0, true}, air{1, 1.2, 1e5};
    fill(grid, {{Shape::box({{0, 0, 0}, {1, 1, 1}}), air}, {Shape::sphere({0, 0, 0}, 0.33), charge}});
    const double mass = 1630 * pi / 6 * 0.33 * 0.33 * 0.33;
    const EulerContents held = contents(grid);
    EXPECT_EQ(held.gas.mass[0], 0);
    EXPECT_NEAR(held.explosive.mass[0] / mass, 1, 1e-12);
    EXPECT_NEAR(held.explosive.energy / (mass * tnt_energy), 1, 1e-12);
    EXPECT_NEAR(held.gas.mass[1] / (1.2 * (1 - mass / 1630)), 1, 1e-12);
    EXPECT_NEAR(held.gas.energy / (2.5e5 * (1 - mass / 1630)), 1, 1e-9);  // what waits counts as explosive, but for round-off of 1e10 Pa
    for (std::size_t c = 0; c < grid.cells(); ++c) EXPECT_NEAR(look(grid, c).pressure, 1e5, 1e-3);
}

TEST(EulerFill, refuses_a_place_without_gas)
{
    EulerGrid grid = unit_grid(8, 8, 8, EulerEdge::rigid, {plain("air", IdealGas{1.4})});
    EXPECT_THROW(fill(grid, {{Shape::sphere({0.5, 0.5, 0.5}, 0.4), {0, 1.2, 1e5}}}), InputError);
    EXPECT_THROW(fill(grid, {{Shape::box({{0, 0, 0}, {1, 1, 1}}), {0, 1.2, -1}}}), InputError);
    EXPECT_THROW(fill(grid, {{Shape::box({{0, 0, 0}, {1, 1, 1}}), {1, 1.2, 1e5}}}), InputError);
}

}  // namespace
}  // namespace corpuscle
