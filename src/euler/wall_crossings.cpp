#include "euler/wall_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "math/box.hpp"
#include "mesh/moving_facet.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

/// How far the middles are moved aside along each axis, and free rims reach over, in widths of a cell.
constexpr std::array<double, 3> aside{1.37e-6, 2.11e-6, 2.89e-6};
constexpr double reach_over = 0.05;
/// A facet whose normal leans less than this to a line lies along it and is not met.
constexpr double least_lean = 1e-11;
/// Facets that one thread takes at least.
constexpr std::size_t worth_a_part = 512;

/// The middle of a cell along an axis as walls see it [m].
double wall_middle(const EulerAxis& axis, int d, std::size_t cell)
{
    return axis.middle(cell) + aside[static_cast<std::size_t>(d)] * axis.width(cell);
}

/// Cells along an axis whose middles lie between two coordinates: first, and one beyond the last.
std::array<std::size_t, 2> middles_between(const EulerAxis& axis, int d, double lower, double upper)
{
    const std::size_t count = axis.cells();
    if (axis.inert()) return {0, 1};
    const double inverse = static_cast<double>(count) / (axis.faces.back() - axis.faces.front());
    const auto guess = [&](double x) {
        return static_cast<std::size_t>(std::clamp((x - axis.faces.front()) * inverse - 0.5, 0.0, static_cast<double>(count)));
    };
    const auto first_from = [&](double x) {
        std::size_t n = guess(x);
        while (n > 0 && wall_middle(axis, d, n - 1) >= x) --n;
        while (n < count && wall_middle(axis, d, n) < x) ++n;
        return n;
    };
    return {first_from(lower), first_from(upper)};
}

/// A facet as the lines along one axis see it: its corners across the axis.
struct Projected {
    const Facet& facet;
    std::array<Vector3d, 3> corner;
    int axis, across, beside;

    /// Twice the signed area of the triangle of a point and the edge across from a corner, the same to the bit for both facets that have
    /// the edge but for its sign.
    [[nodiscard]] double side(std::size_t edge, double x, double y) const
    {
        std::size_t a = (edge + 1) % 3, b = (edge + 2) % 3;
        const bool turned = facet.node[a] > facet.node[b];
        if (turned) std::swap(a, b);
        const double ax = corner[a][across] - x, ay = corner[a][beside] - y, bx = corner[b][across] - x, by = corner[b][beside] - y;
        const double area = ax * by - ay * bx;
        return turned ? -area : area;
    }
    /// From an edge to the corner across from it, in the facet's plane [m].
    [[nodiscard]] double height(std::size_t edge) const
    {
        const Vector3d along = corner[(edge + 2) % 3] - corner[(edge + 1) % 3];
        return norm(cross(along, corner[edge] - corner[(edge + 1) % 3])) / norm(along);
    }
};

/// Finds the crossings of one facet.
class FacetCrossings {
public:
    FacetCrossings(const EulerGrid& grid, const Surface& surface, std::vector<WallCrossing>& found)
        : grid_(grid), surface_(surface), found_(found)
    {
    }

    void add(std::uint32_t number, const Facet& facet, const std::array<Vector3d, 3>& corner, std::uint8_t free)
    {
        const Vector3d area = cross(corner[1] - corner[0], corner[2] - corner[0]);
        if (!(norm(area) > 0)) return;
        const Vector3d normal = normalized(area);
        Box box;
        for (const Vector3d& place : corner) box.include(place);
        for (int d = 0; d < 3; ++d) {
            if (grid_.axes[static_cast<std::size_t>(d)].inert() || std::abs(normal[d]) < least_lean) continue;
            const Projected seen{facet, corner, d, (d + 1) % 3, (d + 2) % 3};
            add_along(number, seen, normal, box, free);
        }
    }

private:
    void add_along(std::uint32_t number, const Projected& seen, const Vector3d& normal, const Box& box, std::uint8_t free)
    {
        const EulerAxis& x = axis(seen.across);
        const EulerAxis& y = axis(seen.beside);
        const double over = free != 0 ? reach_over * std::max(x.width(0), y.width(0)) : 0;
        const auto columns = middles_between(x, seen.across, box.lower[seen.across] - over, box.upper[seen.across] + over);
        const auto rows = middles_between(y, seen.beside, box.lower[seen.beside] - over, box.upper[seen.beside] + over);
        for (std::size_t j = rows[0]; j < rows[1]; ++j) {
            for (std::size_t i = columns[0]; i < columns[1]; ++i) test(number, seen, normal, {i, j}, free);
        }
    }

