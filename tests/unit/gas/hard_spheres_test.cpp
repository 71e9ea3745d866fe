#include "gas/hard_spheres.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "gas/sample.hpp"
#include "gas/sphere_grid.hpp"
#include "gas_samples.hpp"
#include "laws/collision/hard_spheres.hpp"
#include "math/random.hpp"

namespace corpuscle {
namespace {

/// A cube of 1 m with a gas of spheres of that law, mass and radius.
Gas empty_box(double gamma, double mass, double radius)
{
    Gas gas;
    gas.domain.box = unit_box;
    gas.settings.rule = CollisionRule::hard_spheres;
    gas.species.push_back(species_of(IdealGas{gamma}, mass));
    gas.species[0].radius = radius;
    return gas;
}

Particle sphere(const Vector3f& position, const Vector3f& velocity, std::uint32_t species = 0, float energy = 0)
{
    return {position, energy, velocity, particle_tag::make(species)};
}

/// One step of spheres alone.
void step(Gas& gas, double duration)
{
    const FacetTree walls{Surface{}};
    Clock clock;
    clock.begin_step(duration);
    sort(gas);
    collide(gas, clock, walls);
    fly(gas, clock, walls);
}

/// Index of the particle of a species (the only one).
const Particle& only(const Gas& gas, std::uint32_t species)
{
    return *std::find_if(gas.particles.begin(), gas.particles.end(),
                         [&](const Particle& p) { return particle_tag::species(p.tag) == species; });
}

TEST(HardSpheres, two_that_meet_head_on_swap_velocities_where_they_touch)
{
    Gas gas = empty_box(5.0 / 3, 1, 0.05);
    gas.species.push_back(gas.species[0]);
    gas.particles = {sphere({0.4f, 0.5f, 0.5f}, {1, 0, 0}), sphere({0.6f, 0.5f, 0.5f}, {-1, 0, 0}, 1)};
    step(gas, 0.1);  // touch at 0.05 s, 0.45 and 0.55 m
    EXPECT_NEAR(only(gas, 0).velocity.x, -1, 1e-6);
    EXPECT_NEAR(only(gas, 1).velocity.x, 1, 1e-6);
    EXPECT_NEAR(only(gas, 0).position.x, 0.4, 1e-6);
    EXPECT_NEAR(only(gas, 1).position.x, 0.6, 1e-6);
    EXPECT_EQ(gas.collisions, 1u);
}

/// Spheres of 1 and 3 kg, off centre: the velocities follow from the impulse J = 2 mu g_n along the line of centres at 30 degrees.
TEST(HardSpheres, unlike_masses_off_centre)
{
    Gas gas = empty_box(5.0 / 3, 1, 0.05);
    gas.species.push_back(species_of(IdealGas{5.0 / 3}, 3));
    gas.species[1].radius = 0.15;
    gas.particles = {sphere({0.2f, 0.4f, 0.5f}, {1, 0, 0}), sphere({0.6f, 0.5f, 0.5f}, {0, 0, 0}, 1)};
    step(gas, 0.4);
    const double cosine = std::sqrt(0.75), impulse = 2 * 0.75 * cosine;
    EXPECT_NEAR(only(gas, 0).velocity.x, 1 - impulse * cosine, 1e-6);
    EXPECT_NEAR(only(gas, 0).velocity.y, -impulse * 0.5, 1e-6);
    EXPECT_NEAR(only(gas, 1).velocity.x, impulse * cosine / 3, 1e-6);
    EXPECT_NEAR(only(gas, 1).velocity.y, impulse * 0.5 / 3, 1e-6);
}

TEST(HardSpheres, pass_each_other_beyond_contact)
{
    Gas gas = empty_box(5.0 / 3, 1, 0.05);
    gas.particles = {sphere({0.4f, 0.5f, 0.5f}, {1, 0, 0}), sphere({0.6f, 0.601f, 0.5f}, {-1, 0, 0})};
    step(gas, 0.3);
    EXPECT_EQ(gas.collisions, 0u);
}

TEST(HardSpheres, explosive_that_waits_is_not_met)
{
    Gas gas = empty_box(5.0 / 3, 1, 0.05);
    gas.particles = {sphere({0.4f, 0.5f, 0.5f}, {1, 0, 0}), sphere({0.6f, 0.5f, 0.5f}, {-1, 0, 0})};
    gas.particles[1].tag |= particle_tag::unburnt;
    step(gas, 0.3);
    EXPECT_EQ(gas.collisions, 0u);
}

TEST(HardSpheres, do_not_meet_through_a_wall)
{
    Surface wall;
    const std::vector<Vector3d> corners{{0.5, -9, -9}, {0.5, 9, -9}, {0.5, 0, 18}};
    wall.facets.push_back({{0, 1, 2}, 0, 0});
    FacetTree tree(wall);
    tree.follow({corners, corners});
    Gas gas = empty_box(5.0 / 3, 1, 0.05);
    gas.particles = {sphere({0.47f, 0.5f, 0.5f}, {1, 0, 0}), sphere({0.6f, 0.5f, 0.5f}, {-1, 0, 0})};
    Clock clock;
    clock.begin_step(0.02);
    sort(gas);
    collide(gas, clock, tree);
    EXPECT_EQ(gas.collisions, 0u);
}

/// What meetings in the order of time do to spheres in free space, by trying all pairs again after each one.
std::size_t meet_all(std::vector<Vector3d>& place, std::vector<Vector3d>& velocity, double contact, double duration)
{
    std::size_t met = 0;
    for (double now = 0;; ++met) {
        double soonest = duration - now;
        std::size_t a = 0, b = 0;
        for (std::size_t i = 0; i < place.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const double time = meeting_time(place[i] - place[j], velocity[i] - velocity[j], contact);
                if (time < soonest) soonest = time, a = i, b = j;
            }
        for (std::size_t i = 0; i < place.size(); ++i) place[i] += soonest * velocity[i];
        if (a == b) return met;
        now += soonest;
        const Vector3d normal = normalized(place[a] - place[b]);
        const Vector3d change = dot(velocity[b] - velocity[a], normal) * normal;
        velocity[a] += change, velocity[b] -= change;
    }
}

/// A crowd in a long step: many meet several times. Places and velocities are floats at the start and after each bounce: an error of
/// 1e-7 grows by about 2 path/radius, at most 50, at each further meeting of the same sphere; four in a row make 1e-7 * 50^4 at the very
/// worst, and 1e-3 is far below the free path of some 0.1 m.
TEST(HardSpheres, a_crowd_meets_in_the_order_of_time)
{
    constexpr double radius = 0.03, duration = 0.1;
    constexpr std::size_t count = 200;
    Gas gas = empty_box(5.0 / 3, 1, radius);
    Random random(3, Purpose::packing, 0, 0);
    while (gas.particles.size() < count) {
        const Vector3f at(static_cast<float>(0.2 + 0.6 * random.uniform_double()), static_cast<float>(0.2 + 0.6 * random.uniform_double()),
                          static_cast<float>(0.2 + 0.6 * random.uniform_double()));
        const bool free =
            std::all_of(gas.particles.begin(), gas.particles.end(), [&](const Particle& p) { return norm(p.position - at) > 2 * radius; });
        if (free) gas.particles.push_back(sphere(at, random.direction()));
    }
    sort(gas);
    std::vector<Vector3d> place, velocity;
    for (const Particle& p : gas.particles) {
        place.emplace_back(p.position);
        velocity.emplace_back(p.velocity);
    }
    const std::size_t met = meet_all(place, velocity, 2 * radius, duration);
    step(gas, duration);
    EXPECT_GT(met, count / 2);
    EXPECT_EQ(gas.collisions, met);
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_LT(norm(Vector3d(gas.particles[i].position) - place[i]), 1e-3) << i;
        EXPECT_LT(norm(Vector3d(gas.particles[i].velocity) - velocity[i]), 1e-3) << i;
    }
}

/// Momentum to the rounding of floats, energy with the internal one too, for unlike masses and every kind of exchange.
TEST(HardSpheres, a_pair_keeps_momentum_and_energy)
{
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Gas gas = empty_box(1.4, 1, 0.05);
        gas.settings.seed = seed;
        gas.settings.relaxation = 1.5;
        gas.species.push_back(species_of(IdealGas{1.2}, 7));
        gas.species[1].radius = 0.1;
        gas.particles = {sphere({0.4f, 0.45f, 0.5f}, {3, 0.5f, 0}, 0, 2), sphere({0.6f, 0.5f, 0.5f}, {-1, 0, 0.3f}, 1, 30)};
        const Passage before = contents(gas).gas;
        step(gas, 0.04);
        const Passage after = contents(gas).gas;
        EXPECT_EQ(gas.collisions, 1u);
        EXPECT_LT(norm(after.momentum - before.momentum), 1e-5);         // 10 kg m/s by 2^-24, some roundings
        EXPECT_NEAR(after.energy, before.energy, 1e-5 * before.energy);  // 2^-24 each, some roundings
    }
}

