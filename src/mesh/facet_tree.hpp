#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/facet_grid.hpp"
#include "mesh/surface.hpp"

namespace corpuscle {

/// Finds the first facet of a moving surface that a path meets. A uniform grid lists the facets near each of its cells, and tells
/// at once how far any place is from all of them. A step costs what moves in it: facets at rest are left as they are.
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
    [[nodiscard]] double clearance(const Vector3f& position) const { return grid_.clearance(Vector3d(position)); }

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

    /// The grid in which facets are listed.
    [[nodiscard]] const FacetGrid& grid() const { return grid_; }

    /// What a restart needs.
    [[nodiscard]] FieldSet state() { return grid_.state(); }

private:
    /// A path, and what has been found on it so far.
    struct Query {
        Vector3d start, end;
        double from = 0, to = 0;
        std::int64_t except = -1;
        Hit best;
        std::array<std::uint32_t, 32> tested{};  ///< the last facets tested
        std::size_t tests = 0;
    };

    /// Which facets have left the margins they are listed with.
    struct Strays {
        bool still = false, moving = false;
    };

    void find_stirred(const NodePath& nodes);
    Strays take_paths(const NodePath& nodes, std::span<const std::uint8_t> hidden);
    void take_path(std::size_t facet, const NodePath& nodes, bool hidden);
    void search(const Box& box, Query& query) const;
    void test(std::uint32_t facet, Query& query) const;

    std::vector<std::array<std::uint32_t, 3>> facets_;
    std::vector<FacetPath> paths_;       ///< of each facet in this step
    std::vector<Box> boxes_;             ///< about each facet in this step, empty if it is hidden [m]
    std::vector<std::uint8_t> resting_;  ///< of each facet, how it was taken: not at rest, at rest or at rest and hidden
    std::vector<Vector3d> last_;         ///< where each node was at the end of the last step [m]
    std::vector<std::uint8_t> stirred_;  ///< of each node, 1: it moves in this step, or is elsewhere than at the end of the last
    FacetGrid grid_;
};

}  // namespace corpuscle