    void test(std::uint32_t number, const Projected& seen, const Vector3d& normal, const std::array<std::size_t, 2>& line,
              std::uint8_t free)
    {
        const EulerAxis& across = axis(seen.across);
        const EulerAxis& beside = axis(seen.beside);
        const double x = wall_middle(across, seen.across, line[0]), y = wall_middle(beside, seen.beside, line[1]);
        std::array<double, 3> part;
        for (std::size_t e = 0; e < 3; ++e) part[e] = seen.side(e, x, y);
        const double whole = part[0] + part[1] + part[2];
        if (whole == 0) return;
        const double width = axis(across.inert() ? seen.beside : seen.across).width(line[across.inert() ? 1 : 0]);
        bool beyond_rim = false;
        double place = 0;
        for (std::size_t e = 0; e < 3; ++e) {
            part[e] /= whole;
            const double over = (free >> e & 1) != 0 ? reach_over * width / seen.height(e) : 0;
            if (part[e] < -over) return;
            beyond_rim |= part[e] < 0;
            place += part[e] * seen.corner[e][seen.axis];
        }
        if (beyond_rim) part = within(part);
        note(number, seen, normal, line, part, place, beyond_rim);
    }

    /// Weights of the facet's nodes for a place beyond its rim: none below 0.
    static std::array<double, 3> within(std::array<double, 3> part)
    {
        double whole = 0;
        for (double& p : part) whole += p = std::max(p, 0.0);
        for (double& p : part) p /= whole;
        return part;
    }

    void note(std::uint32_t number, const Projected& seen, const Vector3d& normal, const std::array<std::size_t, 2>& line,
              const std::array<double, 3>& weight, double place, bool beyond_rim)
    {
        const EulerAxis& own = axis(seen.axis);
        const double slack = 1e-3 * own.width(0);
        if (place < own.faces.front() - slack || place > own.faces.back() + slack) return;
        std::array<std::size_t, 3> at{};
        at[static_cast<std::size_t>(seen.axis)] = middles_between(own, seen.axis, place, place)[0];
        at[static_cast<std::size_t>(seen.across)] = line[0];
        at[static_cast<std::size_t>(seen.beside)] = line[1];
        const Vector3d along = normal[seen.axis] < 0 ? -normal : normal;
        found_.push_back({static_cast<std::uint8_t>(seen.axis), grid_.face_number(seen.axis, at), place, number, weight, along,
                          seen.facet.solid, seen.facet.solid && (normal[seen.axis] < 0) != surface_.is_turned(number), beyond_rim});
    }

    [[nodiscard]] const EulerAxis& axis(int d) const { return grid_.axes[static_cast<std::size_t>(d)]; }

    const EulerGrid& grid_;
    const Surface& surface_;
    std::vector<WallCrossing>& found_;
};

/// Joins what the parts of a loop have found, in their order.
template <class Found>
std::vector<Found> joined(const std::vector<std::vector<Found>>& parts)
{
    std::vector<Found> all;
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

/// Cells whose middles one facet passes.
void add_swept(const EulerGrid& grid, std::uint32_t facet, bool solid, bool turned, const std::array<Vector3d, 3>& start,
               const std::array<Vector3d, 3>& end, std::vector<SweptCell>& found)
{
    Box box;
    for (std::size_t c = 0; c < 3; ++c) box.include(start[c]), box.include(end[c]);
    const Vector3d out = cross(end[1] - end[0], end[2] - end[0]);
    std::array<std::array<std::size_t, 2>, 3> range{};
    for (int d = 0; d < 3; ++d)
        range[static_cast<std::size_t>(d)] = middles_between(grid.axes[static_cast<std::size_t>(d)], d, box.lower[d], box.upper[d]);
    for (std::size_t k = range[2][0]; k < range[2][1]; ++k) {
        for (std::size_t j = range[1][0]; j < range[1][1]; ++j) {
            for (std::size_t i = range[0][0]; i < range[0][1]; ++i) {
                const Vector3d middle{wall_middle(grid.axes[0], 0, i), wall_middle(grid.axes[1], 1, j), wall_middle(grid.axes[2], 2, k)};
                MovingFacet moving{start, end};
                for (std::size_t c = 0; c < 3; ++c) moving.start[c] -= middle, moving.end[c] -= middle;
                const MovingFacet::Meeting met = moving.first_meeting(false);
                if (met.fraction <= 1)
                    found.push_back({grid.cell(i, j, k), facet, met.normal, solid, solid && (dot(met.normal, out) > 0) != turned});
            }
        }
    }
}

}  // namespace

