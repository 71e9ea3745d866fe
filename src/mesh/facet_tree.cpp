#include "mesh/facet_tree.hpp"

#include <atomic>
#include <string>

#include "base/error.hpp"
#include "mesh/moving_facet.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {
namespace {

constexpr double cell_limit = 1e6;      ///< cells of the grid
constexpr int layer_limit = 4096;       ///< cells in one direction
constexpr int clearance_limit = 16;     ///< cells that clearance looks around
constexpr double steps_ahead = 40;      ///< a rebuild should last so many steps of the present motion ...
constexpr double farthest_ahead = 0.4;  ///< ... but may not widen facets by more than this share of a cell
constexpr double least_margin = 0.1;    ///< by which facets at rest are widened, in cells
constexpr double spare_margin = 0.01;   ///< for rounding, in single precision, of what relies on clearance, in cells

/// The value below which a quarter of the values lie.
double lower_quartile(std::vector<double> values)
{
    const auto quarter = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
    std::nth_element(values.begin(), quarter, values.end());
    return *quarter;
}

/// Twice a triangle's area as a vector.
Vector3d area_vector(const Vector3d* p)
{
    return cross(p[1] - p[0], p[2] - p[0]);
}

/// How far the farthest of a facet's corners is from where it was [m].
double motion(const Vector3d* from, const Vector3d* to)
{
    double farthest = 0;
    for (int i = 0; i < 3; ++i) farthest = std::max(farthest, norm_squared(to[i] - from[i]));
    return std::sqrt(farthest);
}

/// Stops a run whose facets have been lost to overflow: no grid holds them.
void refuse_infinite(const std::vector<double>& sizes, const std::vector<double>& motions)
{
    for (std::size_t f = 0; f < sizes.size(); ++f) {
        if (std::isfinite(sizes[f] + motions[f])) continue;
        throw SafetyStop("surface facet " + std::to_string(f) + " is no longer at a finite place",
                         "look for an unstable part, or take a smaller step");
    }
}

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

/// A pass of the Chebyshev distance transform across rows: each of n rows of `width` cells, `stride` apart, becomes the smallest over
/// its neighbours (itself included) of the larger of their value and their distance.
void widen(const std::uint8_t* in, std::uint8_t* out, std::int32_t n, std::size_t stride, std::size_t width)
{
    for (std::int32_t i = 0; i < n; ++i) {
        std::uint8_t* to = out + i * stride;
        std::copy_n(in + i * stride, width, to);
        for (std::int32_t r = 1; r < clearance_limit; ++r) {
            const std::uint8_t least = static_cast<std::uint8_t>(r);
            for (const std::int32_t j : {i - r, i + r}) {
                if (j < 0 || j >= n) continue;
                const std::uint8_t* from = in + j * stride;
                for (std::size_t x = 0; x < width; ++x) to[x] = std::min(to[x], std::max(from[x], least));
            }
        }
    }
}

/// Along a row of single cells: distances to the nearest 0, forth and back.
void measure_row(std::uint8_t* row, std::int32_t n)
{
    for (std::int32_t i = 1; i < n; ++i) row[i] = std::min<std::uint8_t>(row[i], static_cast<std::uint8_t>(row[i - 1] + 1));
    for (std::int32_t i = n - 2; i >= 0; --i) row[i] = std::min<std::uint8_t>(row[i], static_cast<std::uint8_t>(row[i + 1] + 1));
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
    const Corners& c = corners_[facet];
    if (fraction == 0) return c.start;
    if (fraction == 1) return c.end;
    std::array<Vector3d, 3> p;
    for (int i = 0; i < 3; ++i) p[i] = c.start[i] + fraction * (c.end[i] - c.start[i]);
    return p;
}

void FacetTree::follow(const NodePath& nodes, std::span<const std::uint8_t> hidden)
{
    if (facets_.empty()) return;
    take_corners(nodes, hidden);
    if (!built_ && built_start_.size() == 3 * facets_.size()) build();
    if (built_ && within_reach()) return;
    remember_corners();
    build();
}

/// Copies the corners of all facets and boxes them: what a test reads then lies together. No path comes into the box of a hidden one.
void FacetTree::take_corners(const NodePath& nodes, std::span<const std::uint8_t> hidden)
{
    corners_.resize(facets_.size());
    boxes_.resize(facets_.size());
    for_each(facets_.size(), [&](std::size_t f) {
        for (int i = 0; i < 3; ++i) {
            corners_[f].start[i] = nodes.start[facets_[f][i]];
            corners_[f].end[i] = nodes.end[facets_[f][i]];
        }
        boxes_[f] = !hidden.empty() && hidden[f] ? Box{} : box_about(corners_[f].start, corners_[f].end);
    });
}

/// Whether every facet stays in this step within the margin that the grid was made with.
bool FacetTree::within_reach() const
{
    std::atomic<bool> within = true;
    for_each(facets_.size(), [&](std::size_t f) {
        const double farthest =
            std::max(motion(&built_start_[3 * f], corners_[f].start.data()), motion(&built_start_[3 * f], corners_[f].end.data()));
        if (!(farthest <= reach_[f])) within.store(false, std::memory_order_relaxed);
    });
    return within;
}

/// Notes where the facets are: what the grid is made from.
void FacetTree::remember_corners()
{
    built_start_.resize(3 * facets_.size());
    built_end_.resize(3 * facets_.size());
    for_each(facets_.size(), [&](std::size_t f) {
        std::copy(corners_[f].start.begin(), corners_[f].start.end(), built_start_.begin() + 3 * static_cast<std::ptrdiff_t>(f));
        std::copy(corners_[f].end.begin(), corners_[f].end.end(), built_end_.begin() + 3 * static_cast<std::ptrdiff_t>(f));
    });
}

/// Makes the grid from the corners remembered, and from nothing else.
void FacetTree::build()
{
    place_grid();
    list_facets();
    measure_clearance();
    built_ = true;
    ++rebuilds_;
}

FieldSet FacetTree::state()
{
    FieldSet set{
        "facet_tree",
        {stored_field("built_start", "m", "facet corners at the start of the step in which the search grid was made", built_start_),
         stored_field("built_end", "m", "facet corners at its end", built_end_)}};
    for (Field& field : set.fields) {
        field.restore = [this, take = field.restore](const void* values, std::size_t count) {
            take(values, count);
            built_ = false;
        };
    }
    return set;
}

/// How far each facet moved in the step in which the grid was made [m].
std::vector<double> FacetTree::motions() const
{
    std::vector<double> far(facets_.size());
    for_each(far.size(), [&](std::size_t f) { far[f] = motion(&built_start_[3 * f], &built_end_[3 * f]); });
    return far;
}

/// Sets the facets' margins, which should last many steps of their motion; returns the widest margin [m].
double FacetTree::set_reach(const std::vector<double>& motions)
{
    double widest = 0;
    reach_.resize(motions.size());
    for (std::size_t f = 0; f < motions.size(); ++f) {
        const double ahead = std::max(1.25 * motions[f], std::min(steps_ahead * motions[f], farthest_ahead * grid_.size));
        reach_[f] = least_margin * grid_.size + ahead;
        widest = std::max(widest, reach_[f]);
    }
    return widest + spare_margin * grid_.size;
}

/// Chooses the cells' size from the smaller facets and from the motion, then margins and the grid's box.
void FacetTree::place_grid()
{
    std::vector<double> sizes(facets_.size());
    for_each(sizes.size(), [&](std::size_t f) { sizes[f] = std::sqrt(norm(area_vector(&built_start_[3 * f]))); });
    const std::vector<double> far = motions();
    refuse_infinite(sizes, far);
    Box box;
    for (const Vector3d& p : built_start_) box.include(p);
    for (const Vector3d& p : built_end_) box.include(p);
    const Vector3d extent = box.size();
    const double longest = std::max({extent.x, extent.y, extent.z, 1e-30});
    grid_.size = std::max({0.5 * lower_quartile(sizes), 0.7 * lower_quartile(far), 1.2 * longest / layer_limit}) / 1.1;
    std::array<double, 3> layers{};
    double margin = 0;
    do {
        grid_.size *= 1.1;
        margin = set_reach(far);
        for (int axis = 0; axis < 3; ++axis) layers[axis] = std::ceil((extent[axis] + 2 * margin) / grid_.size);
    } while (layers[0] * layers[1] * layers[2] > cell_limit || std::max({layers[0], layers[1], layers[2]}) > layer_limit);
    box.grow(margin);
    grid_.lower = box.lower;
    grid_.upper = box.upper;
    grid_.inverse_size = 1 / grid_.size;
    for (int axis = 0; axis < 3; ++axis) grid_.count[axis] = static_cast<std::int32_t>(layers[axis]);
}

/// visit(cell) for each cell that a facet comes near while it stays within its reach: column by column across the facet's plane.
template <class Visit>
void FacetTree::visit_cells(std::size_t facet, const Visit& visit) const
{
    const Vector3d* p = &built_start_[3 * facet];
    const double reach = reach_[facet] + spare_margin * grid_.size;
    Box box;
    for (int i = 0; i < 3; ++i) box.include(p[i]);
    box.grow(reach);
    std::array<std::int32_t, 3> low{}, high{};
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = grid_.layer((box.lower[axis] - grid_.lower[axis]) * grid_.inverse_size, axis);
        high[axis] = grid_.layer((box.upper[axis] - grid_.lower[axis]) * grid_.inverse_size, axis);
    }
    const Vector3d area = area_vector(p);
    const Vector3d n = norm(area) > 0 ? area / norm(area) : Vector3d{};
    const int d = std::abs(n.x) >= std::abs(n.y) && std::abs(n.x) >= std::abs(n.z) ? 0 : std::abs(n.y) >= std::abs(n.z) ? 1 : 2;
    const int e = (d + 1) % 3, f = (d + 2) % 3;
    const double half = 0.5 * grid_.size;
    const double thickness = n[d] != 0 ? (reach + half * (std::abs(n[e]) + std::abs(n[f]))) / std::abs(n[d]) : 0;
    std::array<std::int32_t, 3> c{};
    for (c[f] = low[f]; c[f] <= high[f]; ++c[f]) {
        for (c[e] = low[e]; c[e] <= high[e]; ++c[e]) {
            std::int32_t bottom = low[d], top = high[d];
            if (n[d] != 0) {
                const double across_e = grid_.lower[e] + (c[e] + 0.5) * grid_.size - p[0][e];
                const double across_f = grid_.lower[f] + (c[f] + 0.5) * grid_.size - p[0][f];
                const double middle = p[0][d] - (n[e] * across_e + n[f] * across_f) / n[d] - grid_.lower[d];
                bottom = std::max(bottom, grid_.layer(std::clamp((middle - thickness) * grid_.inverse_size, -1.0, 1e9), d));
                top = std::min(top, grid_.layer(std::clamp((middle + thickness) * grid_.inverse_size, -1.0, 1e9), d));
            }
            for (c[d] = bottom; c[d] <= top; ++c[d]) visit(grid_.index(c));
        }
    }
}

