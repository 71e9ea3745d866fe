#include "input/grid_gauges.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/error.hpp"
#include "input/grid_symmetry.hpp"
#include "mesh/shape.hpp"
#include "model/grid_books.hpp"

namespace corpuscle {

namespace {

/// Points along each live axis of a cell, by which the part of it is found that lies within a region.
constexpr std::size_t points_along = 6;

/// The region as it meets the half plane of a round grid; its middle.
struct Region {
    Shape shape;
    Vector3d middle;
};

Region region_of(const GaugeInput& input, EulerSpace space)
{
    if (input.box) {
        const Box box = box_of(*input.box);
        return {Shape::box(box), space == EulerSpace::planar ? box.center() : Vector3d{box.center().x, 0, box.center().z}};
    }
    const Vector3d center = in_space(space, grid_point(space, input.sphere->center));
    return {Shape::sphere(center, input.sphere->radius), center};
}

/// The cell around a point of space; none if it lies outside the grid.
std::optional<std::size_t> cell_around(const EulerGrid& grid, const Vector3d& place)
{
    const Vector3d point = grid_point(grid.space, place);
    std::array<std::size_t, 3> at{};
    for (int d = 0; d < 3; ++d) {
        const EulerAxis& axis = grid.axes[static_cast<std::size_t>(d)];
        const bool left_out = axis.inert() && grid.space != EulerSpace::planar;
        if (left_out) continue;
        if (point[d] < axis.faces.front() || point[d] > axis.faces.back()) return {};
        const auto after = std::upper_bound(axis.faces.begin() + 1, axis.faces.end() - 1, point[d]);
        at[static_cast<std::size_t>(d)] = static_cast<std::size_t>(after - axis.faces.begin()) - 1;
    }
    return grid.cell(at[0], at[1], at[2]);
}

/// The share of a cell's points that lie within a shape.
double share_within(const EulerGrid& grid, std::size_t cell, const Shape& shape)
{
    const auto at = grid.place(cell);
    std::array<std::size_t, 3> counts{};
    std::size_t within = 0;
    for (std::size_t d = 0; d < 3; ++d) counts[d] = grid.axes[d].inert() ? 1 : points_along;
    const auto along = [&](std::size_t d, std::size_t n) {
        const double part = (static_cast<double>(n) + 0.5) / static_cast<double>(counts[d]);
        return grid.axes[d].faces[at[d]] + part * grid.axes[d].width(at[d]);
    };
    for (std::size_t k = 0; k < counts[2]; ++k)
        for (std::size_t j = 0; j < counts[1]; ++j)
            for (std::size_t i = 0; i < counts[0]; ++i)
                within += shape.contains(in_space(grid.space, {along(0, i), along(1, j), along(2, k)})) ? 1 : 0;
    return static_cast<double>(within) / static_cast<double>(counts[0] * counts[1] * counts[2]);
}

/// Cells along an axis that may meet a range: first, and one beyond the last.
std::array<std::size_t, 2> cells_between(const EulerAxis& axis, double lower, double upper)
{
    const auto first = std::upper_bound(axis.faces.begin() + 1, axis.faces.end() - 1, lower);
    const auto last = std::lower_bound(axis.faces.begin() + 1, axis.faces.end(), upper);
    const std::size_t begin = static_cast<std::size_t>(first - axis.faces.begin()) - 1;
    return {begin, std::min(axis.cells(), static_cast<std::size_t>(last - axis.faces.begin()))};
}

GridRegionGauge find_cells(const EulerGrid& grid, const Region& region)
{
    const Box bounds = region.shape.bounds();
    const bool rings = grid.space == EulerSpace::axisymmetric;
    std::array<std::array<std::size_t, 2>, 3> range{{{0, 1}, {0, 1}, {0, 1}}};
    for (int d = 0; d < 3; ++d) {
        const EulerAxis& axis = grid.axes[static_cast<std::size_t>(d)];
        const int from = d == 1 && rings ? 2 : d;  // the grid's second axis is z
        if (!axis.inert()) range[static_cast<std::size_t>(d)] = cells_between(axis, bounds.lower[from], bounds.upper[from]);
    }
    GridRegionGauge found;
    for (std::size_t k = range[2][0]; k < range[2][1]; ++k) {
        for (std::size_t j = range[1][0]; j < range[1][1]; ++j) {
            for (std::size_t i = range[0][0]; i < range[0][1]; ++i) {
                const std::size_t cell = grid.cell(i, j, k);
                const double share = share_within(grid, cell, region.shape);
                if (share == 0) continue;
                found.cells.push_back(cell);
                found.volumes.push_back(share * grid.volume(cell));
            }
        }
    }
    return found;
}

GridRegionGauge region_gauge(const GaugeInput& input, const EulerGrid& grid)
{
    Vector3d middle;
    if (input.point) {
        middle = in_space(grid.space, grid_point(grid.space, *input.point));
    } else {
        const Region region = region_of(input, grid.space);
        GridRegionGauge found = find_cells(grid, region);
        if (!found.cells.empty()) return found;
        middle = region.middle;
    }
    const auto cell = cell_around(grid, middle);
    if (!cell)
        throw InputError(fmt::format("gauge '{}' lies outside the gas box", input.name), "expected it within the box of [euler]",
                         input.places.own);
    return {{*cell}, {grid.volume(*cell)}};
}

/// The face in the grid's axes; refuses one that is not there, or not rigid.
GridFaceGauge face_gauge(const GaugeInput& input, const EulerGrid& grid)
{
    int face = static_cast<int>(*input.face);
    const bool rings = grid.space == EulerSpace::axisymmetric, round = grid.space != EulerSpace::planar;
    const bool there = !round || face == 1 || (rings && face >= 4);
    if (rings && face >= 4) face -= 2;
    if (!there || grid.axes[static_cast<std::size_t>(face / 2)].inert())
        throw InputError(fmt::format("gauge '{}' is on a face that the grid has not", input.name),
                         rings   ? "expected \"x+\" (the outer radius), \"z-\" or \"z+\""
                         : round ? "expected \"x+\", the outer radius"
                                 : "expected a face across an axis with cells",
                         input.places.of("face"));
    if (grid.edges[static_cast<std::size_t>(face)] != EulerEdge::rigid)
        throw InputError(fmt::format("gauge '{}' is on a face of the gas box that is not rigid", input.name),
                         "expected a face whose edge is \"rigid\"", input.places.of("face"));
    return {face};
}

}  // namespace

Gauge make_grid_gauge(const GaugeInput& input, const EulerGrid& grid, double end_time)
{
    const double every = interval_of(input.every, end_time);
    if (input.face) return {input.name, face_gauge(input, grid), every};
    return {input.name, region_gauge(input, grid), every};
}

}  // namespace corpuscle
