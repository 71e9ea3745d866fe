#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>
#include <numeric>

#include "../../unit/contact/gas_structure_bodies.hpp"
#include "gas/collide.hpp"
#include "gas/fill.hpp"
#include "gas/fly.hpp"
#include "gas/sort.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {
namespace {

constexpr double width = 0.5;  ///< of the square tube [m]

/// A flat piston across a tube along x: one large facet about the tube's axis whose corners can move along x only, which makes it a
/// rigid plate that is free to move and to tilt.
Structure piston_at(double x, double mass)
{
    MovingSurface plate;
    for (int i = 0; i < 3; ++i) {
        const double angle = 2 * std::numbers::pi * i / 3;
        plate.start.push_back({x, width / 2 + 2 * std::cos(angle), width / 2 + 2 * std::sin(angle)});
    }
    plate.surface.facets = {{{0, 1, 2}, 0, 0}};
    Structure structure = bare_structure(plate.surface, plate.start, mass / 3);
    for (Vector3d& inverse : structure.nodes.inverse_mass) inverse = {3 / mass, 0, 0};
    return structure;
}

/// A tube with rigid ends, gas in parts of it and a piston.
struct Tube {
    Tube(double length, const EquationOfState& law, double piston_place, double piston_mass)
        : gas(empty_gas({{0, 0, 0}, {length, width, width}}, 0, law)),
          structure(piston_at(piston_place, piston_mass)),
          contact(gas, structure)
    {
        set_thread_count(1);  // so few particles do not repay the threads' meeting
    }

    void fill_between(double from, double to, double density, double energy_per_mass, std::size_t count)
    {
        const Box box{{from, 0, 0}, {to, width, width}};
        gas.species[0].particle_mass = density * box.volume() / static_cast<double>(count);
        fill(gas, {Shape::box(box), {}, 0, density, energy_per_mass, {}, -1}, count);
    }

    /// A step of everything, in the order of a run.
    void step()
    {
        sort(gas);
        if (clock.step() == 0) survey(gas);
        clock.begin_step(stable_step(gas, clock.time()));
        move_freely(structure.nodes, clock.duration());
        contact.follow();
        collide(gas, clock, contact.tree());
        fly(gas, clock, contact.tree());
        contact.apply(clock);
        clock.end_step();
    }

    /// Where the piston crosses the axis, and how fast.
    [[nodiscard]] double place() const { return mean(structure.nodes.position); }
    [[nodiscard]] double speed() const { return mean(structure.nodes.velocity); }
    static double mean(const std::vector<Vector3d>& values) { return (values[0].x + values[1].x + values[2].x) / 3; }

    /// Energy of the gas before (-1) or behind (1) the piston, and its particles.
    [[nodiscard]] std::pair<double, std::size_t> gas_on(int side) const
    {
        const std::array<Vector3d, 3> p = contact.tree().corners(0, 1);
        std::pair<double, std::size_t> held{0, 0};
        for (const Particle& particle : gas.particles) {
            if (dot(Vector3d(particle.position) - p[0], cross(p[1] - p[0], p[2] - p[0])) * side < 0) continue;
            held.first +=
                0.5 * gas.species[0].particle_mass * norm_squared(Vector3d(particle.velocity)) + static_cast<double>(particle.energy);
            ++held.second;
        }
        return held;
    }
    [[nodiscard]] double energy() const { return contents(gas).gas.energy + kinetic_energy(structure.nodes); }

