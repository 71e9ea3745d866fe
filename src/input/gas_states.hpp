#pragma once

#include "input/case/gas_input.hpp"
#include "laws/eos/equation_of_state.hpp"

namespace corpuscle {

/// A gas at a state.
struct GasState {
    EquationOfState law;
    double density = 0;          ///< [kg/m3]
    double pressure = 0;         ///< [Pa]
    double energy_per_mass = 0;  ///< [J/kg]
};

/// The state a gas usually has: from two of its density, pressure and temperature. Errors: InputError if they do not say it.
[[nodiscard]] GasState usual_state(const GasValues& values);

/// The state a fill asks for, by two of density, pressure and temperature, by density and energy, or the usual one. Errors: InputError if
/// it says too little or too much, or the gas cannot have it.
[[nodiscard]] GasState state_of(const FillInput& fill);

}  // namespace corpuscle
