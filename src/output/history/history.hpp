#pragma once

#include <filesystem>
#include <fstream>
#include <span>
#include <vector>

#include "output/history/history_table.hpp"

namespace corpuscle {

/// Writes history.csv: the time and one column a quantity, a line a sample, each on its way to the disk as soon as written.
class History {
public:
    /// A new history, replacing an older one. Throws Error if it cannot be written.
    History(const std::filesystem::path& path, std::vector<HistoryColumn> columns);

    /// Goes on with the history on the disk: lines after `time` [s] and a torn last line are cut off; a missing file starts anew. Throws
    /// Error if its columns are others.
    [[nodiscard]] static History resume(const std::filesystem::path& path, std::vector<HistoryColumn> columns, double time);

    /// Adds a line: the time [s] and a value a column, NaN for what was not sampled (an empty cell). Throws Error if the number of values
    /// or the disk does not fit.
    void add(double time, std::span<const double> values);

    [[nodiscard]] const std::vector<HistoryColumn>& columns() const { return columns_; }

private:
    History(const std::filesystem::path& path, std::vector<HistoryColumn> columns, std::ios::openmode mode);

    std::filesystem::path path_;
    std::vector<HistoryColumn> columns_;
    std::ofstream stream_;
};

}  // namespace corpuscle
