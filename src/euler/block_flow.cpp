#include "euler/block_flow.hpp"

#include <algorithm>
#include <cmath>

#include "euler/block_store.hpp"
#include "euler/block_walls.hpp"
#include "euler/hllc.hpp"
#include "euler/mixed_cells.hpp"
#include "euler/with_count.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

/// A face state with less than this share of the cell's pressure or density takes the cell's.
constexpr double least_left = 0.1;
/// Bounds of the limiter below: steeper for densities, whose jumps at contacts would smear; the plainest for velocity and pressure, which
/// keeps a round blast round on a coarse grid.
constexpr double reach_of_matter = 1.5, reach_of_waves = 1.0;

/// A cell's change along an axis, limited: the mean of the changes to both neighbours, but at most `reach` times the smaller one
/// (1: minmod, 2: monotonised central differences, van Leer, J. Comput. Phys. 23 (1977) 276).
inline double limited(double below, double above, double to_lower, double to_upper, double reach)
{
    const double mean = 0.5 * (below * to_lower + above * to_upper);
    const double size_below = below < 0 ? -below : below, size_above = above < 0 ? -above : above, size = mean < 0 ? -mean : mean;
    const double bound = reach * (size_below < size_above ? size_below : size_above), least = size < bound ? size : bound;
    const double signed_least = mean < 0 ? -least : least;
    return below * above > 0 ? signed_least : 0.0;
}

/// The step of one block that has M materials in sight.
template <std::size_t M>
class BlockFlow {
    using P = Primitive<M>;
    using C = Conserved<M>;
    using FaceRows = EulerRows<P::count>;

public:
    BlockFlow(EulerTile& tile, EulerGrid& grid, const EulerBlock& block, double length)
        : tile_(tile), grid_(grid), block_(block), length_(length), walls_(tile, grid, block)
    {
        for (std::size_t m = 0; m < M; ++m) laws_[m] = grid.laws[tile.materials[m]];
        tile.state.resize(P::count * tile.size);
        tile.drift.resize(P::advected * tile.size);
        tile.change.assign(C::count * tile.size, 0.0);
        for (std::size_t m = 0; m < M; ++m) burning_ |= !grid.now.unburnt[tile.materials[m]].empty();
        if (!burning_) return;
        tile.unburnt.assign(M * tile.size, 0.0);
        tile.unburnt_change.assign(M * tile.size, 0.0);
    }

    EulerPassages run()
    {
        load();
        for_rows(1, [&](std::ptrdiff_t j, std::ptrdiff_t k) { find_drift(j, k); });
        if (M > 1) find_mixed_cells();
        for (int d = 0; d < 3; ++d) {
            if (tile_.axes[d].live) flow_along(d);
        }
        if (walls_.any()) walls_.template add_sources<M>(burning_);
        store();
        return passages_;
    }

private:
    [[nodiscard]] double* state(std::size_t quantity) { return tile_.state.data() + quantity * tile_.size; }
    [[nodiscard]] double* drift(std::size_t quantity) { return tile_.drift.data() + quantity * tile_.size; }
    [[nodiscard]] double* change(std::size_t quantity) { return tile_.change.data() + quantity * tile_.size; }
    [[nodiscard]] double* unburnt(std::size_t m) { return tile_.unburnt.data() + m * tile_.size; }

    /// Halo cells along the rows that are computed with.
    [[nodiscard]] std::ptrdiff_t margin(int d, std::ptrdiff_t layers) const { return tile_.axes[d].live ? layers : 0; }

    /// body(j, k) for the block's rows and the rows up to `layers` beside it, those beside its edges left out that no face needs.
    template <class Body>
    void for_rows(std::ptrdiff_t layers, const Body& body)
    {
        const auto ny = static_cast<std::ptrdiff_t>(tile_.axes[1].cells), nz = static_cast<std::ptrdiff_t>(tile_.axes[2].cells);
        for (std::ptrdiff_t k = -margin(2, layers); k < nz + margin(2, layers); ++k) {
            for (std::ptrdiff_t j = -margin(1, layers); j < ny + margin(1, layers); ++j) {
                if (beyond(j, ny) + beyond(k, nz) <= layers) body(j, k);
            }
        }
    }
    static std::ptrdiff_t beyond(std::ptrdiff_t n, std::ptrdiff_t count) { return n < 0 ? -n : n >= count ? n - count + 1 : 0; }

