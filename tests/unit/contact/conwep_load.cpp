#include "contact/conwep_load.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"

namespace corpuscle {
namespace {

/// A flat square plate of cells x cells squares in z = 0, two facets each, around the origin; nodes free unless held.
Structure square_plate(double side, int cells, bool held)
{
    Structure structure;
    Nodes& nodes = structure.nodes;
    std::vector<Vector3d> places;
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) places.push_back({side * i / cells - side / 2, side * j / cells - side / 2, 0});
    }
    nodes.add(places);
    nodes.mass.assign(places.size(), 0.05);
    const double inverse = held ? 0 : 1 / 0.05;
    nodes.inverse_mass.assign(places.size(), {inverse, inverse, inverse});
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const auto first = static_cast<std::uint32_t>(j * (cells + 1) + i), above = first + static_cast<std::uint32_t>(cells + 1);
            structure.surface.facets.push_back({{first, first + 1, above + 1}, 0, 0});
            structure.surface.facets.push_back({{first, above + 1, above}, 0, 0});
        }
    }
    return structure;
}

/// Applies the load in steps of a length [s] until an end [s]; returns all it gave.
Transfer apply_until(ConwepLoad& load, double end, double step)
{
    Clock clock;
    Transfer total;
    while (clock.time() < end) {
        clock.begin_step(step);
        for (const Transfer& given : load.apply(clock)) {
            EXPECT_EQ(given.from, "conwep");
            EXPECT_EQ(given.to, "structure");
            EXPECT_EQ(given.mass, 0);
            total.momentum += given.momentum;
            total.energy += given.energy;
        }
        clock.end_step();
    }
    return total;
}

Vector3d total_of(const std::vector<Vector3d>& vectors)
{
    Vector3d total;
    for (const Vector3d& v : vectors) total += v;
    return total;
}

const ConwepCharge charge{15, {0, 0, 0.7}, Burst::spherical, 0};

TEST(ConwepLoad, held_plate_takes_the_reflected_impulse)
{
    Structure structure = square_plate(0.02, 1, true);
    ConwepLoad load(structure, 0, charge);
    const Transfer given = apply_until(load, 3e-3, 1.7e-6);
    const double expected = kingery_bulmash(Burst::spherical, 15, 0.7).reflected_impulse * 0.02 * 0.02;
    EXPECT_NEAR(given.momentum.z / -expected, 1, 0.005);
    EXPECT_NEAR(given.momentum.x, 0, 1e-3 * expected);
    EXPECT_EQ(given.energy, 0);
    const Vector3d taken = total_of(structure.nodes.impulse);
    EXPECT_NEAR(taken.z / given.momentum.z, 1, 1e-12);
}

TEST(ConwepLoad, plate_takes_the_angle_rules_impulse)
{
    // Impulse on a square by a fine midpoint sum of I_r c^2 + I_i (1 + c^2 - 2 c), against coarse facets: they must come nearer as h^2.
    const double side = 1.0;
    double expected = 0;
    constexpr int fine = 300;
    for (int j = 0; j < fine; ++j) {
        for (int i = 0; i < fine; ++i) {
            const double x = side * ((i + 0.5) / fine - 0.5), y = side * ((j + 0.5) / fine - 0.5);
            const double distance = std::sqrt(x * x + y * y + 0.49), c = 0.7 / distance;
            const BlastWave wave = kingery_bulmash(Burst::spherical, 15, distance);
            expected += (wave.reflected_impulse * c * c + wave.incident_impulse * (1 + c * c - 2 * c)) * side * side / (fine * fine);
        }
    }
    std::array<double, 2> miss{};
    for (int k = 0; k < 2; ++k) {
        Structure structure = square_plate(side, 10 << k, true);
        ConwepLoad load(structure, 0, charge);
        miss[k] = apply_until(load, 5e-3, 1e-4).momentum.z / -expected - 1;
    }
    EXPECT_NEAR(miss[1], 0, 0.005);
    EXPECT_LT(std::abs(miss[1]), 0.35 * std::abs(miss[0]));
}

TEST(ConwepLoad, pushes_away_from_the_charge_whichever_way_facets_are_turned)
{
    Structure structure = square_plate(0.3, 3, true), turned = structure;
    for (Facet& facet : turned.surface.facets) std::swap(facet.node[1], facet.node[2]);
    ConwepLoad load(structure, 0, charge), other(turned, 0, charge);
    const Transfer given = apply_until(load, 2e-3, 1e-5), same = apply_until(other, 2e-3, 1e-5);
    EXPECT_LT(given.momentum.z, 0);
    EXPECT_NEAR(same.momentum.z / given.momentum.z, 1, 1e-12);

    Structure below = square_plate(0.3, 3, true);
    ConwepLoad from_below(below, 0, {15, {0, 0, -0.7}, Burst::spherical, 0});
    EXPECT_NEAR(apply_until(from_below, 2e-3, 1e-5).momentum.z / -given.momentum.z, 1, 1e-12);
}

