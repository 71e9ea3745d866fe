#pragma once

#include "euler/tile.hpp"

namespace corpuscle {

/// Moves the cells of one block on by a step [s], from `grid.now` to `grid.next`, with `tile` as room and the neighbours' cells as they are
/// now. Returns what went out through the grid's edges. The tile must be laid, its materials set.
EulerPassages flow_block(EulerTile& tile, EulerGrid& grid, const EulerBlock& block, double length);

/// Largest sum over the axes of (|u| + c) area/volume, with the larger face, in the block's cells as they are in `grid.now` [1/s]. The tile
/// must be laid.
[[nodiscard]] double find_signal(const EulerTile& tile, const EulerGrid& grid, const EulerBlock& block);

}  // namespace corpuscle
