#include "input/gas_states.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "input/build_gas.hpp"
#include "math/root.hpp"

namespace corpuscle {

namespace {

constexpr double gas_constant = 8.31446261815324;  // [J/(mol K)], CODATA 2018

EquationOfState law_of(const GasValues& values, double density)
{
    if (values.law) return make_law(*values.law, values.reference_density.value_or(density));
    if (values.co_volume) return NobleAbel{tidy_gamma(*values.gamma), *values.co_volume, values.reference_density.value_or(density)};
    return IdealGas{tidy_gamma(*values.gamma)};
}

/// R T / M [J/kg] = p/rho of the gas when it is thin.
double thermal_energy(const GasValues& values, double temperature)
{
    if (!values.molar_mass)
        throw InputError(fmt::format("the gas '{}' has a temperature but no molar mass", values.name),
                         "expected molar_mass, or a pressure in place of the temperature");
    return gas_constant * temperature / *values.molar_mass;
}

/// Density of a gas at a pressure and a temperature. [kg/m3]
double density_at(const GasValues& values, double pressure_wanted, double temperature)
{
    const double thermal = thermal_energy(values, temperature), thin = pressure_wanted / thermal;
    const bool open = values.co_volume || (values.law && values.law->noble_abel);
    if (open && !values.reference_density && !values.density && !(values.law && values.law->noble_abel->reference_density))
        throw InputError(fmt::format("the gas '{}' has a co-volume but no density that it is a share of", values.name),
                         "expected reference_density, or the density in place of pressure or temperature");
    const EquationOfState law = law_of(values, values.density.value_or(thin));
    if (std::holds_alternative<IdealGas>(law)) return thin;
    check(law, values.name);
    const double energy_per_mass = thermal / (heat_capacity_ratio(law) - 1), most = std::min(largest_density(law), 1e5);
    const double found = find_root([&](double density) { return pressure(law, density, energy_per_mass) - pressure_wanted; },
                                   1e-6 * std::min(thin, most), (1 - 1e-9) * most);
    if (!(found > 0))
        throw InputError(fmt::format("the gas '{}' cannot have {:.4g} Pa at {:.4g} K", values.name, pressure_wanted, temperature),
                         "expected a smaller pressure, or its density");
    return found;
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
    const double density = values.density ? *values.density : density_at(values, *values.pressure, *values.temperature);
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
    const int given = fill.density.has_value() + fill.pressure.has_value() + fill.temperature.has_value() + fill.energy_density.has_value();
    if (given == 0) return usual_state(values);
    if (given != 2 || (fill.energy_density && !fill.density))
        throw InputError(fmt::format("the fill has {} of density, pressure, temperature and energy_density", given),
                         "expected two of density, pressure and temperature, or density and energy_density");
    const double density = fill.density ? *fill.density : density_at(values, *fill.pressure, *fill.temperature);
    const EquationOfState law = law_of(values, values.density.value_or(density));
    if (fill.pressure) return checked_state(values, law, density, energy(law, density, *fill.pressure));
    if (fill.energy_density) return checked_state(values, law, density, *fill.energy_density / density);
    return checked_state(values, law, density, thermal_energy(values, *fill.temperature) / (heat_capacity_ratio(law) - 1));
}

}  // namespace corpuscle