    /// Copies a row of a stored array, halo and all.
    void copy_row(const std::vector<double>& from, std::size_t row, double* to) const
    {
        const TileAxis& x = tile_.axes[0];
        const double* first = from.data() + row;
        for (std::size_t n = 0; n < x.halo; ++n) to[n] = first[x.source[n]];
        std::copy_n(first + block_.begin[0], x.cells, to + x.halo);
        for (std::size_t n = x.halo + x.cells; n < x.total; ++n) to[n] = first[x.source[n]];
    }

    /// Reads the cells that the block sees and finds their primitives.
    void load()
    {
        for_rows(2, [&](std::ptrdiff_t j, std::ptrdiff_t k) { load_row(j, k); });
    }
    void load_row(std::ptrdiff_t j, std::ptrdiff_t k)
    {
        const TileAxis &x = tile_.axes[0], &y = tile_.axes[1], &z = tile_.axes[2];
        const std::size_t nj = static_cast<std::size_t>(j + static_cast<std::ptrdiff_t>(y.halo));
        const std::size_t nk = static_cast<std::size_t>(k + static_cast<std::ptrdiff_t>(z.halo));
        const std::size_t row = grid_.cell(0, y.source[nj], z.source[nk]);
        EulerRows<C::count> conserved;
        for (std::size_t m = 0; m < M; ++m) {
            copy_row(grid_.now.mass[tile_.materials[m]], row, conserved[C::mass(m)].data());
            if (M > 1) copy_share(tile_.materials[m], row, conserved[C::share(m)].data());
        }
        for (int d = 0; d < 3; ++d) copy_row(grid_.now.motion[d], row, conserved[C::motion(d)].data());
        copy_row(grid_.now.energy, row, conserved[C::energy].data());
        for (std::size_t n = 0; n < x.total; ++n) conserved[C::motion(0)][n] *= x.sign[n];
        if (y.sign[nj] < 0) for_simd(x.total, [&](std::size_t n) { conserved[C::motion(1)][n] = -conserved[C::motion(1)][n]; });
        if (z.sign[nk] < 0) for_simd(x.total, [&](std::size_t n) { conserved[C::motion(2)][n] = -conserved[C::motion(2)][n]; });

        const std::size_t first = tile_.at(-static_cast<std::ptrdiff_t>(x.halo), j, k);
        ConservedRow<M> from;
        PrimitiveRow<M> to;
        for (std::size_t q = 0; q < C::count; ++q) from[q] = conserved[q].data();
        for (std::size_t q = 0; q < P::count; ++q) to[q] = state(q) + first;
        find_primitives<M>(laws_, grid_.pressure_floor, x.total, from, to);
        if (burning_) load_unburnt(row, first, conserved);
    }
    void copy_share(std::size_t material, std::size_t row, double* to) const
    {
        const auto& shares = grid_.now.share;
        if (material < shares.size()) return copy_row(shares[material], row, to);
        std::array<double, longest_row> other;
        std::fill_n(to, tile_.axes[0].total, 1.0);
        for (const auto& share : shares) {
            copy_row(share, row, other.data());
            for_simd(tile_.axes[0].total, [&](std::size_t n) { to[n] -= other[n]; });
        }
    }
    void load_unburnt(std::size_t row, std::size_t first, const EulerRows<C::count>& conserved)
    {
        std::array<double, longest_row> waits;
        for (std::size_t m = 0; m < M; ++m) {
            const auto& from = grid_.now.unburnt[tile_.materials[m]];
            if (from.empty()) continue;
            copy_row(from, row, waits.data());
            for (std::size_t n = 0; n < tile_.axes[0].total; ++n) {
                const double mass = conserved[C::mass(m)][n];
                unburnt(m)[first + n] = waits[n] > 0 && mass > 0 ? std::min(1.0, waits[n] / mass) : 0.0;
            }
        }
    }

    /// Slopes of a material's density count only where the cell and both neighbours are mostly of it.
    [[nodiscard]] const double* share_behind(std::size_t quantity)
    {
        return M > 1 && quantity < 2 * M ? state(P::share(quantity % M)) : nullptr;
    }

