#pragma once

#include <cmath>
#include <limits>

namespace corpuscle {

/// Ideal gas, p = (gamma - 1) rho e. Kinetic particles alone give this pressure: the virial part is nothing.
struct IdealGas {
    double gamma = 1.4;  ///< heat capacity ratio, 1 < gamma <= 5/3

    [[nodiscard]] constexpr double heat_capacity_ratio() const { return gamma; }

    /// Densities where the law is meant to hold: any. [kg/m3]
    [[nodiscard]] constexpr double largest_density() const { return std::numeric_limits<double>::infinity(); }

    /// Pressure beyond the kinetic one [Pa].
    template <class Real>
    [[nodiscard]] constexpr Real virial_pressure(Real /*density*/, Real /*kinetic_pressure*/) const
    {
        return Real(0);
    }

    /// Pressure [Pa] at a density [kg/m3] and a specific energy [J/kg].
    [[nodiscard]] constexpr double pressure(double density, double energy) const { return (gamma - 1) * density * energy; }

    /// Specific energy [J/kg] at a density [kg/m3] and a pressure [Pa].
    [[nodiscard]] constexpr double energy(double density, double pressure) const { return pressure / ((gamma - 1) * density); }

    /// Isentropic speed of sound [m/s].
    [[nodiscard]] double sound_speed(double /*density*/, double energy) const { return std::sqrt(gamma * (gamma - 1) * energy); }
};

}  // namespace corpuscle
