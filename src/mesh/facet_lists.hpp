#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/lattice.hpp"

namespace corpuscle {

/// Facets where they were when they were listed, three corners each, and the box in which each facet's corners may go from there.
struct FacetPlaces {
    std::span<const Vector3d> corners;  ///< [m]
    std::span<const Box> reach;         ///< about 0 [m]
};

/// Lists, for each cell of a block of a lattice, the facets that may come near it.
class FacetLists {
public:
    /// Lists the facets of these numbers by all cells that they meet while they stay within their reach.
    void make(const Lattice& lattice, const FacetPlaces& places, std::span<const std::uint32_t> facets);

    /// The cells about all that list facets; empty without facets.
    [[nodiscard]] const CellBlock& block() const { return block_; }

    /// Whether a cell of the block lists facets.
    [[nodiscard]] bool any(std::size_t cell) const { return first_[cell] != first_[cell + 1]; }

    /// visit(facet) for each facet that a cell of the block asked for lists, once for each such cell.
    template <class Visit>
    void visit(const CellBlock& asked, const Visit& visit) const
    {
        const CellBlock met = block_.meet(asked);
        std::array<std::int32_t, 3> c{};
        for (c[2] = met.low[2]; c[2] <= met.high[2]; ++c[2]) {
            for (c[1] = met.low[1]; c[1] <= met.high[1]; ++c[1]) {
                for (c[0] = met.low[0]; c[0] <= met.high[0]; ++c[0]) {
                    const std::size_t cell = block_.index(c);
                    for (std::uint32_t entry = first_[cell]; entry < first_[cell + 1]; ++entry) visit(listed_[entry]);
                }
            }
        }
    }

private:
    void enclose(const Lattice& lattice, const FacetPlaces& places, std::span<const std::uint32_t> facets);
    void cut_slabs(std::size_t facets);
    template <class Visit>
    void visit_slabs(const Lattice& lattice, const FacetPlaces& places, std::span<const std::uint32_t> facets, const Visit& visit) const;

    CellBlock block_;
    std::vector<std::uint32_t> first_;   ///< of each cell's facets in listed_, and one more
    std::vector<std::uint32_t> listed_;  ///< facets cell by cell, in the order of their numbers
    std::vector<CellBlock> near_;        ///< cells about each facet, while lists are made
    std::vector<CellBlock> slabs_;       ///< of the block, one for each thread, of about as many facets
};

}  // namespace corpuscle