    /// change[i] = what quantity `q` changes across cell first + i along axis d.
    void find_slopes(int d, std::size_t q, std::size_t first, std::size_t count, const double* to_lower, const double* to_upper,
                     double* slope)
    {
        const std::size_t stride = tile_.axes[d].stride;
        const double reach = q < 2 * M ? reach_of_matter : reach_of_waves;
        const double *w = state(q) + first, *before = w - stride, *behind = w + stride;
        for_simd(count, [&](std::size_t i) { slope[i] = limited(w[i] - before[i], behind[i] - w[i], to_lower[i], to_upper[i], reach); });
        if (const double* share = share_behind(q)) {
            const double *a = share + first, *lower = a - stride, *upper = a + stride;
            for_simd(count, [&](std::size_t i) {
                const bool inside = (a[i] > 0.5) & (lower[i] > 0.5) & (upper[i] > 0.5);
                slope[i] = inside ? slope[i] : 0.0;
            });
        }
        if (walls_.any()) walls_.flatten(d, first, count, slope);
    }

    /// The axis' geometry along a row: as it is along x, the one value of the row across it.
    struct RowGeometry {
        std::array<double, longest_row> to_lower, to_upper, inverse_width;
    };
    [[nodiscard]] RowGeometry row_geometry(int d, std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t k, std::size_t count) const
    {
        const TileAxis& axis = tile_.axes[d];
        const std::size_t n = static_cast<std::size_t>((d == 0 ? i : d == 1 ? j : k) + static_cast<std::ptrdiff_t>(axis.halo));
        RowGeometry row;
        for (std::size_t c = 0; c < count; ++c) {
            const std::size_t at = d == 0 ? n + c : n;
            row.to_lower[c] = axis.to_lower[at], row.to_upper[c] = axis.to_upper[at], row.inverse_width[c] = axis.inverse_width[at];
        }
        return row;
    }

    /// What the flow's equations in primitive form make of a row's cells in half a step.
    void find_drift(std::ptrdiff_t j, std::ptrdiff_t k)
    {
        const TileAxis& x = tile_.axes[0];
        const std::size_t count = x.cells + 2 * static_cast<std::size_t>(margin(0, 1)), first = tile_.at(-margin(0, 1), j, k);
        EulerRows<P::advected> carried{};
        EulerRows<3> push{};
        std::array<double, longest_row> spread{}, slope;
        for (int d = 0; d < 3; ++d) {
            if (!tile_.axes[d].live) continue;
            const RowGeometry row = row_geometry(d, -margin(0, 1), j, k, count);
            const double* u = state(P::velocity(d)) + first;
            for (std::size_t q = 0; q < P::advected; ++q) {
                find_slopes(d, q, first, count, row.to_lower.data(), row.to_upper.data(), slope.data());
                double* sum = carried[q].data();
                for_simd(count, [&](std::size_t i) { sum[i] += u[i] * (slope[i] * row.inverse_width[i]); });
                if (q == P::velocity(d)) for_simd(count, [&](std::size_t i) { spread[i] += slope[i] * row.inverse_width[i]; });
                if (q == P::pressure) for_simd(count, [&](std::size_t i) { push[d][i] = slope[i] * row.inverse_width[i]; });
            }
        }
        const double* u = state(P::velocity(0)) + first;
        const double* curvature = x.curvature.data() + x.halo - static_cast<std::size_t>(margin(0, 1));
        if (grid_.axes[0].curved) for_simd(count, [&](std::size_t i) { spread[i] += u[i] * curvature[i]; });
        write_drift(first, count, carried, push, spread);
    }
    void write_drift(std::size_t first, std::size_t count, const EulerRows<P::advected>& carried, const EulerRows<3>& push,
                     const std::array<double, longest_row>& spread)
    {
        const double half = 0.5 * length_;
        PrimitiveRow<M> w, to;
        for (std::size_t q = 0; q < P::count; ++q) w[q] = state(q) + first;
        for (std::size_t q = 0; q < P::advected; ++q) to[q] = drift(q) + first;
        for_simd(count, [&](std::size_t i) {
            const Mixture<M> all = mixture<M>(laws_, w, i);
            const double p = w[P::pressure][i], light = 1 / all.density;
            to[P::pressure][i] = -half * (carried[P::pressure][i] + all.stiffness(p) * spread[i]);
            for (int d = 0; d < 3; ++d) to[P::velocity(d)][i] = -half * (carried[P::velocity(d)][i] + push[d][i] * light);
            for (std::size_t m = 0; m < M; ++m) {
                const double r = w[P::density(m)][i], q = w[P::cold(m)][i], z = w[P::stiff(m)][i];
                to[P::density(m)][i] = -half * (carried[P::density(m)][i] + r * spread[i]);
                to[P::cold(m)][i] = -half * (carried[P::cold(m)][i] + (q + z) * spread[i]);
            }
        });
    }

