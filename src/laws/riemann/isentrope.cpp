#include "laws/riemann/isentrope.hpp"

#include <algorithm>
#include <cmath>

#include "math/root.hpp"

namespace corpuscle {

namespace {

/// Step in log(rho): the error of the rule is of its fourth power, about 1e-9.
constexpr double log_step = 0.005;

/// Virial over kinetic pressure that counts as nothing.
constexpr double negligible = 1e-12;

}  // namespace

Isentrope::Isentrope(const EquationOfState& law, double density, double energy) : law_(law)
{
    nodes_.push_back({std::log(density), energy, 0});
    constexpr std::size_t most = 20000;
    while (!ideal(nodes_.back()) && nodes_.size() < most) nodes_.push_back(stepped(nodes_.back(), -log_step));
}

bool Isentrope::ideal(const Node& node) const
{
    const double density = std::exp(node.log_density);
    const double kinetic = (heat_capacity_ratio(law_) - 1) * density * node.energy;
    return std::abs(virial_pressure(law_, density, kinetic)) <= negligible * kinetic;
}

Isentrope::Node Isentrope::slope(const Node& node) const
{
    const double density = std::exp(node.log_density);
    return {1, pressure(law_, density, node.energy) / density, -sound_speed(law_, density, node.energy)};
}

Isentrope::Node Isentrope::stepped(const Node& from, double step) const
{
    const auto moved = [&](const Node& by, double share) {
        return Node{from.log_density + share, from.energy + share * by.energy, from.gain + share * by.gain};
    };
    const Node k1 = slope(from), k2 = slope(moved(k1, 0.5 * step)), k3 = slope(moved(k2, 0.5 * step)), k4 = slope(moved(k3, step));
    return {from.log_density + step, from.energy + step / 6 * (k1.energy + 2 * (k2.energy + k3.energy) + k4.energy),
            from.gain + step / 6 * (k1.gain + 2 * (k2.gain + k3.gain) + k4.gain)};
}

/// Below the table the gas is ideal: e goes with rho^(gamma - 1), and gain + 2 c/(gamma - 1) is kept.
Isentrope::Node Isentrope::ideal_tail(double log_density) const
{
    const Node& last = nodes_.back();
    const double gamma = heat_capacity_ratio(law_);
    const double fall = (gamma - 1) * (log_density - last.log_density);
    const double sound = sound_speed(law_, std::exp(last.log_density), last.energy);
    return {log_density, last.energy * std::exp(fall), last.gain - 2 * sound / (gamma - 1) * std::expm1(0.5 * fall)};
}

Isentrope::Node Isentrope::reached(double log_density) const
{
    const double steps = (nodes_.front().log_density - log_density) / log_step;
    const auto index = static_cast<std::size_t>(std::max(0.0, steps));
    if (index + 1 >= nodes_.size()) return ideal_tail(log_density);
    return stepped(nodes_[index], log_density - nodes_[index].log_density);
}

Isentrope::Point Isentrope::point(const Node& node) const
{
    const double density = std::exp(node.log_density);
    return {density, node.energy, corpuscle::pressure(law_, density, node.energy), sound_speed(law_, density, node.energy), node.gain};
}

Isentrope::Point Isentrope::at_density(double density) const
{
    return point(reached(std::log(density)));
}

Isentrope::Point Isentrope::at_pressure(double pressure) const
{
    const auto miss = [&](double log_density) { return point(reached(log_density)).pressure - pressure; };
    const double high = nodes_.front().log_density;
    if (!(miss(high) > 0)) return point(nodes_.front());
    double low = high - 1;
    while (miss(low) > 0) low -= 2 * (high - low);
    return point(reached(find_root(miss, low, high)));
}

Isentrope::Point Isentrope::on_ray(double speed, double last_density) const
{
    const auto miss = [&](double log_density) {
        const Point here = point(reached(log_density));
        return here.gain - here.sound - speed;
    };
    const double low = std::log(last_density), high = nodes_.front().log_density;
    if (!(miss(high) < 0)) return point(nodes_.front());
    if (!(miss(low) > 0)) return point(reached(low));
    return point(reached(find_root(miss, low, high)));
}

double Isentrope::escape_speed() const
{
    const Node& last = nodes_.back();
    return last.gain + 2 * sound_speed(law_, std::exp(last.log_density), last.energy) / (heat_capacity_ratio(law_) - 1);
}

}  // namespace corpuscle
