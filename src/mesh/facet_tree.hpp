#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "fields/field.hpp"
#include "math/box.hpp"
#include "mesh/surface.hpp"

namespace corpuscle {

/// Finds the first facet of a moving surface that a path meets. A uniform grid lists the facets near each of its cells, and tells
/// at once how far any place is from all of them; it is made anew only when a facet leaves the margin it was put in with.
/// All tests are made in double precision, continuous in time, with edges that overlap: a closed surface does not leak.
class FacetTree {
public:
    /// The meeting of a path with a facet.
    struct Hit {
        std::int64_t facet = -1;         ///< -1: none
        double fraction = 1;             ///< of the path
        std::array<double, 3> weight{};  ///< of the facet's nodes at the point met: none below 0, their sum is 1
        Vector3d normal;                 ///< unit normal at that moment, towards the side the path comes from
        bool upper = false;              ///< which is the side of the facet's own normal, by the right hand
    };

    explicit FacetTree(const Surface& surface);

    /// Makes the tree valid for a step in which the nodes move straight from start to end [m]; the spans must outlive the step.
    /// Facets marked in `hidden` (none if empty) are not met.
    void follow(const NodePath& nodes, std::span<const std::uint8_t> hidden = {});

    /// Lower bound of the distance from a place to any facet at any moment of the step [m]: 0 if near, infinity without facets.
    [[nodiscard]] double clearance(const Vector3f& position) const
    {
        const Vector3d p{position};
        const double outside = distance_outside(p);
        if (outside > 0) return outside;
        const Vector3d q = (p - grid_.lower) * grid_.inverse_size;
        const std::array<std::int32_t, 3> c{grid_.layer(q.x, 0), grid_.layer(q.y, 1), grid_.layer(q.z, 2)};
        const int free = clearance_[grid_.index(c)];
        if (free == 0) return 0;
        const double inner = std::min({wall_distance(q.x - c[0]), wall_distance(q.y - c[1]), wall_distance(q.z - c[2])});
        return grid_.size * std::max(0.0, free - 1 + inner - 1e-6);
    }

    /// Whether a facet, where it is at the start of the step, cuts the straight line between two places.
    [[nodiscard]] bool separates(const Vector3d& a, const Vector3d& b) const { return first_hit(a, b, 0, 0, -1).facet >= 0; }

    /// The first facet met, from either side, by what goes straight and evenly from `start` to `end` [m] while the fraction of the
    /// step goes from `from` to `to` (equal: the facets stand where they are at that fraction). Also finds facets that overtake it.
    /// The facet `except`, on which the path starts (-1: none), counts only if it is met again.
    [[nodiscard]] Hit first_hit(const Vector3d& start, const Vector3d& end, double from, double to, std::int64_t except) const;

    /// Facets that the tree holds.
    [[nodiscard]] std::size_t size() const { return facets_.size(); }

    /// Nodes of a facet, and where they are at a fraction of the step (exactly their start and end at 0 and 1) [m].
    [[nodiscard]] const std::array<std::uint32_t, 3>& nodes(std::int64_t facet) const { return facets_[facet]; }
    [[nodiscard]] std::array<Vector3d, 3> corners(std::int64_t facet, double fraction) const;

    /// Times that the grid was made.
    [[nodiscard]] std::uint64_t rebuilds() const { return rebuilds_; }

    /// What a restart needs so that clearances, which depend on when the grid was made, go on as they were.
    [[nodiscard]] FieldSet state();

private:
    static constexpr double nowhere = std::numeric_limits<double>::infinity();

    /// Cubes that fill a box about all facets.
    struct Grid {
        Vector3d lower{nowhere, nowhere, nowhere}, upper{-nowhere, -nowhere, -nowhere};  ///< [m]
        double size = 1;                                                                 ///< of a cell [m]
        double inverse_size = 1;                                                         ///< [1/m]
        std::array<std::int32_t, 3> count{0, 0, 0};

        /// Layer of cells at so many cell sizes (at most 1e9) from the lower face, the outermost beyond it.
        [[nodiscard]] std::int32_t layer(double sizes, int axis) const
        {
            return std::clamp(static_cast<std::int32_t>(sizes), 0, count[axis] - 1);
        }
        [[nodiscard]] std::size_t index(const std::array<std::int32_t, 3>& c) const
        {
            return (static_cast<std::size_t>(c[2]) * count[1] + c[1]) * count[0] + c[0];
        }
        [[nodiscard]] std::size_t cells() const { return static_cast<std::size_t>(count[0]) * count[1] * count[2]; }
    };
    struct Corners {
        std::array<Vector3d, 3> start, end;  ///< [m]
    };

    /// A path, and what has been found on it so far.
    struct Query {
        Vector3d start, end;
        double from = 0, to = 0;
        std::int64_t except = -1;
        Hit best;
        std::array<std::uint32_t, 8> tested{};  ///< the last facets tested
        std::size_t tests = 0;
    };

    static double wall_distance(double q) { return std::min(q, 1 - q); }

    /// Distance to the grid's box, 0 inside; infinity while there is no grid.
    [[nodiscard]] double distance_outside(const Vector3d& p) const
    {
        const double x = std::max({grid_.lower.x - p.x, p.x - grid_.upper.x, 0.0});
        const double y = std::max({grid_.lower.y - p.y, p.y - grid_.upper.y, 0.0});
        const double z = std::max({grid_.lower.z - p.z, p.z - grid_.upper.z, 0.0});
        return x + y + z > 0 ? std::sqrt(x * x + y * y + z * z) : 0.0;
    }

    [[nodiscard]] bool within_reach() const;
    void take_corners(const NodePath& nodes, std::span<const std::uint8_t> hidden);
    void remember_corners();
    void build();
    [[nodiscard]] std::vector<double> motions() const;
    double set_reach(const std::vector<double>& motions);
    void place_grid();
    void list_facets();
    void measure_clearance();
    void search(const Box& box, Query& query) const;
    void test(std::uint32_t facet, Query& query) const;
    template <class Visit>
    void visit_cells(std::size_t facet, const Visit& visit) const;

    std::vector<std::array<std::uint32_t, 3>> facets_;
    std::vector<Corners> corners_;       ///< of each facet in this step
    std::vector<Box> boxes_;             ///< about each facet in this step [m]
    std::vector<Vector3d> built_start_;  ///< corners, three a facet, at the start of the step in which the grid was made [m]
    std::vector<Vector3d> built_end_;    ///< at its end [m]
    std::vector<double> reach_;          ///< a facet's corners may go so far from built_start_ [m]
    bool built_ = false;                 ///< the grid is that of built_start_ and built_end_

    Grid grid_;
    std::vector<std::uint32_t> first_;     ///< of each cell's facets in listed_, and one more
    std::vector<std::uint32_t> listed_;    ///< facets cell by cell
    std::vector<std::uint8_t> clearance_;  ///< cells to the nearest listing cell in the largest direction; 0: lists facets itself
    std::uint64_t rebuilds_ = 0;
};

}  // namespace corpuscle