std::vector<std::uint8_t> free_edges(const Surface& surface)
{
    const auto key = [](std::uint32_t a, std::uint32_t b) { return (static_cast<std::uint64_t>(std::min(a, b)) << 32) + std::max(a, b); };
    std::unordered_map<std::uint64_t, int> owners;
    for (std::size_t f = 0; f < surface.facets.size(); ++f) {
        if (surface.is_hidden(f)) continue;
        const auto& n = surface.facets[f].node;
        for (std::size_t e = 0; e < 3; ++e) ++owners[key(n[(e + 1) % 3], n[(e + 2) % 3])];
    }
    std::vector<std::uint8_t> bits(surface.facets.size());
    for (std::size_t f = 0; f < surface.facets.size(); ++f) {
        if (surface.is_hidden(f)) continue;
        const auto& n = surface.facets[f].node;
        for (std::size_t e = 0; e < 3; ++e) {
            if (owners[key(n[(e + 1) % 3], n[(e + 2) % 3])] == 1) bits[f] = static_cast<std::uint8_t>(bits[f] | 1u << e);
        }
    }
    return bits;
}

std::vector<WallCrossing> find_crossings(const EulerGrid& grid, const Surface& surface, std::span<const std::uint8_t> free,
                                         std::span<const Vector3d> nodes)
{
    std::vector<std::vector<WallCrossing>> parts(part_count(surface.facets.size(), worth_a_part));
    for_each_part(surface.facets.size(), parts.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
        FacetCrossings crossings(grid, surface, parts[part]);
        for (std::size_t f = begin; f < end; ++f) {
            const Facet& facet = surface.facets[f];
            if (surface.is_hidden(f)) continue;
            crossings.add(static_cast<std::uint32_t>(f), facet, {nodes[facet.node[0]], nodes[facet.node[1]], nodes[facet.node[2]]},
                          free[f]);
        }
    });
    std::vector<WallCrossing> found = joined(parts);
    const auto order = [](const WallCrossing& c) { return std::tuple(c.axis, c.face, c.place, c.facet); };
    std::sort(found.begin(), found.end(), [&](const WallCrossing& a, const WallCrossing& b) { return order(a) < order(b); });
    return found;
}

std::vector<SweptCell> swept_cells(const EulerGrid& grid, const Surface& surface, const NodePath& nodes)
{
    std::vector<std::vector<SweptCell>> parts(part_count(surface.facets.size(), worth_a_part));
    for_each_part(surface.facets.size(), parts.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            if (surface.is_hidden(f)) continue;
            std::array<Vector3d, 3> from, to;
            for (std::size_t c = 0; c < 3; ++c) {
                from[c] = nodes.start[surface.facets[f].node[c]];
                to[c] = nodes.end[surface.facets[f].node[c]];
            }
            if (from[0] == to[0] && from[1] == to[1] && from[2] == to[2]) continue;
            add_swept(grid, static_cast<std::uint32_t>(f), surface.facets[f].solid, surface.is_turned(f), from, to, parts[part]);
        }
    });
    std::vector<SweptCell> found = joined(parts);
    std::sort(found.begin(), found.end(),
              [](const SweptCell& a, const SweptCell& b) { return std::tie(a.cell, a.facet) < std::tie(b.cell, b.facet); });
    found.erase(std::unique(found.begin(), found.end(), [](const SweptCell& a, const SweptCell& b) { return a.cell == b.cell; }),
                found.end());
    return found;
}

}  // namespace corpuscle
