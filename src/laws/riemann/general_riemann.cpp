#include "laws/riemann/general_riemann.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "math/root.hpp"

namespace corpuscle {

namespace {

GasSide mirrored(GasSide side)
{
    side.velocity = -side.velocity;
    return side;
}

/// Nothing, where a gas has been, at the speed of its edge.
GasSide nothing(const GasSide& side, double velocity)
{
    return {side.law, 0, velocity, 0};
}

/// Refuses a state that no gas can have.
void check(const GasSide& side, const char* name)
{
    if (side.density == 0) return;
    check(side.law, fmt::format("Riemann problem, {} state", name));
    if (side.density > 0 && side.density < largest_density(side.law) && side.pressure > 0 && side.energy() > 0) return;
    throw InputError(fmt::format("Riemann problem: {} state (density {:g}, pressure {:g}, law {}) is no gas", name, side.density,
                                 side.pressure, law_name(side.law)),
                     "give density and pressure > 0, a density the law is meant for and a pressure above its cold one");
}

/// Density behind a shock that takes the gas to a pressure: the root of the Hugoniot between the density ahead and the law's largest.
double shocked_density(const GasSide& ahead, double energy_ahead, double pressure)
{
    const auto miss = [&](double density) {
        return energy(ahead.law, density, pressure) - energy_ahead - 0.5 * (pressure + ahead.pressure) * (1 / ahead.density - 1 / density);
    };
    double low = ahead.density, high = low;
    while (miss(high) > 0) {
        if (high >= largest_density(ahead.law))
            throw InputError(
                fmt::format("no shock to {:g} Pa from density {:g} kg/m3 within law {}", pressure, ahead.density, law_name(ahead.law)),
                "expected states within the law's range");
        low = high;
        high = std::min(1.1 * high, largest_density(ahead.law));
    }
    return high > low ? find_root(miss, low, high) : low;
}

/// Pressure at the interface: the root of the closing speed, which falls as pressure grows; sought in log p.
template <class Closing>
double interface_pressure(const Closing& closing, double low, double high)
{
    const auto miss = [&](double log_pressure) { return closing(std::exp(log_pressure)); };
    low *= 1 - 1e-6;  // so that round-off does not close the bracket where both sides are alike
    high *= 1 + 1e-6;
    while (closing(low) < 0) low *= 1e-3;
    while (closing(high) > 0) high *= 1.5;
    return std::exp(find_root(miss, std::log(low), std::log(high)));
}

}  // namespace

double GasSide::energy() const
{
    return density == 0 ? 0.0 : corpuscle::energy(law, density, pressure);
}

double GasSide::sound_speed() const
{
    return density == 0 ? 0.0 : corpuscle::sound_speed(law, density, energy());
}

GeneralRiemannSolution::Half::Half(const GasSide& side) : ahead_(side), energy_(side.energy())
{
    if (!empty()) expansion_.emplace(side.law, side.density, energy_);
}

GasSide GeneralRiemannSolution::Half::shocked(double pressure) const
{
    const double density = shocked_density(ahead_, energy_, pressure);
    const double loss = std::sqrt(std::max(0.0, (pressure - ahead_.pressure) * (1 / ahead_.density - 1 / density)));
    return {ahead_.law, density, ahead_.velocity - loss, pressure};
}

GasSide GeneralRiemannSolution::Half::expanded(const Isentrope::Point& point) const
{
    return {ahead_.law, point.density, ahead_.velocity + point.gain, point.pressure};
}

GasSide GeneralRiemannSolution::Half::behind(double pressure) const
{
    return pressure > ahead_.pressure ? shocked(pressure) : expanded(expansion_->at_pressure(pressure));
}

double GeneralRiemannSolution::Half::wave_speed(double pressure) const
{
    if (empty()) return ahead_.velocity;
    if (!(pressure > ahead_.pressure * (1 + 1e-12))) return ahead_.velocity - ahead_.sound_speed();
    const double density = shocked(pressure).density;
    const double mass_flux = std::sqrt((pressure - ahead_.pressure) / (1 / ahead_.density - 1 / density));
    return ahead_.velocity - mass_flux / ahead_.density;
}

GasSide GeneralRiemannSolution::Half::at(double star, double speed) const
{
    if (empty()) return nothing(ahead_, ahead_.velocity);
    if (speed <= wave_speed(star)) return ahead_;
    if (star > ahead_.pressure) return shocked(star);
    const double won = speed - ahead_.velocity;
    if (star == 0 && won >= escape_speed()) return nothing(ahead_, ahead_.velocity + escape_speed());
    const double last = star > 0 ? expansion_->at_pressure(star).density : ahead_.density * 1e-200;
    return expanded(expansion_->on_ray(won, last));
}

GeneralRiemannSolution::GeneralRiemannSolution(const GasSide& left, const GasSide& right)
    : left_((check(left, "left"), left)), right_mirrored_((check(right, "right"), mirrored(right)))
{
    const double opening = right.velocity - left.velocity;
    vacuum_ = left_.empty() || right_mirrored_.empty() || opening >= left_.escape_speed() + right_mirrored_.escape_speed();
    if (vacuum_) {
        velocity_ = left_.empty() ? right.velocity - right_mirrored_.escape_speed() : left.velocity + left_.escape_speed();
        return;
    }
    const auto closing = [&](double p) { return left_.behind(p).velocity + right_mirrored_.behind(p).velocity; };
    pressure_ = interface_pressure(closing, std::min(left.pressure, right.pressure), std::max(left.pressure, right.pressure));
    velocity_ = 0.5 * (left_.behind(pressure_).velocity - right_mirrored_.behind(pressure_).velocity);
}

double GeneralRiemannSolution::star_density_left() const
{
    return vacuum_ ? 0.0 : left_.behind(pressure_).density;
}

double GeneralRiemannSolution::star_density_right() const
{
    return vacuum_ ? 0.0 : right_mirrored_.behind(pressure_).density;
}

double GeneralRiemannSolution::left_wave_speed() const
{
    return left_.wave_speed(pressure_);
}

double GeneralRiemannSolution::right_wave_speed() const
{
    return -right_mirrored_.wave_speed(pressure_);
}

GasSide GeneralRiemannSolution::at(double speed) const
{
    if (vacuum_) {
        const GasSide from_left = left_.at(0, speed);
        return from_left.density > 0 ? from_left : mirrored(right_mirrored_.at(0, -speed));
    }
    if (speed < velocity_) return left_.at(pressure_, speed);
    return mirrored(right_mirrored_.at(pressure_, -speed));
}

}  // namespace corpuscle
