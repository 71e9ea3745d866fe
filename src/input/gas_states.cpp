#include "input/gas_states.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "input/build_gas.hpp"

namespace corpuscle {

namespace {

constexpr double gas_constant = 8.31446261815324;  // [J/(mol K)], CODATA 2018

EquationOfState law_of(const GasValues& values, double density)
{
    if (values.law) return make_law(*values.law, values.reference_density.value_or(density));
    if (values.co_volume) return NobleAbel{*values.gamma, *values.co_volume, values.reference_density.value_or(density)};
    return IdealGas{*values.gamma};
}

/// R T / M [J/kg] = p/rho of the gas when it is thin.
double thermal_energy(const GasValues& values, double temperature)
{
    if (!values.molar_mass)
        throw InputError(fmt::format("the gas '{}' has a temperature but no molar mass", values.name),
                         "expected molar_mass, or a pressure in place of the temperature");
    return gas_constant * temperature / *values.molar_mass;
}

/// The state of a density and a specific energy, refused if the law does not hold there.
GasState checked_state(const GasValues& values, const EquationOfState& law, double density, double energy_per_mass)
{
    check(law, values.name);
    if (density > largest_density(law))
        throw InputError(fmt::format("density {:.4g} kg/m3 is beyond what the law of gas '{}' allows", density, values.name),
                         fmt::format("expected at most {:.4g} kg/m3", largest_density(law)));
    const double p = pressure(law, density, energy_per_mass);
    if (!(energy_per_mass > 0) || !(p > 0))
        throw InputError(fmt::format("the gas '{}' cannot have this pressure at {:.4g} kg/m3: its energy would be {:.4g} J/kg", values.name,
                                     density, energy_per_mass),
                         "expected a larger pressure or a smaller density");
    return {law, density, p, energy_per_mass};
}

}  // namespace

GasState usual_state(const GasValues& values)
{
    const bool by_temperature = values.temperature && values.molar_mass;
    if (!values.density && !(values.pressure && by_temperature))
        throw InputError(fmt::format("the gas '{}' has no usual state", values.name), "expected its density, and pressure or temperature");
    const double density = values.density ? *values.density : *values.pressure / thermal_energy(values, *values.temperature);
    const EquationOfState law = law_of(values, density);
    if (values.pressure) return checked_state(values, law, density, energy(law, density, *values.pressure));
    if (!values.temperature)
        throw InputError(fmt::format("the gas '{}' has a density but neither pressure nor temperature", values.name),
                         "expected one of them");
    return checked_state(values, law, density, thermal_energy(values, *values.temperature) / (heat_capacity_ratio(law) - 1));
}

GasState state_of(const FillInput& fill)
{
    const GasValues& values = *fill.gas.values;
    const EquationOfState law = law_of(values, values.density.value_or(fill.density));
    if (fill.pressure) return checked_state(values, law, fill.density, energy(law, fill.density, *fill.pressure));
    if (fill.energy_density) return checked_state(values, law, fill.density, *fill.energy_density / fill.density);
    return checked_state(values, law, fill.density, thermal_energy(values, *fill.temperature) / (heat_capacity_ratio(law) - 1));
}

}  // namespace corpuscle
