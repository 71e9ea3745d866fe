#include "radial/flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/error.hpp"

namespace corpuscle {

namespace {

/// Share of the time that sound, and twice the jump of velocity, take through the narrowest cell.
constexpr double cfl = 0.4;

/// Most that a step may be longer than the one before.
constexpr double growth = 1.1;

/// A burning cell takes the time in which the front passes so many cells: the burn is spread as a shock is.
constexpr double burn_cells = 2.5;

/// Speeds below this share of the speed of sound are no disturbance.
constexpr double still = 1e-9;

/// Cells beyond the last disturbed edge that are moved with it: no signal passes them in a step.
constexpr std::size_t margin = 8;

}  // namespace

RadialFlow::RadialFlow(Symmetry symmetry, const std::vector<RadialZone>& zones) : symmetry_(symmetry)
{
    for (std::size_t z = 0; z < zones.size(); ++z) lay(zones[z], static_cast<std::uint32_t>(z));
    if (mass_.empty()) throw InputError("a radial flow has no cells", "give it a zone of at least one cell");
    edge_mass_.assign(radius_.size(), 0);
    for (std::size_t i = 0; i < cells(); ++i) {
        edge_mass_[i] += 0.5 * mass_[i];
        edge_mass_[i + 1] += 0.5 * mass_[i];
    }
    area_.resize(radius_.size());
    pressure_.resize(cells());
    sound_.resize(cells());
    stress_.resize(cells());
    disturbed_ = radius_.size() - 1;
    viscous_.resize(cells());
    find_states(0);
    find_sound();
    find_disturbed();
}

void RadialFlow::lay(const RadialZone& zone, std::uint32_t gas)
{
    check(zone.law, fmt::format("zone {}", gas + 1));
    const bool ordered = zone.edges.size() > 1 && std::is_sorted(zone.edges.begin(), zone.edges.end(), std::less_equal<>());
    const bool joined = radius_.empty() || (ordered && zone.edges.front() == radius_.back());
    if (!ordered || !joined || !(zone.density > 0) || !(zone.energy > 0) || (symmetry_ != Symmetry::planar && zone.edges.front() < 0))
        throw InputError(fmt::format("zone {} of a radial flow cannot be", gas + 1),
                         "expected growing edges from where the zone before ends (not below 0), and density and energy above 0");
    laws_.push_back(zone.law);
    if (radius_.empty()) {
        radius_.push_back(zone.edges.front());
        velocity_.push_back(zone.velocity);
    } else {
        velocity_.back() = 0.5 * (velocity_.back() + zone.velocity);
    }
    for (std::size_t i = 0; i + 1 < zone.edges.size(); ++i) {
        const double inner = zone.edges[i], outer = zone.edges[i + 1];
        radius_.push_back(outer);
        velocity_.push_back(zone.velocity);
        gas_.push_back(gas);
        mass_.push_back(zone.density * volume_between(symmetry_, inner, outer));
        density_.push_back(zone.density);
        energy_.push_back(zone.energy);
        const bool explosive = zone.detonation_velocity > 0;
        burn_start_.push_back(explosive ? std::abs(inner) / zone.detonation_velocity : -1);
        burn_length_.push_back(explosive ? burn_cells * (outer - inner) / zone.detonation_velocity : 0);
        burnt_out_ = std::max(burnt_out_, burn_start_.back() + burn_length_.back());
    }
}

double RadialFlow::burnt_share(std::size_t cell, double time) const
{
    if (!(time < burn_start_[cell] + burn_length_[cell])) return 1;
    return std::max(0.0, (time - burn_start_[cell]) / burn_length_[cell]);
}

void RadialFlow::find_states(double time)
{
    for (std::size_t i = 0; i < disturbed_; ++i) {
        density_[i] = mass_[i] / volume_between(symmetry_, radius_[i], radius_[i + 1]);
        pressure_[i] = burnt_share(i, time) * pressure(laws_[gas_[i]], density_[i], energy_[i]);
    }
}

/// Growth of the velocity through a cell over its width [1/s]; beyond an end the flow is its own mirror image.
double RadialFlow::strain_rate(std::size_t cell) const
{
    return (velocity_[cell + 1] - velocity_[cell]) / (radius_[cell + 1] - radius_[cell]);
}

/// Viscous pressure of a cell that is pressed together [Pa]: the jump of pressure of a shock with the cell's jump of velocity
/// (Kurapatenko 1970), for a gas of the local exponent rho c^2/p; less the share of the jump that a smooth flow would have as well (van
/// Leer's limiter on the neighbours' strain rates).
double RadialFlow::viscous_pressure(std::size_t cell) const
{
    const double jump = velocity_[cell + 1] - velocity_[cell];
    if (!(jump < 0)) return 0;
    const double own = strain_rate(cell);
    const double inner = (cell == 0 ? own : strain_rate(cell - 1)) / own;
    const double outer = (cell + 1 == cells() ? own : strain_rate(cell + 1)) / own;
    const double smooth = std::max(0.0, std::min({0.5 * (inner + outer), 2 * inner, 2 * outer, 1.0}));
    const double sound = sound_[cell], density = density_[cell];
    const double exponent = pressure_[cell] > 0 ? std::clamp(density * sound * sound / pressure_[cell], 1.0, 5.0) : 5.0;
    const double quadratic = 0.25 * (exponent + 1) * std::abs(jump);
    return (1 - smooth) * density * (quadratic + std::sqrt(quadratic * quadratic + sound * sound)) * std::abs(jump);
}

double RadialFlow::stable_step() const
{
    double rate = 0;
    for (std::size_t i = 0; i < disturbed_; ++i) {
        const double own = (sound_[i] + 2 * std::abs(velocity_[i + 1] - velocity_[i])) / (radius_[i + 1] - radius_[i]);
        if (!(own > 0) || !std::isfinite(own))
            throw SafetyStop(fmt::format("the radial flow broke down at {:g} m, {:g} s", middle(i), time_), "give it other cells");
        rate = std::max(rate, own);
    }
    return cfl / rate;
}

double RadialFlow::next_step(double remaining)
{
    double length = stable_step();
    if (last_step_ > 0) length = std::min(length, growth * last_step_);
    last_step_ = length;
    if (remaining <= length) return remaining;
    return remaining < 2 * length ? 0.5 * remaining : length;
}

void RadialFlow::move(double length)
{
    const std::size_t last = disturbed_;
    for (std::size_t j = 1; j < last; ++j) {
        const double force = area_[j] * (stress_[j - 1] - stress_[j]);
        velocity_[j] = start_.velocity[j] + length * force / edge_mass_[j];
    }
    const auto mean_velocity = [&](std::size_t j) { return 0.5 * (start_.velocity[j] + velocity_[j]); };
    for (std::size_t j = 0; j <= last; ++j) radius_[j] = start_.radius[j] + length * mean_velocity(j);
    for (std::size_t i = 0; i < last; ++i) {
        const double expansion = area_[i + 1] * mean_velocity(i + 1) - area_[i] * mean_velocity(i);
        energy_[i] = start_.energy[i] - length * stress_[i] * expansion / mass_[i];
    }
}

void RadialFlow::step(double length)
{
    const std::size_t last = disturbed_;
    start_ = {radius_, velocity_, energy_, pressure_};
    for (std::size_t j = 0; j <= last; ++j) area_[j] = area(symmetry_, radius_[j]);
    for (std::size_t i = 0; i < last; ++i) {
        viscous_[i] = viscous_pressure(i);
        stress_[i] = pressure_[i] + viscous_[i];
    }
    move(length);
    find_states(time_ + length);
    for (std::size_t j = 0; j <= last; ++j) area_[j] = swept_area(symmetry_, start_.radius[j], radius_[j]);
    for (std::size_t i = 0; i < last; ++i) stress_[i] = 0.5 * (start_.pressure[i] + pressure_[i]) + viscous_[i];
    move(length);
    time_ += length;
    find_states(time_);
    find_sound();
    find_disturbed();
}

void RadialFlow::find_sound()
{
    for (std::size_t i = 0; i < disturbed_; ++i) sound_[i] = sound_speed(laws_[gas_[i]], density_[i], energy_[i]);
}

void RadialFlow::find_disturbed()
{
    std::size_t last = radius_.size() - 1;
    const auto felt = [&](std::size_t edge) {
        const bool face = gas_[edge - 1] != gas_[edge];
        return face || std::abs(velocity_[edge] - velocity_.back()) > still * sound_[edge - 1];
    };
    while (last > 1 && !felt(last - 1)) --last;
    disturbed_ = std::min(last + margin, radius_.size() - 1);
}

RadialContents RadialFlow::contents(int gas) const
{
    RadialContents total;
    for (std::size_t i = 0; i < cells(); ++i) {
        if (gas >= 0 && gas_[i] != static_cast<std::uint32_t>(gas)) continue;
        const double low = velocity_[i], high = velocity_[i + 1];
        total.mass += mass_[i];
        total.momentum += 0.5 * mass_[i] * (low + high);
        total.kinetic_energy += 0.25 * mass_[i] * (low * low + high * high);
        total.internal_energy += mass_[i] * energy_[i];
    }
    return total;
}

}  // namespace corpuscle
