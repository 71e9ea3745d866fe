#include "laws/riemann/riemann.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "math/root.hpp"

namespace corpuscle {

namespace {

/// Volume the molecules move in, v - b [m3/kg].
double free_volume(const RiemannSide& side)
{
    return 1 / side.density - side.co_volume;
}

/// Fastest speed a gas gains by expanding into nothing, 2 c (1 - b rho)/(gamma - 1) [m/s].
double escape_speed(const RiemannSide& side)
{
    if (side.density == 0) return 0;
    return 2 * side.sound_speed() * (1 - side.co_volume * side.density) / (side.gamma - 1);
}

/// Speed a left gas loses when a wave takes it to a pressure (negative: gains): Toro's f_K.
double velocity_loss(const RiemannSide& side, double pressure)
{
    const double g = side.gamma;
    if (pressure > side.pressure) {
        return (pressure - side.pressure) * std::sqrt(2 * free_volume(side) / ((g + 1) * pressure + (g - 1) * side.pressure));
    }
    return escape_speed(side) * std::expm1((g - 1) / (2 * g) * std::log(pressure / side.pressure));
}

/// Free volume v - b behind the wave that takes the gas to a pressure: Hugoniot or isentrope.
double free_volume_behind(const RiemannSide& side, double pressure)
{
    const double g = side.gamma;
    if (pressure > side.pressure) {
        return free_volume(side) * ((g - 1) * pressure + (g + 1) * side.pressure) / ((g + 1) * pressure + (g - 1) * side.pressure);
    }
    return free_volume(side) * std::pow(side.pressure / pressure, 1 / g);
}

/// The gas of a left side behind a wave that takes it to a pressure.
RiemannSide behind(const RiemannSide& side, double pressure)
{
    RiemannSide state = side;
    state.pressure = pressure;
    state.density = 1 / (free_volume_behind(side, pressure) + side.co_volume);
    state.velocity = side.velocity - velocity_loss(side, pressure);
    return state;
}

/// Speed of a shock that runs leftwards into the gas and leaves a pressure behind.
double shock_speed(const RiemannSide& side, double pressure)
{
    const double g = side.gamma;
    const double mass_flux = std::sqrt(((g + 1) * pressure + (g - 1) * side.pressure) / (2 * free_volume(side)));
    return side.velocity - mass_flux / side.density;
}

/// Nothing, where a gas has been.
RiemannSide nothing(const RiemannSide& side, double velocity)
{
    RiemannSide state = side;
    state.density = state.pressure = 0;
    state.velocity = velocity;
    return state;
}

/// State inside a rarefaction that runs leftwards, on the ray u - c = speed; `lowest` is the pressure at its tail.
RiemannSide inside_fan(const RiemannSide& side, double lowest, double speed)
{
    const auto miss = [&](double log_pressure) {
        const RiemannSide state = behind(side, std::exp(log_pressure));
        return state.velocity - state.sound_speed() - speed;
    };
    const double floor = std::max(lowest, side.pressure * 1e-280);
    if (!(miss(std::log(side.pressure)) < 0)) return side;
    if (!(miss(std::log(floor)) > 0)) return behind(side, floor);
    return behind(side, std::exp(find_root(miss, std::log(floor), std::log(side.pressure))));
}

/// State on a ray left of the interface. `star` is the pressure at the interface, 0 if the gas ends in nothing at speed `interface`.
RiemannSide left_of_interface(const RiemannSide& side, double star, double interface, double speed)
{
    if (side.density == 0) return nothing(side, interface);
    if (star > side.pressure) return speed < shock_speed(side, star) ? side : behind(side, star);
    if (speed <= side.velocity - side.sound_speed()) return side;
    if (star > 0) {
        const RiemannSide tail = behind(side, star);
        if (speed >= tail.velocity - tail.sound_speed()) return tail;
    } else if (speed >= side.velocity + escape_speed(side)) {
        return nothing(side, interface);
    }
    return inside_fan(side, star, speed);
}

RiemannSide mirrored(RiemannSide side)
{
    side.velocity = -side.velocity;
    return side;
}

/// Refuses a state that no gas can have.
void check(const RiemannSide& side, const char* name)
{
    if (side.density == 0) return;
    if (side.density > 0 && side.pressure > 0 && side.gamma > 1 && side.co_volume >= 0 && side.co_volume * side.density < 1) return;
    throw InputError(fmt::format("Riemann problem: {} state (density {:g}, pressure {:g}, gamma {:g}, co-volume {:g}) is no gas", name,
                                 side.density, side.pressure, side.gamma, side.co_volume),
                     "give density and pressure > 0, gamma > 1 and density * co-volume < 1");
}

/// Pressure at the interface: the root of f_L + f_R + u_R - u_L, which grows with pressure; sought in log p.
double interface_pressure(const RiemannSide& left, const RiemannSide& right_mirrored)
{
    const double closing = left.velocity + right_mirrored.velocity;
    const auto miss = [&](double log_pressure) {
        const double p = std::exp(log_pressure);
        return velocity_loss(left, p) + velocity_loss(right_mirrored, p) - closing;
    };
    double low = std::min(left.pressure, right_mirrored.pressure);
    double high = std::max(left.pressure, right_mirrored.pressure);
    while (miss(std::log(low)) > 0) low *= 1e-3;
    while (miss(std::log(high)) < 0) high *= 10;
    return std::exp(find_root(miss, std::log(low), std::log(high)));
}

/// One Newton step in p itself: brings the star pressure from the last bits of log p to those of p.
double polished(const RiemannSide& left, const RiemannSide& right_mirrored, double pressure)
{
    const double closing = left.velocity + right_mirrored.velocity;
    const auto miss = [&](double p) { return velocity_loss(left, p) + velocity_loss(right_mirrored, p) - closing; };
    const double slope = (miss(pressure * (1 + 1e-6)) - miss(pressure * (1 - 1e-6))) / (2e-6 * pressure);
    return pressure - miss(pressure) / slope;
}

}  // namespace

double RiemannSide::sound_speed() const
{
    return density == 0 ? 0.0 : std::sqrt(gamma * pressure / (density * (1 - co_volume * density)));
}

double RiemannSide::energy() const
{
    return density == 0 ? 0.0 : pressure * free_volume(*this) / (gamma - 1);
}

RiemannSide riemann_side(const NobleAbel& law, double density, double velocity, double pressure)
{
    return {density, velocity, pressure, law.gamma, law.specific_co_volume()};
}

RiemannSolution::RiemannSolution(const RiemannSide& left, const RiemannSide& right) : left_(left), right_mirrored_(mirrored(right))
{
    check(left, "left");
    check(right, "right");
    const double opening = right.velocity - left.velocity;
    vacuum_ = left.density == 0 || right.density == 0 || opening >= escape_speed(left) + escape_speed(right);
    if (vacuum_) {
        velocity_ = left.density == 0 ? right.velocity - escape_speed(right) : left.velocity + escape_speed(left);
        return;
    }
    pressure_ = polished(left_, right_mirrored_, interface_pressure(left_, right_mirrored_));
    velocity_ =
        0.5 * (left.velocity + right.velocity) + 0.5 * (velocity_loss(right_mirrored_, pressure_) - velocity_loss(left_, pressure_));
}

double RiemannSolution::star_density_left() const
{
    return vacuum_ ? 0.0 : behind(left_, pressure_).density;
}

double RiemannSolution::star_density_right() const
{
    return vacuum_ ? 0.0 : behind(right_mirrored_, pressure_).density;
}

double RiemannSolution::left_wave_speed() const
{
    return pressure_ > left_.pressure ? shock_speed(left_, pressure_) : left_.velocity - left_.sound_speed();
}

double RiemannSolution::right_wave_speed() const
{
    return -(pressure_ > right_mirrored_.pressure ? shock_speed(right_mirrored_, pressure_)
                                                  : right_mirrored_.velocity - right_mirrored_.sound_speed());
}

RiemannSide RiemannSolution::at(double speed) const
{
    if (vacuum_) {
        const RiemannSide from_left = left_of_interface(left_, 0, velocity_, speed);
        return from_left.density > 0 ? from_left : mirrored(left_of_interface(right_mirrored_, 0, -velocity_, -speed));
    }
    if (speed < velocity_) return left_of_interface(left_, pressure_, velocity_, speed);
    return mirrored(left_of_interface(right_mirrored_, pressure_, -velocity_, -speed));
}

}  // namespace corpuscle
