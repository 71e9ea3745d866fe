#pragma once

#include <string>
#include <vector>

namespace corpuscle {

/// Rows of words in aligned columns.
class TextTable {
public:
    explicit TextTable(std::vector<std::string> heading) : rows_{std::move(heading)} {}

    void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

    /// The table with a line under its heading; columns of numbers to the right.
    [[nodiscard]] std::string text() const;

private:
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace corpuscle
