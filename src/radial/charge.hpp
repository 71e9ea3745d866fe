#pragma once

#include "radial/flow.hpp"

namespace corpuscle {

/// A spherical (or cylindrical, or plane) charge and the gas around it.
struct RadialCharge {
    EquationOfState products;
    double density = 0;              ///< of the explosive [kg/m3]
    double energy = 0;               ///< of detonation, specific [J/kg]
    double detonation_velocity = 0;  ///< lit at the centre; 0: all of it burnt at once at time 0 [m/s]
    double radius = 0;               ///< [m]

    EquationOfState ambient;
    double ambient_density = 0;   ///< [kg/m3]
    double ambient_pressure = 0;  ///< [Pa]
};

/// How finely a charge and its surroundings are cut.
struct RadialCells {
    double per_radius = 100;    ///< cells of the explosive's inner part, and of the air next to it, in a radius of the charge
    double surface_ratio = 30;  ///< how much narrower the explosive's cells are at its surface, where they expand most
    double growth_power = 0.5;  ///< the air's cells grow with the radius to this power
};

/// Radius of a ball of a mass [kg] and a density [kg/m3].
[[nodiscard]] double ball_radius(double mass, double density);

/// The flow before it starts, out to a radius [m]: gas 0 is the explosive, gas 1 what surrounds it.
[[nodiscard]] RadialFlow lay_charge(const RadialCharge& charge, const RadialCells& cells, double reach,
                                    Symmetry symmetry = Symmetry::spherical);

}  // namespace corpuscle
