#pragma once

#include <string>

#include "euler/grid.hpp"

// Which cell is to blame, in the words of the message that stops a run.

namespace corpuscle {

/// ": cell (3, 4, 0) of the grid, ..." of the first cell with a number that is not finite; nothing if all are.
[[nodiscard]] std::string not_finite_cell(const EulerGrid& grid);

/// "the fastest cell is (3, 4, 0) of the grid, ...": where waves and gas together are fastest; nothing of a grid without cells.
[[nodiscard]] std::string fastest_cell(const EulerGrid& grid);

}  // namespace corpuscle
