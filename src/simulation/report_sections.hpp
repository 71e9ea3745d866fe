#pragma once

#include <string>

#include "simulation/report.hpp"

namespace corpuscle {

// The parts of the report, each a piece of HTML; empty if the run has nothing of the kind.

/// The title, the status, and the run in a sentence.
[[nodiscard]] std::string report_header(const RunSummary& summary);
/// The few numbers a reader looks for first.
[[nodiscard]] std::string report_tiles(const RunSummary& summary);
/// Pass or warn, with the number and the limit.
[[nodiscard]] std::string report_verdicts(const RunSummary& summary);
/// What several seeds say together: how far each number of the results may be from the mean of infinitely many.
[[nodiscard]] std::string report_ensemble(const RunSummary& summary);
/// What probes, gauges and parts saw.
[[nodiscard]] std::string report_results(const RunSummary& summary);
/// Who gave what to whom.
[[nodiscard]] std::string report_ledger(const RunSummary& summary);
/// Time per phase, counts and work.
[[nodiscard]] std::string report_cost(const RunSummary& summary);
/// Everything needed to run it again.
[[nodiscard]] std::string report_repeat(const RunSummary& summary, const std::string& resolved_case);

}  // namespace corpuscle
