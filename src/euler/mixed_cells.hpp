#pragma once

#include "euler/tile.hpp"

namespace corpuscle {

/// Finds what leaves cells in which gases meet: along each axis the share of a gas is a smooth step (see thinc.hpp), and what leaves
/// through a face is the step's mean over the part of the cell that the flow carries through it.
struct MixedCellFinder {
    const EulerTile& tile;
    double length;                                          ///< of the step [s]
    std::size_t materials;                                  ///< in sight
    std::array<const double*, most_euler_materials> share;  ///< of each, in the tile's cells
    std::array<const double*, 3> velocity;                  ///< [m/s]

    /// Whether more than a trace of two gases is in a cell.
    [[nodiscard]] bool is_mixed(std::size_t c) const;
    /// What leaves cell c, which has the place `at` in the block.
    [[nodiscard]] MixedCell mixed_cell(std::size_t c, const std::array<std::ptrdiff_t, 3>& at) const;
    /// The same of one whose gases leave it as they are in it, all through.
    [[nodiscard]] MixedCell even_cell(std::size_t c) const;

private:
    using Shares = std::array<double, 6>;
    [[nodiscard]] std::size_t place_in(int d, const std::array<std::ptrdiff_t, 3>& at) const;
    [[nodiscard]] Shares leaving_volumes(std::size_t c, const std::array<std::ptrdiff_t, 3>& at) const;
    [[nodiscard]] Shares leaving_shares(std::size_t c, const std::array<std::ptrdiff_t, 3>& at, const double* of, const Shares& out) const;
    void complete(MixedCell& cell, std::size_t drawn) const;
    void bound(MixedCell& cell, std::size_t c, const Shares& out) const;
};

}  // namespace corpuscle
