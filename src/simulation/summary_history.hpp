#pragma once

#include <string>
#include <vector>

#include "output/history/history_table.hpp"
#include "simulation/summary.hpp"

namespace corpuscle {

/// A history column's name taken apart: "center.displacement_z" -> {"center", "displacement", "z"}.
struct ColumnName {
    std::string owner;      ///< before the last dot, empty if there is none
    std::string quantity;   ///< without the component
    std::string component;  ///< "x", "y", "z" or empty
};

[[nodiscard]] ColumnName column_name(const std::string& name);

/// The column that goes with another: ("ball.velocity_x", "error") -> "ball.velocity_error_x".
[[nodiscard]] std::string companion(const std::string& name, const std::string& kind);

/// The owner of the columns that stand beside a gauge's: what the curves of Kingery and Bulmash say of its place.
[[nodiscard]] std::string kingery_bulmash_name(const std::string& gauge);

/// Extremes of every column that belongs to one of `probes`, read from the whole history (so a resumed run counts all of it).
void add_probes(RunSummary& summary, const HistoryTable& history, const std::vector<std::string>& probes);

/// Peak, impulse and arrival of each of `gauges`, from its columns "pressure" [Pa] and "impulse" [Pa s]. Arrival is the first sample whose
/// pressure has risen by 5 % of the greatest rise over the first sample. Standard errors are those of the samples that peak and impulse
/// were read from, where the history has them.
void add_gauges(RunSummary& summary, const HistoryTable& history, const std::vector<std::string>& gauges);

}  // namespace corpuscle