    /// Finds cells with more than one gas, and what of each leaves through their faces.
    void find_mixed_cells()
    {
        tile_.mixed.assign(tile_.size, -1);
        tile_.mixed_cells.clear();
        MixedCellFinder finder{tile_, length_, M, {}, {}};
        for (std::size_t m = 0; m < M; ++m) finder.share[m] = state(P::share(m));
        for (int d = 0; d < 3; ++d) finder.velocity[d] = state(P::velocity(d));
        const auto nx = static_cast<std::ptrdiff_t>(tile_.axes[0].cells);
        for_rows(1, [&](std::ptrdiff_t j, std::ptrdiff_t k) {
            for (std::ptrdiff_t i = -margin(0, 1); i < nx + margin(0, 1); ++i) {
                const std::size_t c = tile_.at(i, j, k);
                if (!finder.is_mixed(c)) continue;
                tile_.mixed[c] = static_cast<std::int32_t>(tile_.mixed_cells.size());
                tile_.mixed_cells.push_back(walls_.beside_wall(c) ? finder.even_cell(c) : finder.mixed_cell(c, {i, j, k}));
            }
        });
    }

    /// States at the lower and upper faces across axis d of `count` cells from place (i, j, k) along x, half a step on.
    void find_face_states(int d, std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t k, std::size_t count, FaceRows& lower, FaceRows& upper)
    {
        const std::size_t first = tile_.at(i, j, k);
        const RowGeometry row = row_geometry(d, i, j, k, count);
        std::array<double, longest_row> slope;
        for (std::size_t q = 0; q < P::advected; ++q) {
            find_slopes(d, q, first, count, row.to_lower.data(), row.to_upper.data(), slope.data());
            const double *w = state(q) + first, *g = drift(q) + first;
            double *low = lower[q].data(), *high = upper[q].data();
            for_simd(count, [&](std::size_t c) {
                const double middle = w[c] + g[c], half = 0.5 * slope[c];
                low[c] = middle - half;
                high[c] = middle + half;
            });
        }
        for (std::size_t m = 0; m < M; ++m) {
            const double* z = state(P::stiff(m)) + first;
            double *low = lower[P::stiff(m)].data(), *high = upper[P::stiff(m)].data();
            for_simd(count, [&](std::size_t c) { low[c] = z[c], high[c] = z[c]; });
        }
        keep_positive(first, count, lower, upper);
        if (M > 1) find_face_shares(d, first, count, lower, upper);
    }

    /// Takes the cell's own state where a face's would fall too far below it.
    void keep_positive(std::size_t first, std::size_t count, FaceRows& lower, FaceRows& upper)
    {
        std::array<std::uint64_t, longest_row> bad;
        const double* p = state(P::pressure) + first;
        for_simd(count, [&](std::size_t c) {
            const double least = lower[P::pressure][c] < upper[P::pressure][c] ? lower[P::pressure][c] : upper[P::pressure][c];
            bool found = !(least > least_left * p[c]);
            for (std::size_t m = 0; m < M; ++m) {
                const double low = lower[P::density(m)][c], high = upper[P::density(m)][c];
                found |= !((low < high ? low : high) > least_left * state(P::density(m))[first + c]);
            }
            bad[c] = found ? 1 : 0;
        });
        std::uint64_t any = 0;
        for (std::size_t c = 0; c < count; ++c) any |= bad[c];
        if (any == 0) return;
        for (std::size_t q = 0; q < P::advected; ++q) {
            const double* w = state(q) + first;
            for (std::size_t c = 0; c < count; ++c) {
                if (bad[c]) lower[q][c] = upper[q][c] = w[c];
            }
        }
    }

