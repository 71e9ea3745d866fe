#include "simulation/summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "output/replace_file.hpp"
#include "sample_run.hpp"
#include "simulation/summary_history.hpp"
#include "unit/scratch_folder.hpp"

namespace corpuscle {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

/// Names of an object's members, in alphabetical order.
std::vector<std::string> keys(const json& object)
{
    std::vector<std::string> names;
    for (const auto& item : object.items()) names.push_back(item.key());
    return names;
}

TEST(Summary, HasThePromisedKeys)
{
    const json summary = json::parse(summary_text(sample_run().summary));
    EXPECT_EQ(summary.at("version"), 1);
    EXPECT_EQ(summary.at("title"), "15 kg TNT, 700 mm from a \"clamped\" <RHA> plate & frame");
    EXPECT_EQ(summary.at("status"), "done");
    EXPECT_EQ(summary.at("end_time_s"), 0.003);
    EXPECT_EQ(summary.at("steps"), 1234);
    EXPECT_EQ(summary.at("wall_s"), 14.2);
    EXPECT_EQ(summary.at("cpu_s"), 27.9);
    EXPECT_EQ(summary.at("peak_memory_bytes"), 123456789);
    EXPECT_EQ(summary.at("threads"), 2);
    EXPECT_EQ(summary.at("ranks"), 1);
    EXPECT_EQ(summary.at("seed"), 7);
    EXPECT_EQ(summary.at("counts"), json::parse(R"({"particles": {"tnt": 2400, "air": 17600}, "elements": 512, "grains": 0, "cells": 0})"));
    EXPECT_EQ(summary.at("work"), json::parse(R"({"particle_steps": 24680000, "element_steps": 631808, "grain_steps": 0,
                                                 "cell_steps": 0, "squeezed_cells": 0})"));
    EXPECT_EQ(summary.at("seconds").at("collide"), 5.5);
    EXPECT_EQ(summary.at("ledger").at("mass_error"), 0);
    EXPECT_EQ(summary.at("ledger").at("momentum_error"), 2.5e-7);
    EXPECT_EQ(summary.at("ledger").at("energy_error"), -3.1e-3);
    EXPECT_THAT(keys(summary.at("probes").at("center").at("displacement_z_m")),
                ElementsAre("final", "max", "min", "time_of_max_s", "time_of_min_s"));
    EXPECT_THAT(keys(summary.at("gauges").at("wall")),
                ElementsAre("arrival_s", "impulse_error_pa_s", "impulse_pa_s", "peak_pressure_error_pa", "peak_pressure_pa"));
    EXPECT_EQ(
        summary.at("parts").at("plate"),
        json::parse(
            R"({"impulse_n_s": [0.1, -0.2, -1650], "max_plastic_strain": 0.0123, "kinetic_energy_j": 4.5e4, "internal_energy_j": 8.9e4,
                 "gas_impulse_n_s": [0, 0, -1600], "gas_work_j": 1.3e5})"));
    EXPECT_EQ(summary.at("ledger").at("transfers").at(0).at("from"), "gas");
    EXPECT_EQ(summary.at("verdicts").size(), 5U);
}

TEST(Summary, KeepsThePhasesInTheOrderOfTheStep)
{
    const auto summary = nlohmann::ordered_json::parse(summary_text(sample_run().summary));
    std::vector<std::string> phases;
    for (const auto& item : summary.at("seconds").items()) phases.push_back(item.key());
    EXPECT_THAT(phases, ElementsAre("burn", "accelerate", "collide", "fly", "contact", "resist", "ledger", "outputs"));
}

TEST(Summary, ReadsBackTheSame)
{
    const ScratchFolder folder;
    const std::string text = summary_text(sample_run().summary);
    write_summary(folder / "summary.json", sample_run().summary);
    EXPECT_EQ(read_file(folder / "summary.json"), text);
    EXPECT_EQ(summary_text(read_summary(folder / "summary.json")), text);
}

TEST(Summary, TakesNumbersThatAreNotFinite)
{
    const ScratchFolder folder;
    RunSummary summary = sample_run().summary;
    summary.energy_error = std::numeric_limits<double>::quiet_NaN();
    summary.gauges["wall"].arrival = std::numeric_limits<double>::infinity();
    write_summary(folder / "summary.json", summary);
    EXPECT_THAT(read_file(folder / "summary.json"), HasSubstr("\"energy_error\": null"));
    const RunSummary back = read_summary(folder / "summary.json");
    EXPECT_TRUE(std::isnan(back.energy_error));
    EXPECT_FALSE(all_verdicts(back)[2].passed());
}

TEST(Summary, RefusesWhatIsNone)
{
    const ScratchFolder folder;
    for (const char* text : {"{", "{}", "[1]", R"({"version": 2})"}) {
        replace_file(folder / "summary.json", text);
        EXPECT_THROW((void)read_summary(folder / "summary.json"), InputError) << text;
    }
}

TEST(SummaryKey, CarriesTheUnit)
{
    EXPECT_EQ(summary_key("displacement_z", "m"), "displacement_z_m");
    EXPECT_EQ(summary_key("velocity_x", "m/s"), "velocity_x_m_per_s");
    EXPECT_EQ(summary_key("impulse", "Pa s"), "impulse_pa_s");
    EXPECT_EQ(summary_key("plastic_strain", "1"), "plastic_strain");
}

TEST(Verdict, PassesUpToItsLimitAndNeverWithoutANumber)
{
    EXPECT_TRUE((Verdict{"x", 0.1, 0.1, ""}).passed());
    EXPECT_FALSE((Verdict{"x", 0.11, 0.1, ""}).passed());
    EXPECT_FALSE((Verdict{"x", std::numeric_limits<double>::quiet_NaN(), 0.1, ""}).passed());
    EXPECT_FALSE(energy_verdict(-0.5).passed());
    EXPECT_FALSE(noise_verdict(0).passed());
    EXPECT_NEAR(noise_verdict(100).value, 0.1128379, 1e-7);  // sqrt(4 / (100 pi))
    EXPECT_DOUBLE_EQ(resolution_verdict(0.07, 0.7).value, 0.1);
}

TEST(SummaryHistory, TakesColumnNamesApart)
{
    const ColumnName name = column_name("plate.center.displacement_z");
    EXPECT_EQ(name.owner, "plate.center");
    EXPECT_EQ(name.quantity, "displacement");
    EXPECT_EQ(name.component, "z");
    EXPECT_EQ(column_name("wall.pressure").component, "");
    EXPECT_EQ(column_name("alone").owner, "");
    EXPECT_EQ(column_name("a.index").quantity, "index");
}

TEST(SummaryHistory, FindsExtremesBetweenGaps)
{
    const double gap = std::numeric_limits<double>::quiet_NaN();
    HistoryTable history{{{"p.velocity_z", "m/s"}, {"other.velocity_z", "m/s"}, {"p.pressure", "Pa"}},
                         {1, 2, 3, 4, 5},
                         {{gap, -2, 5, 1, gap}, {0, 0, 0, 0, 0}, {1, 1, 1, 1, 1}}};  // a gauge is called p, too
    RunSummary summary;
    add_probes(summary, history, {"p"});
    ASSERT_EQ(summary.probes.size(), 1U);
    ASSERT_EQ(summary.probes.at("p").size(), 1U);
    const ProbeSummary& speed = summary.probes.at("p").at("velocity_z_m_per_s");
    EXPECT_EQ(speed.minimum, -2);
    EXPECT_EQ(speed.time_of_minimum, 2);
    EXPECT_EQ(speed.maximum, 5);
    EXPECT_EQ(speed.time_of_maximum, 3);
    EXPECT_EQ(speed.final, 1);
}

TEST(SummaryHistory, FindsPeakImpulseAndArrival)
{
    const double gap = std::numeric_limits<double>::quiet_NaN();
    const HistoryTable history{{{"g.pressure", "Pa"}, {"g.impulse", "Pa s"}, {"still.pressure", "Pa"}},
                               {1, 2, 3, 4, 5},
                               {{100, 101, gap, 300, 200}, {0, 1, 3, 9, 8}, {100, 100, 100, 100, 100}}};
    RunSummary summary;
    add_gauges(summary, history, {"g", "still", "absent"});
    EXPECT_EQ(summary.gauges.at("g").peak_pressure, 300);
    EXPECT_EQ(summary.gauges.at("g").impulse, 9);
    EXPECT_EQ(summary.gauges.at("g").arrival, 4);
    EXPECT_TRUE(std::isnan(summary.gauges.at("still").arrival));
    EXPECT_EQ(summary.gauges.count("absent"), 0U);
    EXPECT_TRUE(std::isnan(summary.gauges.at("g").peak_pressure_error));
}

/// Errors are those of the very samples that peak and impulse were read from.
TEST(SummaryHistory, FindsTheErrorsOfPeakAndImpulse)
{
    const HistoryTable history{{{"g.pressure", "Pa"}, {"g.pressure_error", "Pa"}, {"g.impulse", "Pa s"}, {"g.impulse_error", "Pa s"}},
                               {1, 2, 3},
                               {{100, 300, 200}, {10, 30, 20}, {0, 5, 9}, {0, 2, 3}}};
    RunSummary summary;
    add_gauges(summary, history, {"g"});
    EXPECT_EQ(summary.gauges.at("g").peak_pressure_error, 30);
    EXPECT_EQ(summary.gauges.at("g").impulse_error, 3);
}

/// A sample above 5 % of the greatest rise is no arrival while it is within four errors of still gas, whose squared error is that of a
/// sample over the ratio of their pressures; where nothing rises above them, there is none.
TEST(SummaryHistory, TellsArrivalFromNoise)
{
    const HistoryTable history{{{"g.pressure", "Pa"}, {"g.pressure_error", "Pa"}, {"noise.pressure", "Pa"}, {"noise.pressure_error", "Pa"}},
                               {1, 2, 3, 4, 5},
                               {{100, 130, 100, 400, 300}, {10, 11, 10, 140, 120}, {100, 130, 90, 120, 100}, {10, 11, 9, 11, 10}}};
    RunSummary summary;
    add_gauges(summary, history, {"g", "noise"});
    EXPECT_EQ(summary.gauges.at("g").arrival, 4);  // 300 above, four times 140/sqrt(4) is 280; 30 at time 2 is below 38.6
    EXPECT_TRUE(std::isnan(summary.gauges.at("noise").arrival));
}

TEST(SummaryHistory, NamesTheColumnsThatGoTogether)
{
    EXPECT_EQ(companion("wall.pressure", "error"), "wall.pressure_error");
    EXPECT_EQ(companion("ball.velocity_x", "error"), "ball.velocity_error_x");
    EXPECT_EQ(companion("time", "low"), "time_low");
}

}  // namespace
}  // namespace corpuscle
