#include <gmock/gmock.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include "base/error.hpp"
#include "euler/fill.hpp"
#include "simulation/grid_gauges.hpp"
#include "simulation/simulation.hpp"
#include "unit/scratch_folder.hpp"

namespace corpuscle {
namespace {

using ::testing::HasSubstr;

/// A closed box of 8 x 4 x 4 cells of air with a hot corner.
std::unique_ptr<Model> hot_box()
{
    auto model = std::make_unique<Model>(Gas{}, Structure{});
    model->euler = make_grid(EulerSpace::planar, {even_faces(0, 2, 8), even_faces(0, 1, 4), even_faces(0, 1, 4)}, {},
                             {{"air", IdealGas{1.4}, {}, 0.029}});
    fill(model->euler, [](const Vector3d& at) { return EulerSample{0, 1.2, at.x < 0.5 ? 2e5 : 1e5, {}, 0, false}; });
    model->end_time = 2e-3;
    model->output.history_every = 1e-4;
    model->output.fields_every = 1e-3;
    return model;
}

std::map<std::string, double> columns(OutputPlan& plan)
{
    HistorySource& source = plan.history.at(0);
    std::vector<double> values(source.columns.size());
    source.sample(values);
    std::map<std::string, double> result;
    for (std::size_t i = 0; i < values.size(); ++i) result[source.columns[i].name] = values[i];
    return result;
}

TEST(GridGauges, InARegionShowTheGasAndItsImpulse)
{
    auto model = hot_box();
    model->gauges.push_back({"g", GridRegionGauge{{0, 7}, {0.01, 0.03}}, 1e-3});
    Clock clock;
    GridGauges gauges(*model);
    OutputPlan plan;
    gauges.add_to(plan, clock);
    auto seen = columns(plan);
    EXPECT_DOUBLE_EQ(seen.at("g.pressure"), 0.25 * 2e5 + 0.75 * 1e5);
    EXPECT_DOUBLE_EQ(seen.at("g.density"), 1.2);
    EXPECT_DOUBLE_EQ(seen.at("g.temperature"), 1.25e5 * 0.029 / (1.2 * 8.31446261815324));
    EXPECT_EQ(seen.at("g.impulse"), 0);
    clock.begin_step(1e-3);
    for (double& energy : model->euler.now.energy) energy *= 2;
    seen = columns(plan);
    EXPECT_DOUBLE_EQ(seen.at("g.pressure"), 2.5e5);
    EXPECT_DOUBLE_EQ(seen.at("g.impulse"), 0.5 * 1.25e5 * 1e-3);  // by the trapezoidal rule, above the first pressure
    EXPECT_EQ(seen.at("g.velocity_x"), 0);
}

TEST(GridGauges, OnAFaceShowTheMeanOverTheInterval)
{
    auto model = hot_box();
    model->gauges.push_back({"wall", GridFaceGauge{1}, 1e-3});
    Clock clock;
    GridGauges gauges(*model);
    OutputPlan plan;
    gauges.add_to(plan, clock);
    EXPECT_TRUE(std::isnan(columns(plan).at("wall.pressure")));  // there was no time yet
    clock.begin_step(2e-3);
    model->euler.passages[1].momentum.x = 400;
    auto seen = columns(plan);
    EXPECT_DOUBLE_EQ(seen.at("wall.pressure"), 2e5);  // over 1 m2
    EXPECT_DOUBLE_EQ(seen.at("wall.impulse"), 400);
}

TEST(GridRun, ClosesItsBooksAndCountsItsCells)
{
    const ScratchFolder scratch;
    const RunFolder folder(scratch.path() / "run");
    folder.create(Existing::refuse);
    Simulation simulation(hot_box(), folder);
    const std::atomic<bool> never = false;
    EXPECT_EQ(simulation.run(never, [](const Progress& progress) { EXPECT_EQ(progress.step_set_by, "euler"); }), Ending::done);
    const RunSummary summary = simulation.summary();
    EXPECT_EQ(summary.cells, 128u);
    EXPECT_EQ(summary.cell_steps, 128 * summary.steps);
    EXPECT_LT(summary.mass_error, 1e-13);
    EXPECT_LT(summary.energy_error, 1e-13);
    EXPECT_LT(summary.momentum_error, 1e-13);
    EXPECT_TRUE(std::filesystem::exists(folder.fields() / "cells.hdf.series"));
}

TEST(GridRun, StopsAtACellThatIsNoNumber)
{
    const ScratchFolder scratch;
    const RunFolder folder(scratch.path() / "run");
    folder.create(Existing::refuse);
    auto model = hot_box();
    model->euler.now.energy[model->euler.cell(5, 2, 3)] = std::numeric_limits<double>::quiet_NaN();
    Simulation simulation(std::move(model), folder);
    const std::atomic<bool> never = false;
    try {
        simulation.run(never, [](const Progress&) {});
        FAIL() << "nothing was thrown";
    } catch (const SafetyStop& error) {
        EXPECT_THAT(error.what(), HasSubstr("no longer finite"));
        EXPECT_THAT(error.what(), HasSubstr("of the grid, around ("));
        EXPECT_THAT(error.what(), HasSubstr("euler.cfl"));
    }
}

}  // namespace
}  // namespace corpuscle
