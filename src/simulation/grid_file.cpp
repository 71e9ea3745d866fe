#include "simulation/grid_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "model/grid_books.hpp"
#include "output/vtk/cells.hpp"
#include "output/vtk/image.hpp"
#include "output/vtk/points.hpp"

namespace corpuscle {

namespace {

/// The grid's axes in space: of rings the second is z, the third is none.
std::array<EulerAxis, 3> axes_in_space(const EulerGrid& grid)
{
    std::array<EulerAxis, 3> axes = grid.axes;
    if (grid.space == EulerSpace::axisymmetric) std::swap(axes[1], axes[2]);
    return axes;
}

bool is_even(const EulerAxis& axis)
{
    const double first = axis.width(0);
    for (std::size_t i = 1; i < axis.cells(); ++i)
        if (std::abs(axis.width(i) / first - 1) > 1e-6) return false;
    return true;
}

FieldSet shown_fields(const EulerGrid& grid)
{
    FieldSet set = cell_fields(grid);
    for (Field& field : set.fields) {
        if (field.name != "velocity") continue;
        field = derived_field<Vector3f>(field.name, field.unit, field.meaning, field.count,
                                        [&grid](std::size_t c) { return Vector3f(in_space(grid.space, look(grid, c).velocity)); });
    }
    return set;
}

/// Corners of cells along the axes with more than one; on the others all lie in the middle of the one cell.
struct Corners {
    std::array<EulerAxis, 3> axes;
    std::array<std::size_t, 3> counts{1, 1, 1};  ///< of corners

    explicit Corners(const EulerGrid& grid) : axes(axes_in_space(grid))
    {
        for (std::size_t d = 0; d < 3; ++d) counts[d] = axes[d].inert() ? 1 : axes[d].cells() + 1;
    }
    [[nodiscard]] std::size_t count() const { return counts[0] * counts[1] * counts[2]; }
    [[nodiscard]] std::uint32_t number(std::size_t i, std::size_t j, std::size_t k) const
    {
        return static_cast<std::uint32_t>(i + counts[0] * (j + counts[1] * k));
    }
    [[nodiscard]] Vector3d place(std::size_t n) const
    {
        const std::array<std::size_t, 3> at{n % counts[0], n / counts[0] % counts[1], n / (counts[0] * counts[1])};
        Vector3d place;
        for (std::size_t d = 0; d < 3; ++d) place[static_cast<int>(d)] = axes[d].inert() ? axes[d].middle(0) : axes[d].faces[at[d]];
        return place;
    }
};

/// The axes with cells, and the flat one, if there is one.
std::array<std::size_t, 3> flat_last(const Corners& corners)
{
    std::array<std::size_t, 3> order{0, 1, 2};
    std::stable_partition(order.begin(), order.end(), [&](std::size_t d) { return corners.counts[d] > 1; });
    return order;
}

/// The corners of a cell, in VTK's order: around its lower face, then around the upper one.
void add_cell(CellGrid& cells, const Corners& corners, const std::array<std::size_t, 3>& at)
{
    const std::array<std::size_t, 3> axis = flat_last(corners);
    constexpr std::array<std::array<std::size_t, 3>, 8> steps{
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
    const bool solid = corners.counts[axis[2]] > 1;
    std::vector<std::uint32_t> nodes;
    for (std::size_t n = 0; n < (solid ? 8U : 4U); ++n) {
        std::array<std::size_t, 3> corner = at;
        for (std::size_t d = 0; d < 3; ++d)
            if (corners.counts[axis[d]] > 1) corner[axis[d]] += steps[n][d];
        nodes.push_back(corners.number(corner[0], corner[1], corner[2]));
    }
    cells.add(solid ? ElementShape::hexahedron : ElementShape::quadrilateral, nodes);
}

void write_graded(const EulerGrid& grid, const VtkOptions& options, const std::filesystem::path& path)
{
    const Corners corners(grid);
    CellGrid cells;
    for (std::size_t k = 0; k < corners.axes[2].cells(); ++k)
        for (std::size_t j = 0; j < corners.axes[1].cells(); ++j)
            for (std::size_t i = 0; i < corners.axes[0].cells(); ++i) add_cell(cells, corners, {i, j, k});
    const Field places =
        derived_field<Vector3d>("position", "m", "place", corners.count(), [&](std::size_t n) { return corners.place(n); });
    write_cells(path, places, cells, {{"points", {}}, shown_fields(grid)}, options);
}

/// Cells on a line have no corners to draw: their middles are written as points.
void write_middles(const EulerGrid& grid, const VtkOptions& options, const std::filesystem::path& path)
{
    const Field places = derived_field<Vector3d>("position", "m", "place", grid.cells(),
                                                 [&grid](std::size_t c) { return in_space(grid.space, grid.middle(c)); });
    write_points(path, places, shown_fields(grid), options);
}

}  // namespace

void write_grid(const EulerGrid& grid, const VtkOptions& options, const std::filesystem::path& path)
{
    const std::array<EulerAxis, 3> axes = axes_in_space(grid);
    if (!std::all_of(axes.begin(), axes.end(), is_even)) {
        const bool line = std::count_if(axes.begin(), axes.end(), [](const EulerAxis& axis) { return axis.inert(); }) == 2;
        return line ? write_middles(grid, options, path) : write_graded(grid, options, path);
    }
    std::array<std::int64_t, 3> counts{};
    Vector3d lowest, cell;
    for (std::size_t d = 0; d < 3; ++d) {
        counts[d] = static_cast<std::int64_t>(axes[d].cells());
        lowest[static_cast<int>(d)] = axes[d].faces.front();
        cell[static_cast<int>(d)] = axes[d].width(0);
    }
    write_image(path, cell_centers(counts, lowest, cell), shown_fields(grid), options);
}

}  // namespace corpuscle
