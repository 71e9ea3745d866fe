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

/// After the flow: takes the room at the end of the step for that of now, and lets cells within solids be as they were.
void end_cut(EulerGrid& grid);

/// Marks the cells that lie within solids, by what lines enter and leave; a line that leaves one first began in it.
void find_solid_cells(EulerGrid& grid, const std::vector<WallCrossing>& crossings);

/// Cells within solids are as they were before the flow: what is computed there is no gas.
void keep_solid_cells(EulerGrid& grid);

/// Place of the cell above a face across an axis, from the face's number.
[[nodiscard]] std::array<std::size_t, 3> place_of_face(const EulerGrid& grid, int axis, std::size_t face);

/// Finds how far each face is open beside the walls, the walls' areas, and the openings around corners; all areas around a cell sum to
/// nothing, so that gas at rest stays at rest.
void shape_openings(EulerGrid& grid);

}  // namespace corpuscle