/// Lists the facets cell by cell, in the order of the facets.
void FacetTree::list_facets()
{
    first_.assign(grid_.cells() + 1, 0);
    for (std::size_t f = 0; f < facets_.size(); ++f) visit_cells(f, [&](std::size_t cell) { ++first_[cell]; });
    listed_.resize(exclusive_scan(first_));
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t f = 0; f < facets_.size(); ++f) {
        visit_cells(f, [&](std::size_t cell) { listed_[next[cell]++] = static_cast<std::uint32_t>(f); });
    }
}

/// Chebyshev distance of each cell to the nearest that lists facets, by one pass in each direction.
void FacetTree::measure_clearance()
{
    const std::size_t row = grid_.count[0], plane = row * grid_.count[1];
    std::vector<std::uint8_t> scratch(grid_.cells());
    clearance_.resize(grid_.cells());
    for_each(grid_.cells(), [&](std::size_t c) { scratch[c] = first_[c] == first_[c + 1] ? clearance_limit : 0; });
    for_each(grid_.cells() / row, [&](std::size_t r) { measure_row(scratch.data() + r * row, grid_.count[0]); });
    for_each_dynamic(grid_.count[2], 1,
                     [&](std::size_t z) { widen(scratch.data() + z * plane, clearance_.data() + z * plane, grid_.count[1], row, row); });
    for_each_dynamic(grid_.count[1], 1,
                     [&](std::size_t y) { widen(clearance_.data() + y * row, scratch.data() + y * row, grid_.count[2], plane, row); });
    clearance_.swap(scratch);
}

