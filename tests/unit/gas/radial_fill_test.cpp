#include "gas/radial_fill.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"

#include "gas_samples.hpp"

namespace corpuscle {
namespace {

/// A ball of air of radius 1 in ten layers: denser and faster outward.
RadialFill ball(const Vector3d& center)
{
    RadialFill fill;
    fill.center = center;
    for (int i = 0; i < 10; ++i) {
        const double inner = 0.1 * i, outer = 0.1 * (i + 1);
        const RadialLayer layer{inner, outer, 1.0 + i, 2e5, 100 * inner, 100 * outer};
        const double mass = layer.density * 4 * std::numbers::pi / 3 * (std::pow(outer, 3) - std::pow(inner, 3));
        const double low = layer.inner_velocity, high = layer.outer_velocity;
        fill.layers.push_back(layer);
        fill.mass += mass;
        fill.momentum += 0.5 * mass * (low + high);
        fill.energy += mass * (layer.energy + 0.25 * (low * low + high * high));
    }
    return fill;
}

Gas filled(const Box& box, const RadialFill& fill, std::size_t count)
{
    Gas gas;
    gas.domain.box = box;
    const double share = sector_of(gas.domain, fill.center).share();
    gas.species.push_back(species_of(IdealGas{1.4}, share * fill.mass / static_cast<double>(count)));
    fill_radial(gas, fill, count);
    return gas;
}

struct Part {
    const char* name;
    Box box;
    double share;
    Vector3d mean;  ///< of the directions
};

/// Boxes that hold a ball around the origin, its halves, quarters and an eighth, on either side.
std::vector<Part> parts()
{
    return {{"whole", {{-2, -2, -2}, {2, 2, 2}}, 1, {}},
            {"half", {{-2, -2, 0}, {2, 2, 2}}, 0.5, {0, 0, 0.5}},
            {"other half", {{-2, -2, -2}, {0, 2, 2}}, 0.5, {-0.5, 0, 0}},
            {"quarter", {{0, -2, -2}, {2, 0, 2}}, 0.25, {0.5, -0.5, 0}},
            {"eighth", {{-2, -2, -2}, {0, 0, 0}}, 0.125, {-0.5, -0.5, -0.5}}};
}

TEST(RadialFill, mass_momentum_and_energy_are_those_of_the_flow)
{
    const RadialFill fill = ball({});
    for (const Part& part : parts()) {
        const Gas gas = filled(part.box, fill, 10000);
        const GasContents held = contents(gas);
        double radial = 0;
        for (const Particle& p : gas.particles)
            radial += gas.species[0].particle_mass * dot(Vector3d(p.velocity), normalized(Vector3d(p.position)));
        // Positions, velocities and energies are single: each is off by at most 6e-8 of itself.
        EXPECT_NEAR(held.gas.mass / (part.share * fill.mass), 1, 1e-12) << part.name;
        EXPECT_NEAR(held.gas.energy / (part.share * fill.energy), 1, 1e-7) << part.name;
        EXPECT_NEAR(radial / (part.share * fill.momentum), 1, 1e-6) << part.name;
        const Vector3d missing = held.gas.momentum - part.share * fill.momentum * part.mean;
        EXPECT_LT(norm(missing), 1e-6 * part.share * fill.momentum) << part.name;
    }
}

TEST(RadialFill, particles_lie_in_their_sector_as_the_layers_have_them)
{
    const RadialFill fill = ball({});
    for (const Part& part : parts()) {
        constexpr std::size_t count = 20000;
        const Gas gas = filled(part.box, fill, count);
        const double particle_mass = gas.species[0].particle_mass;
        std::array<double, 10> mass{}, velocity{}, energy{};
        Vector3d direction;
        for (const Particle& p : gas.particles) {
            const Vector3d place(p.position), own(p.velocity);
            const double r = norm(place);
            ASSERT_TRUE(part.box.contains(place) && r < 1) << part.name;
            const auto layer = static_cast<std::size_t>(10 * r);
            mass[layer] += particle_mass;
            velocity[layer] += particle_mass * dot(own, place) / r;
            const Vector3d thermal = own - 100.0 * place;
            energy[layer] += 0.5 * particle_mass * norm_squared(thermal) + p.energy;
            direction += place / r;
        }
        // Stratified in mass and angle: directions are even far better than chance, whose error is 1/sqrt(3 n) = 0.004.
        EXPECT_LT(norm((1.0 / count) * direction - part.mean), 0.002) << part.name;
        for (std::size_t i = 3; i < 10; ++i) {
            const RadialLayer& layer = fill.layers[i];
            const double volume = 4 * std::numbers::pi / 3 * (std::pow(layer.outer, 3) - std::pow(layer.inner, 3));
            const double n = mass[i] / particle_mass;
            // Shells are a spacing thick, and particles within them at random: at each face at most a shell's n^(2/3) of them, 4 sigma.
            EXPECT_NEAR(mass[i] / (part.share * layer.density * volume), 1, 4 * std::sqrt(2 * std::pow(n, 2.0 / 3)) / n) << part.name << i;
            // Thermal speed of 283 m/s a component; blocks of 64 have no mean, so less than chance is left: 4 sigma of chance.
            EXPECT_NEAR(velocity[i] / mass[i], 50 * (layer.inner + layer.outer), 4 * 283 / std::sqrt(n) + 2) << part.name << i;
            EXPECT_NEAR(energy[i] / mass[i] / layer.energy, 1, 4 / std::sqrt(n)) << part.name << i;
        }
    }
}

TEST(RadialFill, same_bits_for_any_number_of_threads)
{
    const RadialFill fill = ball({1, 0, 0});
    const Box box{{-1, 0, -1}, {3, 1, 1}};
    const WithThreads one(1);
    const Gas alone = filled(box, fill, 5000);
    const WithThreads three(3);
    EXPECT_TRUE(same_bits(alone.particles, filled(box, fill, 5000).particles));
}

TEST(RadialFill, refuses_a_flow_without_heat)
{
    RadialFill fill = ball({});
    fill.energy *= 1e-3;
    EXPECT_THROW(filled({{-2, -2, -2}, {2, 2, 2}}, fill, 100), InputError);
}

}  // namespace
}  // namespace corpuscle
