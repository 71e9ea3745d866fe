#include "simulation/outputs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <thread>

#include "output/replace_file.hpp"
#include "unit/scratch_folder.hpp"

namespace corpuscle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A model of one number, x' = 1, that writes a fast and a slow column, a family of dumps and restarts.
struct Counter {
    Clock clock;
    std::vector<double> x{0};

    OutputPlan plan(double restart_every = 1e9)
    {
        OutputPlan plan;
        plan.history.push_back({0.1, {{"fast.x", "m"}}, [this](std::span<double> values) { values[0] = x[0]; }});
        plan.history.push_back({0.25, {{"slow.x", "m"}, {"slow.y", "m"}}, [this](std::span<double> values) {
                                    values[0] = x[0];
                                    values[1] = -x[0];
                                }});
        plan.fields.push_back({"dots", 0.2, [this](const std::filesystem::path& path) { std::ofstream(path) << x[0]; }});
        plan.restart_every = restart_every;
        plan.state = [this] { return RestartContent{{{"time", clock.time()}}, {{"counter", {stored_field("x", "m", "", x)}}}}; };
        return plan;
    }
    void step(Outputs& outputs, double duration)
    {
        clock.begin_step(duration);
        x[0] += duration;
        outputs.write_due(clock);
        clock.end_step();
        outputs.save_due();
    }
};

RunFolder made(const ScratchFolder& folder)
{
    RunFolder run(folder / "run");
    run.create(Existing::replace);
    return run;
}

TEST(Outputs, WritesEachSourceAtItsOwnTimes)
{
    const ScratchFolder folder;
    Counter counter;
    Outputs outputs(made(folder), counter.plan());
    outputs.write_due(counter.clock);
    for (int i = 0; i < 50; ++i) counter.step(outputs, 0.01);

    const HistoryTable history = read_history(outputs.folder().history());
    ASSERT_EQ(history.times.size(), 7U);  // 0, 0.1, 0.2, 0.25, 0.3, 0.4, 0.5
    EXPECT_NEAR(history.times[3], 0.25, 1e-12);
    EXPECT_TRUE(std::isnan(history.values[0][3]));
    EXPECT_NEAR(history.values[1][3], 0.25, 1e-12);
    EXPECT_NEAR(history.values[2][3], -0.25, 1e-12);
    EXPECT_TRUE(std::isnan(history.values[1][4]));
    EXPECT_TRUE(std::filesystem::exists(outputs.folder().fields() / "dots_000002.hdf"));
    EXPECT_FALSE(std::filesystem::exists(outputs.folder().fields() / "dots_000003.hdf"));
    EXPECT_NEAR(outputs.next_due(), 0.6, 1e-12);
}

TEST(Outputs, FinishWritesTheLastStateOnce)
{
    const ScratchFolder folder;
    Counter counter;
    Outputs outputs(made(folder), counter.plan());
    outputs.write_due(counter.clock);
    for (int i = 0; i < 23; ++i) counter.step(outputs, 0.01);
    outputs.finish(counter.clock);
    outputs.finish(counter.clock);
    const HistoryTable history = read_history(outputs.folder().history());
    EXPECT_EQ(history.times.size(), 4U);  // 0, 0.1, 0.2, 0.23
    EXPECT_NEAR(history.values[1].back(), 0.23, 1e-12);
    EXPECT_FALSE(std::filesystem::exists(outputs.folder().fields() / "dots_000003.hdf"));
    EXPECT_EQ(RestartFolder(outputs.folder().restart()).files().size(), 2U);
    EXPECT_THAT(read_file(outputs.folder().log()), HasSubstr("state saved in state_000002.hdf"));
}

TEST(Outputs, WritesEverythingInTheLastStepIfItKnowsTheEnd)
{
    const ScratchFolder folder;
    Counter counter;
    OutputPlan plan = counter.plan();
    plan.end_time = 0.23;
    Outputs outputs(made(folder), plan);
    outputs.write_due(counter.clock);
    for (int i = 0; i < 23; ++i) counter.step(outputs, 0.01);
    EXPECT_NEAR(read_history(outputs.folder().history()).values[1].back(), 0.23, 1e-12);
    const std::string history = read_file(outputs.folder().history());
    const std::string list = read_file(outputs.folder().fields() / "dots.hdf.series");
    outputs.finish(counter.clock);
    EXPECT_EQ(read_file(outputs.folder().history()), history);
    EXPECT_EQ(read_file(outputs.folder().fields() / "dots.hdf.series"), list);
    EXPECT_TRUE(std::filesystem::exists(outputs.folder().fields() / "view.py"));
}

