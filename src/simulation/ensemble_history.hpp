#pragma once

#include <map>
#include <string>
#include <vector>

#include "output/history/history_table.hpp"

namespace corpuscle {

/// When a case wants its history sampled. A run samples at the end of the step that reaches such a time, so rows of two seeds differ by
/// up to a step.
struct SampleTimes {
    std::map<std::string, double> every;  ///< by owner of the columns (probe, gauge) [s]
    double otherwise = 0;                 ///< of all other columns [s]
    double end = 0;                       ///< of the run [s]

    /// 0, every, 2 every, ..., end, for a column's owner.
    [[nodiscard]] std::vector<double> of(const std::string& owner) const;
};

/// The histories of runs that differ by their seed as one: of each column the mean (under the column's own name), the standard deviation
/// (`_deviation`) and the ends of the mean's confidence interval of 95 % (`_low`, `_high`), at the times the case wants. What is known
/// at moments is interpolated between rows; what is a mean since the last row (pressure and force of facets and faces) is averaged anew
/// over the wanted interval. Columns of standard errors are left out: the deviation says more. All members have the same columns.
[[nodiscard]] HistoryTable ensemble_history(const std::vector<HistoryTable>& members, const SampleTimes& times);

}  // namespace corpuscle