    Gas gas;
    Structure structure;
    GasStructureContact contact;
    Clock clock;
};

/// Gas drives a heavy piston into vacuum from x = 0.5 m on. Its work must be that of the isentrope p (V - b)^gamma: the gas's energy
/// goes as (V - b)^(1 - gamma). The gas follows the piston, so of each joule 1/(1 + m/3M) is the piston's.
/// The piston's impulse, and so the work, is uncertain by sqrt(4/(pi hits)): hits are independent and flux-weighted Maxwellian.
void drive(const EquationOfState& law, double density, double energy_per_mass)
{
    const double start = 0.5, gas_mass = density * start * width * width, piston_mass = 100 * gas_mass;
    const double filled = std::holds_alternative<NobleAbel>(law) ? std::get<NobleAbel>(law).filled_share(density) : 0.0;
    const double gamma = heat_capacity_ratio(law);
    Tube tube(1.3, law, start, piston_mass);
    tube.fill_between(0, start, density, energy_per_mass, 16000);
    const double total = tube.energy();
    for (const double end : {0.75, 1.0}) {
        while (tube.place() < end) {
            tube.step();
            ASSERT_LT(tube.clock.step(), 20000u);
        }
        const double hits = static_cast<double>(tube.contact.facet_hits()[0]);
        const double expected =
            total * (1 - std::pow((1 - filled) / (tube.place() / start - filled), gamma - 1)) / (1 + gas_mass / (3 * piston_mass));
        const double work = kinetic_energy(tube.structure.nodes), sigma = std::sqrt(4 / (std::numbers::pi * hits));
        std::printf("V/V0 %.2f: work/isentrope %.4f, sigma %.4f, %g hits, %llu steps\n", tube.place() / start, work / expected, sigma, hits,
                    static_cast<unsigned long long>(tube.clock.step()));
        EXPECT_NEAR(work / expected, 1, 4 * sigma);
        EXPECT_NEAR(tube.energy(), total, 1e-6 * total);
        EXPECT_EQ(tube.gas_on(1).second, 0u);
    }
    EXPECT_EQ(tube.contact.trapped(), 0u);
}

TEST(Piston, ideal_gas_drives_it_along_the_isentrope)
{
    drive(IdealGas{1.4}, 1.2, 2.5e5);
}
TEST(Piston, noble_abel_gas_drives_it_along_the_isentrope)
{
    drive(NobleAbel{1.3, 0.3, 1200}, 1200, 2.5e5);
}

/// What the last part of a swinging piston's run shows.
struct Rest {
    double speed = 0;           ///< root mean square [m/s]
    double pressure_ratio = 0;  ///< mean, gas before the piston to gas behind it
    double pressure = 0;        ///< mean of the gas before it [Pa]
    double time = 0;            ///< [s]
    std::uint64_t hits = 0;
};

/// Runs so many steps and looks.
Rest watch(Tube& tube, int steps, double length)
{
    Rest rest;
    const double begin = tube.clock.time(), gamma = heat_capacity_ratio(tube.gas.species[0].law);
    const std::uint64_t hits = tube.contact.facet_hits()[0];
    for (int i = 0; i < steps; ++i) {
        tube.step();
        const double before = tube.gas_on(-1).first / tube.place(), behind = tube.gas_on(1).first / (length - tube.place());
        rest.speed += tube.speed() * tube.speed() / steps;
        rest.pressure_ratio += before / behind / steps;
        rest.pressure += (gamma - 1) * before / (width * width) / steps;
    }
    rest.speed = std::sqrt(rest.speed);
    rest.time = tube.clock.time() - begin;
    rest.hits = tube.contact.facet_hits()[0] - hits;
    return rest;
}

/// Equal masses of one gas at one temperature in 1/3 and 2/3 of a tube: the piston between them swings, is damped by the gas alone and
/// comes to rest, but for Brownian motion (M v^2 = m sigma^2, the equipartition of lumps), where the pressures are equal.
/// The pressures' ratio, of means over a time T, is uncertain by the hits of both sides, sqrt(2 * 4/(pi hits of one)), and by the
/// momentum that the piston happens to have at both ends of T, sqrt(2) M v/(p A T).
TEST(Piston, comes_to_rest_between_two_gases_where_pressures_are_equal)
{
    const std::size_t each = 2000;
    const double length = 1.5, piston_mass = 0.3, heat = 2.5e5;
    Tube tube(length, IdealGas{1.4}, 0.5, piston_mass);
    tube.fill_between(0, 0.5, 2.4, heat, each);
    tube.fill_between(0.5, length, 1.2, heat, each);
    const double total = tube.energy(), brownian = std::sqrt(tube.gas.species[0].particle_mass * 0.4 * heat / piston_mass);
    const Rest first = watch(tube, 1000, length);
    for (int i = 0; i < 4000; ++i) tube.step();
    const Rest last = watch(tube, 4000, length);
    const double from_hits = std::sqrt(2 * 4 / (std::numbers::pi * 0.5 * static_cast<double>(last.hits)));
    const double from_momentum = std::sqrt(2.0) * piston_mass * brownian / (last.pressure * width * width * last.time);
    const double sigma = std::hypot(from_hits, from_momentum);
    std::printf("speed %.2f m/s, at last %.2f (Brownian %.2f); pressure ratio %.4f at first, %.4f at last, sigma %.4f; place %.3f m\n",
                first.speed, last.speed, brownian, first.pressure_ratio, last.pressure_ratio, sigma, tube.place());
    EXPECT_NEAR(last.pressure_ratio, 1, 4 * sigma);
    EXPECT_GT(first.speed, 5 * brownian);
    EXPECT_LT(last.speed, 1.5 * brownian);
    EXPECT_GT(last.speed, 0.6 * brownian);
    EXPECT_EQ(tube.gas_on(-1).second, each);
    EXPECT_EQ(tube.gas_on(1).second, each);
    EXPECT_NEAR(tube.energy(), total, 1e-6 * total);
    EXPECT_EQ(tube.contact.trapped(), 0u);
}

}  // namespace
}  // namespace corpuscle