    void find_face_shares(int d, std::size_t first, std::size_t count, FaceRows& lower, FaceRows& upper)
    {
        std::array<double, longest_row> rest;
        std::fill_n(rest.data(), count, 1.0);
        for (std::size_t m = 0; m + 1 < M; ++m) {
            const double* a = state(P::share(m)) + first;
            double *low = lower[P::share(m)].data(), *high = upper[P::share(m)].data();
            for_simd(count, [&](std::size_t c) {
                const double share = a[c] < 0.5 ? 0.0 : 1.0;
                low[c] = share, high[c] = share;
                rest[c] -= share;
            });
        }
        for_simd(count, [&](std::size_t c) { lower[P::share(M - 1)][c] = rest[c], upper[P::share(M - 1)][c] = rest[c]; });
        if (tile_.mixed_cells.empty()) return;
        for (std::size_t c = 0; c < count; ++c) {
            const std::int32_t number = tile_.mixed[first + c];
            if (number < 0) continue;
            const MixedCell& cell = tile_.mixed_cells[static_cast<std::size_t>(number)];
            for (std::size_t m = 0; m < M; ++m) {
                lower[P::share(m)][c] = cell.face_share[m][2 * d];
                upper[P::share(m)][c] = cell.face_share[m][2 * d + 1];
            }
        }
    }

    /// Fluxes through the faces across an axis, and what they make of the cells.
    void flow_along(int d)
    {
        if (d == 0) return flow_along_rows();
        const TileAxis &own = tile_.axes[d], &other = tile_.axes[3 - d];
        const auto count = static_cast<std::ptrdiff_t>(own.cells);
        for (std::ptrdiff_t o = 0; o < static_cast<std::ptrdiff_t>(other.cells); ++o) {
            FaceRows* before = &faces_[0];
            FaceRows* behind = &faces_[1];
            for (std::ptrdiff_t n = -1; n <= count; ++n) {
                const std::ptrdiff_t j = d == 1 ? n : o, k = d == 1 ? o : n;
                find_face_states(d, 0, j, k, tile_.axes[0].cells, faces_[2], *behind);
                if (n >= 0) {
                    find_fluxes<M>(laws_, d, tile_.axes[0].cells, rows_at(*before, 0), rows_at(faces_[2], 0), fluxes_);
                    if (walls_.any()) walls_.template narrow<M>(d, d == 1 ? n : o, d == 1 ? o : n, tile_.axes[0].cells, fluxes_);
                    if (burning_) find_unburnt_fluxes(tile_.at(0, j, k) - own.stride, tile_.at(0, j, k), tile_.axes[0].cells);
                    const auto face = static_cast<std::size_t>(n);
                    if (n > 0) add_across(tile_.at(0, j, k) - own.stride, -own.area[face] * own.inverse_volume[face - 1]);
                    if (n < count) add_across(tile_.at(0, j, k), own.area[face] * own.inverse_volume[face]);
                    if (on_edge(d, n)) pass_edge_across(d, n, o);
                }
                std::swap(before, behind);
            }
        }
    }

    /// Pointers to the rows, from an offset on.
    [[nodiscard]] static std::array<const double*, P::count> rows_at(const FaceRows& rows, std::size_t offset)
    {
        std::array<const double*, P::count> to;
        for (std::size_t q = 0; q < P::count; ++q) to[q] = rows[q].data() + offset;
        return to;
    }

    void flow_along_rows()
    {
        const std::size_t count = tile_.axes[0].cells;
        for_rows(0, [&](std::ptrdiff_t j, std::ptrdiff_t k) {
            find_face_states(0, -1, j, k, count + 2, faces_[0], faces_[1]);
            find_fluxes<M>(laws_, 0, count + 1, rows_at(faces_[1], 0), rows_at(faces_[0], 1), fluxes_);
            if (walls_.any()) walls_.template narrow<M>(0, j, k, count + 1, fluxes_);
            if (burning_) find_unburnt_fluxes(tile_.at(-1, j, k), tile_.at(0, j, k), count + 1);
            add_along(tile_.at(0, j, k));
            if (on_edge(0, 0)) pass_edge(0, 0, 0, row_area(j, k));
            if (on_edge(0, static_cast<std::ptrdiff_t>(count))) pass_edge(0, 1, count, row_area(j, k));
        });
    }

