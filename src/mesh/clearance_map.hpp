#pragma once

#include <cstdint>
#include <vector>

#include "mesh/facet_lists.hpp"

namespace corpuscle {

/// How many cells away from each cell of a lattice the nearest is that lists facets, in the largest direction; 0: it does itself. Looks
/// only so far: `limit` stands for anything farther.
class ClearanceMap {
public:
    static constexpr int limit = 16;

    /// Measures from the facets that stay where they are, of which `moving` are more.
    void measure(const Lattice& lattice, const FacetLists& still, const FacetLists& moving);
    /// Measures again after only those have been listed anew.
    void measure_moving(const FacetLists& moving);

    [[nodiscard]] int cells_to_nearest(const std::array<std::int32_t, 3>& c) const { return to_any_[all_.index(c)]; }

private:
    [[nodiscard]] CellBlock measure_about(const FacetLists& lists);
    template <class Visit>
    void for_each_row(const CellBlock& block, const Visit& visit) const;

    CellBlock all_;      ///< cells of the lattice
    CellBlock changed_;  ///< where moving facets have lowered what to_still_ says
    std::vector<std::uint8_t> to_still_, to_any_;
    std::vector<std::uint8_t> near_, scratch_;  ///< distances about some lists, while they are measured
};

}  // namespace corpuscle
