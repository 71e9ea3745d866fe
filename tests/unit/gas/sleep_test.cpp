#include "gas/sleep.hpp"

#include <gtest/gtest.h>

#include "gas/sample.hpp"
#include "gas_samples.hpp"

namespace corpuscle {
namespace {

constexpr double density = 1.2, energy = 0.253e6 / density;

/// Air in a cube of 1 m; what lies in a small box at a corner may disturb it.
Gas still_air(std::size_t count = 20000)
{
    Gas gas = filled_box(unit_box, IdealGas{1.4}, density, energy, count);
    gas.ambient = ambient_like(gas.species[0], density, energy);
    gas.sleeping.disturbances = {{{{0, 0, 0}, {0.05, 0.05, 0.05}}, 0}};
    return gas;
}

/// The same with gas of 300 times the pressure in that corner.
Gas loud_air(std::size_t count = 20000)
{
    Gas gas = still_air(count);
    for (Particle& particle : gas.particles)
        if (norm(Vector3d(particle.position)) < 0.15) particle.velocity = std::sqrt(300.0f) * particle.velocity;
    return gas;
}

double spacing(const Gas& gas)
{
    return std::cbrt(gas.species[0].particle_mass / density);
}

Box zone_box(const Gas& gas, std::uint32_t number)
{
    return gas.cells.curve.cell(number * CellCurve::keys_of(gas.sleeping.depth), gas.sleeping.depth);
}

TEST(Sleep, holds_what_no_disturbance_reaches_and_no_more)
{
    Gas gas = still_air();
    lay_to_sleep(gas, FacetTree{Surface{}});
    const SleepingGas& sleeping = gas.sleeping;
    ASSERT_GT(sleeping.particles, gas.particles.size() / 4);
    std::vector<bool> named(sleeping.state.size());
    std::uint32_t i = 0;
    for (const SleepingZone& zone : sleeping.zones) {
        named[zone.number] = true;
        const Box box = zone_box(gas, zone.number);
        EXPECT_GT(distance(sleeping.disturbances[0].box, box), 10 * spacing(gas));
        for (const std::uint32_t end = i + zone.particles; i < end; ++i)
            EXPECT_EQ(sleeping.zone_of(gas.cells.curve.key(gas.particles[i].position)), zone.number);
    }
    EXPECT_EQ(i, sleeping.particles);
    for (std::uint32_t number = 0; number < named.size(); ++number) {
        if (named[number]) continue;
        EXPECT_LE(distance(sleeping.disturbances[0].box, zone_box(gas, number)), 10 * spacing(gas) * (1 + 1e-12));
    }
    for (; i < gas.particles.size(); ++i) EXPECT_FALSE(sleeping.holds(gas.cells.curve.key(gas.particles[i].position)));
}

TEST(Sleep, is_not_for_gas_without_disturbances_or_surroundings_nor_for_hard_spheres)
{
    Gas quiet = still_air(), lonely = still_air(), spheres = still_air();
    quiet.sleeping.disturbances.clear();
    lonely.ambient = {};
    spheres.settings.rule = CollisionRule::hard_spheres;
    for (Gas* gas : {&quiet, &lonely, &spheres}) {
        lay_to_sleep(*gas, FacetTree{Surface{}});
        EXPECT_FALSE(gas->sleeping.any());
    }
}

TEST(Sleep, zone_turns_particles_back_like_a_plane_of_symmetry)
{
    Gas gas = still_air();
    lay_to_sleep(gas, FacetTree{Surface{}});
    const double mass = gas.species[0].particle_mass;
    int tried = 0;
    for (const SleepingZone& zone : gas.sleeping.zones) {
        const Box box = zone_box(gas, zone.number);
        const Vector3d middle = box.center(), size = box.size();
        for (int axis = 0; axis < 3; ++axis) {
            Vector3d before = middle, after = middle;
            before[axis] = box.lower[axis] - 0.1 * size[axis];
            after[axis] = box.lower[axis] + 0.05 * size[axis];
            if (!unit_box.contains(before) || gas.sleeping.holds(gas.cells.curve.key(Vector3f(before)))) continue;
            Particle particle{Vector3f(after), 0, {3, 4, 5}, 0};
            const Vector3d impulse = turn_back(gas, particle);
            Vector3d image = middle, velocity{3, 4, 5}, expected;
            image[axis] = box.lower[axis] - 0.05 * size[axis];
            expected[axis] = 2 * mass * velocity[axis];
            velocity[axis] = -velocity[axis];
            EXPECT_LT(norm(Vector3d(particle.position) - image), 1e-6);
            EXPECT_EQ(Vector3d(particle.velocity), velocity);
            EXPECT_LT(norm(impulse - expected), 1e-12 * norm(expected));
            ++tried;
        }
    }
    EXPECT_GT(tried, 3);
}

TEST(Sleep, particle_that_comes_over_an_edge_leaves_it_again)
{
    Gas gas = still_air();
    lay_to_sleep(gas, FacetTree{Surface{}});
    for (const SleepingZone& zone : gas.sleeping.zones) {
        const Box box = zone_box(gas, zone.number);
        const Vector3d corner = box.lower + 1e-3 * box.size();
        Particle particle{Vector3f(corner), 0, {1, 1, 1}, 0};
        const Vector3d outside = box.lower - 1e-3 * box.size();
        if (!unit_box.contains(outside) || gas.sleeping.holds(gas.cells.curve.key(Vector3f(outside)))) continue;
        const Vector3d impulse = turn_back(gas, particle);
        EXPECT_FALSE(gas.sleeping.holds(gas.cells.curve.key(particle.position)));
        EXPECT_GT(norm(impulse), 0);
        EXPECT_LT(norm(Vector3d(particle.position) - corner), 5e-3 * norm(box.size()));
    }
}

TEST(Sleep, gas_asleep_does_not_move_and_nothing_is_lost)
{
    Gas gas = loud_air();
    Clock clock;
    const GasContents before = contents(gas);
    while (clock.step() < 60) {
        const std::vector<Particle> asleep(gas.particles.begin(), gas.particles.begin() + gas.sleeping.particles);
        const std::uint32_t zones = static_cast<std::uint32_t>(gas.sleeping.zones.size());
        advance(gas, clock);
        if (clock.step() > 1) {
            ASSERT_LE(gas.sleeping.zones.size(), zones);
        }
        if (gas.sleeping.zones.size() == zones && clock.step() > 1) {
            const std::vector<Particle> still(gas.particles.begin(), gas.particles.begin() + gas.sleeping.particles);
            EXPECT_TRUE(same_bits(asleep, still));
        }
        const GasContents now = contents(gas);
        ASSERT_EQ(gas.particles.size(), 20000u);
        ASSERT_NEAR(now.gas.mass, before.gas.mass, 1e-12);
        ASSERT_NEAR(now.gas.energy, before.gas.energy, 1e-6 * before.gas.energy);
        Vector3d momentum = now.gas.momentum + gas.sleeping.turned.momentum;
        for (const Passage& passage : gas.passages.face) momentum += passage.momentum;
        ASSERT_LT(norm(momentum - before.gas.momentum), 1e-6 * speed_sum(gas));
    }
}

TEST(Sleep, disturbance_is_ahead_of_its_shock_and_of_sound)
{
    Gas gas = loud_air(8000);
    Clock clock;
    const double sound = std::sqrt(1.4 * 0.4 * energy);
    double start = 0;
    while (clock.time() < 1e-3 && (clock.step() == 0 || gas.sleeping.any())) {
        advance(gas, clock);
        if (clock.step() == 1) start = gas.sleeping.disturbances[0].reach;
        const double reach = gas.sleeping.disturbances[0].reach;
        ASSERT_GE(reach, start + 1.5 * sound * (clock.time() - clock.duration()) * (1 - 1e-9) - 1.5 * sound * clock.duration());
        double fastest_asleep = 0;
        for (std::uint32_t i = 0; i < gas.sleeping.particles; ++i)
            fastest_asleep = std::max(fastest_asleep, static_cast<double>(norm(gas.particles[i].velocity)));
        ASSERT_LT(fastest_asleep, 7 * std::sqrt(gas.ambient.velocity_variance));
    }
    EXPECT_FALSE(gas.sleeping.any()) << "all gas is awake once sound could have crossed the box";
}

TEST(Sleep, threads_change_not_one_bit)
{
    const auto run = [](int threads) {
        const WithThreads with(threads);
        Gas gas = loud_air();
        Clock clock;
        while (clock.step() < 40) advance(gas, clock);
        return gas;
    };
    const Gas one = run(1);
    EXPECT_TRUE(one.sleeping.any());
    for (const int threads : {2, 3}) {
        const Gas other = run(threads);
        EXPECT_TRUE(same_bits(one.particles, other.particles));
        EXPECT_TRUE(same_bits(one.sleeping.turned, other.sleeping.turned));
    }
}

TEST(Sleep, goes_on_after_a_restart_as_if_nothing_had_been)
{
    Gas gas = loud_air();
    Clock clock;
    while (clock.step() < 20) advance(gas, clock);
    ASSERT_TRUE(gas.sleeping.any());
    Gas restored = loud_air();
    FieldSet from = state(gas), to = state(restored);
    for (std::size_t f = 0; f < from.fields.size(); ++f) {
        const Field& field = from.fields[f];
        std::vector<double> values(field.count * static_cast<std::size_t>(field.components) + 1);  // 8 bytes hold any scalar
        field.gather(values.data());
        to.fields[f].restore(values.data(), field.count);
    }
    restored.step_limit = gas.step_limit;
    Clock other = clock;
    while (clock.step() < 40) {
        advance(gas, clock);
        advance(restored, other);
    }
    EXPECT_TRUE(same_bits(gas.particles, restored.particles));
    EXPECT_EQ(gas.sleeping.zones.size(), restored.sleeping.zones.size());
}

}  // namespace
}  // namespace corpuscle
