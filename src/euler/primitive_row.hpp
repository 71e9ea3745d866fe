#pragma once

#include <array>

#include "euler/grid.hpp"
#include "euler/quantities.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

/// Numbers of a row of cells as they are stored and as they are computed with; each points to the row's first cell.
template <std::size_t M>
using ConservedRow = std::array<const double*, Conserved<M>::count>;
template <std::size_t M>
using PrimitiveRow = std::array<double*, Primitive<M>::count>;

/// Q and Z of one material along a row; its exponentials are left out where none of it is there.
inline void find_cold_terms(const MieGrueneisen& law, std::size_t count, const double* density, const double* share, double* q, double* z)
{
    bool any = false;
    for (std::size_t i = 0; i < count; ++i) any |= share[i] > least_share;
    if (!law.cold || !any) {
        for_simd(count, [&](std::size_t i) { q[i] = 0, z[i] = 0; });
        return;
    }
    for_simd(count, [&](std::size_t i) {
        const auto terms = law.cold_terms(density[i]);
        const bool there = share[i] > least_share;
        q[i] = there ? terms.q : 0.0;
        z[i] = there ? terms.z : 0.0;
    });
}

/// Densities of the materials, velocity and pressure of a row of cells.
template <std::size_t M>
void find_primitives(const std::array<MieGrueneisen, M>& laws, double pressure_floor, std::size_t count, const ConservedRow<M>& from,
                     const PrimitiveRow<M>& to)
{
    using P = Primitive<M>;
    using C = Conserved<M>;
    for (std::size_t m = 0; m < M; ++m) {
        const MieGrueneisen& law = laws[m];
        const double *mass = from[C::mass(m)], *own = from[C::share(m)];
        double *density = to[P::density(m)], *share = to[P::share(m)];
        for_simd(count, [&](std::size_t i) {
            share[i] = M == 1 ? 1.0 : own[i];
            density[i] = phase_density(law, mass[i], share[i]);
        });
        find_cold_terms(law, count, density, share, to[P::cold(m)], to[P::stiff(m)]);
    }
    for_simd(count, [&](std::size_t i) {
        double density = 0, inverse_gamma = 0, cold = 0;
        for (std::size_t m = 0; m < M; ++m) {
            const double share = to[P::share(m)][i];
            density += from[C::mass(m)][i];
            inverse_gamma += share * laws[m].inverse_gamma(to[P::density(m)][i]);
            cold += share * to[P::cold(m)][i];
        }
        const double inverse = density > 1e-100 ? 1 / density : 0.0;
        const double px = from[C::motion(0)][i], py = from[C::motion(1)][i], pz = from[C::motion(2)][i];
        const double pressure = (from[C::energy][i] - 0.5 * inverse * (px * px + py * py + pz * pz) + cold) / inverse_gamma;
        to[P::velocity(0)][i] = px * inverse;
        to[P::velocity(1)][i] = py * inverse;
        to[P::velocity(2)][i] = pz * inverse;
        to[P::pressure][i] = pressure > pressure_floor ? pressure : pressure_floor;
    });
}

/// What a mixture of materials makes of their shares `a`, densities `r`, Q `q` and Z `z`.
template <std::size_t M>
struct Mixture {
    double density = 0;        ///< [kg/m3]
    double inverse_gamma = 0;  ///< X of the mixture
    double cold = 0;           ///< Q
    double stiff = 0;          ///< Z
    double factor = 0;         ///< G

    /// rho c^2 at a pressure; never below that of an ideal gas with gamma 1 [Pa]
    [[nodiscard]] double stiffness(double pressure) const
    {
        const double found = (stiff + factor * pressure) / inverse_gamma;
        return found > pressure ? found : pressure;
    }
};

/// The mixture in cell i of a row (of cells, or of face states).
template <std::size_t M, class Row>
inline Mixture<M> mixture(const std::array<MieGrueneisen, M>& laws, const Row& row, std::size_t i)
{
    using P = Primitive<M>;
    Mixture<M> all;
    for (std::size_t m = 0; m < M; ++m) {
        const double share = M == 1 ? 1.0 : row[P::share(m)][i], density = row[P::density(m)][i];
        all.density += share * density;
        all.inverse_gamma += share * laws[m].inverse_gamma(density);
        all.cold += share * row[P::cold(m)][i];
        all.stiff += share * row[P::stiff(m)][i];
        all.factor += share * laws[m].g;
    }
    return all;
}

}  // namespace corpuscle
