#pragma once

#include <string>

#include "simulation/summary.hpp"

namespace corpuscle {

/// The tables a run ends with: probes and gauges, time a phase, books, verdicts.
[[nodiscard]] std::string results_text(const RunSummary& summary);

}  // namespace corpuscle
