#include <algorithm>
#include <tuple>

#include "euler/cut.hpp"

namespace corpuscle {

namespace {

/// A crossing of a line along the axis by which insides are told.
struct LineCrossing {
    std::size_t line = 0, cell = 0;  ///< the line by its first cell; along it, the cell above the crossing
    double place = 0;                ///< [m]
    bool enters = false;
};

/// Marks the cells of one line: it is within as many solids as it has entered and not left; what it leaves first it was in from the start.
void mark_line(const EulerGrid& grid, int d, const std::vector<LineCrossing>& crossings, std::size_t begin, std::size_t end,
               std::vector<std::uint8_t>& within)
{
    const std::size_t count = grid.axes[static_cast<std::size_t>(d)].cells();
    const auto place = grid.place(crossings[begin].line);
    int depth = 0, least = 0;
    for (std::size_t n = begin; n < end; ++n) {
        depth += crossings[n].enters ? 1 : -1;
        least = std::min(least, depth);
    }
    depth = -least;
    std::size_t next = begin;
    for (std::size_t c = 0; c < count; ++c) {
        for (; next < end && crossings[next].cell <= c; ++next) depth += crossings[next].enters ? 1 : -1;
        auto at = place;
        at[static_cast<std::size_t>(d)] = c;
        if (depth > 0) within[grid.cell(at[0], at[1], at[2])] = 1;
    }
}

}  // namespace

std::vector<std::uint8_t> cells_within(const EulerGrid& grid, const std::vector<WallCrossing>& crossings)
{
    int d = 0;
    while (d < 2 && grid.axes[static_cast<std::size_t>(d)].inert()) ++d;
    std::vector<LineCrossing> found;
    for (const WallCrossing& crossing : crossings) {
        if (!crossing.solid || crossing.axis != d) continue;
        auto at = place_of_face(grid, d, crossing.face);
        const std::size_t cell = at[static_cast<std::size_t>(d)];
        at[static_cast<std::size_t>(d)] = 0;
        found.push_back({grid.cell(at[0], at[1], at[2]), cell, crossing.place, crossing.enters});
    }
    if (found.empty()) return {};
    std::sort(found.begin(), found.end(), [](const LineCrossing& a, const LineCrossing& b) {
        return std::tuple(a.line, a.place, a.enters) < std::tuple(b.line, b.place, b.enters);
    });
    std::vector<std::uint8_t> within(grid.cells(), 0);
    for (std::size_t begin = 0; begin < found.size();) {
        std::size_t end = begin;
        while (end < found.size() && found[end].line == found[begin].line) ++end;
        mark_line(grid, d, found, begin, end, within);
        begin = end;
    }
    return within;
}

void keep_solid_cells(EulerGrid& grid)
{
    const auto keep = [&](std::vector<double>& now, const std::vector<double>& before) {
        for (std::size_t c = 0; c < grid.walls.solid.size() && !now.empty(); ++c) {
            if (grid.walls.solid[c] != 0) now[c] = before[c];
        }
    };
    EulerState &now = grid.now, &before = grid.next;
    for (std::size_t m = 0; m < now.mass.size(); ++m) keep(now.mass[m], before.mass[m]);
    for (std::size_t d = 0; d < 3; ++d) keep(now.motion[d], before.motion[d]);
    keep(now.energy, before.energy);
    for (std::size_t m = 0; m < now.share.size(); ++m) keep(now.share[m], before.share[m]);
}

}  // namespace corpuscle
