#pragma once

#include "../../unit/gas/gas_samples.hpp"
#include "laws/blast/sedov.hpp"

namespace corpuscle {

/// Sedov's blast by particles: an octant of a cold gas of density 1 between planes of symmetry, all energy in a small ball at the corner.
/// gamma 1.4 and the energy 0.851072 put the front at 1 m after 1 s.
struct PointBlast {
    static constexpr double gamma = 1.4, whole_energy = 0.851072, side = 1.2;
    /// Pressure of the gas ahead [Pa]: against Sedov's nothing. The front at 1 m then runs at Mach 107: its jump is off by 2/M^2, 2e-4.
    static constexpr double pressure_ahead = 1e-5;
    static constexpr double particles_lit = 100;  ///< that share the energy: the ball's radius follows

    std::size_t particles = 0;
    Gas gas;
    Clock clock;
    double spacing = 0;      ///< ahead of the front [m]
    double ball_radius = 0;  ///< [m]

    PointBlast(std::size_t count, const GasSettings& settings) : particles(count)
    {
        const Box box{{0, 0, 0}, {side, side, side}};
        const double particle_mass = box.volume() / static_cast<double>(count);
        spacing = std::cbrt(particle_mass);
        ball_radius = std::cbrt(particles_lit * particle_mass * 6 / std::numbers::pi);
        const Shape ball = Shape::sphere({0, 0, 0}, ball_radius);
        const auto lit = static_cast<std::size_t>(particles_lit);
        gas.settings = settings;
        gas.domain.box = box;
        gas.species.push_back(species_of(IdealGas{gamma}, particle_mass));
        fill(gas, {ball, {}, 0, 1, whole_energy / 8 / (particles_lit * particle_mass), {}, -1}, lit);
        fill(gas, {Shape::box(box), {ball}, 0, 1, pressure_ahead / (gamma - 1), {}, -1}, count - lit);
    }

    void run_until(double time)
    {
        while (clock.time() < time * (1 - 1e-12)) advance(gas, clock, time - clock.time());
    }
};

/// Mean flow between two radii.
struct Shell {
    double lower = 0, upper = 0;  ///< [m]
    double particles = 0;
    BlastFlow flow;
    BlastFlow sigma;  ///< one standard deviation, from the number of particles
};

/// The octant's gas in shells of equal thickness: density, radial velocity, and pressure of the motion about the shell's radial flow.
inline std::vector<Shell> shells(const PointBlast& blast, double thickness, double outermost)
{
    const auto count = static_cast<std::size_t>(std::llround(outermost / thickness));
    std::vector<Shell> result(count);
    std::vector<double> radial(count), squared(count);
    for (const Particle& particle : blast.gas.particles) {
        const Vector3d place(particle.position), velocity(particle.velocity);
        const double r = norm(place);
        const auto k = static_cast<std::size_t>(r / thickness);
        if (k >= count || !(r > 0)) continue;
        result[k].particles += 1;
        radial[k] += dot(place, velocity) / r;
        squared[k] += norm_squared(velocity);
    }
    const double mass = blast.gas.species[0].particle_mass;
    for (std::size_t k = 0; k < count; ++k) {
        Shell& shell = result[k];
        shell.lower = static_cast<double>(k) * thickness;
        shell.upper = shell.lower + thickness;
        const double n = shell.particles, volume = std::numbers::pi / 6 * (std::pow(shell.upper, 3) - std::pow(shell.lower, 3));
        if (n < 2) continue;
        shell.flow.density = n * mass / volume;
        shell.flow.velocity = radial[k] / n;
        shell.flow.pressure = mass * (squared[k] - n * shell.flow.velocity * shell.flow.velocity) / (3 * volume);
        shell.sigma = {shell.flow.density / std::sqrt(n), std::sqrt(shell.flow.pressure / shell.flow.density / n),
                       shell.flow.pressure * std::sqrt(5.0 / 3 / n)};
    }
    return result;
}

/// Where the density, coming from outside, first passes half way between still gas and its peak [m]; linear between the shells' middles.
inline double half_rise(const std::vector<Shell>& shells)
{
    double peak = 0;
    for (const Shell& shell : shells) peak = std::max(peak, shell.flow.density);
    const double half = 0.5 * (1 + peak);
    std::size_t k = shells.size() - 2;
    while (k > 0 && shells[k].flow.density < half) --k;
    const double inside = shells[k].flow.density, outside = shells[k + 1].flow.density;
    return 0.5 * (shells[k].lower + shells[k].upper) + (inside - half) / (inside - outside) * (shells[k].upper - shells[k].lower);
}

/// The front that the whole outward momentum tells [m]: of a point blast it is C rho R^4/t, whatever smears the front.
inline double momentum_radius(const PointBlast& blast)
{
    const SedovBlast exact(PointBlast::gamma, 1, PointBlast::whole_energy);
    constexpr int pieces = 4000;
    double constant = 0;  // of the octant with R = 1 at t = 1
    for (int k = 0; k < pieces; ++k) {
        const double r = exact.radius(1) * (k + 0.5) / pieces;
        const BlastFlow flow = exact.at(r, 1);
        constant += flow.density * flow.velocity * std::numbers::pi / 2 * r * r * exact.radius(1) / pieces;
    }
    constant /= std::pow(exact.radius(1), 4);
    double momentum = 0;
    for (const Particle& particle : blast.gas.particles) {
        const Vector3d place(particle.position);
        const double r = norm(place);
        if (r > 0) momentum += blast.gas.species[0].particle_mass * dot(place, Vector3d(particle.velocity)) / r;
    }
    return std::pow(momentum * blast.clock.time() / constant, 0.25);
}

}  // namespace corpuscle
