#pragma once

#include <vector>

#include "output/history/history_table.hpp"
#include "simulation/report_chart.hpp"
#include "simulation/summary.hpp"

namespace corpuscle {

/// The charts of a run's history: columns of one quantity and unit share a chart (each probe and component a curve), those of the owner
/// "energy" another, and a second one for those below a twentieth of the greatest. Components that stay below a thousandth of the chart's
/// greatest value are left out. Displacement comes first, then energy, pressure, impulse, velocity, then the others by name. The case's
/// reference values become dashed lines. Columns that tell how sure another is become a band of 95 % around its curve: from `_low` to
/// `_high` of an ensemble, else 1.96 standard errors (`_error`) to both sides.
[[nodiscard]] std::vector<Chart> history_charts(const HistoryTable& history, const std::vector<ReferenceValue>& references);

}  // namespace corpuscle
