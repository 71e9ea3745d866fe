#include "app/terminal/table.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

namespace corpuscle {

namespace {

using Rows = std::vector<std::vector<std::string>>;

std::size_t width_of(const Rows& rows, std::size_t column)
{
    std::size_t width = 0;
    for (const auto& row : rows) width = std::max(width, row[column].size());
    return width;
}

/// Does every cell under the heading begin like a number?
bool is_numeric(const Rows& rows, std::size_t column)
{
    return rows.size() > 1 && std::all_of(rows.begin() + 1, rows.end(), [&](const std::vector<std::string>& row) {
               const std::string& cell = row[column];
               return !cell.empty() && (std::isdigit(static_cast<unsigned char>(cell[0])) != 0 || cell[0] == '-');
           });
}

}  // namespace

std::string TextTable::text() const
{
    std::vector<std::string> lines(rows_.size());
    std::size_t whole = 0;
    for (std::size_t column = 0; column < rows_.front().size(); ++column) {
        const std::size_t width = width_of(rows_, column);
        const bool numeric = is_numeric(rows_, column);
        const bool last = column + 1 == rows_.front().size();
        for (std::size_t r = 0; r < rows_.size(); ++r) {
            const std::string& cell = rows_[r][column];
            lines[r] += numeric ? fmt::format("{:>{}}", cell, width) : last ? cell : fmt::format("{:<{}}", cell, width);
            if (!last) lines[r] += "  ";
        }
        whole += width + (last ? 0 : 2);
    }
    std::string text = lines.front() + "\n" + std::string(whole, '-') + "\n";
    for (std::size_t r = 1; r < lines.size(); ++r) text += lines[r] + "\n";
    return text;
}

}  // namespace corpuscle
