#include "gas/sample.hpp"

#include <gtest/gtest.h>

#include "gas_samples.hpp"

namespace corpuscle {
namespace {

/// Two species, one of them stiff, four particles in the left half of the unit box, others that do not count.
Gas few()
{
    Gas gas;
    gas.domain.box = unit_box;
    gas.species = {species_of(IdealGas{1.4}, 0.1), species_of(NobleAbel{1.3, 0.5, 10}, 0.3)};
    gas.charges.push_back({"charge", 1, 1, 1, 1, {}});
    const auto add = [&](const Vector3f& place, const Vector3f& velocity, float energy, std::uint32_t tag) {
        gas.particles.push_back({place, energy, velocity, tag});
    };
    add({0.1f, 0.2f, 0.3f}, {1, 0, 2}, 5, 0);
    add({0.2f, 0.7f, 0.9f}, {-3, 1, 0}, 1, 0);
    add({0.3f, 0.7f, 0.2f}, {0, 4, 1}, 2, 1);
    add({0.4f, 0.1f, 0.6f}, {2, -1, 1}, 3, 1);
    add({0.2f, 0.2f, 0.2f}, {100, 100, 100}, 50, particle_tag::make(1, 0, particle_tag::unburnt));
    add({0.2f, 0.2f, 0.2f}, {100, 100, 100}, 50, particle_tag::gone);
    return gas;
}

const Shape left_half = Shape::box({{0, 0, 0}, {0.5, 1, 1}});

TEST(Sample, is_what_the_particles_make)
{
    const Gas gas = few();
    const GasSample found = sample(gas, left_half, 0.5);
    EXPECT_EQ(found.particles, 4u);
    EXPECT_NEAR(found.density, 0.8 / 0.5, 1e-12);
    const Vector3d mean = (0.1 * Vector3d{-2, 1, 2} + 0.3 * Vector3d{2, 3, 2}) / 0.8;
    EXPECT_NEAR(norm(found.velocity - mean), 0, 1e-12);
    std::array<double, 2> thermal{};
    for (int i = 0; i < 4; ++i) thermal[i / 2] += 0.5 * (i < 2 ? 0.1 : 0.3) * norm_squared(Vector3d(gas.particles[i].velocity) - mean);
    EXPECT_NEAR(found.kinetic_pressure, 2.0 / 3 * (thermal[0] + thermal[1]) / 0.5, 1e-12);
    const double filled = 0.5 * (0.6 / 0.5) / 10;  // co-volume share of the stiff species at its own density
    EXPECT_NEAR(found.pressure, 2.0 / 3 * (thermal[0] + thermal[1] / (1 - filled)) / 0.5, 1e-12);
    EXPECT_NEAR(found.energy, (thermal[0] + thermal[1] + 11) / 0.8, 1e-12);
}

TEST(Sample, of_nothing_is_nothing)
{
    const GasSample found = sample(few(), Shape::box({{0.6, 0, 0}, {1, 1, 1}}), 0.4);
    EXPECT_EQ(found.particles, 0u);
    EXPECT_EQ(found.density, 0);
    EXPECT_EQ(found.pressure, 0);
    EXPECT_EQ(found.energy, 0);
}

/// Density and pressure of a fresh fill are those asked for; the sample sees velocities from the mean of the n it finds: 1 - 1/n.
TEST(Sample, finds_the_state_that_was_filled)
{
    const Gas gas = filled_box(unit_box, IdealGas{1.4}, 1.2, 2e5, 10000);
    const GasSample found = sample(gas, Shape::box(unit_box), 1);
    EXPECT_NEAR(found.density, 1.2, 1e-12);
    EXPECT_NEAR(found.pressure, 0.4 * 1.2 * 2e5, 2e-7 * 0.4 * 1.2 * 2e5);
    EXPECT_NEAR(found.energy, 2e5, 0.04);
}

/// Standard errors of n particles of a Maxwellian gas, from the moments of a normal law: density rho/sqrt(n), a velocity sigma/sqrt(n),
/// pressure p sqrt(5/(3 n)), temperature T sqrt(2/(3 n)). The errors themselves are sums over 10000 particles: of c^4 its relative
/// standard deviation is sqrt((945 - 225)/225/n) = 1.8 %, of (c^2 - <c^2>)^2 sqrt(60/4/n) = 3.9 %, half of that in the root; 4 sigma.
TEST(Sample, states_the_errors_of_a_maxwellian_gas)
{
    Gas gas = filled_box(unit_box, IdealGas{1.4}, 1.2, 2e5, 10000);
    gas.species[0].molar_mass = 0.029;
    const GasSample found = sample(gas, Shape::box(unit_box), 1);
    const double root = std::sqrt(10000.0), sigma = std::sqrt(0.4 * 2e5);
    EXPECT_NEAR(found.temperature, 0.4 * 2e5 * 0.029 / 8.31446261815324, 1e-4 * found.temperature);
    EXPECT_NEAR(found.error.density, 1.2 / root, 1e-12);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(found.error.velocity[axis], sigma / root, 0.03 * sigma / root);
    const double pressure = found.pressure * std::sqrt(5.0 / 3) / root, heat = found.temperature * std::sqrt(2.0 / 3) / root;
    EXPECT_NEAR(found.error.pressure, pressure, 4 * 0.009 * pressure);
    EXPECT_EQ(found.error.kinetic_pressure, found.error.pressure);
    EXPECT_NEAR(found.error.temperature, heat, 4 * 0.02 * heat);
}

/// Where the law is stiff and two gases mix, the errors are those of the jackknife: what each particle's absence changes, squared and
/// added. A jackknife differs by the share of one particle in a ratio, 1/n of it.
TEST(Sample, states_the_errors_the_jackknife_finds)
{
    Gas gas = filled_box(unit_box, NobleAbel{1.3, 0.5, 10}, 6, 2e5, 600);
    gas.species.push_back(species_of(IdealGas{1.4}, 0.004));
    for (Species& species : gas.species) species.molar_mass = 0.03;
    for (std::size_t i = 0; i < 600; i += 3) gas.particles[i].tag = particle_tag::make(1);
    const Shape whole = Shape::box(unit_box);
    const GasSample all = sample(gas, whole, 1);
    GasSampleError squares{0, {}, 0, 0, 0};
    for (Particle& left_out : gas.particles) {
        left_out.tag |= particle_tag::gone;
        const GasSample rest = sample(gas, whole, 1);
        left_out.tag &= ~particle_tag::gone;
        squares.density += std::pow(rest.density - all.density, 2);
        squares.velocity.x += std::pow(rest.velocity.x - all.velocity.x, 2);
        squares.kinetic_pressure += std::pow(rest.kinetic_pressure - all.kinetic_pressure, 2);
        squares.pressure += std::pow(rest.pressure - all.pressure, 2);
        squares.temperature += std::pow(rest.temperature - all.temperature, 2);
    }
    const double close = 0.01;
    EXPECT_NEAR(all.error.density, std::sqrt(squares.density), 1e-9 * all.error.density);
    EXPECT_NEAR(all.error.velocity.x, std::sqrt(squares.velocity.x), close * all.error.velocity.x);
    EXPECT_NEAR(all.error.kinetic_pressure, std::sqrt(squares.kinetic_pressure), close * all.error.kinetic_pressure);
    EXPECT_NEAR(all.error.pressure, std::sqrt(squares.pressure), close * all.error.pressure);
    EXPECT_NEAR(all.error.temperature, std::sqrt(squares.temperature), close * all.error.temperature);
}

/// A gas whose molar mass is not known has no temperature.
TEST(Sample, has_no_temperature_without_a_molar_mass)
{
    EXPECT_TRUE(std::isnan(sample(few(), left_half, 0.5).temperature));
}

/// Each cell of the grid is the sample of its box; together they hold all mass and momentum.
TEST(Average, is_the_sample_of_every_cell)
{
    Gas gas = few();
    gas.domain.box = {{0, 0, 0}, {1, 1.5, 0.75}};
    gas.particles.clear();
    fill(gas, {Shape::box(gas.domain.box), {}, 0, 3, 100, {5, 0, -3}, -1}, 900);
    fill(gas, {Shape::sphere({0.5, 0.7, 0.4}, 0.3), {}, 1, 9, 100, {}, -1}, 300);
    const GasGrid grid = average(gas, 0.26);
    ASSERT_EQ(grid.cells, (std::array<std::size_t, 3>{4, 6, 3}));
    double mass = 0;
    Vector3d momentum;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t j = 0; j < 6; ++j) {
            for (std::size_t i = 0; i < 4; ++i) {
                const Vector3d lower{0.25 * static_cast<double>(i), 0.25 * static_cast<double>(j), 0.25 * static_cast<double>(k)};
                const Shape cell = Shape::box({lower, lower + Vector3d{0.25, 0.25, 0.25}});
                const double volume = 0.25 * 0.25 * 0.25;
                const GasSample expected = sample(gas, cell, volume);
                const std::size_t c = (k * 6 + j) * 4 + i;
                const double products =
                    (expected.density * volume - 0.1 * static_cast<double>(expected.particles)) / 0.2 * 0.3;  // of 0.1 and 0.3 kg
                EXPECT_FLOAT_EQ(grid.density[c], static_cast<float>(expected.density));
                EXPECT_NEAR(grid.pressure[c], expected.pressure, 1e-6 * expected.pressure);
                EXPECT_NEAR(norm(Vector3d(grid.velocity[c]) - expected.velocity), 0, 1e-5);
                EXPECT_NEAR(grid.product_share[c], expected.density > 0 ? products / (expected.density * volume) : 0, 1e-6);
                mass += static_cast<double>(grid.density[c]) * volume;
                momentum += static_cast<double>(grid.density[c]) * volume * Vector3d(grid.velocity[c]);
            }
        }
    }
    const Passage held = contents(gas).gas;
    EXPECT_NEAR(mass, held.mass, 1e-6 * held.mass);
    EXPECT_NEAR(norm(momentum - held.momentum), 0, 1e-6 * speed_sum(gas));
}

