#include "laws/eos/chapman_jouguet.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "math/root.hpp"

namespace corpuscle {

namespace {

/// An unreacted explosive and the law of its products.
struct Front {
    const EquationOfState& law;
    double density;  ///< [kg/m3]
    double energy;   ///< [J/kg]

    /// Pressure [Pa] of the products at `behind` [kg/m3] that keeps energy across the front, e - e0 = p (v0 - v)/2; p is linear in e in
    /// every law.
    [[nodiscard]] double hugoniot_pressure(double behind) const
    {
        const double cold = corpuscle::pressure(law, behind, 0);
        const double hot = corpuscle::pressure(law, behind, energy) - cold;
        return (cold + hot) / (1 - 0.5 * hot / energy * shrinkage(behind));
    }

    /// v0 - v [m3/kg].
    [[nodiscard]] double shrinkage(double behind) const { return 1 / density - 1 / behind; }

    /// Flow speed behind the front, squared, over sound speed squared, less one: positive where the flow is supersonic.
    [[nodiscard]] double excess(double behind) const
    {
        const double p = hugoniot_pressure(behind);
        const double sound = sound_speed(law, behind, energy + 0.5 * p * shrinkage(behind));
        const double mass_flux_squared = p / shrinkage(behind);
        return mass_flux_squared / (behind * behind * sound * sound) - 1;
    }
};

}  // namespace

ChapmanJouguet chapman_jouguet(const EquationOfState& law, double density, double energy)
{
    const Front front{law, density, energy};
    const double last = std::min(2 * density, 0.999 * largest_density(law));
    constexpr int pieces = 1000;
    const bool plausible = density > 0 && energy > 0 && last > density;
    double low = density * (1 + 1e-6);
    for (int i = 1; plausible && i <= pieces; ++i) {
        const double high = density + (last - density) * i / pieces;
        if (front.excess(low) > 0 && !(front.excess(high) > 0)) {
            ChapmanJouguet state;
            state.density = find_root([&](double behind) { return front.excess(behind); }, low, high);
            state.pressure = front.hugoniot_pressure(state.density);
            state.particle_velocity = std::sqrt(state.pressure * front.shrinkage(state.density));
            state.detonation_velocity = std::sqrt(state.pressure / front.shrinkage(state.density)) / density;
            state.energy = energy + 0.5 * state.pressure * front.shrinkage(state.density);
            return state;
        }
        low = high;
    }
    throw InputError(fmt::format("no steady detonation: density {:g} kg/m3 with {:g} J/kg under law {}", density, energy, law_name(law)),
                     "check the constants and the energy of the explosive");
}

double energy_on_isentrope(const EquationOfState& law, double density, double energy, double to_density, int steps)
{
    const double step = std::log(to_density / density) / steps;
    const auto slope = [&](double log_density, double e) { return pressure(law, std::exp(log_density), e) / std::exp(log_density); };
    double e = energy;
    for (int i = 0; i < steps; ++i) {
        const double at = std::log(density) + i * step;
        const double k1 = slope(at, e);
        const double k2 = slope(at + 0.5 * step, e + 0.5 * step * k1);
        const double k3 = slope(at + 0.5 * step, e + 0.5 * step * k2);
        const double k4 = slope(at + step, e + step * k3);
        e += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return e;
}

}  // namespace corpuscle
