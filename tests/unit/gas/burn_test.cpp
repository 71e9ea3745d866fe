#include "gas/burn.hpp"

#include <gtest/gtest.h>

#include "gas_samples.hpp"

namespace corpuscle {
namespace {

constexpr double energy_per_mass = 4.3e6, density = 1630, detonation_velocity = 7000;
const std::vector<DetonationPoint> two_points{{{0.5, 0.5, 0.6}, 5e-6}, {{0.45, 0.5, 0.5}, 0}};

/// A charge of Noble-Abel gas in the middle of an empty box, lit at two points.
Gas charged(std::size_t count)
{
    Gas gas;
    gas.domain.box = unit_box;
    const Shape ball = Shape::sphere({0.5, 0.5, 0.5}, 0.1);
    gas.species.push_back(species_of(NobleAbel{1.3, 0.3, density}, density * ball.volume() / static_cast<double>(count)));
    gas.charges.push_back({"charge", 0, detonation_velocity, energy_per_mass, density, two_points});
    fill(gas, {ball, {}, 0, density, energy_per_mass, {}, 0}, count);
    return gas;
}

TEST(Charge, burns_from_the_nearest_point_in_time)
{
    const Charge charge = charged(10).charges[0];
    EXPECT_EQ(charge.first_time(), 0);
    EXPECT_DOUBLE_EQ(charge.burn_time({0.45, 0.5, 0.43}), 0.07 / detonation_velocity);
    EXPECT_DOUBLE_EQ(charge.burn_time({0.5, 0.5, 0.607}), 5e-6 + 0.007 / detonation_velocity);
    EXPECT_EQ(charge.burn_time({0.45, 0.5, 0.5}), 0);
}

TEST(Burn, takes_exactly_the_particles_the_front_has_passed)
{
    Gas gas = charged(4000);
    const std::vector<Particle> before = gas.particles;
    Clock clock;
    Passage released;
    for (int step = 0; step < 12; ++step) {
        clock.begin_step(2e-6);
        released += burn(gas, clock);
        std::uint64_t waiting = 0;
        for (std::size_t i = 0; i < before.size(); ++i) {
            const bool waits = gas.particles[i].tag & particle_tag::unburnt;
            const Vector3d place(before[i].position);
            double first = 1;
            for (const DetonationPoint& point : two_points)
                first = std::min(first, point.time + norm(place - point.point) / detonation_velocity);
            ASSERT_EQ(waits, first > clock.time()) << "step " << step;
            waiting += waits;
            Particle other = gas.particles[i];
            other.tag = before[i].tag;
            ASSERT_EQ(bits(other), bits(before[i]));
        }
        EXPECT_EQ(gas.charges[0].unburnt, waiting);
        clock.end_step();
    }
    EXPECT_EQ(gas.charges[0].unburnt, 0u);
    const double mass = 4000 * gas.species[0].particle_mass;
    EXPECT_NEAR(released.mass, mass, 1e-12 * mass);
    EXPECT_NEAR(released.energy, mass * energy_per_mass, 1e-7 * mass * energy_per_mass);  // rounding of floats, twice 2^-24 at most
    EXPECT_LE(norm(released.momentum), 1.1e-7 * speed_sum(gas));
}

TEST(Burn, moves_energy_from_explosive_to_gas_and_loses_none)
{
    Gas gas = charged(3000);
    const GasContents start = contents(gas);
    EXPECT_EQ(start.gas.mass, 0);
    Passage released;
    Clock clock;
    for (int step = 0; step < 10; ++step) {
        clock.begin_step(1e-6);
        released += burn(gas, clock);
        const GasContents now = contents(gas);
        EXPECT_NEAR(now.gas.energy, released.energy, 1e-12 * start.explosive.energy);
        EXPECT_NEAR(now.gas.energy + now.explosive.energy, start.explosive.energy, 1e-12 * start.explosive.energy);
        EXPECT_NEAR(now.gas.mass + now.explosive.mass, start.explosive.mass, 1e-12 * start.explosive.mass);
        clock.end_step();
    }
    EXPECT_GT(released.mass, 0);
    EXPECT_LT(released.mass, start.explosive.mass);
}

/// What has not burnt rests and takes no part in collisions, with gas all round it.
TEST(Burn, explosive_that_waits_is_left_alone)
{
    Gas gas = charged(2000);
    for (DetonationPoint& point : gas.charges[0].points) point.time += 1;
    gas.species.push_back(species_of(IdealGas{1.4}, gas.species[0].particle_mass));
    fill(gas, {Shape::box({{0.3, 0.3, 0.3}, {0.7, 0.7, 0.7}}), {}, 1, 100, 2e5, {}, -1}, 2000);
    const auto explosive = [](const Gas& of) {
        std::vector<std::array<std::uint32_t, 8>> list;
        for (const Particle& p : of.particles) {
            if (particle_tag::species(p.tag) == 0) list.push_back(bits(p));
        }
        std::sort(list.begin(), list.end());
        return list;
    };
    const auto before = explosive(gas);
    Clock clock;
    for (int step = 0; step < 20; ++step) advance(gas, clock);
    EXPECT_GT(gas.collisions, 500u);
    EXPECT_EQ(explosive(gas), before);
    EXPECT_EQ(gas.charges[0].unburnt, 2000u);
}

/// The step in which explosive may burn is already short enough for it.
TEST(Burn, stable_step_foresees_the_explosion)
{
    Gas gas = charged(2000);
    sort(gas);
    survey(gas);
    const double foreseen = stable_step(gas, 0);
    Clock clock;
    clock.begin_step(foreseen);
    clock.end_step();
    clock.begin_step(1);
    clock.end_step();  // all has burnt by now
    clock.begin_step(0);
    burn(gas, clock);
    EXPECT_EQ(gas.charges[0].unburnt, 0u);
    survey(gas);
    // The same gas at the same density: cells differ from the mean, the law of the step is one.
    EXPECT_LT(foreseen, 1.5 * stable_step(gas, 2));
    EXPECT_GT(foreseen, 0.3 * stable_step(gas, 2));
}

}  // namespace
}  // namespace corpuscle
