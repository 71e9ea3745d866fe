#pragma once

#include <cmath>

#include "unit/gas/gas_samples.hpp"

namespace corpuscle {

/// Gas in a cube whose three upper walls recede slowly, so that it expands without heat: its energy must follow the isentrope, which for
/// Noble-Abel is p (V - b)^gamma = const, E ~ (V - b)^(1 - gamma). What it loses is the work of the pressure on the walls.
struct Expansion {
    EquationOfState law = IdealGas{1.4};
    double density = 1;  ///< at the start
    double energy = 1;   ///< specific, at the start
    double side = 20;    ///< of the cube, in spacings
    double mach = 0.03;  ///< of the walls, in the gas as it is
    double volume_ratio = 100;
    std::uint64_t seed = 1;
};

/// The gas at one moment; energies are thermal and over that at the start.
struct Expanded {
    double volume_ratio = 1;
    double energy = 1;
    double isentrope = 1;
    double translational = 1;  ///< share of the energy, over xi
};

/// Specific energy on the isentrope, over that at the start: de/d ln V = -p v, by the midpoint rule.
inline double isentropic_energy(const EquationOfState& law, double density, double energy, double expansion)
{
    double e = energy;
    constexpr int steps = 4000;
    const double step = std::log(expansion) / steps;
    const auto slope = [&](double at, double specific) { return -pressure(law, at, specific) / at; };
    for (int i = 0; i < steps; ++i) {
        const double here = density * std::exp(-step * i), middle = here * std::exp(-step / 2);
        e += step * slope(middle, e + 0.5 * step * slope(here, e));
    }
    return e / energy;
}

/// Walls that move out: the engine's faces are at rest within a step, so particles that they turn are given the walls' speed here, twice.
class RecedingWalls {
public:
    RecedingWalls(Gas& gas, double side) : gas_(gas), side_(side) {}

    /// A step in which the walls recede at `speed`.
    void advance(Clock& clock, double speed)
    {
        const FacetTree none{Surface{}};
        if (clock.step() == 0) {
            sort(gas_);
            survey(gas_);
        }
        clock.begin_step(stable_step(gas_, clock.time()));
        gas_.cells = {};  // the curve through the box is another each step
        sort(gas_);
        set_upper_faces(Edge::open);  // a displaced particle stays where it is: beyond the wall it is told from others
        collide(gas_, clock, none);
        for (Particle& p : gas_.particles) mirror(p, speed);
        set_upper_faces(Edge::rigid);
        side_ += speed * clock.duration();
        gas_.domain.box.upper = {side_, side_, side_};
        before_.clear();
        for (const Particle& p : gas_.particles) before_.push_back(p.velocity);
        fly(gas_, clock, none);
        for (std::size_t i = 0; i < before_.size(); ++i) push(gas_.particles[i], before_[i], speed);
        clock.end_step();
    }
    [[nodiscard]] double side() const { return side_; }

private:
    void set_upper_faces(Edge edge)
    {
        for (const int face : {1, 3, 5}) gas_.domain.edges[face] = edge;
    }
    /// Image of a displaced particle in the moving wall: place and velocity.
    void mirror(Particle& p, double speed) const
    {
        for (int axis = 0; axis < 3; ++axis) {
            if (static_cast<double>(p.position[axis]) <= side_) continue;
            p.position[axis] = static_cast<float>(2 * side_ - static_cast<double>(p.position[axis]));
            p.velocity[axis] = static_cast<float>(2 * speed) - p.velocity[axis];
        }
    }
    /// Gives the wall's speed to a particle that the wall has turned.
    static void push(Particle& p, const Vector3f& before, double speed)
    {
        for (int axis = 0; axis < 3; ++axis) {
            if (before[axis] > 0 && p.velocity[axis] < 0) p.velocity[axis] += static_cast<float>(2 * speed);
        }
    }

    Gas& gas_;
    double side_;
    std::vector<Vector3f> before_;
};

/// Thermal energy of gas that flows as speed x/side, and its translational share over xi.
inline Expanded look(const Gas& gas, double side, double speed)
{
    const double mass = gas.species[0].particle_mass;
    double moving = 0, internal = 0;
    for (const Particle& p : gas.particles) {
        moving += 0.5 * mass * norm_squared(Vector3d(p.velocity) - (speed / side) * Vector3d(p.position));
        internal += static_cast<double>(p.energy);
    }
    Expanded state;
    state.energy = moving + internal;
    state.translational = moving / state.energy / translational_share(heat_capacity_ratio(gas.species[0].law));
    return state;
}

/// Expands the gas; its states at V/V0 = 1.5, 2, 3, 5, 10, ...
inline std::vector<Expanded> expand(const Expansion& set)
{
    const Box box{{0, 0, 0}, {set.side, set.side, set.side}};
    Gas gas = filled_box(box, set.law, set.density, set.energy, static_cast<std::size_t>(box.volume()));
    gas.settings.seed = set.seed;
    const double start = contents(gas).gas.energy;
    RecedingWalls walls(gas, set.side);
    Clock clock;
    std::vector<Expanded> states;
    Expanded now;
    for (const double goal : {1.5, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
        if (goal > 1.001 * set.volume_ratio) break;
        double speed = 0;
        while (now.volume_ratio < goal) {
            speed = set.mach * sound_speed(set.law, set.density / now.volume_ratio, set.energy * now.energy);
            walls.advance(clock, speed);
            now.volume_ratio = std::pow(walls.side() / set.side, 3);
            if (clock.step() % 20 == 0) now.energy = look(gas, walls.side(), speed).energy / start;
        }
        const double ratio = now.volume_ratio;
        now = look(gas, walls.side(), speed);
        now.volume_ratio = ratio;
        now.energy /= start;
        now.isentrope = isentropic_energy(set.law, set.density, set.energy, ratio);
        states.push_back(now);
    }
    return states;
}

}  // namespace corpuscle
