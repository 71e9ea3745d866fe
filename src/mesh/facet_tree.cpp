#include "mesh/facet_tree.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "mesh/moving_facet.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {
namespace {

constexpr double piece_limit = 16384;  ///< of a path that is searched piece by piece

/// How a facet was taken.
enum : std::uint8_t { not_at_rest, at_rest, at_rest_and_hidden };

/// The box about a facet in a step, a little wider than what rounding and overlapping edges need.
Box box_about(const std::array<Vector3d, 3>& start, const std::array<Vector3d, 3>& end)
{
    Box box;
    for (int i = 0; i < 3; ++i) {
        box.include(start[i]);
        box.include(end[i]);
    }
    const Vector3d size = box.size();
    box.grow(4e-6 * std::max({size.x, size.y, size.z}));
    return box;
}

/// The box about a path.
Box box_about(const Vector3d& a, const Vector3d& b)
{
    Box box;
    box.include(a);
    box.include(b);
    return box;
}

/// The part [first, second] of a path that lies in a box, empty (second < first) if none does.
std::array<double, 2> part_within(const Vector3d& start, const Vector3d& end, const Vector3d& lower, const Vector3d& upper)
{
    double first = 0, last = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double travel = end[axis] - start[axis];
        if (travel == 0) {
            if (start[axis] < lower[axis] || start[axis] > upper[axis]) return {1, 0};
            continue;
        }
        const double a = (lower[axis] - start[axis]) / travel, b = (upper[axis] - start[axis]) / travel;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return {first, last};
}

}  // namespace

FacetTree::FacetTree(const Surface& surface)
{
    facets_.reserve(surface.facets.size());
    for (const Facet& facet : surface.facets) facets_.push_back(facet.node);
}

std::array<Vector3d, 3> FacetTree::corners(std::int64_t facet, double fraction) const
{
    const FacetPath& c = paths_[facet];
    if (fraction == 0) return c.start;
    if (fraction == 1) return c.end;
    std::array<Vector3d, 3> p;
    for (int i = 0; i < 3; ++i) p[i] = c.start[i] + fraction * (c.end[i] - c.start[i]);
    return p;
}

void FacetTree::follow(const NodePath& nodes, std::span<const std::uint8_t> hidden)
{
    if (facets_.empty()) return;
    grid_.list_again();
    find_stirred(nodes);
    const Strays strays = take_paths(nodes, hidden);
    if (!grid_.listed() || strays.still) return grid_.list_all(paths_);
    if (strays.moving) grid_.list_moving(paths_);
}

/// Finds the nodes that move or have been moved.
void FacetTree::find_stirred(const NodePath& nodes)
{
    const bool first = last_.empty();
    last_.resize(nodes.start.size());
    stirred_.resize(nodes.start.size());
    for_each(last_.size(), [&](std::size_t n) {
        stirred_[n] = first || !(nodes.start[n] == nodes.end[n] && nodes.end[n] == last_[n]) ? 1 : 0;
        last_[n] = nodes.end[n];
    });
}

/// Takes the paths of all facets but those that rest as they did, and says which are no longer where the grid looks for them.
FacetTree::Strays FacetTree::take_paths(const NodePath& nodes, std::span<const std::uint8_t> hidden)
{
    paths_.resize(facets_.size());
    boxes_.resize(facets_.size());
    resting_.resize(facets_.size(), not_at_rest);
    std::atomic<bool> still = false, moving = false;
    for_each(facets_.size(), [&](std::size_t f) {
        const auto& [a, b, c] = facets_[f];
        const bool gone = !hidden.empty() && hidden[f] != 0;
        const bool rests = (stirred_[a] | stirred_[b] | stirred_[c]) == 0;
        const std::uint8_t state = !rests ? not_at_rest : gone ? at_rest_and_hidden : at_rest;
        if (rests && resting_[f] == state) return;
        resting_[f] = state;
        take_path(f, nodes, gone);
        if (!grid_.listed() || grid_.keeps(f, paths_[f])) return;
        (grid_.is_still(f) ? still : moving).store(true, std::memory_order_relaxed);
    });
    return {still, moving};
}

/// Copies a facet's corners and boxes them: what a test reads then lies together. No path comes into the box of a hidden one.
void FacetTree::take_path(std::size_t facet, const NodePath& nodes, bool hidden)
{
    for (int i = 0; i < 3; ++i) {
        paths_[facet].start[i] = nodes.start[facets_[facet][i]];
        paths_[facet].end[i] = nodes.end[facets_[facet][i]];
    }
    boxes_[facet] = hidden ? Box{} : box_about(paths_[facet].start, paths_[facet].end);
}

/// Tests the facets listed along the path piece by piece, so that the first pieces decide; a facet tested is remembered a while.
FacetTree::Hit FacetTree::first_hit(const Vector3d& start, const Vector3d& end, double from, double to, std::int64_t except) const
{
    Query query{start, end, from, to, except, {}, {}, 0};
    query.tested.fill(std::numeric_limits<std::uint32_t>::max());
    const std::array<double, 2> part = part_within(start, end, grid_.lattice().lower, grid_.lattice().upper);
    if (facets_.empty() || !(part[0] <= part[1])) return query.best;
    const Vector3d path = end - start;
    const double length = std::max({std::abs(path.x), std::abs(path.y), std::abs(path.z)}) * (part[1] - part[0]);
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::min(length * grid_.lattice().inverse_size, piece_limit))));
    const double share = (part[1] - part[0]) / pieces;
    for (int piece = 0; piece < pieces; ++piece) {
        const double ends = part[0] + (piece + 1) * share;
        search(box_about(start + (part[0] + piece * share) * path, start + ends * path), query);
        if (query.best.fraction <= ends && query.best.facet >= 0) break;
    }
    return query.best;
}

/// Tests the facets that may come near a box and whose own boxes do.
void FacetTree::search(const Box& box, Query& query) const
{
    grid_.visit(box, [&](std::uint32_t facet) {
        if (boxes_[facet].overlaps(box)) test(facet, query);
    });
}

/// Tests one facet, unless it was tested a moment ago, and keeps the earliest meeting (of two at once that of the lower number).
void FacetTree::test(std::uint32_t facet, Query& query) const
{
    if (std::find(query.tested.begin(), query.tested.end(), facet) != query.tested.end()) return;
    query.tested[query.tests++ % query.tested.size()] = facet;
    MovingFacet moving{corners(facet, query.from), corners(facet, query.to)};
    for (int i = 0; i < 3; ++i) {
        moving.start[i] -= query.start;
        moving.end[i] -= query.end;
    }
    const MovingFacet::Meeting met = moving.first_meeting(facet == query.except);
    if (met.fraction > 1 || met.fraction > query.best.fraction) return;
    if (met.fraction == query.best.fraction && query.best.facet >= 0 && query.best.facet < facet) return;
    query.best = {facet, met.fraction, met.weight, met.normal, met.upper};
}

}  // namespace corpuscle