/// Adds a facet of a further part: a triangle in z = height that covers the plate as seen from above. [m]
void add_screen(Structure& structure, double height)
{
    const std::uint32_t first = structure.nodes.add({{-2, -1, height}, {2, -1, height}, {0, 3, height}});
    structure.surface.facets.push_back({{first, first + 1, first + 2}, 1, 1});
}

TEST(ConwepLoad, what_another_part_hides_gets_nothing_or_the_incident_wave)
{
    Structure open = square_plate(0.02, 1, true), hidden = open, beside = open;
    add_screen(hidden, 0.3);
    add_screen(beside, -0.3);                                 // behind the plate
    EXPECT_THROW(ConwepLoad(hidden, 0, charge), InputError);  // none of it sees the charge
    ConwepLoad in_the_open(open, 0, charge), before_a_wall(beside, 0, charge);
    const double full = apply_until(in_the_open, 3e-3, 1e-5).momentum.z;
    EXPECT_EQ(apply_until(before_a_wall, 3e-3, 1e-5).momentum.z, full);

    ConwepCharge diffracted = charge;
    diffracted.shadow = Shadow::incident;
    ConwepLoad shadowed(hidden, 0, diffracted);
    const double expected = kingery_bulmash(Burst::spherical, 15, 0.7).incident_impulse * 0.02 * 0.02;
    EXPECT_NEAR(apply_until(shadowed, 5e-3, 1e-5).momentum.z / -expected, 1, 0.005);
    ConwepLoad on_the_screen(hidden, 1, charge);  // which sees it
    EXPECT_LT(apply_until(on_the_screen, 3e-3, 1e-5).momentum.z, 0);
}

TEST(ConwepLoad, half_a_screen_shades_half_a_plate)
{
    Structure structure = square_plate(1, 10, true);
    add_screen(structure, 0.01);
    for (std::size_t n = structure.nodes.reference.size() - 3; n < structure.nodes.reference.size(); ++n)
        structure.nodes.reference[n].x += 2.0;  // from x = 0 on, about
    structure.nodes.reference[structure.nodes.reference.size() - 1] = {0, 3, 0.01};
    structure.nodes.reference[structure.nodes.reference.size() - 3] = {0, -3, 0.01};
    structure.nodes.previous = structure.nodes.position = structure.nodes.reference;
    ConwepLoad load(structure, 0, {15, {0, 0, 0.7}, Burst::spherical, 0});
    for (const std::uint32_t f : load.facets()) {
        const auto& node = structure.surface.facets[f].node;
        double x = 0;
        for (const std::uint32_t n : node) x += structure.nodes.reference[n].x / 3;
        EXPECT_LT(x, 0);
    }
    EXPECT_EQ(load.facets().size(), 100u);  // half of 200
}

TEST(ConwepLoad, work_is_the_kinetic_energy_of_free_nodes)
{
    Structure structure = square_plate(0.3, 3, false);
    for (std::size_t i = 0; i < structure.nodes.size(); ++i) structure.nodes.velocity[i] = {1.0, -2.0, 3.0 + 0.1 * static_cast<double>(i)};
    const auto kinetic = [&] {
        double energy = 0;
        for (std::uint32_t i = 0; i < structure.nodes.size(); ++i)
            energy += 0.5 * structure.nodes.mass[i] * norm_squared(structure.nodes.contact_velocity(i));
        return energy;
    };
    ConwepLoad load(structure, 0, charge);
    const double before = kinetic();
    const Transfer given = apply_until(load, 2e-3, 3e-6);
    EXPECT_NEAR(given.energy / (kinetic() - before), 1, 1e-11);
    EXPECT_GT(std::abs(given.energy), 1);
    EXPECT_NEAR(norm(total_of(structure.nodes.impulse) - given.momentum) / norm(given.momentum), 0, 1e-12);
}

TEST(ConwepLoad, work_counts_the_half_step_of_the_inner_force)
{
    Structure structure = square_plate(0.3, 1, false);
    constexpr double step = 1e-5, force = -3000, inverse_mass = 1 / 0.05;
    for (Vector3d& inner : structure.nodes.force) inner = {0, 0, force};
    ConwepLoad load(structure, 0, charge);
    Clock clock;
    clock.restore(250e-6, step, step, 25);
    clock.begin_step(step);
    const Transfer given = load.apply(clock).front();
    double work = 0;  // impulse times the mean of the velocities that central difference has half a step before and half a step after
    for (const Vector3d& impulse : structure.nodes.impulse) work += impulse.z * 0.5 * (impulse.z + force * step) * inverse_mass;
    EXPECT_LT(given.momentum.z, -1);
    EXPECT_NEAR(given.energy / work, 1, 1e-12);
}

TEST(ConwepLoad, steps_of_any_length_give_the_same_impulse)
{
    Structure structure = square_plate(0.3, 2, true);
    ConwepLoad load(structure, 0, charge), again(structure, 0, charge);
    EXPECT_NEAR(apply_until(load, 4e-3, 7e-7).momentum.z / apply_until(again, 4e-3, 4e-3).momentum.z, 1, 1e-11);
}

