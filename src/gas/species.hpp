#pragma once

#include <string>

#include "laws/eos/equation_of_state.hpp"

namespace corpuscle {

/// A gas of particles of one mass.
struct Species {
    std::string name;
    EquationOfState law;
    double particle_mass = 0;      ///< [kg]
    double internal_freedoms = 0;  ///< zeta = (5 - 3 gamma)/(gamma - 1) of one particle
    double molar_mass = 0;         ///< of its molecules [kg/mol]; 0: not known, so it has no temperature
    double radius = 0;             ///< of a particle as a hard sphere; unused by other rules of collision [m]
};

/// Internal degrees of freedom that give a gas the heat capacity ratio gamma, 1 < gamma <= 5/3 (equipartition).
[[nodiscard]] constexpr double internal_freedoms(double gamma)
{
    return (5 - 3 * gamma) / (gamma - 1);
}

/// Share of the thermal energy that is translational at equilibrium, xi = 3 (gamma - 1)/2.
[[nodiscard]] constexpr double translational_share(double gamma)
{
    return 1.5 * (gamma - 1);
}

}  // namespace corpuscle
