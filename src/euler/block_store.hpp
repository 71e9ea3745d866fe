#pragma once

#include <algorithm>
#include <array>

#include "euler/primitive_row.hpp"
#include "euler/relaxation.hpp"
#include "euler/tile.hpp"

namespace corpuscle {

/// Materials with less than this share of a cell do not push others there.
inline constexpr double least_relaxed = 1e-8;

/// Writes a block's cells as they are after the step, from the rates of change that the tile holds.
template <std::size_t M>
class BlockStore {
    using P = Primitive<M>;
    using C = Conserved<M>;

public:
    BlockStore(EulerTile& tile, EulerGrid& grid, const EulerBlock& block, const std::array<MieGrueneisen, M>& laws, double length)
        : tile_(tile), grid_(grid), block_(block), laws_(laws), length_(length)
    {
        scale_.fill(length);
        keep_.fill(1.0);
    }

    /// The row of cells at places (0, j, k) of the block, which are number `from` and on in the tile.
    void store_row(std::size_t j, std::size_t k, std::size_t from, bool burning)
    {
        const std::size_t to = grid_.cell(block_.begin[0], block_.begin[1] + j, block_.begin[2] + k);
        if (block_.walled) find_room(to);
        for (std::size_t m = 0; m < M; ++m) {
            const std::size_t material = tile_.materials[m];
            add_row(grid_.now.mass[material].data() + to, change(C::mass(m)) + from, grid_.next.mass[material].data() + to);
        }
        for (int d = 0; d < 3; ++d) add_row(grid_.now.motion[d].data() + to, change(C::motion(d)) + from, grid_.next.motion[d].data() + to);
        add_row(grid_.now.energy.data() + to, change(C::energy) + from, grid_.next.energy.data() + to);
        store_shares(from, to);
        keep_others(to);
        for (std::size_t m = 0; burning && m < M; ++m) {
            const std::size_t material = tile_.materials[m];
            if (grid_.now.unburnt[material].empty()) continue;
            add_row(grid_.now.unburnt[material].data() + to, tile_.unburnt_change.data() + m * tile_.size + from,
                    grid_.next.unburnt[material].data() + to);
        }
    }

private:
    [[nodiscard]] const double* state(std::size_t quantity) const { return tile_.state.data() + quantity * tile_.size; }
    [[nodiscard]] const double* change(std::size_t quantity) const { return tile_.change.data() + quantity * tile_.size; }

    /// What a cell holds spreads over the room that walls leave it at the end of the step.
    void find_room(std::size_t to)
    {
        const double *now = grid_.walls.room.data() + to, *next = grid_.walls.room_next.data() + to;
        for_simd(tile_.axes[0].cells, [&](std::size_t i) {
            keep_[i] = now[i] / next[i];
            scale_[i] = length_ / next[i];
        });
    }
    void add_row(const double* now, const double* rate, double* next)
    {
        for_simd(tile_.axes[0].cells, [&](std::size_t i) { next[i] = keep_[i] * now[i] + scale_[i] * rate[i]; });
    }
    /// What is not in sight stays.
    void keep_others(std::size_t to)
    {
        for (std::size_t m = 0; m < grid_.materials.size(); ++m) {
            const bool seen = std::find(tile_.materials.begin(), tile_.materials.end(), m) != tile_.materials.end();
            if (!seen) std::copy_n(grid_.now.mass[m].data() + to, tile_.axes[0].cells, grid_.next.mass[m].data() + to);
            if ((!seen || M == 1) && m < grid_.now.share.size()) {
                std::copy_n(grid_.now.share[m].data() + to, tile_.axes[0].cells, grid_.next.share[m].data() + to);
            }
        }
    }
    /// Shares after the step: between 0 and 1, and such that the gases of a mixed cell are in one pressure.
    void store_shares(std::size_t from, std::size_t to)
    {
        if (M == 1) return;
        EulerRows<M> share;
        const std::size_t count = tile_.axes[0].cells;
        std::fill_n(share[M - 1].data(), count, 1.0);
        for (std::size_t m = 0; m + 1 < M; ++m) {
            const double *now = state(P::share(m)) + from, *rate = change(C::share(m)) + from;
            for_simd(count, [&](std::size_t i) {
                const double next = now[i] + scale_[i] * rate[i], positive = next > 0 ? next : 0.0;
                share[m][i] = positive < 1 ? positive : 1.0;
                share[M - 1][i] -= share[m][i];
            });
        }
        for (std::size_t i = 0; i < count; ++i) {
            if (M > 2 && share[M - 1][i] < 0) fit(share, i);
            relax(share, i, from, to);
        }
        for (std::size_t m = 0; m < M; ++m) {
            if (tile_.materials[m] < grid_.now.share.size())
                std::copy_n(share[m].data(), count, grid_.next.share[tile_.materials[m]].data() + to);
        }
    }
    /// Where the others leave less than nothing to the last one they share the cell.
    void fit(EulerRows<M>& share, std::size_t i)
    {
        const double scale = 1 / (1 - share[M - 1][i]);
        for (std::size_t m = 0; m + 1 < M; ++m) share[m][i] *= scale;
        share[M - 1][i] = 0;
    }
    /// Brings the materials in cell i of a row to one pressure.
    void relax(EulerRows<M>& share, std::size_t i, std::size_t from, std::size_t to)
    {
        std::array<PhasePart, M> parts;
        std::array<std::size_t, M> number;
        std::size_t count = 0;
        for (std::size_t m = 0; m < M; ++m) {
            if (!(share[m][i] > least_relaxed)) continue;
            parts[count] = part_after(m, share[m][i], i, from, to);
            if (parts[count].mass > 0) number[count++] = m;
        }
        if (count == 2) {
            const double whole = parts[0].share + parts[1].share;
            share[number[0]][i] = relaxed_share(parts[0], parts[1]);
            share[number[1]][i] = whole - share[number[0]][i];
        } else if (count > 2) {
            std::array<double, M> found;
            relax_shares({parts.data(), count}, {found.data(), count});
            for (std::size_t n = 0; n < count; ++n) share[number[n]][i] = found[n];
        }
    }
    [[nodiscard]] PhasePart part_after(std::size_t m, double share, std::size_t i, std::size_t from, std::size_t to) const
    {
        const std::size_t c = from + i;
        const double before = state(P::share(m))[c], x = laws_[m].inverse_gamma(state(P::density(m))[c]);
        const double energy = before * (x * state(P::pressure)[c] - state(P::cold(m))[c]);
        return {&laws_[m], share, grid_.next.mass[tile_.materials[m]][to + i], keep_[i] * energy + scale_[i] * change(C::part(m))[c]};
    }

    EulerTile& tile_;
    EulerGrid& grid_;
    const EulerBlock& block_;
    const std::array<MieGrueneisen, M>& laws_;
    double length_;
    std::array<double, longest_row> keep_, scale_;
};

}  // namespace corpuscle
