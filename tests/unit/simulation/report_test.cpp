#include "simulation/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>

#include "base/error.hpp"
#include "output/replace_file.hpp"
#include "sample_run.hpp"
#include "simulation/report_chart.hpp"
#include "simulation/report_curves.hpp"
#include "simulation/report_text.hpp"
#include "simulation/report_units.hpp"
#include "unit/scratch_folder.hpp"

namespace corpuscle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++found;
    return found;
}

std::vector<std::string> labels(const Chart& chart)
{
    std::vector<std::string> result;
    for (const Curve& curve : chart.curves) result.push_back(curve.label);
    return result;
}

TEST(Report, IsMadeFromTheRunsFolderAlone)
{
    const ScratchFolder folder;
    write_sample_run(folder.path());
    const auto path = write_report(folder.path());
    EXPECT_EQ(path, folder / "report.html");
    const std::string page = read_file(path);
    EXPECT_EQ(write_report(folder.path()), path);
    EXPECT_EQ(read_file(path), page);
    EXPECT_THROW(write_report(folder / "absent"), InputError);
}

/// A value too small for most arithmetic is still drawn.
TEST(Drawn, TakesDenormalValues)
{
    const std::string figure = drawn({"T", "time", "s", "height", "m", {{"ball", {0, 1}, {4e-320, 1}}}, {}});
    EXPECT_EQ(count(figure, "class=\"curve c0\""), 1U);
}

/// Standard errors are no curves of their own but bands of 1.96 of them; ends of a band that are given are taken as they are.
TEST(Report, DrawsErrorsAsBands)
{
    const HistoryTable history{{{"g.pressure", "Pa"},
                                {"g.pressure_error", "Pa"},
                                {"c.velocity_z", "m/s"},
                                {"c.velocity_low_z", "m/s"},
                                {"c.velocity_high_z", "m/s"},
                                {"c.velocity_deviation_z", "m/s"}},
                               {1, 2},
                               {{100, 200}, {10, 20}, {1, 2}, {0.5, 1}, {2, 4}, {0.1, 0.2}}};
    const std::vector<Chart> charts = history_charts(history, {});
    ASSERT_EQ(charts.size(), 2U);
    ASSERT_THAT(labels(charts[0]), ElementsAre("g (band: 95 %)"));
    EXPECT_NEAR(charts[0].curves[0].band.low[1], 200 - 1.959964 * 20, 1e-9);
    EXPECT_NEAR(charts[0].curves[0].band.high[0], 100 + 1.959964 * 10, 1e-9);
    EXPECT_THAT(charts[1].curves[0].band.low, ElementsAre(0.5, 1));
    EXPECT_THAT(charts[1].curves[0].band.high, ElementsAre(2, 4));
    EXPECT_EQ(count(drawn(charts[1]), "class=\"band c0\""), 1U);
}

TEST(Report, RefersToNothingOutsideItself)
{
    const std::string page = report_page(sample_run());
    EXPECT_FALSE(std::regex_search(page, std::regex(R"((src|href|action)\s*=)", std::regex::icase)));
    for (const char* outside :
         {"http:", "https:", "//cdn", "@import", "url(", "<link", "<iframe", "<img", "fetch(", "XMLHttpRequest", "import("}) {
        EXPECT_EQ(page.find(outside), std::string::npos) << outside;
    }
}

TEST(Report, ShowsVerdictsWithNumberAndLimit)
{
    ReportData data = sample_run();
    std::string page = report_page(data);
    for (const char* name : {"Mass", "Momentum", "Energy", "Noise", "Resolution"})
        EXPECT_THAT(page, HasSubstr("<h3>" + std::string(name) + "</h3>"));
    EXPECT_EQ(count(page, "check pass"), 4U);
    EXPECT_EQ(count(page, "check warn"), 1U);  // resolution 0.09 / 0.7 over 0.1
    EXPECT_THAT(page, HasSubstr("0.31 %</div><p>limit 1 %"));
    data.summary.energy_error = 0.02;
    page = report_page(data);
    EXPECT_EQ(count(page, "check warn"), 2U);
    EXPECT_THAT(page, HasSubstr("<div class=\"number\">2 %</div><p>limit 1 %</p>"));
}

