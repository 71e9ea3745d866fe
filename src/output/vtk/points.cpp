#include "output/vtk/points.hpp"

#include <numeric>

#include "output/vtk/cells.hpp"

namespace corpuscle {

namespace {

constexpr std::uint8_t poly_vertex = 2;  // VTK_POLY_VERTEX

/// One cell that holds all points, or none where there are no points.
CellGrid one_cell(std::size_t count)
{
    CellGrid grid;
    if (count == 0) return grid;
    grid.connectivity.resize(count);
    std::iota(grid.connectivity.begin(), grid.connectivity.end(), std::int64_t{0});
    grid.offsets.push_back(static_cast<std::int64_t>(count));
    grid.types.push_back(poly_vertex);
    return grid;
}

}  // namespace

void write_points(const std::filesystem::path& path, const Field& positions, const FieldSet& fields, const VtkOptions& options)
{
    GridFields on_points{{fields.name, {}}, {}};
    for (const Field& field : fields.fields) {
        if (field.name != positions.name) on_points.points.fields.push_back(field);
    }
    write_cells(path, positions, one_cell(positions.count), on_points, options);
}

}  // namespace corpuscle
