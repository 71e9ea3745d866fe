#include "output/history/history.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>

#include "base/error.hpp"
#include "output/replace_file.hpp"
#include "unit/scratch_folder.hpp"

namespace corpuscle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

const std::vector<HistoryColumn> columns{{"center.displacement_z", "m"}, {"wall, left.pressure", "Pa"}};

void add(History& history, double time, double first, double second)
{
    history.add(time, std::array{first, second});
}

TEST(History, WritesUnitsNumbersAndGaps)
{
    const ScratchFolder folder;
    History history(folder / "history.csv", columns);
    add(history, 0, 0, nothing);
    add(history, 1e-5, -0.1, 101325);
    EXPECT_EQ(read_file(folder / "history.csv"),
              "time [s],center.displacement_z [m],\"wall, left.pressure [Pa]\"\n0,0,\n1e-05,-0.1,101325\n");
}

TEST(History, ReadsBackWhatItWrote)
{
    const ScratchFolder folder;
    History history(folder / "history.csv", columns);
    add(history, 0.1, 1.0 / 3, nothing);
    add(history, 0.2, -5e-324, 1e300);
    const HistoryTable table = read_history(folder / "history.csv");
    EXPECT_EQ(table.columns, columns);
    EXPECT_THAT(table.times, ElementsAre(0.1, 0.2));
    ASSERT_NE(table.find("center.displacement_z"), nullptr);
    EXPECT_THAT(*table.find("center.displacement_z"), ElementsAre(1.0 / 3, -5e-324));
    EXPECT_TRUE(std::isnan(table.values[1][0]));
    EXPECT_EQ(table.values[1][1], 1e300);
    EXPECT_EQ(table.find("absent"), nullptr);
}

TEST(History, GoesOnFromTheRestartTime)
{
    const ScratchFolder folder;
    {
        History history(folder / "history.csv", columns);
        for (int i = 0; i < 5; ++i) add(history, i, 10 * i, 0);
    }
    std::ofstream(folder / "history.csv", std::ios::app) << "5,50";  // killed while writing
    {
        History history = History::resume(folder / "history.csv", columns, 2);
        add(history, 2.5, 25, 0);
    }
    const HistoryTable table = read_history(folder / "history.csv");
    EXPECT_THAT(table.times, ElementsAre(0, 1, 2, 2.5));
    EXPECT_THAT(table.values[0], ElementsAre(0, 10, 20, 25));
}

TEST(History, CutsATornLineEvenWhenNothingElseGoes)
{
    const ScratchFolder folder;
    {
        History history(folder / "history.csv", columns);
        add(history, 1, 2, 3);
    }
    std::ofstream(folder / "history.csv", std::ios::app) << "2,";
    {
        History history = History::resume(folder / "history.csv", columns, 10);
        add(history, 11, 12, 13);
    }
    EXPECT_THAT(read_history(folder / "history.csv").times, ElementsAre(1, 11));
}

TEST(History, RefusesOtherColumnsOrValues)
{
    const ScratchFolder folder;
    History history(folder / "history.csv", columns);
    EXPECT_THROW(history.add(0, std::array{1.0}), Error);
    try {
        (void)History::resume(folder / "history.csv", {{"other", "m"}}, 1);
        FAIL() << "other columns were accepted";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("history.csv:1:1: "));
        EXPECT_THAT(error.remedy(), HasSubstr("other [m]"));
    }
    EXPECT_EQ(read_history(folder / "history.csv").columns, columns);
}

TEST(History, NamesTheLineItCannotRead)
{
    const ScratchFolder folder;
    std::ofstream(folder / "a.csv") << "time [s],x [m]\n0,1\n1,abc\n";
    std::ofstream(folder / "b.csv") << "time [s],x [m]\n0,1,2\n";
    std::ofstream(folder / "c.csv") << "x,y\n0,1\n";
    for (const auto& [name, place] : {std::pair{"a.csv", "a.csv:3:"}, {"b.csv", "b.csv:2:"}, {"c.csv", "c.csv:1:"}}) {
        try {
            (void)read_history(folder / name);
            FAIL() << name << " was read";
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr(place));
        }
    }
    EXPECT_THROW((void)read_history(folder / "absent.csv"), Error);
    EXPECT_THROW(History(folder / "no/folder.csv", columns), Error);
}

}  // namespace
}  // namespace corpuscle
