#include "simulation/report.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "output/replace_file.hpp"
#include "simulation/report_chart.hpp"
#include "simulation/report_curves.hpp"
#include "simulation/report_sections.hpp"
#include "simulation/report_style.hpp"
#include "simulation/report_text.hpp"
#include "simulation/run_folder.hpp"

namespace corpuscle {

namespace {

std::string charts_section(const ReportData& data)
{
    std::string charts;
    for (const Chart& chart : history_charts(data.history, data.summary.references)) charts += drawn(chart);
    return charts.empty() ? "" : "<section><h2>Curves</h2><div class=\"charts\">\n" + charts + "</div></section>\n";
}

}  // namespace

ReportData read_report_data(const std::filesystem::path& run_folder)
{
    const RunFolder folder(run_folder);
    if (!std::filesystem::exists(folder.summary())) {
        throw InputError(fmt::format("'{}' holds no finished run: there is no summary.json", run_folder.string()),
                         "give the folder a run wrote its results to");
    }
    ReportData data;
    data.summary = read_summary(folder.summary());
    if (std::filesystem::exists(folder.history())) data.history = read_history(folder.history());
    if (std::filesystem::exists(folder.resolved_case())) data.resolved_case = read_file(folder.resolved_case());
    return data;
}

std::string report_page(const ReportData& data)
{
    const RunSummary& summary = data.summary;
    std::string page = fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width,initial-scale=1\">"
        "<title>{}</title>\n<style>{}</style></head><body><main>\n",
        escaped(summary.title), report_style());
    page += report_header(summary) + report_tiles(summary) + report_verdicts(summary) + charts_section(data) + report_ensemble(summary) +
            report_results(summary) + report_ledger(summary) + report_cost(summary) + report_repeat(summary, data.resolved_case);
    page += fmt::format("<footer>Written by {}. SI units unless a unit is written.</footer>\n</main><script>{}</script></body></html>\n",
                        escaped(summary.program.empty() ? "corpuscle" : summary.program), report_script());
    return page;
}

std::filesystem::path write_report(const std::filesystem::path& run_folder)
{
    const std::filesystem::path path = RunFolder(run_folder).report();
    replace_file(path, report_page(read_report_data(run_folder)));
    return path;
}

}  // namespace corpuscle
