#pragma once

#include <vector>

#include "simulation/summary.hpp"

namespace corpuscle {

/// The summaries of runs that differ by their seed as one: of every number under probes, gauges and parts the mean in its usual place and
/// its statistic in the ensemble's block; of steps, work and times the sum; of verdicts and errors of the books the worst. `seeds` are
/// those of all members, `members` the summaries of those that are done.
[[nodiscard]] RunSummary ensemble_summary(const std::vector<RunSummary>& members, const std::vector<std::uint64_t>& seeds);

}  // namespace corpuscle
