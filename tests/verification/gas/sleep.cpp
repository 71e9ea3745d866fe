#include <gtest/gtest.h>

#include <cstdio>

#include "../../unit/gas/gas_samples.hpp"
#include "gas/sample.hpp"

namespace corpuscle {
namespace {

constexpr double density = 1.2, energy = 0.253e6 / density, pressure = 0.4 * 0.253e6;

/// Still air beside air asleep is as beside a wall: its pressure, mass and temperature stay, and it pushes the sleeping gas with the
/// ambient pressure. The step's own spread of reach is left out (`wake` is not called), so the zones sleep for 3 ms, in which sound crosses
/// the box once. Noise: the awake gas (N particles, no exchange) keeps its energy to rounding; its momentum on the faces of area A in time
/// t is that of N_hits = n v_mean/4 A t hits, relative error sqrt(4/pi/N_hits) at most (collisions lower it).
TEST(Sleep, gas_beside_it_stays_still)
{
    constexpr std::size_t count = 20000;
    Gas gas = filled_box(unit_box, IdealGas{1.4}, density, energy, count);
    gas.ambient = ambient_like(gas.species[0], density, energy);
    gas.sleeping.disturbances = {{{{0, 0, 0}, {0.2, 1, 1}}, 0}};
    const FacetTree none{Surface{}};
    lay_to_sleep(gas, none);
    const std::size_t asleep = gas.sleeping.particles, awake = gas.particles.size() - asleep;
    ASSERT_GT(asleep, awake / 4);
    double edge = 1;
    for (std::uint32_t i = 0; i < asleep; ++i) edge = std::min(edge, static_cast<double>(gas.particles[i].position.x));
    sort(gas);
    survey(gas);
    Clock clock;
    while (clock.time() < 3e-3) {
        clock.begin_step(stable_step(gas, clock.time()));
        sort(gas);
        collide(gas, clock, none);
        fly(gas, clock, none);
        clock.end_step();
    }
    sort(gas);
    ASSERT_EQ(gas.sleeping.particles, asleep);
    const double push = gas.sleeping.turned.momentum.x / (clock.time() * pressure);
    const double flux = density / gas.species[0].particle_mass * std::sqrt(gas.ambient.velocity_variance / (2 * std::numbers::pi));
    const double error = std::sqrt(4 / (std::numbers::pi * flux * clock.time()));
    const double far = std::floor(edge * 100) / 100, near = far - 0.1;
    const GasSample beside = sample(gas, Shape::box({{near, 0, 0}, {far, 1, 1}}), far - near);
    std::printf("%zu of the particles asleep from x = %.3f m: pressure on them %.4f +- %.4f of the ambient; density beside them %.4f\n",
                asleep, edge, push, error, beside.density / density);
    EXPECT_NEAR(push, 1, 4 * error);
    const double speck = 1 / std::sqrt(static_cast<double>(beside.particles));
    EXPECT_NEAR(beside.density / density, 1, 4 * speck);
    EXPECT_NEAR(beside.pressure / pressure, 1, 4 * std::sqrt(5.0 / 3) * speck);
}

/// What a blast in air does to a wall it reaches after a while: a ball of hot gas (300 bar) in the corner of a tube whose far end is rigid.
/// With and without sleep, six seeds each: impulse on the end must agree within the statistics of the runs (4 sigma of the difference).
TEST(Sleep, blast_is_the_same_as_in_gas_awake)
{
    constexpr std::size_t count = 9000;
    constexpr double end = 1.2e-3;
    const auto impulse = [](std::uint64_t seed, bool sleep) {
        Gas gas;
        gas.settings.seed = seed;
        gas.domain.box = {{0, 0, 0}, {1.5, 0.3, 0.3}};
        gas.species.push_back(species_of(IdealGas{1.4}, density * gas.domain.box.volume() / count));
        const Box hot{{0, 0, 0}, {0.1, 0.3, 0.3}};
        fill(gas, {Shape::box(gas.domain.box), {Shape::box(hot)}, 0, density, energy, {}, -1}, count * 14 / 15);
        fill(gas, {Shape::box(hot), {}, 0, density, 100 * energy, {}, -1}, count / 15);
        gas.ambient = ambient_like(gas.species[0], density, energy);
        if (sleep) gas.sleeping.disturbances = {{hot, 0}};
        Clock clock;
        double steps = 0, all = 0;
        while (clock.time() < end) {
            advance(gas, clock);
            steps += static_cast<double>(gas.particles.size() - gas.sleeping.particles);
            all += static_cast<double>(gas.particles.size());
        }
        const double push = gas.passages.face[1].momentum.x / (0.09 * pressure * clock.time());
        std::printf("seed %d, sleep %d: pressure on the end %.4f of the ambient, %.2f of the particle steps\n", static_cast<int>(seed),
                    sleep, push, steps / all);
        EXPECT_LE(steps, (sleep ? 0.95 : 1.0) * all);
        return push;
    };
    std::vector<double> with, without;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        with.push_back(impulse(seed, true));
        without.push_back(impulse(10 + seed, false));
    }
    const Statistics a(with), b(without);
    const double error = std::sqrt((a.variance + b.variance) / 5);  // of 6 runs each, about their own means
    EXPECT_NEAR(a.mean, b.mean, 4 * error);
}

}  // namespace
}  // namespace corpuscle