TEST(ConwepLoad, nothing_comes_before_the_arrival_and_detonation_may_wait)
{
    Structure structure = square_plate(0.02, 1, true);
    const double arrival = kingery_bulmash(Burst::spherical, 15, 0.7).arrival;
    ConwepLoad load(structure, 0, charge), late(structure, 0, {15, {0, 0, 0.7}, Burst::spherical, 1e-3});
    EXPECT_EQ(apply_until(load, 0.99 * arrival, 0.99 * arrival).momentum.z, 0);
    EXPECT_EQ(apply_until(late, 1e-3 + 0.99 * arrival, 1e-3 + 0.99 * arrival).momentum.z, 0);
    EXPECT_LT(apply_until(load, 1.05 * arrival, 1.05 * arrival).momentum.z, 0);
    EXPECT_NEAR(apply_until(late, 10e-3, 1e-4).momentum.z / apply_until(load, 10e-3, 1e-4).momentum.z, 1, 1e-9);
}

TEST(ConwepLoad, push_follows_the_plate_as_it_turns)
{
    Structure structure = square_plate(0.02, 1, true);
    ConwepLoad load(structure, 0, charge);
    for (std::size_t i = 0; i < structure.nodes.size(); ++i) {
        const Vector3d at = structure.nodes.reference[i];
        structure.nodes.previous[i] = structure.nodes.position[i] = {at.x * std::cos(0.2), at.y, -at.x * std::sin(0.2)};
    }
    const Vector3d given = apply_until(load, 3e-3, 1e-5).momentum;
    EXPECT_NEAR(given.x / given.z, std::tan(0.2), 1e-9);
}

TEST(ConwepLoad, takes_only_its_part)
{
    Structure structure = square_plate(0.02, 1, true);
    structure.surface.facets[1].part = 1;
    ConwepLoad load(structure, 0, charge);
    EXPECT_THAT(load.facets(), testing::ElementsAre(0U));
    const double expected = kingery_bulmash(Burst::spherical, 15, 0.7).reflected_impulse * 0.02 * 0.02 / 2;
    EXPECT_NEAR(apply_until(load, 3e-3, 1e-5).momentum.z / -expected, 1, 0.005);
}

TEST(ConwepLoad, hemisphere_on_the_ground_pushes_harder)
{
    Structure structure = square_plate(0.02, 1, true);
    ConwepLoad load(structure, 0, {15, {0, 0, 0.7}, Burst::hemispherical, 0});
    const double expected = kingery_bulmash(Burst::hemispherical, 15, 0.7).reflected_impulse * 0.02 * 0.02;
    EXPECT_NEAR(apply_until(load, 3e-3, 1e-5).momentum.z / -expected, 1, 0.005);
}

TEST(ConwepLoad, refusals_name_part_and_range)
{
    Structure structure = square_plate(0.02, 1, true);
    const auto message_of = [&](std::uint32_t part, const ConwepCharge& wrong) {
        try {
            ConwepLoad load(structure, part, wrong);
        } catch (const InputError& error) {
            return error.problem();
        }
        return std::string("accepted");
    };
    EXPECT_THAT(message_of(0, {15, {0, 0, 0.1}, Burst::spherical, 0}),
                testing::AllOf(testing::HasSubstr("part 'number 0'"), testing::HasSubstr("0.0531..40")));
    EXPECT_THAT(message_of(0, {1, {0, 0, 41}, Burst::spherical, 0}), testing::HasSubstr("0.0531..40"));
    EXPECT_THAT(message_of(3, charge), testing::HasSubstr("no surface"));
}

TEST(ConwepLoad, keeps_impulse_and_peak_of_each_facet_and_brings_its_state_back)
{
    Structure structure = square_plate(0.02, 1, true);
    ConwepLoad load(structure, 0, charge), other(structure, 0, charge);
    apply_until(load, 3e-3, 1e-5);
    const BlastWave wave = kingery_bulmash(Burst::spherical, 15, 0.7);
    const auto values_of = [](ConwepLoad& which, const char* field) {
        std::vector<float> values(2);
        const FieldSet set = which.facet_fields();
        set.find(field)->gather(values.data());
        return values;
    };
    EXPECT_NEAR(values_of(load, "specific_impulse")[0] / wave.reflected_impulse, 1, 0.005);
    EXPECT_NEAR(values_of(load, "peak_pressure")[1] / wave.reflected_pressure, 1, 0.005);
    EXPECT_NEAR(values_of(load, "arrival")[1] / wave.arrival, 1, 0.005);
    EXPECT_EQ(values_of(load, "pressure")[1], 0);

    const FieldSet from = load.state(), to = other.state();
    std::vector<double> saved(2);
    from.fields[0].gather(saved.data());
    to.fields[0].restore(saved.data(), 2);
    EXPECT_EQ(values_of(other, "specific_impulse"), values_of(load, "specific_impulse"));
}

}  // namespace
}  // namespace corpuscle
