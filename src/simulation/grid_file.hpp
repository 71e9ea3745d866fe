#pragma once

#include <filesystem>

#include "euler/grid.hpp"
#include "output/vtk/vtk_file.hpp"

namespace corpuscle {

/// Writes the cells of the gases on a grid as they are: a box of them, a half plane y = 0 of rings, a line of shells. Even cells are points
/// of an image, at their middles; of a graded grid each cell is written with its corners, or, on a line, its middle. Throws Error.
void write_grid(const EulerGrid& grid, const VtkOptions& options, const std::filesystem::path& path);

}  // namespace corpuscle
