#pragma once

#include "simulation/report.hpp"

namespace corpuscle {

/// A finished run of a plate under a charge, with every member filled by a value of its own. Not a computed one: damped oscillations by
/// formula.
[[nodiscard]] ReportData sample_run();

/// Writes summary.json, history.csv and case.resolved.toml of sample_run() into a folder.
void write_sample_run(const std::filesystem::path& folder);

}  // namespace corpuscle
