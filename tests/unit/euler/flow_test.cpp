#include <gtest/gtest.h>

#include <cmath>

#include "parallel/loops.hpp"
#include "unit/euler/euler_samples.hpp"

namespace corpuscle {
namespace {

const EulerMaterial air = plain("air", IdealGas{1.4}), products = plain("products", tnt_products);

/// Largest difference of pressure to `pressure` and of velocity to `velocity`, relative to the pressure and the speed of sound.
double unrest(const EulerGrid& grid, double pressure, const Vector3d& velocity)
{
    double most = 0;
    for (std::size_t c = 0; c < grid.cells(); ++c) {
        const EulerCell cell = look(grid, c);
        most = std::max({most, std::abs(cell.pressure / pressure - 1), norm(cell.velocity - velocity) / cell.sound_speed});
    }
    return most;
}

/// All numbers of a grid in one row; what its edges got can be left out.
std::vector<double> all_numbers(EulerGrid& grid, bool passages = true)
{
    std::vector<double> numbers;
    for (const Field& field : state(grid).fields) {
        if (!passages && field.name == "passages") continue;
        std::vector<double> values(field.count * static_cast<std::size_t>(field.components));
        field.gather(values.data());
        numbers.insert(numbers.end(), values.begin(), values.end());
    }
    return numbers;
}

/// A ball of hot products in air, off the middle.
EulerGrid ball_in_air(std::size_t cells, bool skip_quiet)
{
    EulerSettings settings;
    settings.block_cells = 8;
    settings.skip_quiet = skip_quiet;
    EulerGrid grid = unit_grid(cells, cells, cells, EulerEdge::open, {products, air}, settings);
    fill(grid, {{Shape::box({{0, 0, 0}, {1, 1, 1}}), {1, 1.2, 101325}},
                {Shape::sphere({0.3, 0.32, 0.34}, 0.1), {0, 1630, 0, {}, tnt_energy, false}}});
    return grid;
}

/// A drop of dense products that drifts through air under one pressure: pressure and velocity stay as they are. The bound is round-off:
/// the JWL law's cold pressure of 6e9 Pa, over 1e8 Pa, makes a rounding of 60 eps a cell and step, 40 steps.
TEST(EulerFlow, keeps_pressure_and_velocity_where_gases_drift_in_touch)
{
    const Vector3d drift{300, 200, -150};
    EulerGrid grid = unit_grid(20, 20, 20, EulerEdge::open, {products, air});
    fill(grid, {{Shape::box({{0, 0, 0}, {1, 1, 1}}), {1, 1.2, 1e8, drift}}, {Shape::sphere({0.4, 0.4, 0.5}, 0.2), {0, 1630, 1e8, drift}}});
    Clock clock;
    for (int s = 0; s < 40; ++s) {
        clock.begin_step(stable_step(grid));
        flow(grid, clock);
        clock.end_step();
    }
    EXPECT_GT(clock.time() * norm(drift), 0.01);
    EXPECT_LT(unrest(grid, 1e8, drift), 1e-9);
}

TEST(EulerFlow, leaves_gases_at_rest_alone)
{
    EulerGrid grid = unit_grid(16, 16, 1, EulerEdge::rigid, {products, air});
    fill(grid, {{Shape::box({{0, 0, 0}, {1, 1, 1}}), {1, 1.2, 1e8}}, {Shape::sphere({0.5, 0.5, 0.5}, 0.3), {0, 1630, 1e8}}});
    Clock clock;
    for (int s = 0; s < 40; ++s) {
        clock.begin_step(stable_step(grid));
        flow(grid, clock);
        clock.end_step();
    }
    EXPECT_LT(unrest(grid, 1e8, {}), 1e-9);
}

TEST(EulerFlow, keeps_uniform_gas_at_rest_to_the_bit_in_every_space)
{
    const std::array<EulerEdge, 6> edges{EulerEdge::rigid, EulerEdge::open,  EulerEdge::rigid,
                                         EulerEdge::open,  EulerEdge::rigid, EulerEdge::rigid};
    EulerSettings all;
    all.skip_quiet = false;
    const std::vector<double> graded = graded_faces(0, 1, 0.02, 0.1), even = even_faces(0, 1, 12);
    for (const EulerSpace space : {EulerSpace::planar, EulerSpace::axisymmetric, EulerSpace::spherical}) {
        EulerGrid grid =
            make_grid(space, {graded, space == EulerSpace::spherical ? std::vector<double>{0, 1} : even, {0, 1}}, edges, {air}, all);
        fill(grid, [](const Vector3d&) { return EulerSample{0, 1.2, 101325}; });
        const std::vector<double> before = all_numbers(grid, false);
        Clock clock;
        for (int s = 0; s < 10; ++s) {
            clock.begin_step(stable_step(grid));
            flow(grid, clock);
            clock.end_step();
        }
        EXPECT_EQ(active_cells(grid), grid.cells());
        EXPECT_EQ(all_numbers(grid, false), before);
    }
}

/// Blocks that nothing has reached are not computed, and what is computed is the same to the last bit as if all were.
TEST(EulerFlow, skips_quiet_blocks_without_a_trace)
{
    EulerGrid some = ball_in_air(32, true), all = ball_in_air(32, false);
    EXPECT_LT(active_cells(some), all.cells() / 2);
    EXPECT_EQ(active_cells(all), all.cells());
    Clock clock;
    for (int s = 0; s < 12; ++s) {
        ASSERT_EQ(stable_step(some), stable_step(all));
        clock.begin_step(stable_step(some));
        flow(some, clock);
        flow(all, clock);
        clock.end_step();
    }
    EXPECT_GT(active_cells(some), 0u);
    EXPECT_EQ(all_numbers(some, false), all_numbers(all, false));
    for (std::size_t f = 0; f < 6; ++f) {
        EXPECT_NEAR(norm(some.passages[f].momentum) / norm(all.passages[f].momentum), 1, 1e-12);
        EXPECT_EQ(some.passages[f].mass, all.passages[f].mass);
    }

    EulerGrid still = unit_grid(32, 32, 32, EulerEdge::rigid, {products, air});
    fill(still, [](const Vector3d&) { return EulerSample{1, 1.2, 101325}; });
    EXPECT_EQ(active_cells(still), 0u);
}

TEST(EulerFlow, does_not_depend_on_threads_nor_on_blocks)
{
    const int threads = thread_count();
    std::vector<std::vector<double>> found;
    for (const int count : {1, 2, 3}) {
        set_thread_count(count);
        EulerGrid grid = ball_in_air(24, true);
        Clock clock;
        for (int s = 0; s < 15; ++s) {
            clock.begin_step(stable_step(grid));
            flow(grid, clock);
            clock.end_step();
        }
        found.push_back(all_numbers(grid));
    }
    set_thread_count(threads);
    EXPECT_EQ(found[1], found[0]);
    EXPECT_EQ(found[2], found[0]);
}

/// A run taken up from its saved state goes on with the same bits.
TEST(EulerFlow, goes_on_from_its_saved_state)
{
    EulerMaterial tnt = products;
    tnt.explosive = {tnt_energy, 0, 6930, {{{0, 0, 0}, 0}}};
    const auto made = [&] {
        EulerGrid grid = unit_grid(24, 24, 1, EulerEdge::open, {tnt, air});
        fill(grid,
             {{Shape::box({{0, 0, 0}, {1, 1, 1}}), {1, 1.2, 101325}}, {Shape::sphere({0, 0, 0.5}, 0.3), {0, 1630, 101325, {}, 0, true}}});
        return grid;
    };
    EulerGrid straight = made(), stopped = made();
    Clock clock;
    const auto advance = [&](EulerGrid& grid, Clock& at) {
        at.begin_step(stable_step(grid));
        flow(grid, at);
        at.end_step();
    };
    for (int s = 0; s < 10; ++s) advance(straight, clock);
    const FieldSet saved = state(straight), room = state(stopped);
    for (std::size_t f = 0; f < saved.fields.size(); ++f) {
        std::vector<double> values(saved.fields[f].count * static_cast<std::size_t>(saved.fields[f].components));
        saved.fields[f].gather(values.data());
        room.fields[f].restore(values.data(), saved.fields[f].count);
    }
    prepare(stopped);
    Clock again = clock;
    for (int s = 0; s < 20; ++s) {
        advance(straight, clock);
        advance(stopped, again);
    }
    EXPECT_EQ(clock.time(), again.time());
    EXPECT_EQ(all_numbers(stopped), all_numbers(straight));
}

/// Explosive gives its energy exactly, once, and all of it; before the detonation comes it waits under the pressure around it.
TEST(EulerBurn, gives_all_the_energy_once)
{
    EulerMaterial tnt = products;
    tnt.explosive = {tnt_energy, 0, 6930, {{{0, 0, 0}, 1e-5}}};
    EulerGrid grid = unit_grid(32, 32, 1, EulerEdge::rigid, {tnt, air});
    fill(grid, {{Shape::box({{0, 0, 0}, {1, 1, 1}}), {1, 1.2, 101325}}, {Shape::sphere({0, 0, 0.5}, 0.3), {0, 1630, 101325, {}, 0, true}}});
    const EulerContents before = contents(grid);
    Clock clock;
    EXPECT_EQ(run_until(grid, clock, 0.9e-5).energy, 0);
    EXPECT_LT(unrest(grid, 101325, {}), 1e-3);
    const EulerAmount released = run_until(grid, clock, 1e-4);
    EXPECT_NEAR(released.energy / before.explosive.energy, 1, 1e-12);
    EXPECT_NEAR(released.mass[0] / before.explosive.mass[0], 1, 1e-12);
    const EulerContents after = contents(grid);
    EXPECT_EQ(after.explosive.whole_mass(), 0);
    EXPECT_NEAR(after.gas.energy / (before.gas.energy + before.explosive.energy), 1, 1e-12);
}

}  // namespace
}  // namespace corpuscle
