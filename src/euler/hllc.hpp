#pragma once

#include "euler/primitive_row.hpp"

namespace corpuscle {

/// Fluxes through a row of faces: those of the conserved numbers, of the shares of volume, and of volume itself.
template <std::size_t M>
struct FluxRows {
    EulerRows<Conserved<M>::count> flux;
    std::array<double, longest_row> volume;  ///< velocity that carries volume through the face [m/s]
};

/// Fluxes across axis `d` between face states `left` and `right` of each of `count` faces: the approximate Riemann solver with three
/// waves of Toro, Spruce and Speares (HLLC, Shock Waves 4 (1994) 25) with Davis' speeds of the outer ones. Mass, momentum and energy are
/// carried by the same volume velocity as the shares, so that a contact in equal pressure and velocity stays so.
template <std::size_t M, class Row>
void find_fluxes(const std::array<MieGrueneisen, M>& laws, int d, std::size_t count, const Row& left, const Row& right, FluxRows<M>& out)
{
    using P = Primitive<M>;
    using C = Conserved<M>;
    const int s = (d + 1) % 3, t = (d + 2) % 3;
    for_simd(count, [&](std::size_t i) {
        const Mixture<M> l = mixture<M>(laws, left, i), r = mixture<M>(laws, right, i);
        const double pl = left[P::pressure][i], pr = right[P::pressure][i];
        const double ul = left[P::velocity(d)][i], ur = right[P::velocity(d)][i];
        const double cl = std::sqrt(l.stiffness(pl) / l.density), cr = std::sqrt(r.stiffness(pr) / r.density);
        const double slowest = ul - cl < ur - cr ? ul - cl : ur - cr, fastest = ul + cl > ur + cr ? ul + cl : ur + cr;
        const double push_l = l.density * (slowest - ul), push_r = r.density * (fastest - ur);
        const double contact = (pr - pl + push_l * ul - push_r * ur) / (push_l - push_r);
        const bool from_left = contact >= 0;
        const double u = from_left ? ul : ur, p = from_left ? pl : pr, density = from_left ? l.density : r.density;
        const double wave = from_left ? slowest : fastest;
        const bool whole = from_left ? slowest >= 0 : fastest <= 0;  // all waves go one way: the flux of the state itself
        const double speed = whole ? u : contact;
        const double relative = wave - u, squeeze = relative / (wave - speed);
        const double pressure = p + density * relative * (speed - u);
        const double volume = squeeze * speed, mass = density * volume;
        const double us = from_left ? left[P::velocity(s)][i] : right[P::velocity(s)][i];
        const double ut = from_left ? left[P::velocity(t)][i] : right[P::velocity(t)][i];
        const double inverse_gamma = from_left ? l.inverse_gamma : r.inverse_gamma, cold = from_left ? l.cold : r.cold;
        const double energy = inverse_gamma * p - cold + 0.5 * density * (u * u + us * us + ut * ut);
        const double star_energy = squeeze * (energy + (speed - u) * (density * speed + p / relative));
        for (std::size_t m = 0; m < M; ++m) {
            const double share = M == 1 ? 1.0 : from_left ? left[P::share(m)][i] : right[P::share(m)][i];
            const double own = from_left ? left[P::density(m)][i] : right[P::density(m)][i];
            out.flux[C::share(m)][i] = share * volume;
            out.flux[C::mass(m)][i] = share * own * volume;
            const double own_cold = from_left ? left[P::cold(m)][i] : right[P::cold(m)][i];
            if (M > 1) out.flux[C::part(m)][i] = share * (laws[m].inverse_gamma(own) * p - own_cold) * volume;
        }
        out.flux[C::motion(d)][i] = mass * speed + pressure;
        out.flux[C::motion(s)][i] = mass * us;
        out.flux[C::motion(t)][i] = mass * ut;
        out.flux[C::energy][i] = (star_energy + pressure) * speed;
        out.volume[i] = volume;
    });
}

}  // namespace corpuscle