TEST(HardSpheres, radius)
{
    // b 0.3 is packing 0.086 at the reference density: m/rho0 = 2e-6 m3, 4/3 pi r^3 = 0.086 of it.
    const Species products = species_of(NobleAbel{1.3, 0.3, 1600}, 3.2e-3);
    const double radius = sphere_radius(products, 0.01, 1.0);
    EXPECT_NEAR(carnahan_starling(sphere_packing(1 / 2e-6, radius)), 1 / 0.7, 1e-9);
    const double air = sphere_radius(species_of(IdealGas{1.4}, 1e-3), 0.01, 1.25);
    EXPECT_NEAR(sphere_packing(1.25 / 1e-3, air), 0.01, 1e-12);
    EXPECT_NEAR(sphere_radius(species_of(NobleAbel{1.3, 0, 1600}, 1e-3), 0.01, 1.25), air, 1e-12);
}

TEST(HardSpheres, what_spheres_cannot_be_is_refused)
{
    EXPECT_THROW((void)sphere_radius(species_of(Jwl{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630}, 1), 0.01, 1630), InputError);
    EXPECT_THROW((void)sphere_radius(species_of(NobleAbel{1.3, 0.8, 1630}, 1), 0.01, 1630), InputError);
    EXPECT_NO_THROW((void)sphere_radius(species_of(NobleAbel{1.3, 0.74, 1630}, 1), 0.01, 1630));
}

