#pragma once

#include <vector>

#include "euler/grid.hpp"
#include "euler/wall_crossings.hpp"

namespace corpuscle {

/// Cuts the grid by walls where they are now: which faces are shut, what room each cell has at the end of the step. The walls have
/// passed the middles of the cells `swept` since the last cut: those change sides, and what they hold goes to cells beside them on the side
/// they leave, while cells on the side they join share with them. Nothing is lost in that but for round-off.
void cut(EulerGrid& grid, const std::vector<WallCrossing>& crossings, const std::vector<SweptCell>& swept);

/// Cuts a grid whose cells have just been laid out or read back: their numbers are those of the room they have.
void cut_first(EulerGrid& grid, const std::vector<WallCrossing>& crossings);

/// Takes the room at the end of the step for that of now.
void end_cut(EulerWalls& walls);

/// Finds how far each face is open beside the walls, the walls' areas, and the openings around corners; all areas around a cell sum to
/// nothing, so that gas at rest stays at rest.
void shape_openings(EulerGrid& grid);

}  // namespace corpuscle