    /// Adds the fluxes along x to a row of cells. Round about an axis or a point, the pressure of the cell is taken off the momentum's flux
    /// on both sides: equal pressures then push nothing, to the last bit, though the areas differ.
    void add_along(std::size_t first)
    {
        const TileAxis& x = tile_.axes[0];
        const double *area = x.area.data(), *inverse = x.inverse_volume.data();
        for (std::size_t q = 0; q < M + 4; ++q) {
            const double* flux = fluxes_.flux[q].data();
            double* sum = change(q) + first;
            if (q == C::motion(0) && grid_.axes[0].curved) {
                const double *p = state(P::pressure) + first, *g = drift(P::pressure) + first;
                for_simd(x.cells, [&](std::size_t i) {
                    const double middle = p[i] + g[i];
                    sum[i] += inverse[i] * (area[i] * (flux[i] - middle) - area[i + 1] * (flux[i + 1] - middle));
                });
            } else {
                for_simd(x.cells, [&](std::size_t i) { sum[i] += inverse[i] * (area[i] * flux[i] - area[i + 1] * flux[i + 1]); });
            }
        }
        const double* volume = fluxes_.volume.data();
        for (std::size_t m = 0; m + 1 < M; ++m) {
            const double *flux = fluxes_.flux[C::share(m)].data(), *a = state(P::share(m)) + first;
            double* sum = change(C::share(m)) + first;
            for_simd(x.cells, [&](std::size_t i) {
                const double in = area[i] * (flux[i] - a[i] * volume[i]), out = area[i + 1] * (flux[i + 1] - a[i] * volume[i + 1]);
                sum[i] += inverse[i] * (in - out);
            });
        }
        for (std::size_t m = 0; M > 1 && m < M; ++m) {
            const double *flux = fluxes_.flux[C::part(m)].data(), *a = state(P::share(m)) + first;
            const double *p = state(P::pressure) + first, *g = drift(P::pressure) + first;
            double* sum = change(C::part(m)) + first;
            for_simd(x.cells, [&](std::size_t i) {
                const double push = a[i] * (p[i] + g[i]);
                sum[i] += inverse[i] * (area[i] * (flux[i] + push * volume[i]) - area[i + 1] * (flux[i + 1] + push * volume[i + 1]));
            });
        }
        for (std::size_t m = 0; burning_ && m < M; ++m) {
            double* sum = unburnt_change(m) + first;
            const double* flux = unburnt_flux_[m].data();
            for_simd(x.cells, [&](std::size_t i) { sum[i] += inverse[i] * (area[i] * flux[i] - area[i + 1] * flux[i + 1]); });
        }
    }

    /// Adds the fluxes through a row of faces to the row of cells on one side, times `factor`.
    void add_across(std::size_t first, double factor)
    {
        const std::size_t count = tile_.axes[0].cells;
        for (std::size_t q = 0; q < M + 4; ++q) {
            const double* flux = fluxes_.flux[q].data();
            double* sum = change(q) + first;
            for_simd(count, [&](std::size_t i) { sum[i] += factor * flux[i]; });
        }
        const double* volume = fluxes_.volume.data();
        for (std::size_t m = 0; m + 1 < M; ++m) {
            const double *flux = fluxes_.flux[C::share(m)].data(), *a = state(P::share(m)) + first;
            double* sum = change(C::share(m)) + first;
            for_simd(count, [&](std::size_t i) { sum[i] += factor * (flux[i] - a[i] * volume[i]); });
        }
        for (std::size_t m = 0; M > 1 && m < M; ++m) {
            const double *flux = fluxes_.flux[C::part(m)].data(), *a = state(P::share(m)) + first;
            const double *p = state(P::pressure) + first, *g = drift(P::pressure) + first;
            double* sum = change(C::part(m)) + first;
            for_simd(count, [&](std::size_t i) { sum[i] += factor * (flux[i] + a[i] * (p[i] + g[i]) * volume[i]); });
        }
        for (std::size_t m = 0; burning_ && m < M; ++m) {
            double* sum = unburnt_change(m) + first;
            const double* flux = unburnt_flux_[m].data();
            for_simd(count, [&](std::size_t i) { sum[i] += factor * flux[i]; });
        }
    }