/// Values of a field, as a writer gathers them.
template <class T>
std::vector<T> values(const FieldSet& set, const std::string& name)
{
    const Field* field = set.find(name);
    std::vector<T> list(field ? field->count : 0);
    if (field) field->gather(list.data());
    return list;
}

TEST(Fields, show_grid_and_particles)
{
    const Gas gas = few();
    const GasGrid grid = average(gas, 0.5);
    const FieldSet cells = fields(grid);
    EXPECT_EQ(values<float>(cells, "density"), grid.density);
    EXPECT_EQ(values<float>(cells, "pressure"), grid.pressure);
    EXPECT_EQ(values<float>(cells, "product_share"), grid.product_share);
    EXPECT_EQ(values<Vector3f>(cells, "velocity"), grid.velocity);

    const FieldSet shown = particle_fields(gas);
    EXPECT_EQ(values<float>(shown, "speed")[0], std::sqrt(5.0f));
    EXPECT_EQ(values<float>(shown, "speed")[4], 0);  // waits
    EXPECT_EQ(values<Vector3f>(shown, "velocity")[2], (Vector3f{0, 4, 1}));
    EXPECT_EQ(values<float>(shown, "internal_energy")[3], 10);
    EXPECT_EQ(values<std::uint8_t>(shown, "species")[3], 1);
    EXPECT_EQ(values<std::uint8_t>(shown, "burnt")[3], 1);
    EXPECT_EQ(values<std::uint8_t>(shown, "burnt")[4], 0);
}

}  // namespace
}  // namespace corpuscle
