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

/// Of each cell, whether it lies within a solid, by what lines enter and leave; a line that leaves one first began in it. Empty if no line
/// meets a solid.
[[nodiscard]] std::vector<std::uint8_t> cells_within(const EulerGrid& grid, const std::vector<WallCrossing>& crossings);

/// Cells within solids are as they were before the flow: what is computed there is no gas.
void keep_solid_cells(EulerGrid& grid);

/// Room that a shut face gives its lower (side 0) or upper cell beyond half a cell, or takes from it, over the cell's volume without walls.
[[nodiscard]] double lent_room(const EulerGrid& grid, const WallFace& face, std::size_t side);

/// Where a wall has ended or begun between two cells without passing the middle of either (it eroded, or its rim went by), what it had
/// shifted, or shifts, of the cells' common boundary goes over to the other cell with the gas in it. `gone` are the faces shut before,
/// `swept` the cells that changed sides, in order.
void return_room(EulerGrid& grid, const std::vector<WallFace>& gone, const std::vector<std::size_t>& swept);

/// Brings cells that walls leave little room to one state with the widest cell that they are open to: a step of the others would be too
/// long for them.
void mix_small_cells(EulerGrid& grid);

/// All arrays of a state: each counts per volume.
[[nodiscard]] std::vector<std::vector<double>*> numbers_per_volume(EulerState& state);

/// Place of the cell above a face across an axis, from the face's number.
[[nodiscard]] std::array<std::size_t, 3> place_of_face(const EulerGrid& grid, int axis, std::size_t face);

/// Finds how far each face is open beside the walls, the walls' areas, and the openings around corners; all areas around a cell sum to
/// nothing, so that gas at rest stays at rest.
void shape_openings(EulerGrid& grid);

}  // namespace corpuscle
