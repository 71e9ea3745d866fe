#include <algorithm>
#include <cmath>

#include "euler/block_flow.hpp"
#include "euler/primitive_row.hpp"
#include "euler/with_count.hpp"

namespace corpuscle {

namespace {

/// The signal of a row of the block's cells.
template <std::size_t M>
double row_signal(const EulerTile& tile, const EulerGrid& grid, const std::array<std::size_t, 3>& begin, std::size_t j, std::size_t k)
{
    using P = Primitive<M>;
    using C = Conserved<M>;
    const std::size_t count = tile.axes[0].cells, first = grid.cell(begin[0], begin[1] + j, begin[2] + k);
    std::array<MieGrueneisen, M> laws;
    ConservedRow<M> from{};
    PrimitiveRow<M> to{};
    EulerRows<P::count> found;
    EulerRows<M> shares;
    for (std::size_t m = 0; m < M; ++m) {
        const std::size_t material = tile.materials[m];
        laws[m] = grid.laws[material];
        from[C::mass(m)] = grid.now.mass[material].data() + first;
        for (std::size_t i = 0; M > 1 && i < count; ++i) shares[m][i] = share_of(grid.now, material, first + i);
        from[C::share(m)] = shares[m].data();
    }
    for (int d = 0; d < 3; ++d) from[C::motion(d)] = grid.now.motion[d].data() + first;
    from[C::energy] = grid.now.energy.data() + first;
    for (std::size_t q = 0; q < P::count; ++q) to[q] = found[q].data();
    find_primitives<M>(laws, grid.pressure_floor, count, from, to);
    std::array<double, longest_row> signal{};
    const std::array<std::size_t, 3> at{0, j, k};
    for_simd(count, [&](std::size_t i) {
        const Mixture<M> all = mixture<M>(laws, to, i);
        const double sound = std::sqrt(all.stiffness(found[P::pressure][i]) / all.density);
        double sum = 0;
        for (int d = 0; d < 3; ++d) {
            const double u = found[P::velocity(d)][i], speed = u < 0 ? -u : u;
            sum += (speed + sound) * tile.axes[d].larger_face[tile.axes[d].halo + at[d] + (d == 0 ? i : 0)];
        }
        signal[i] = sum;
    });
    double most = 0;
    for (std::size_t i = 0; i < count; ++i) most = std::max(most, signal[i]);
    return most;
}

}  // namespace

double find_signal(const EulerTile& tile, const EulerGrid& grid, const EulerBlock& block)
{
    return with_count(tile.materials.size(), [&](auto count) {
        double most = 0;
        for (std::size_t k = 0; k < tile.axes[2].cells; ++k) {
            for (std::size_t j = 0; j < tile.axes[1].cells; ++j) most = std::max(most, row_signal<count()>(tile, grid, block.begin, j, k));
        }
        return most;
    });
}

}  // namespace corpuscle
