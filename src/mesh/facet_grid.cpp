#include "mesh/facet_grid.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "base/error.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {
namespace {

constexpr double cell_limit = 1e6;           ///< cells of the grid ...
constexpr double cells_a_facet = 16;         ///< ... or so many for each facet, if that is more
constexpr int layer_limit = 4096;            ///< cells in one direction
constexpr double steps_ahead = 40;           ///< lists should last so many steps of the present motion ...
constexpr double farthest_ahead = 0.4;       ///< ... but may not widen facets by more than this share of a cell
constexpr double least_margin = 0.1;         ///< by which facets at rest are widened, in cells
constexpr double spare_margin = 0.01;        ///< for rounding, in single precision, of what relies on clearance, in cells
constexpr double room_to_move = 3;           ///< about moving facets beside resting ones, in cells
constexpr std::size_t sample_limit = 10000;  ///< facets that tell what is usual

/// The value below which a quarter of value(i), i < count, lie; of many, a part is looked at.
template <class Value>
double lower_quartile(std::size_t count, const Value& value)
{
    const std::size_t stride = (count + sample_limit - 1) / sample_limit;
    std::vector<double> values;
    for (std::size_t i = 0; i < count; i += stride) values.push_back(value(i));
    const auto quarter = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
    std::nth_element(values.begin(), quarter, values.end());
    return *quarter;
}

/// The longest side of a box of this size, never quite 0 [m].
double longest_of(const Vector3d& size)
{
    return std::max({size.x, size.y, size.z, 1e-30});
}

/// A box that can be added up.
struct Bounds {
    Box box;

    Bounds& operator+=(const Bounds& other)
    {
        for (int axis = 0; axis < 3; ++axis) {
            box.lower[axis] = std::min(box.lower[axis], other.box.lower[axis]);
            box.upper[axis] = std::max(box.upper[axis], other.box.upper[axis]);
        }
        return *this;
    }
};

/// Stops a run whose facets have been lost to overflow: no grid holds them.
void refuse_infinite(std::span<const FacetPath> paths)
{
    const auto finite = [](const FacetPath& path) {
        double total = 0;
        for (int i = 0; i < 3; ++i) total += norm_squared(path.start[i]) + norm_squared(path.end[i]);
        return std::isfinite(total);
    };
    const auto lost = std::find_if_not(paths.begin(), paths.end(), finite);
    if (lost == paths.end()) return;
    throw SafetyStop("surface facet " + std::to_string(lost - paths.begin()) + " is no longer at a finite place",
                     "look for an unstable part, or take a smaller step");
}

}  // namespace

void FacetGrid::list_all(std::span<const FacetPath> paths)
{
    refuse_infinite(paths);
    listed_start_.resize(3 * paths.size());
    listed_end_.resize(3 * paths.size());
    still_.resize(paths.size());
    for_each(paths.size(), [&](std::size_t f) { still_[f] = paths[f].start == paths[f].end ? 1 : 0; });
    sort_by_rest();
    remember(paths, resting_);
    remember(paths, moving_);
    place();
    set_reach(resting_);
    set_reach(moving_);
    list();
}

void FacetGrid::list_moving(std::span<const FacetPath> paths)
{
    if (resting_.empty()) return list_all(paths);
    remember(paths, moving_);
    set_reach(moving_);
    if (!moving_fit()) return list_all(paths);
    moving_lists_.make(lattice_, {listed_start_, reach_}, moving_);
    map_.measure_moving(moving_lists_);
    ++listings_;
}

void FacetGrid::list_again()
{
    if (listed_ || listed_start_.empty()) return;
    sort_by_rest();
    lattice_.size = placed_[3];
    lay_out({{placed_[0], placed_[1], placed_[2]}, {placed_[4], placed_[5], placed_[6]}});
    set_reach(resting_);
    set_reach(moving_);
    list();
}

FieldSet FacetGrid::state()
{
    FieldSet set{"facet_grid",
                 {stored_field("built_start", "m", "facet corners at the start of the step in which the facet was listed", listed_start_),
                  stored_field("built_end", "m", "facet corners at its end", listed_end_),
                  stored_field("still", "1", "facets at rest when the search grid was placed", still_),
                  stored_field("placed", "m", "the search grid's lower corner, size of a cell, upper corner", placed_)}};
    for (Field& field : set.fields) {
        field.restore = [this, take = field.restore](const void* values, std::size_t count) {
            take(values, count);
            listed_ = false;
        };
    }
    return set;
}

/// How far the farthest of a facet's corners moved in the step in which it was listed [m].
double FacetGrid::motion(std::size_t facet) const
{
    double farthest = 0;
    for (std::size_t i = 3 * facet; i < 3 * facet + 3; ++i) farthest = std::max(farthest, norm_squared(listed_end_[i] - listed_start_[i]));
    return std::sqrt(farthest);
}

/// The margin for a motion of so much in a step: it should last many steps [m].
double FacetGrid::ahead(double motion) const
{
    return least_margin * lattice_.size + std::max(1.25 * motion, std::min(steps_ahead * motion, farthest_ahead * lattice_.size));
}

/// The margin of a facet, wider where it moves to [m].
Box FacetGrid::reach_of(std::size_t facet) const
{
    Box moved;
    moved.include({});
    for (std::size_t i = 3 * facet; i < 3 * facet + 3; ++i) moved.include(listed_end_[i] - listed_start_[i]);
    return {{-ahead(-moved.lower.x), -ahead(-moved.lower.y), -ahead(-moved.lower.z)},
            {ahead(moved.upper.x), ahead(moved.upper.y), ahead(moved.upper.z)}};
}

