#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "fields/field.hpp"
#include "mesh/mesh.hpp"
#include "output/vtk/vtk_file.hpp"

namespace corpuscle {

/// Cells over shared nodes, as VTK lists them.
struct CellGrid {
    std::vector<std::int64_t> connectivity;  ///< nodes of all cells, one cell after the other
    std::vector<std::int64_t> offsets{0};    ///< where each cell's nodes begin, and the end: cells + 1 entries
    std::vector<std::uint8_t> types;         ///< VTK's number of each cell's shape

    /// Adds one element by its corners (as many as its shape has).
    void add(ElementShape shape, std::span<const std::uint32_t> corners);
};

/// The elements of a mesh as a grid.
[[nodiscard]] CellGrid cell_grid(std::span<const MeshElement> elements);

/// Fields on the points and on the cells of a grid.
struct GridFields {
    FieldSet points;
    FieldSet cells;
};

/// Writes a mesh as one VTKHDF file: `nodes` [m] is a field of 3 components, float32 or float64. Throws Error if a field's count, the
/// offsets or a node index do not fit.
void write_cells(const std::filesystem::path& path, const Field& nodes, const CellGrid& grid, const GridFields& fields,
                 const VtkOptions& options = {});

}  // namespace corpuscle
