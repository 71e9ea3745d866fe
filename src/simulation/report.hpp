#pragma once

#include <filesystem>
#include <string>

#include "output/history/history_table.hpp"
#include "simulation/summary.hpp"

namespace corpuscle {

/// What a report is made of.
struct ReportData {
    RunSummary summary;
    HistoryTable history;
    std::string resolved_case;  ///< text of case.resolved.toml
};

/// Reads a run's summary.json, history.csv and case.resolved.toml; the last two may be missing. Throws Error, or InputError if the folder
/// holds no finished run.
[[nodiscard]] ReportData read_report_data(const std::filesystem::path& run_folder);

/// The report as one self-contained HTML page: it refers to nothing outside itself.
[[nodiscard]] std::string report_page(const ReportData& data);

/// Makes report.html of a run's folder from what the run left there (again, if there is one). Gives its path. Throws as read_report_data.
std::filesystem::path write_report(const std::filesystem::path& run_folder);

}  // namespace corpuscle
