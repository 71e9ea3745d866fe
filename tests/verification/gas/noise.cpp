#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "../../unit/gas/gas_samples.hpp"
#include "gas/sample.hpp"

// The errors that gauges state of themselves, held against how far many seeds of air at rest really scatter.

namespace corpuscle {
namespace {

constexpr Box room{{0, 0, 0}, {0.2, 0.1, 0.1}};  // m
constexpr double density = 1.2, energy = 2.11e5, pressure = 0.4 * density * energy;
constexpr std::size_t particles = 2000;
constexpr int seeds = 250;

Gas air(std::uint64_t seed, double mean_free_path)
{
    Gas gas;
    gas.settings.seed = seed;
    gas.settings.mean_free_path = mean_free_path;
    gas.domain.box = room;
    gas.species.push_back(species_of(IdealGas{1.4}, density * room.volume() / particles));
    gas.species[0].molar_mass = 0.02896;
    fill(gas, {Shape::box(room), {}, 0, density, energy, {}, -1}, particles);
    return gas;
}

/// Sum of squared errors of many samples, and of the variances the samples state.
struct Comparison {
    double found = 0;
    double stated = 0;
    int samples = 0;

    void add(double error, double stated_variance)
    {
        found += error * error;
        stated += stated_variance;
        ++samples;
    }
    [[nodiscard]] double ratio() const { return found / stated; }
    /// Four standard deviations of the ratio: a variance from n normal samples scatters by sqrt(2/n).
    [[nodiscard]] double four_sigma() const { return 4 * std::sqrt(2.0 / samples); }
};

/// Windows of `steps` steps of the impulse on both end walls, from 100 us on: by then the lattice that the gas was filled on is forgotten.
Comparison wall_impulse(double mean_free_path, int steps, int windows)
{
    Comparison comparison;
    for (int seed = 1; seed <= seeds; ++seed) {
        Gas gas = air(static_cast<std::uint64_t>(seed), mean_free_path);
        Clock clock;
        while (clock.time() < 1e-4) advance(gas, clock);
        for (int window = 0; window < windows; ++window) {
            const FacePassages before = gas.passages;
            const double begin = clock.time();
            for (int step = 0; step < steps; ++step) advance(gas, clock);
            const double expected = pressure * 0.01 * (clock.time() - begin);  // walls of 0.01 m2
            for (const std::size_t face : {0, 1}) {
                const double impulse = std::abs(gas.passages.face[face].momentum.x - before.face[face].momentum.x);
                comparison.add(impulse - expected, gas.passages.squares[face] - before.squares[face]);
            }
        }
    }
    return comparison;
}

/// Particles that do not collide hit a wall like rain: the scatter of the impulse is the stated one. Of the 2000 particles about 1.5 % come
/// to a wall in a window (8 steps, 35 us), so the number is binomial and the ratio 1 - 0.02 pi/4 instead of 1.
TEST(Noise, of_a_wall_hit_by_free_particles_is_the_stated_one)
{
    const Comparison comparison = wall_impulse(1000, 8, 4);
    EXPECT_NEAR(comparison.ratio(), 1 - 0.02 * std::numbers::pi / 4, comparison.four_sigma());
    RecordProperty("ratio", std::to_string(comparison.ratio()));
}

/// Collisions keep momentum, so over many times between them a wall's impulse scatters less than stated, and never more: towards
/// c sqrt(2 pi)/(4 sigma) = 0.74 for plane sound, less in a box this short, whose ends answer each other.
TEST(Noise, of_a_wall_in_a_gas_that_collides_is_at_most_the_stated_one)
{
    const Comparison comparison = wall_impulse(1, 30, 1);
    EXPECT_LT(comparison.ratio(), 1 - 0.5 * comparison.four_sigma());
    RecordProperty("ratio", std::to_string(comparison.ratio()));
}

/// Sixteen balls of 50 mm that touch, each with about 65 of 2000 particles that move freely, at 300 us, when a particle has flown further
/// than a ball is wide. A closed box and the mean velocity that is taken off change the variances by a share of 1/65 + 1/30 at most: 5 %.
TEST(Noise, of_a_region_is_the_stated_one)
{
    std::array<Comparison, 4> comparisons;
    const double sigma_squared = 0.4 * energy, temperature = sigma_squared * 0.02896 / 8.31446261815324;
    for (int seed = 1; seed <= seeds; ++seed) {
        Gas gas = air(static_cast<std::uint64_t>(seed), 1000);
        Clock clock;
        while (clock.time() < 3e-4) advance(gas, clock);
        for (int ball = 0; ball < 16; ++ball) {
            const Vector3d center{0.025 + 0.05 * (ball / 4), 0.025 + 0.05 * (ball / 2 % 2), 0.025 + 0.05 * (ball % 2)};
            const Shape region = Shape::sphere(center, 0.025);
            const GasSample found = sample(gas, region, region.volume());
            comparisons[0].add(found.density - density, std::pow(found.error.density, 2));
            comparisons[1].add(found.velocity.x, std::pow(found.error.velocity.x, 2));
            comparisons[2].add(found.pressure - pressure, std::pow(found.error.pressure, 2));
            comparisons[3].add(found.temperature - temperature, std::pow(found.error.temperature, 2));
        }
    }
    const std::array<const char*, 4> names{"density", "velocity", "pressure", "temperature"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        EXPECT_NEAR(comparisons[i].ratio(), 1, comparisons[i].four_sigma() + 0.05) << names[i];
        RecordProperty(names[i], std::to_string(comparisons[i].ratio()));
    }
}

}  // namespace
}  // namespace corpuscle
