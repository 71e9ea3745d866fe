#include "euler/tile.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle {

namespace {

/// Where a cell beyond the ends of an axis gets its state from: its mirror's image at a wall, the last cell at an open end.
struct Source {
    std::size_t cell = 0;
    double sign = 1;
};
Source source_of(std::ptrdiff_t cell, const EulerAxis& axis, EulerEdge lower, EulerEdge upper)
{
    const auto count = static_cast<std::ptrdiff_t>(axis.cells());
    if (cell < 0) return lower == EulerEdge::open ? Source{0, 1} : Source{static_cast<std::size_t>(-1 - cell), -1};
    if (cell < count) return {static_cast<std::size_t>(cell), 1};
    const auto last = static_cast<std::size_t>(count - 1);
    return upper == EulerEdge::open ? Source{last, 1} : Source{static_cast<std::size_t>(2 * count - 1 - cell), -1};
}

/// Width over distance of middles; 1 for cells that are alike but for round-off.
double width_ratio(double width, double other)
{
    const double ratio = 2 * width / (width + other);
    return std::abs(ratio - 1) < 1e-10 ? 1.0 : ratio;
}

void lay_axis(TileAxis& own, const EulerAxis& axis, EulerEdge lower, EulerEdge upper, std::size_t begin, std::size_t end)
{
    own.live = !axis.inert();
    own.cells = end - begin;
    own.halo = own.live ? euler_halo : 0;
    own.total = own.cells + 2 * own.halo;
    for (std::size_t n = 0; n < own.total; ++n) {
        const std::ptrdiff_t cell = static_cast<std::ptrdiff_t>(begin + n) - static_cast<std::ptrdiff_t>(own.halo);
        const auto width = [&](std::ptrdiff_t c) { return axis.width(source_of(c, axis, lower, upper).cell); };
        const Source source = source_of(cell, axis, lower, upper);
        own.source[n] = source.cell;
        own.sign[n] = source.sign;
        own.inverse_width[n] = own.live ? 1 / width(cell) : 0;
        if (own.live) {
            own.to_lower[n] = width_ratio(width(cell), width(cell - 1));
            own.to_upper[n] = width_ratio(width(cell), width(cell + 1));
        }
        const double larger = std::max(axis.area[source.cell], axis.area[source.cell + 1]);
        own.larger_face[n] = own.live ? larger / axis.volume[source.cell] : 0;
        own.curvature[n] = source.sign * (axis.area[source.cell + 1] - axis.area[source.cell]) / axis.volume[source.cell];
    }
    for (std::size_t n = 0; n <= own.cells; ++n) own.area[n] = axis.area[begin + n];
    for (std::size_t n = 0; n < own.cells; ++n) own.inverse_volume[n] = 1 / axis.volume[begin + n];
}

}  // namespace

void lay_tile(EulerTile& tile, const EulerGrid& grid, const EulerBlock& block)
{
    std::size_t stride = 1;
    for (int d = 0; d < 3; ++d) {
        lay_axis(tile.axes[d], grid.axes[d], grid.edges[2 * d], grid.edges[2 * d + 1], block.begin[d], block.end[d]);
        tile.axes[d].stride = stride;
        stride *= tile.axes[d].total;
    }
    tile.size = stride;
}

}  // namespace corpuscle