/// Notes where facets are: what lists are made from.
void FacetGrid::remember(std::span<const FacetPath> paths, std::span<const std::uint32_t> facets)
{
    for_each(facets.size(), [&](std::size_t i) {
        const std::size_t f = facets[i];
        std::copy(paths[f].start.begin(), paths[f].start.end(), listed_start_.begin() + 3 * static_cast<std::ptrdiff_t>(f));
        std::copy(paths[f].end.begin(), paths[f].end.end(), listed_end_.begin() + 3 * static_cast<std::ptrdiff_t>(f));
    });
}

/// Parts the facets at rest from the others.
void FacetGrid::sort_by_rest()
{
    resting_.clear();
    moving_.clear();
    for (std::uint32_t f = 0; f < still_.size(); ++f) (still_[f] ? resting_ : moving_).push_back(f);
}

/// The box about the places remembered of some facets at both ends of the step.
Box FacetGrid::box_about(std::span<const std::uint32_t> facets) const
{
    const Bounds bounds = sum_chunks<Bounds>(facets.size(), [&](std::size_t begin, std::size_t end) {
        Bounds about;
        for (std::size_t i = 3 * begin; i < 3 * end; ++i) {
            const std::size_t corner = 3 * static_cast<std::size_t>(facets[i / 3]) + i % 3;
            about.box.include(listed_start_[corner]);
            about.box.include(listed_end_[corner]);
        }
        return about;
    });
    return bounds.box;
}

/// Chooses the cells' size from the smaller facets and from the motion, then the grid's box: it holds all facets within their margins, and
/// gives room to those that move beside others at rest.
void FacetGrid::place()
{
    const double usual_size = lower_quartile(still_.size(), [&](std::size_t f) {
        const Vector3d* p = &listed_start_[3 * f];
        return std::sqrt(norm(cross(p[1] - p[0], p[2] - p[0])));
    });
    const double usual_motion = lower_quartile(still_.size(), [&](std::size_t f) { return motion(f); });
    const double fastest = -minimum(moving_.size(), 0.0, [&](std::size_t i) { return -motion(moving_[i]); });
    const Bounds resting{box_about(resting_)}, moving{box_about(moving_)};
    const double room = resting_.empty() ? 0 : room_to_move;
    const auto needed = [&] {
        Bounds rest = resting, move = moving;
        rest.box.grow(ahead(0) + spare_margin * lattice_.size);
        move.box.grow(ahead(fastest) + (room + spare_margin) * lattice_.size);
        return resting_.empty() ? move.box : moving_.empty() ? rest.box : (rest += move).box;
    };
    const Vector3d extent = (Bounds{resting} += moving).box.size();
    lattice_.size = std::max({0.5 * usual_size, 0.7 * usual_motion, 1.2 * longest_of(extent) / layer_limit});
    while (!lay_out(needed())) lattice_.size *= 1.1;
    placed_ = {lattice_.lower.x, lattice_.lower.y, lattice_.lower.z, lattice_.size, lattice_.upper.x, lattice_.upper.y, lattice_.upper.z};
}

/// Fills a box with cells of the size chosen; false if they would be too many.
bool FacetGrid::lay_out(const Box& box)
{
    std::array<double, 3> layers{};
    for (int axis = 0; axis < 3; ++axis) layers[axis] = std::ceil(box.size()[axis] / lattice_.size);
    const double most = std::max(cell_limit, cells_a_facet * static_cast<double>(still_.size()));
    if (layers[0] * layers[1] * layers[2] > most || std::max({layers[0], layers[1], layers[2]}) > layer_limit) return false;
    lattice_.lower = box.lower;
    lattice_.upper = box.upper;
    lattice_.inverse_size = 1 / lattice_.size;
    for (int axis = 0; axis < 3; ++axis) lattice_.count[axis] = static_cast<std::int32_t>(layers[axis]);
    return true;
}

/// Sets facets' margins, which should last many steps of their motion.
void FacetGrid::set_reach(std::span<const std::uint32_t> facets)
{
    reach_.resize(still_.size());
    for_each(facets.size(), [&](std::size_t i) { reach_[facets[i]] = reach_of(facets[i]); });
}

/// Whether the grid's box holds the moving facets within their margins.
bool FacetGrid::moving_fit() const
{
    const Box box{lattice_.lower, lattice_.upper};
    const auto fits = [&](std::size_t facet) {
        Box reach = reach_[facet];
        reach.grow(spare_margin * lattice_.size);
        bool within = true;
        for (std::size_t i = 3 * facet; i < 3 * facet + 3; ++i)
            within = within && box.contains(listed_start_[i] + reach.lower) && box.contains(listed_start_[i] + reach.upper);
        return within;
    };
    return 0 == sum<std::size_t>(moving_.size(), [&](std::size_t i) { return std::size_t{fits(moving_[i]) ? 0u : 1u}; });
}

/// Lists all facets.
void FacetGrid::list()
{
    still_lists_.make(lattice_, {listed_start_, reach_}, resting_);
    moving_lists_.make(lattice_, {listed_start_, reach_}, moving_);
    map_.measure(lattice_, still_lists_, moving_lists_);
    listed_ = true;
    ++listings_;
    ++placings_;
}

}  // namespace corpuscle
