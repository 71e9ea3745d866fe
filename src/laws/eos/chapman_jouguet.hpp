#pragma once

#include "laws/eos/equation_of_state.hpp"

namespace corpuscle {

/// State of the products right behind a steady plane detonation front.
struct ChapmanJouguet {
    double detonation_velocity = 0;  ///< D [m/s]
    double pressure = 0;             ///< [Pa]
    double density = 0;              ///< [kg/m3]
    double particle_velocity = 0;    ///< in the frame of the unreacted explosive [m/s]
    double energy = 0;               ///< specific [J/kg]
};

/// The front's state for an explosive at rest, without pressure, of a density [kg/m3] and a specific energy of detonation [J/kg]:
/// mass, momentum and energy kept across the front, and the flow behind it leaves at the speed of sound (Chapman 1899, Jouguet 1905).
/// Throws InputError if the law has no such state up to twice the explosive's density.
[[nodiscard]] ChapmanJouguet chapman_jouguet(const EquationOfState& law, double density, double energy);

/// Specific energy [J/kg] at `to_density` of a gas that expands without heat from a density [kg/m3] and a specific energy [J/kg]:
/// de/drho = p/rho^2, integrated by the classical Runge-Kutta rule in `steps` equal steps of log(rho).
[[nodiscard]] double energy_on_isentrope(const EquationOfState& law, double density, double energy, double to_density, int steps = 400);

}  // namespace corpuscle
