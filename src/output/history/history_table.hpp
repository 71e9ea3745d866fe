#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace corpuscle {

/// A column of history.csv: "<owner>.<quantity> [unit]" in its header, e.g. "center.displacement_z [m]".
struct HistoryColumn {
    std::string name;  ///< "<owner>.<quantity>"
    std::string unit;  ///< SI, "1" if none

    friend bool operator==(const HistoryColumn&, const HistoryColumn&) = default;
};

/// What a history.csv holds.
struct HistoryTable {
    std::vector<HistoryColumn> columns;       ///< without the time
    std::vector<double> times;                ///< [s], growing
    std::vector<std::vector<double>> values;  ///< one list a column, as long as `times`; NaN where nothing was sampled

    [[nodiscard]] const std::vector<double>* find(const std::string& name) const;
};

/// The header line (without its end) of a history with these columns.
[[nodiscard]] std::string history_header(const std::vector<HistoryColumn>& columns);

/// Reads a history.csv. A torn last line is left out. Throws Error (file, line) for anything else that is not such a table.
[[nodiscard]] HistoryTable read_history(const std::filesystem::path& path);

/// Number of bytes of the file that hold its header and the whole lines up to `time` [s]. Throws Error as read_history does, or if the
/// header is another one than that of `columns`.
[[nodiscard]] std::size_t history_size_until(const std::filesystem::path& path, const std::vector<HistoryColumn>& columns, double time);

}  // namespace corpuscle
