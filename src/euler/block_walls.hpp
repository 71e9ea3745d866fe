#pragma once

#include <algorithm>
#include <array>

#include "euler/hllc.hpp"
#include "euler/tile.hpp"

namespace corpuscle {

/// The walls in a block's sight.
class BlockWalls {
public:
    BlockWalls(EulerTile& tile, const EulerGrid& grid, const EulerBlock& block) : tile_(tile), grid_(grid), block_(block)
    {
        if (block.walled) find_clear();
    }
    [[nodiscard]] bool any() const { return block_.walled; }

    /// No slope reaches across a wall: there is none along an axis that a cell has a shut face on.
    void flatten(int d, std::size_t first, std::size_t count, double* slope) const
    {
        const std::uint8_t* clear = tile_.clear.data() + first;
        const auto bit = static_cast<unsigned>(d);
        for (std::size_t i = 0; i < count; ++i) slope[i] = (clear[i] >> bit & 1u) != 0 ? slope[i] : 0.0;
    }
    [[nodiscard]] bool beside_wall(std::size_t cell) const { return any() && tile_.clear[cell] != all_clear; }

    /// Fluxes through a row of faces across axis d, the first of them the lower face of the cell at place (0, j, k), as far as they are
    /// open.
    template <std::size_t M>
    void narrow(int d, std::ptrdiff_t j, std::ptrdiff_t k, std::size_t count, FluxRows<M>& fluxes) const
    {
        const std::array<std::size_t, 3> place{block_.begin[0], block_.begin[1] + static_cast<std::size_t>(j),
                                               block_.begin[2] + static_cast<std::size_t>(k)};
        const std::size_t first = grid_.face_number(d, place);
        const double* open = grid_.walls.open[static_cast<std::size_t>(d)].data() + first;
        const std::int32_t* shut = grid_.walls.shut[static_cast<std::size_t>(d)].data() + first;
        const auto limit = [&](double* flux) {
            for (std::size_t i = 0; i < count; ++i) flux[i] = shut[i] >= 0 ? 0.0 : open[i] * flux[i];
        };
        for (std::size_t q = 0; q < Conserved<M>::count; ++q) limit(fluxes.flux[q].data());
        limit(fluxes.volume.data());
    }

    /// Adds what walls and corners give to the block's cells; `waits`: what explosive waits of is counted, too.
    template <std::size_t M>
    void add_sources(bool waits)
    {
        using C = Conserved<M>;
        for_sources([&](std::size_t c, double per_volume, const WallSource& given) {
            double* to = tile_.change.data() + c;
            for (std::size_t m = 0; m < M; ++m) {
                const std::size_t material = tile_.materials[m];
                to[C::mass(m) * tile_.size] += per_volume * given.mass[material];
                if (M > 1) to[C::share(m) * tile_.size] += per_volume * given.share[material];
                if (M > 1) to[C::part(m) * tile_.size] += per_volume * given.part[material];
                if (waits) tile_.unburnt_change[m * tile_.size + c] += per_volume * given.unburnt[material];
            }
            for (int d = 0; d < 3; ++d) to[C::motion(d) * tile_.size] += per_volume * given.momentum[d];
            to[C::energy * tile_.size] += per_volume * given.energy;
        });
    }

private:
    static constexpr std::uint8_t all_clear = 7;

    /// visit(cell of the tile, 1/volume, source) for the block's own cells that have one.
    template <class Visit>
    void for_sources(const Visit& visit) const
    {
        for (std::size_t k = block_.begin[2]; k < block_.end[2]; ++k) {
            for (std::size_t j = block_.begin[1]; j < block_.end[1]; ++j) {
                const std::size_t row = grid_.cell(block_.begin[0], j, k);
                const std::size_t first =
                    tile_.at(0, static_cast<std::ptrdiff_t>(j - block_.begin[1]), static_cast<std::ptrdiff_t>(k - block_.begin[2]));
                for (std::size_t i = 0; i < tile_.axes[0].cells; ++i) {
                    const std::int32_t number = grid_.walls.source_of[row + i];
                    if (number >= 0)
                        visit(first + i, 1 / grid_.whole_volume(row + i), grid_.walls.sources[static_cast<std::size_t>(number)]);
                }
            }
        }
    }

    /// For each cell in sight, bit d: both its faces across axis d are open.
    void find_clear()
    {
        tile_.clear.assign(tile_.size, all_clear);
        std::size_t c = 0;
        for (std::size_t k = 0; k < tile_.axes[2].total; ++k) {
            for (std::size_t j = 0; j < tile_.axes[1].total; ++j) {
                for (std::size_t i = 0; i < tile_.axes[0].total; ++i, ++c) {
                    const std::array<std::size_t, 3> place{tile_.axes[0].source[i], tile_.axes[1].source[j], tile_.axes[2].source[k]};
                    for (int d = 0; d < 3; ++d) {
                        auto upper = place;
                        ++upper[static_cast<std::size_t>(d)];
                        const auto& shut = grid_.walls.shut[static_cast<std::size_t>(d)];
                        const bool clear = shut[grid_.face_number(d, place)] < 0 && shut[grid_.face_number(d, upper)] < 0;
                        if (!clear) tile_.clear[c] = static_cast<std::uint8_t>(tile_.clear[c] & ~(1u << static_cast<unsigned>(d)));
                    }
                }
            }
        }
    }

    EulerTile& tile_;
    const EulerGrid& grid_;
    const EulerBlock& block_;
};

}  // namespace corpuscle