TEST(Outputs, ResumedRunLeavesTheSameFilesAsOneThatNeverStopped)
{
    const ScratchFolder one;
    const ScratchFolder two;
    Counter whole;
    Outputs all(made(one), whole.plan());
    all.write_due(whole.clock);
    for (int i = 0; i < 80; ++i) whole.step(all, 0.01);

    Counter before;
    const RunFolder folder = made(two);
    {
        Outputs outputs(folder, before.plan());
        outputs.write_due(before.clock);
        for (int i = 0; i < 40; ++i) before.step(outputs, 0.01);
        outputs.save();
        for (int i = 0; i < 17; ++i) before.step(outputs, 0.01);  // lost by the kill
    }
    Counter after;
    std::vector<std::string> remarks;
    const RestartFile state = RestartFolder(folder.restart()).open_newest(remarks);
    state.restore(after.plan().state().sets);
    after.clock.restore(state.number("time"), 0.01, 0.01, 40);
    Outputs outputs(folder, after.plan(), after.clock.time());
    for (int i = 0; i < 40; ++i) after.step(outputs, 0.01);

    EXPECT_EQ(after.x, whole.x);
    EXPECT_EQ(read_file(folder.history()), read_file(all.folder().history()));
    EXPECT_EQ(read_file(folder.fields() / "dots.hdf.series"), read_file(all.folder().fields() / "dots.hdf.series"));
    EXPECT_EQ(read_file(folder.fields() / "dots_000004.hdf"), read_file(all.folder().fields() / "dots_000004.hdf"));
}

TEST(Outputs, SavesByTheWallClock)
{
    const ScratchFolder folder;
    Counter counter;
    Outputs outputs(made(folder), counter.plan(0.02));
    counter.step(outputs, 0.01);
    EXPECT_TRUE(RestartFolder(outputs.folder().restart()).files().empty());
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
    counter.step(outputs, 0.01);
    EXPECT_EQ(RestartFolder(outputs.folder().restart()).files().size(), 1U);
}

TEST(Outputs, WithoutSourcesWritesNothing)
{
    const ScratchFolder folder;
    Outputs outputs(made(folder), {});
    Clock clock;
    outputs.write_due(clock);
    clock.begin_step(1);
    outputs.write_due(clock);
    clock.end_step();
    outputs.finish(clock);
    EXPECT_EQ(read_file(outputs.folder().history()), "time [s]\n");
    EXPECT_TRUE(std::isinf(outputs.next_due()));
}

TEST(Interval, IsDueAtEveryMultiple)
{
    Interval interval(1e-5);
    std::vector<double> taken;
    for (int i = 0; i <= 100'000; ++i) {
        const double time = i * 1e-6;
        if (interval.take(time)) taken.push_back(time);
    }
    ASSERT_EQ(taken.size(), 10'001U);
    for (std::size_t k = 0; k < taken.size(); ++k) EXPECT_NEAR(taken[k], static_cast<double>(k) * 1e-5, 1e-12);
}

TEST(Interval, SkipsWhatALongStepJumpedOver)
{
    Interval interval(1);
    EXPECT_TRUE(interval.take(0));
    EXPECT_FALSE(interval.take(0.5));
    EXPECT_TRUE(interval.take(7.5));
    EXPECT_EQ(interval.next(), 8);
    interval.resume(3);
    EXPECT_EQ(interval.next(), 4);
}

TEST(Interval, OfNothingIsDueOnlyAtTheStart)
{
    for (const double every : {0.0, static_cast<double>(INFINITY)}) {
        Interval interval(every);
        EXPECT_TRUE(interval.take(0));
        EXPECT_TRUE(std::isinf(interval.next()));
        EXPECT_FALSE(interval.take(1e9));
    }
}

}  // namespace
}  // namespace corpuscle
