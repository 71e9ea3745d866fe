#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "euler/grid.hpp"

namespace corpuscle {

/// Layers of cells of the neighbours that a block needs to see.
inline constexpr std::size_t euler_halo = 2;
/// Most cells in a row of a tile, halo and all: blocks have up to one and a half times `most_block_cells`.
inline constexpr std::size_t longest_row = most_block_cells + most_block_cells / 2 + 2 * euler_halo + 4;

/// A row of numbers for each of several quantities.
template <std::size_t Count>
using EulerRows = std::array<std::array<double, longest_row>, Count>;

/// A block's cells along one axis, halo included: where their numbers come from, and their geometry.
struct TileAxis {
    bool live = false;
    std::size_t cells = 1, halo = 0, total = 1;  ///< of the block; on each side; together
    std::size_t stride = 0;                      ///< in the tile
    std::array<std::size_t, longest_row> source{};
    std::array<double, longest_row> sign{};            ///< -1 where the source is a mirror's image
    std::array<double, longest_row> to_lower{};        ///< width over the distance of middles to the cell before
    std::array<double, longest_row> to_upper{};        ///< and to the cell behind
    std::array<double, longest_row> inverse_width{};   ///< [1/m]
    std::array<double, longest_row> larger_face{};     ///< area of the larger face over the volume: what a step may empty a cell by [1/m]
    std::array<double, longest_row> curvature{};       ///< (area behind - area before)/volume [1/m]
    std::array<double, longest_row> area{};            ///< of the lower faces of the block's own cells and of the last upper one
    std::array<double, longest_row> inverse_volume{};  ///< of the block's own cells
};

/// A cell in which gases meet: the shares that leave it through its faces, lower and upper along each axis, for each material.
struct MixedCell {
    std::array<std::array<double, 2 * 3>, most_euler_materials> face_share{};
};

/// Room for a block's computation, of one thread.
struct EulerTile {
    std::array<TileAxis, 3> axes;
    std::size_t size = 0;                ///< cells, halo included
    std::vector<std::size_t> materials;  ///< those that are in sight
    std::vector<double> state;           ///< of the cells: quantity by quantity, see flow.cpp
    std::vector<double> drift;           ///< their change over half a step
    std::vector<double> change;          ///< of the conserved numbers of the block's own cells, per time
    std::vector<double> unburnt;         ///< share of its mass that waits, of each material in sight
    std::vector<double> unburnt_change;  ///< of the mass that waits, per volume and time
    std::vector<std::int32_t> mixed;     ///< number of a mixed cell, -1 elsewhere
    std::vector<MixedCell> mixed_cells;
    std::vector<std::uint8_t> clear;  ///< where walls are in sight: bit d of a cell, no wall shuts its faces across axis d

    /// Number of a cell by its place in the block; halo cells have places below 0 or beyond the end.
    [[nodiscard]] std::size_t at(std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t k) const
    {
        const auto along = [&](int d, std::ptrdiff_t n) {
            return static_cast<std::size_t>(n + static_cast<std::ptrdiff_t>(axes[d].halo)) * axes[d].stride;
        };
        return along(0, i) + along(1, j) + along(2, k);
    }
};

/// Makes room for a block and finds its geometry.
void lay_tile(EulerTile& tile, const EulerGrid& grid, const EulerBlock& block);

}  // namespace corpuscle