TEST(Report, DrawsEveryQuantityOnce)
{
    const std::string page = report_page(sample_run());
    EXPECT_EQ(count(page, "<figure class=\"chart\">"), 6U);
    for (const char* title : {"Displacement", "Energy", "Energy, the smaller shares", "Pressure", "Impulse", "Velocity"})
        EXPECT_THAT(page, HasSubstr("<b>" + std::string(title) + "</b>"));
    EXPECT_EQ(count(page, "<path class=\"curve"), 7U);  // x and y displacements are negligible
    EXPECT_THAT(page, HasSubstr("time [ms]"));
    EXPECT_THAT(page, HasSubstr("[mm]"));
    EXPECT_THAT(page, HasSubstr("[MPa]"));
    EXPECT_THAT(page, HasSubstr("[kPa s]"));
    EXPECT_EQ(count(page, "<g class=\"reference\">"), 1U);
    EXPECT_THAT(page, HasSubstr("experiment &lt;A &amp; B&gt;: -47 mm"));
}

TEST(Report, EscapesWhatTheCaseSays)
{
    const std::string page = report_page(sample_run());
    EXPECT_THAT(page, HasSubstr("&lt;RHA&gt; plate &amp; frame"));
    EXPECT_THAT(page, Not(HasSubstr("<RHA>")));
    EXPECT_EQ(count(page, "</pre>"), 1U);
    EXPECT_EQ(count(page, "<script"), 7U);  // six charts and the read-out
    EXPECT_EQ(count(page, "</script>"), 7U);
}

TEST(Report, SaysWhatItCostAndHowToRepeatIt)
{
    const std::string page = report_page(sample_run());
    EXPECT_THAT(
        page,
        HasSubstr("3 ms of time in 1,234 steps, with 20,000 particles (17,600 air, 2,400 tnt) and 512 elements: 14.2 s on 2 threads."));
    EXPECT_THAT(page, HasSubstr("corpuscle run case.toml --threads 2"));
    EXPECT_THAT(page, HasSubstr("Seed 7."));
    EXPECT_THAT(page, HasSubstr("end_time = &quot;3 ms&quot;"));
    EXPECT_THAT(page, HasSubstr("38.7 %"));  // collide, 5.5 s of 14.2 s
    EXPECT_THAT(page, HasSubstr("gas → structure"));
    EXPECT_THAT(page, HasSubstr("575.4 ns"));  // 14.2 s / 24.68e6
    EXPECT_THAT(page, HasSubstr("(0, 0, -1.65) kN s"));
}

TEST(Report, SaysWhyARunStopped)
{
    ReportData data = sample_run();
    data.summary.status = "stopped";
    data.summary.reason = "energy of part 'plate' is not a number";
    const std::string page = report_page(data);
    EXPECT_THAT(page, HasSubstr("<span class=\"status warn\">stopped</span>"));
    EXPECT_THAT(page, HasSubstr("energy of part &#39;plate&#39; is not a number"));
}

TEST(Report, TakesARunOfNothing)
{
    ReportData data;
    data.summary.title = "nothing";
    const std::string page = report_page(data);
    EXPECT_THAT(page, HasSubstr("with nothing"));
    EXPECT_EQ(count(page, "<figure"), 0U);
    EXPECT_EQ(count(page, "nan"), 0U);
    EXPECT_EQ(count(page, "inf"), 0U);
}

TEST(HistoryCharts, GroupsAndOrdersTheColumns)
{
    const ReportData data = sample_run();
    const std::vector<Chart> charts = history_charts(data.history, data.summary.references);
    ASSERT_EQ(charts.size(), 6U);
    EXPECT_THAT(labels(charts[0]), ElementsAre("center z"));
    EXPECT_THAT(labels(charts[1]), ElementsAre("gas"));
    EXPECT_THAT(labels(charts[2]), ElementsAre("kinetic", "internal"));
    EXPECT_THAT(labels(charts[3]), ElementsAre("wall"));
    ASSERT_EQ(charts[0].references.size(), 1U);
    EXPECT_EQ(charts[0].references[0].value, -0.047);
    EXPECT_TRUE(charts[1].references.empty());
}

