#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "fields/field.hpp"
#include "mesh/clearance_map.hpp"

namespace corpuscle {

/// Where a facet's corners are at both ends of a step. [m]
struct FacetPath {
    std::array<Vector3d, 3> start, end;
};

/// Knows which facets may come near a place, and how far any place is at least from all of them, as long as each stays within the margin
/// it was listed with. Those at rest when the grid was placed are listed once; the others anew whenever one leaves its margin.
class FacetGrid {
public:
    /// Whether there are lists.
    [[nodiscard]] bool listed() const { return listed_; }

    /// Places the grid anew and lists all facets where they are in this step.
    void list_all(std::span<const FacetPath> paths);
    /// Lists those anew that did not rest when the grid was placed; or all, where they no longer fit into it.
    void list_moving(std::span<const FacetPath> paths);
    /// Lists as a restart has it; nothing if it has nothing.
    void list_again();

    /// Whether a facet stays in this step within the margin it was listed with.
    [[nodiscard]] bool keeps(std::size_t facet, const FacetPath& path) const
    {
        const Vector3d* listed = &listed_start_[3 * facet];
        bool within = true;
        for (int i = 0; i < 3; ++i)
            within = within && reach_[facet].contains(path.start[i] - listed[i]) && reach_[facet].contains(path.end[i] - listed[i]);
        return within;
    }
    /// Whether a facet was at rest when the grid was placed.
    [[nodiscard]] bool is_still(std::size_t facet) const { return still_[facet] != 0; }

    /// Lower bound of the distance from a place to any facet within its margin [m]: 0 if near, infinity without facets.
    [[nodiscard]] double clearance(const Vector3d& p) const
    {
        const double outside = distance_outside(p);
        if (outside > 0) return outside;
        const Vector3d q = (p - lattice_.lower) * lattice_.inverse_size;
        const std::array<std::int32_t, 3> c{lattice_.layer(q.x, 0), lattice_.layer(q.y, 1), lattice_.layer(q.z, 2)};
        const int free = map_.cells_to_nearest(c);
        if (free == 0) return 0;
        const double inner = std::min({wall_distance(q.x - c[0]), wall_distance(q.y - c[1]), wall_distance(q.z - c[2])});
        return lattice_.size * std::max(0.0, free - 1 + inner - 1e-6);
    }

    /// visit(facet) for each facet that may come near a box, some more than once.
    template <class Visit>
    void visit(const Box& box, const Visit& visit) const
    {
        const CellBlock block = lattice_.block(box);
        still_lists_.visit(block, visit);
        moving_lists_.visit(block, visit);
    }

    [[nodiscard]] const Lattice& lattice() const { return lattice_; }

    /// Times that facets were listed.
    [[nodiscard]] std::uint64_t listings() const { return listings_; }
    /// Of these, how often all.
    [[nodiscard]] std::uint64_t placings() const { return placings_; }

    /// What a restart needs so that clearances, which depend on when facets were listed, go on as they were.
    [[nodiscard]] FieldSet state();

private:
    static double wall_distance(double q) { return std::min(q, 1 - q); }

    /// Distance to the lattice's box, 0 inside; infinity while there is none.
    [[nodiscard]] double distance_outside(const Vector3d& p) const
    {
        const double x = std::max({lattice_.lower.x - p.x, p.x - lattice_.upper.x, 0.0});
        const double y = std::max({lattice_.lower.y - p.y, p.y - lattice_.upper.y, 0.0});
        const double z = std::max({lattice_.lower.z - p.z, p.z - lattice_.upper.z, 0.0});
        return x + y + z > 0 ? std::sqrt(x * x + y * y + z * z) : 0.0;
    }

    [[nodiscard]] double motion(std::size_t facet) const;
    [[nodiscard]] double ahead(double motion) const;
    [[nodiscard]] Box reach_of(std::size_t facet) const;
    void remember(std::span<const FacetPath> paths, std::span<const std::uint32_t> facets);
    void sort_by_rest();
    void place();
    [[nodiscard]] Box box_about(std::span<const std::uint32_t> facets) const;
    bool lay_out(const Box& box);
    void set_reach(std::span<const std::uint32_t> facets);
    [[nodiscard]] bool moving_fit() const;
    void list();

    std::vector<Vector3d> listed_start_;           ///< corners, three a facet, at the start of the step in which it was listed [m]
    std::vector<Vector3d> listed_end_;             ///< at its end [m]
    std::vector<std::uint8_t> still_;              ///< 1: at rest when the grid was placed
    std::vector<double> placed_;                   ///< the lattice's lower corner, cell size and layers, as a restart has them
    std::vector<Box> reach_;                       ///< about 0: a facet's corners may go so far from listed_start_ [m]
    std::vector<std::uint32_t> resting_, moving_;  ///< facets by still_
    Lattice lattice_;
    FacetLists still_lists_, moving_lists_;
    ClearanceMap map_;
    bool listed_ = false;
    std::uint64_t listings_ = 0, placings_ = 0;
};

}  // namespace corpuscle
