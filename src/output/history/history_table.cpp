#include "output/history/history_table.hpp"

#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <optional>
#include <string_view>

#include "base/error.hpp"
#include "output/replace_file.hpp"

namespace corpuscle {

namespace {

/// A cell of a CSV file (RFC 4180): in quotes where it must be.
std::string quoted(const std::string& text)
{
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string result = "\"";
    for (const char letter : text) {
        if (letter == '"') result += '"';
        result += letter;
    }
    return result + '"';
}

/// Cuts a line of a CSV file into its cells.
std::vector<std::string> cells_of(std::string_view line)
{
    std::vector<std::string> cells(1);
    bool in_quotes = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char letter = line[i];
        const bool doubled = in_quotes && letter == '"' && i + 1 < line.size() && line[i + 1] == '"';
        if (doubled) {
            cells.back() += line[i++];
        } else if (letter == '"') {
            in_quotes = !in_quotes;
        } else if (letter == ',' && !in_quotes) {
            cells.emplace_back();
        } else {
            cells.back() += letter;
        }
    }
    return cells;
}

/// A number, NaN for an empty cell, nothing for anything else.
std::optional<double> number(std::string_view cell)
{
    if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
    double value = 0;
    const auto [end, problem] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (problem != std::errc{} || end != cell.data() + cell.size()) return std::nullopt;
    return value;
}

/// "name [unit]" taken apart.
HistoryColumn column_of(const std::string& header)
{
    const std::size_t bracket = header.rfind(" [");
    if (bracket == std::string::npos || header.back() != ']') return {header, "1"};
    return {header.substr(0, bracket), header.substr(bracket + 2, header.size() - bracket - 3)};
}

/// Goes through the whole lines of a history.
class LineReader {
public:
    explicit LineReader(const std::filesystem::path& path) : path_(path.string()), text_(read_file(path)) {}

    /// The next whole line, nothing at the end or if the last one is torn.
    std::optional<std::string_view> next()
    {
        const std::size_t end = text_.find('\n', position_);
        if (end == std::string::npos) return std::nullopt;
        const std::string_view line = std::string_view(text_).substr(position_, end - position_);
        position_ = end + 1;
        ++line_;
        return line;
    }
    /// The next row's numbers, the time first.
    std::optional<std::vector<double>> next_row(std::size_t count)
    {
        const auto line = next();
        if (!line) return std::nullopt;
        std::vector<double> row;
        for (const std::string& cell : cells_of(*line)) {
            const auto value = number(cell);
            if (!value) refuse(fmt::format("'{}' is not a number", cell));
            row.push_back(*value);
        }
        if (row.size() != count) refuse(fmt::format("{} cells, expected {}", row.size(), count));
        return row;
    }
    [[noreturn]] void refuse(const std::string& what) const { throw Error(what, "the history was changed by hand?", {path_, line_, 1}); }
    [[nodiscard]] std::size_t position() const { return position_; }

private:
    std::string path_;
    std::string text_;
    std::size_t position_ = 0;
    int line_ = 0;
};

}  // namespace

const std::vector<double>* HistoryTable::find(const std::string& name) const
{
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (columns[i].name == name) return &values[i];
    }
    return nullptr;
}

std::string history_header(const std::vector<HistoryColumn>& columns)
{
    std::string line = "time [s]";
    for (const HistoryColumn& column : columns) line += "," + quoted(fmt::format("{} [{}]", column.name, column.unit));
    return line;
}

HistoryTable read_history(const std::filesystem::path& path)
{
    LineReader reader(path);
    const auto header = reader.next();
    if (!header || !header->starts_with("time [s]")) reader.refuse("not a history: its first column must be 'time [s]'");
    HistoryTable table;
    const std::vector<std::string> cells = cells_of(*header);
    for (std::size_t i = 1; i < cells.size(); ++i) table.columns.push_back(column_of(cells[i]));
    table.values.resize(table.columns.size());
    while (const auto row = reader.next_row(cells.size())) {
        table.times.push_back(row->front());
        for (std::size_t i = 0; i < table.values.size(); ++i) table.values[i].push_back((*row)[i + 1]);
    }
    return table;
}

std::size_t history_size_until(const std::filesystem::path& path, const std::vector<HistoryColumn>& columns, double time)
{
    LineReader reader(path);
    const auto header = reader.next();
    const std::string expected = history_header(columns);
    if (!header || *header != expected) {
        throw Error(fmt::format("the history has other columns than the case: '{}'", header ? std::string(*header) : std::string()),
                    fmt::format("expected '{}'; resume with the case that was run", expected), {path.string(), 1, 1});
    }
    std::size_t size = reader.position();
    while (const auto row = reader.next_row(columns.size() + 1)) {
        if (row->front() > time) break;
        size = reader.position();
    }
    return size;
}

}  // namespace corpuscle
