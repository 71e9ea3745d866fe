#pragma once

#include <algorithm>
#include <cmath>

namespace corpuscle {

/// Noble-Abel gas, p (V - b) = (gamma - 1) E with V = rho0/rho: molecules that keep the share b of the volume V = 1 for themselves.
/// In place of b the share phi = b rho/rho0 of the present volume is used: p = (gamma - 1) rho e/(1 - phi), phi < 1.
/// Source: Noble & Abel 1880; the particle blast method of Teng & Wang takes it for detonation products.
struct NobleAbel {
    double gamma = 1.4;              ///< heat capacity ratio, 1 < gamma <= 5/3
    double co_volume = 0;            ///< b, share of the volume at the reference density, 0 <= b < 1
    double reference_density = 1.0;  ///< rho0, of the unreacted explosive [kg/m3]

    /// Share phi above which the virial pressure is held: a crowded cell of particles must not divide by zero.
    static constexpr double crowded = 0.95;

    [[nodiscard]] constexpr double heat_capacity_ratio() const { return gamma; }

    /// Density at which the molecules fill all space, infinite for b = 0 [kg/m3].
    [[nodiscard]] constexpr double largest_density() const { return reference_density / co_volume; }

    /// Volume that a kilogram of molecules keeps for itself [m3/kg].
    [[nodiscard]] constexpr double specific_co_volume() const { return co_volume / reference_density; }

    /// Share of the volume that the molecules keep for themselves, phi [1].
    template <class Real>
    [[nodiscard]] constexpr Real filled_share(Real density) const
    {
        return static_cast<Real>(specific_co_volume()) * density;
    }

    /// Pressure beyond the kinetic one, p_k phi/(1 - phi) [Pa]; phi is held at `crowded`.
    template <class Real>
    [[nodiscard]] constexpr Real virial_pressure(Real density, Real kinetic_pressure) const
    {
        const Real share = std::min(filled_share(density), static_cast<Real>(crowded));
        return kinetic_pressure * share / (Real(1) - share);
    }

    /// Pressure [Pa] at a density [kg/m3] below the largest and a specific energy [J/kg].
    [[nodiscard]] constexpr double pressure(double density, double energy) const
    {
        return (gamma - 1) * density * energy / (1 - filled_share(density));
    }

    /// Specific energy [J/kg] at a density [kg/m3] and a pressure [Pa].
    [[nodiscard]] constexpr double energy(double density, double pressure) const
    {
        return pressure * (1 - filled_share(density)) / ((gamma - 1) * density);
    }

    /// Isentropic speed of sound, c^2 = gamma p/(rho (1 - phi)) [m/s].
    [[nodiscard]] double sound_speed(double density, double energy) const
    {
        return std::sqrt(gamma * (gamma - 1) * energy) / (1 - filled_share(density));
    }
};

}  // namespace corpuscle
