#include "simulation/ensemble.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "sample_run.hpp"
#include "simulation/ensemble_summary.hpp"
#include "unit/scratch_folder.hpp"

namespace corpuscle {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

const double gap = std::numeric_limits<double>::quiet_NaN();

SampleTimes every_second()
{
    SampleTimes times;
    times.every = {{"probe", 1.0}, {"wall", 2.0}};
    times.otherwise = 4;
    times.end = 4;
    return times;
}

TEST(SampleTimes, AreMultiplesAndTheEnd)
{
    EXPECT_THAT(every_second().of("probe"), ElementsAre(0, 1, 2, 3, 4));
    EXPECT_THAT(every_second().of("anything"), ElementsAre(0, 4));
    SampleTimes uneven;
    uneven.otherwise = 3;
    uneven.end = 4;
    EXPECT_THAT(uneven.of(""), ElementsAre(0, 3, 4));
}

/// Two runs of x = t and x = 3 t, sampled at the ends of steps of different lengths: interpolated, their mean is 2 t and their deviation
/// sqrt(2) t, at the wanted times.
TEST(EnsembleHistory, InterpolatesWhatIsKnownAtMoments)
{
    const HistoryTable one{{{"probe.velocity_x", "m/s"}}, {0, 1.1, 2.2, 3.1, 4}, {{0, 1.1, 2.2, 3.1, 4}}};
    const HistoryTable other{{{"probe.velocity_x", "m/s"}}, {0, 1.5, 2, 4}, {{0, 4.5, gap, 12}}};
    const HistoryTable found = ensemble_history({one, other}, every_second());
    EXPECT_THAT(found.times, ElementsAre(0, 1, 2, 3, 4));
    ASSERT_EQ(found.columns.size(), 4U);
    EXPECT_EQ(found.columns[1], (HistoryColumn{"probe.velocity_deviation_x", "m/s"}));
    EXPECT_EQ(found.columns[2].name, "probe.velocity_low_x");
    EXPECT_EQ(found.columns[3].name, "probe.velocity_high_x");
    EXPECT_THAT(found.values[0], Pointwise(DoubleNear(1e-12), {0.0, 2.0, 4.0, 6.0, 8.0}));
    EXPECT_NEAR(found.values[1][3], std::sqrt(2.0) * 3, 1e-12);
    EXPECT_NEAR(found.values[3][3], 6 + 12.7062 * 3, 1e-3);
}

/// A pressure that is the mean since the last row is averaged over the wanted interval: the impulse is kept. A jump of 10 Pa that is seen
/// for a second of the two leaves 5 Pa, whatever the rows; its standard error is no column of its own, nor is it averaged.
TEST(EnsembleHistory, AveragesAnewWhatIsAMeanSinceTheLastRow)
{
    const std::vector<HistoryColumn> columns{{"wall.pressure", "Pa"}, {"wall.pressure_error", "Pa"}};
    const HistoryTable one{columns, {0, 1, 2, 4}, {{0, 0, 10, 0}, {1, 1, 1, 1}}};
    const HistoryTable other{columns, {0, 1, 2, 4}, {{0, 10, 0, 0}, {1, 1, 1, 1}}};
    const HistoryTable found = ensemble_history({one, other}, every_second());
    ASSERT_EQ(found.columns.size(), 4U);
    EXPECT_THAT(found.times, ElementsAre(0, 2, 4));
    EXPECT_THAT(found.values[0], Pointwise(DoubleNear(1e-12), {0.0, 5.0, 0.0}));
    EXPECT_THAT(found.values[1], Pointwise(DoubleNear(1e-12), {0.0, 0.0, 0.0}));
}

/// Columns with other times have rows of their own, and empty cells in those.
TEST(EnsembleHistory, LeavesCellsEmptyWhereNothingIsWanted)
{
    const HistoryTable one{{{"probe.x", "m"}, {"energy.gas", "J"}}, {0, 1, 2, 3, 4}, {{0, 1, 2, 3, 4}, {9, 9, 9, 9, 9}}};
    const HistoryTable found = ensemble_history({one, one}, every_second());
    ASSERT_EQ(found.times.size(), 5U);
    EXPECT_EQ(found.values[4][0], 9);
    EXPECT_TRUE(std::isnan(found.values[4][1]));
    EXPECT_EQ(found.values[4][4], 9);
}

/// Means in the usual places, sums of work, the worst verdict; and it reads back what it wrote.
TEST(EnsembleSummary, IsMeansSumsAndTheWorst)
{
    RunSummary one = sample_run().summary, other = one;
    one.seed = 7;
    other.seed = 8;
    other.probes["center"]["displacement_z_m"].minimum = one.probes["center"]["displacement_z_m"].minimum - 0.002;
    other.gauges["wall"].arrival = std::numeric_limits<double>::quiet_NaN();
    other.parts["plate"].impulse.z = one.parts["plate"].impulse.z - 10;
    other.energy_error = 4e-3;
    other.verdicts[0].value = 0.5;
    const RunSummary both = ensemble_summary({one, other}, {7, 8, 9});
    EXPECT_EQ(both.steps, 2 * one.steps);
    EXPECT_EQ(both.energy_error, 4e-3);
    EXPECT_EQ(both.verdicts[0].value, 0.5);
    const double least = one.probes["center"]["displacement_z_m"].minimum - 0.001;
    EXPECT_DOUBLE_EQ(both.probes.at("center").at("displacement_z_m").minimum, least);
    EXPECT_DOUBLE_EQ(both.parts.at("plate").impulse.z, -1655);
    EXPECT_THAT(both.ensemble->seeds, ElementsAre(7, 8, 9));
    EXPECT_THAT(both.ensemble->done, ElementsAre(7, 8));
    const Statistic& found = both.ensemble->quantities.at("/probes/center/displacement_z_m/min");
    EXPECT_NEAR(found.standard_error, 0.001, 1e-12);
    EXPECT_EQ(both.ensemble->quantities.at("/gauges/wall/arrival_s").count, 1U);
    const RunSummary again = parse_summary(summary_text(both), "again");
    EXPECT_THAT(again.ensemble->done, ElementsAre(7, 8));
    EXPECT_EQ(again.ensemble->quantities.at("/probes/center/displacement_z_m/min"), found);
    EXPECT_EQ(again.ensemble->quantities.at("/parts/plate/impulse_n_s/2").mean, -1655);
}

TEST(Ensemble, OfNoneThatIsDoneIsStillASummary)
{
    const RunSummary none = ensemble_summary({}, {1, 2});
    const RunSummary again = parse_summary(summary_text(none), "again");
    EXPECT_TRUE(again.ensemble->done.empty());
    EXPECT_TRUE(again.ensemble->quantities.empty());
}

/// An older ensemble's members are gone after --force, so that none of them counts as done.
TEST(Ensemble, ClearsAwayAnOlderOnesMembers)
{
    const ScratchFolder folder;
    const Ensemble ensemble(folder / "all", 5, 2, 3e-3), longer(folder / "all", 5, 2, 4e-3);
    ensemble.create(Existing::refuse);
    std::filesystem::create_directories(ensemble.member(6).path());
    write_sample_run(ensemble.member(6).path());
    EXPECT_TRUE(ensemble.is_done(6));
    EXPECT_FALSE(longer.is_done(6));
    EXPECT_FALSE(ensemble.is_done(5));
    EXPECT_THROW(ensemble.check(Existing::refuse), InputError);
    ensemble.create(Existing::replace);
    EXPECT_FALSE(ensemble.is_done(6));
    EXPECT_FALSE(ensemble.has_state(6));
}

}  // namespace
}  // namespace corpuscle