TEST(AxisTicks, AreRoundAndCoverTheRange)
{
    EXPECT_THAT(axis_ticks(0, 47, 5), ElementsAre(0, 10, 20, 30, 40, 50));
    EXPECT_THAT(axis_ticks(-3, 3, 6), ElementsAre(-3, -2, -1, 0, 1, 2, 3));
    EXPECT_THAT(axis_ticks(5, 5, 2), ElementsAre(0, 5, 10));
    for (const double size : {1e-12, 0.037, 1.0, 999.0, 1e15}) {
        for (int wanted = 2; wanted < 9; ++wanted) {
            const auto ticks = axis_ticks(-0.3 * size, size, wanted);
            EXPECT_LE(ticks.front(), -0.3 * size * (1 - 1e-9));
            EXPECT_GE(ticks.back(), size * (1 - 1e-9));
            EXPECT_GE(ticks.size(), 2U);
            EXPECT_LE(ticks.size(), static_cast<std::size_t>(2 * wanted + 3));
        }
    }
}

TEST(Thinned, KeepsExtremesAndEnds)
{
    Curve curve;
    for (int i = 0; i < 100'000; ++i) {
        curve.x.push_back(i);
        curve.y.push_back(i == 12'345 ? 1e3 : i == 54'321 ? -1e3 : std::sin(0.001 * i));
    }
    curve.y[777] = std::numeric_limits<double>::quiet_NaN();
    const auto points = thinned(curve, 1000);
    EXPECT_LE(points.size(), 1000U);
    EXPECT_EQ(points.front(), std::pair(curve.x.front(), curve.y.front()));
    EXPECT_EQ(points.back(), std::pair(curve.x.back(), curve.y.back()));
    EXPECT_THAT(points, testing::Contains(std::pair(12'345.0, 1e3)));
    EXPECT_THAT(points, testing::Contains(std::pair(54'321.0, -1e3)));
    EXPECT_TRUE(std::is_sorted(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.first < b.first; }));
}

TEST(Drawn, PutsPointsWhereTheAxesSay)
{
    // 0 .. 2 s over 0 .. 10 m: the drawing's frame is 62 .. 506 across and 266 .. 14 upwards.
    const std::string figure = drawn({"T", "time", "s", "height", "m", {{"ball", {0, 1, 2}, {0, 10, 5}}}, {}});
    EXPECT_THAT(figure, HasSubstr("d=\"M62.0 266.0L284.0 14.0L506.0 140.0\""));
    EXPECT_THAT(figure, HasSubstr(">10</text>"));
    EXPECT_THAT(figure, HasSubstr(R"("curves":[[0.0,0.0,1.0,10.0,2.0,5.0]])"));
}

TEST(ShownUnits, TakeAPrefixWhereItMakesSense)
{
    EXPECT_EQ(shown_value(0.0431, "m"), "43.1 mm");
    EXPECT_EQ(shown_value(-0.047, "m"), "-47 mm");
    EXPECT_EQ(shown_value(1500, "m"), "1500 m");
    EXPECT_EQ(shown_value(9.16e7, "Pa"), "91.6 MPa");
    EXPECT_EQ(shown_value(8530, "Pa s"), "8.53 kPa s");
    EXPECT_EQ(shown_value(1e-3, "s"), "1 ms");
    EXPECT_EQ(shown_value(1.56e-4, "s"), "156 µs");
    EXPECT_EQ(shown_value(250, "m/s"), "250 m/s");
    EXPECT_EQ(shown_value(0.5, "1"), "0.5");
    EXPECT_EQ(shown_value(0, "J"), "0 J");
    EXPECT_EQ(shown_value(std::numeric_limits<double>::quiet_NaN(), "J"), "-");
    EXPECT_EQ(shown_value(1630, "kg/m3"), "1630 kg/m3");
    EXPECT_EQ(shown_value(7e9, "J/m3"), "7 GJ/m3");
}

TEST(ReportText, RoundsAndGroups)
{
    EXPECT_EQ(grouped(0), "0");
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(1'234'567), "1,234,567");
    EXPECT_EQ(rounded(12345.678), "12346");
    EXPECT_EQ(rounded(0.00012), "1.200e-04");
    EXPECT_EQ(percentage(0.0031), "0.31 %");
    EXPECT_EQ(percentage(4.1e-13), "4.1e-13");
    EXPECT_EQ(percentage(0), "0 %");
    EXPECT_EQ(spaced("plastic_strain"), "plastic strain");
}

}  // namespace
}  // namespace corpuscle
