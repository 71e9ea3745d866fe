#include "output/vtk/cells.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace corpuscle {

namespace {

/// VTK's numbers of cell shapes (vtkCellType.h).
std::uint8_t vtk_type(ElementShape shape)
{
    switch (shape) {
        case ElementShape::triangle: return 5;
        case ElementShape::quadrilateral: return 9;
        case ElementShape::tetrahedron: return 10;
        case ElementShape::hexahedron: break;
    }
    return 12;
}

void check(const Field& nodes, const CellGrid& grid)
{
    const bool fits = nodes.components == 3 && grid.offsets.size() == grid.types.size() + 1 && grid.offsets.front() == 0 &&
                      grid.offsets.back() == static_cast<std::int64_t>(grid.connectivity.size()) &&
                      std::is_sorted(grid.offsets.begin(), grid.offsets.end());
    const auto count = static_cast<std::int64_t>(nodes.count);
    const bool inside =
        std::all_of(grid.connectivity.begin(), grid.connectivity.end(), [count](std::int64_t node) { return node >= 0 && node < count; });
    if (!fits || !inside) {
        throw Error(fmt::format("a grid of {} cells does not fit its {} nodes: offsets, cell types and node indices disagree",
                                grid.types.size(), nodes.count));
    }
}

}  // namespace

void CellGrid::add(ElementShape shape, std::span<const std::uint32_t> corners)
{
    const auto used = corners.first(static_cast<std::size_t>(node_count(shape)));
    connectivity.insert(connectivity.end(), used.begin(), used.end());
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    types.push_back(vtk_type(shape));
}

CellGrid cell_grid(std::span<const MeshElement> elements)
{
    CellGrid grid;
    for (const MeshElement& element : elements) grid.add(element.shape, element.node);
    return grid;
}

void write_cells(const std::filesystem::path& path, const Field& nodes, const CellGrid& grid, const GridFields& fields,
                 const VtkOptions& options)
{
    check(nodes, grid);
    const int gzip = options.gzip;
    const std::uint64_t cells = grid.types.size();
    Hdf5File file = begin_vtk_file(path, "UnstructuredGrid");
    file.write("/VTKHDF/NumberOfPoints", std::vector<std::int64_t>{static_cast<std::int64_t>(nodes.count)});
    file.write("/VTKHDF/NumberOfCells", std::vector<std::int64_t>{static_cast<std::int64_t>(cells)});
    file.write("/VTKHDF/NumberOfConnectivityIds", std::vector<std::int64_t>{static_cast<std::int64_t>(grid.connectivity.size())});
    file.write("/VTKHDF/Points", nodes, shape_of(nodes), gzip);
    file.write("/VTKHDF/Connectivity", grid.connectivity, gzip);
    file.write("/VTKHDF/Offsets", grid.offsets, gzip);
    file.write("/VTKHDF/Types", grid.types, gzip);
    write_fields(file, "PointData", fields.points, {nodes.count}, gzip);
    write_fields(file, "CellData", fields.cells, {cells}, gzip);
    file.close();
}

}  // namespace corpuscle