    /// Explosive that waits goes with its material, as the cell has it that it comes from.
    void find_unburnt_fluxes(std::size_t left, std::size_t right, std::size_t count)
    {
        for (std::size_t m = 0; m < M; ++m) {
            const double *flux = fluxes_.flux[C::mass(m)].data(), *a = unburnt(m) + left, *b = unburnt(m) + right;
            double* to = unburnt_flux_[m].data();
            for_simd(count, [&](std::size_t i) { to[i] = flux[i] * (flux[i] > 0 ? a[i] : b[i]); });
        }
    }
    [[nodiscard]] double* unburnt_change(std::size_t m) { return tile_.unburnt_change.data() + m * tile_.size; }

    [[nodiscard]] bool on_edge(int d, std::ptrdiff_t face) const
    {
        const std::size_t cell = block_.begin[d] + static_cast<std::size_t>(face);
        return cell == 0 || cell == grid_.axes[d].cells();
    }
    [[nodiscard]] double row_area(std::ptrdiff_t j, std::ptrdiff_t k) const
    {
        const auto row = [&](int d, std::ptrdiff_t n) { return grid_.axes[d].volume[block_.begin[d] + static_cast<std::size_t>(n)]; };
        return grid_.round() * row(1, j) * row(2, k);
    }
    void pass_edge_across(int d, std::ptrdiff_t face, std::ptrdiff_t other)
    {
        const int o = 3 - d;
        const double depth = grid_.round() * grid_.axes[o].volume[block_.begin[o] + static_cast<std::size_t>(other)];
        for (std::size_t i = 0; i < tile_.axes[0].cells; ++i) {
            pass_edge(d, face == 0 ? 0 : 1, i, depth * grid_.axes[0].volume[block_.begin[0] + i]);
        }
    }
    /// Books what goes out through face `at` of the row of fluxes, which lies in the grid's lower (0) or upper (1) edge; `breadth`: its
    /// area but for the axis' own part.
    void pass_edge(int d, int side, std::size_t at, double breadth)
    {
        const TileAxis& axis = tile_.axes[d];
        const double out = (side == 0 ? -1 : 1) * length_ * breadth * axis.area[side == 0 ? 0 : axis.cells];
        EulerAmount& passed = passages_[2 * static_cast<std::size_t>(d) + static_cast<std::size_t>(side)];
        for (std::size_t m = 0; m < M; ++m) passed.mass[tile_.materials[m]] += out * fluxes_.flux[C::mass(m)][at];
        for (int e = 0; e < 3; ++e) passed.momentum[e] += out * fluxes_.flux[C::motion(e)][at];
        passed.energy += out * fluxes_.flux[C::energy][at];
    }

    /// Writes the block's cells as they are after the step.
    void store()
    {
        BlockStore<M> to(tile_, grid_, block_, laws_, length_);
        for_rows(0, [&](std::ptrdiff_t j, std::ptrdiff_t k) {
            to.store_row(static_cast<std::size_t>(j), static_cast<std::size_t>(k), tile_.at(0, j, k), burning_);
        });
    }

    EulerTile& tile_;
    EulerGrid& grid_;
    const EulerBlock& block_;
    double length_;
    BlockWalls walls_;
    bool burning_ = false;
    std::array<MieGrueneisen, M> laws_;
    std::array<FaceRows, 3> faces_;
    FluxRows<M> fluxes_;
    EulerRows<M> unburnt_flux_;
    EulerPassages passages_{};
};

}  // namespace

EulerPassages flow_block(EulerTile& tile, EulerGrid& grid, const EulerBlock& block, double length)
{
    return with_count(tile.materials.size(), [&](auto count) { return BlockFlow<count()>(tile, grid, block, length).run(); });
}

}  // namespace corpuscle
