#pragma once

#include <string>

#include "simulation/summary.hpp"

namespace corpuscle {

/// The tables a run ends with: probes and gauges, time a phase, books, verdicts.
[[nodiscard]] std::string results_text(const RunSummary& summary);

/// The table an ensemble ends with: means with their standard errors and confidence intervals.
[[nodiscard]] std::string ensemble_text(const RunSummary& summary);

}  // namespace corpuscle
