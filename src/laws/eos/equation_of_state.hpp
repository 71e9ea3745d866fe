#pragma once

#include <string>
#include <variant>

#include "laws/eos/ideal_gas.hpp"
#include "laws/eos/jwl.hpp"
#include "laws/eos/noble_abel.hpp"

namespace corpuscle {

/// Every law of gas there is. Kernels pick one by std::visit outside their loop; the functions below serve where speed is no matter.
using EquationOfState = std::variant<IdealGas, NobleAbel, Jwl>;

/// gamma of the particles, which sets how their energy is split [1].
[[nodiscard]] double heat_capacity_ratio(const EquationOfState& law);

/// Largest density the law is meant for [kg/m3].
[[nodiscard]] double largest_density(const EquationOfState& law);

/// Pressure beyond the kinetic one [Pa] at a density [kg/m3] and a kinetic pressure [Pa].
[[nodiscard]] double virial_pressure(const EquationOfState& law, double density, double kinetic_pressure);

/// Whole pressure [Pa] at a density [kg/m3] and a specific energy [J/kg].
[[nodiscard]] double pressure(const EquationOfState& law, double density, double energy);

/// Specific energy [J/kg] at a density [kg/m3] and a pressure [Pa].
[[nodiscard]] double energy(const EquationOfState& law, double density, double pressure);

/// Isentropic speed of sound [m/s] at a density [kg/m3] and a specific energy [J/kg].
[[nodiscard]] double sound_speed(const EquationOfState& law, double density, double energy);

/// "ideal", "noble_abel" or "jwl", as written in cases.
[[nodiscard]] std::string law_name(const EquationOfState& law);

/// Refuses constants outside a law's range with an InputError that names `owner` (the gas or explosive) and the constant.
void check(const EquationOfState& law, const std::string& owner);

}  // namespace corpuscle
