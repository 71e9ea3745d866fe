#pragma once

#include <cmath>

namespace corpuscle {

/// Detonation products after Jones, Wilkins and Lee, with V = rho0/rho and E the energy per volume of unreacted explosive:
///     p = A (1 - w/(R1 V)) exp(-R1 V) + B (1 - w/(R2 V)) exp(-R2 V) + w E/V.
/// The last term is the pressure of particles with gamma = 1 + w; the first two depend on density alone: the virial part.
/// Source: Lee, Hornig & Kury, UCRL-50422 (1968). Fitted to expansion from the detonation front (V about 0.7) outwards.
struct Jwl {
    double a = 0;                    ///< A [Pa]
    double b = 0;                    ///< B [Pa]
    double r1 = 1;                   ///< R1 [1]
    double r2 = 1;                   ///< R2 [1]
    double omega = 0.3;              ///< w, 0 < w <= 2/3 [1]
    double reference_density = 1.0;  ///< rho0, of the unreacted explosive [kg/m3]

    [[nodiscard]] constexpr double heat_capacity_ratio() const { return 1 + omega; }

    /// Densities where the law is meant to hold: to V = 1/2, far beyond the front of a steady detonation [kg/m3].
    [[nodiscard]] constexpr double largest_density() const { return 2 * reference_density; }

    /// Pressure at no energy [Pa]; nothing at density zero.
    template <class Real>
    [[nodiscard]] Real cold_pressure(Real density) const
    {
        const Real compression = density * static_cast<Real>(1 / reference_density);
        const Real expansion = Real(1) / compression;
        const Real first =
            (static_cast<Real>(a) - static_cast<Real>(a * omega / r1) * compression) * std::exp(static_cast<Real>(-r1) * expansion);
        const Real second =
            (static_cast<Real>(b) - static_cast<Real>(b * omega / r2) * compression) * std::exp(static_cast<Real>(-r2) * expansion);
        return first + second;
    }

    /// Pressure beyond the kinetic one [Pa].
    template <class Real>
    [[nodiscard]] Real virial_pressure(Real density, Real /*kinetic_pressure*/) const
    {
        return cold_pressure(density);
    }

    /// Pressure [Pa] at a density [kg/m3] and a specific energy [J/kg].
    [[nodiscard]] double pressure(double density, double energy) const { return cold_pressure(density) + omega * density * energy; }

    /// Specific energy [J/kg] at a density [kg/m3] and a pressure [Pa].
    [[nodiscard]] double energy(double density, double pressure) const { return (pressure - cold_pressure(density)) / (omega * density); }

    /// Isentropic speed of sound, c^2 = dp/drho at fixed e + p/rho^2 dp/de at fixed rho [m/s].
    [[nodiscard]] double sound_speed(double density, double energy) const
    {
        const double expansion = reference_density / density;
        const double slope = cold_slope(a, r1, expansion) + cold_slope(b, r2, expansion) + omega * energy;
        return std::sqrt(slope + omega * pressure(density, energy) / density);
    }

private:
    /// Derivative by density of K (1 - w/(R V)) exp(-R V) [m2/s2].
    [[nodiscard]] double cold_slope(double factor, double rate, double expansion) const
    {
        const double by_expansion = omega / (rate * expansion * expansion) - rate + omega / expansion;
        return -factor * std::exp(-rate * expansion) * by_expansion * expansion * expansion / reference_density;
    }
};

}  // namespace corpuscle