/// Tests the facets listed along the path piece by piece, so that the first pieces decide; a facet tested is remembered a while.
FacetTree::Hit FacetTree::first_hit(const Vector3d& start, const Vector3d& end, double from, double to, std::int64_t except) const
{
    Query query{start, end, from, to, except, {}, {}, 0};
    query.tested.fill(std::numeric_limits<std::uint32_t>::max());
    const std::array<double, 2> part = part_within(start, end, grid_.lower, grid_.upper);
    if (facets_.empty() || !(part[0] <= part[1])) return query.best;
    const Vector3d path = end - start;
    const double length = std::max({std::abs(path.x), std::abs(path.y), std::abs(path.z)}) * (part[1] - part[0]);
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::min(length * grid_.inverse_size, 4.0 * layer_limit))));
    const double share = (part[1] - part[0]) / pieces;
    for (int piece = 0; piece < pieces; ++piece) {
        const double ends = part[0] + (piece + 1) * share;
        search(box_about(start + (part[0] + piece * share) * path, start + ends * path), query);
        if (query.best.fraction <= ends && query.best.facet >= 0) break;
    }
    return query.best;
}

/// Tests the facets that the cells of a box list and that come into the box.
void FacetTree::search(const Box& box, Query& query) const
{
    std::array<std::int32_t, 3> low{}, high{}, c{};
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = grid_.layer((box.lower[axis] - grid_.lower[axis]) * grid_.inverse_size, axis);
        high[axis] = grid_.layer((box.upper[axis] - grid_.lower[axis]) * grid_.inverse_size, axis);
    }
    for (c[2] = low[2]; c[2] <= high[2]; ++c[2]) {
        for (c[1] = low[1]; c[1] <= high[1]; ++c[1]) {
            for (c[0] = low[0]; c[0] <= high[0]; ++c[0]) {
                const std::size_t cell = grid_.index(c);
                for (std::uint32_t entry = first_[cell]; entry < first_[cell + 1]; ++entry) {
                    if (boxes_[listed_[entry]].overlaps(box)) test(listed_[entry], query);
                }
            }
        }
    }
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