/// A sample says the pressure that the spheres really have, not that of the law their radius was taken from.
TEST(HardSpheres, samples_tell_their_pressure)
{
    Gas gas = filled_box(unit_box, NobleAbel{1.3, 0.3, 1000}, 1000, 1e6, 4000);
    const GasSample by_law = sample(gas, Shape::box(unit_box), 1);
    gas.species[0].radius = sphere_radius(gas.species[0], 0.01, 1);
    gas.settings.rule = CollisionRule::hard_spheres;
    const GasSample at_reference = sample(gas, Shape::box(unit_box), 1);
    EXPECT_NEAR(at_reference.pressure, by_law.pressure, 1e-9 * by_law.pressure);  // the radius is matched at this density
    const GasSample thin = sample(gas, Shape::box(unit_box), 2);                  // as if spread over twice the volume
    EXPECT_NEAR(thin.pressure / thin.kinetic_pressure, carnahan_starling(0.5 * packing_of(1 / 0.7)), 1e-9);
    EXPECT_GT(thin.pressure / thin.kinetic_pressure, 1.01 / (1 - 0.15));
}

/// Every sphere within a box is visited, once, however small the cubes.
TEST(SphereGrid, finds_all_that_are_near)
{
    Gas gas = filled_box(unit_box, IdealGas{1.4}, 1, 1e5, 500);
    std::vector<std::uint32_t> all(gas.particles.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    for (const double side : {0.02, 0.1, 0.6, 5.0}) {
        const SphereGrid grid(gas, all, 0, side);
        const Box box{{0.31, -0.2, 0.5}, {0.62, 0.23, 1.7}};
        std::vector<int> visits(all.size());
        grid.visit(box.lower, box.upper, [&](std::uint32_t i) { ++visits[i]; });
        std::size_t inside = 0;
        for (const std::uint32_t i : all) {
            EXPECT_LE(visits[i], 1);
            if (!box.contains(Vector3d(gas.particles[i].position))) continue;
            EXPECT_EQ(visits[i], 1) << i;
            ++inside;
        }
        EXPECT_GT(inside, 10u);
    }
}

}  // namespace
}  // namespace corpuscle
