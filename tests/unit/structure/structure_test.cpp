#include "structure/structure.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <memory>

#include "parallel/loops.hpp"
#include "plates.hpp"
#include "structure/energy.hpp"
#include "structure/fields.hpp"

namespace corpuscle {
namespace {

using testing::HasSubstr;

/// A plate of 400 elements held on one side, thrown and hit: it bends, yields and rings.
std::unique_ptr<Structure> thrown_plate(int threads = 1)
{
    set_thread_count(threads);
    auto structure = std::make_unique<Structure>();
    PartDescription d = plate(square_mesh(20, 0.2, 0.2), armour_steel(), 0.005);
    for (std::uint32_t i = 0; i <= 20; ++i) d.holds.push_back(clamp({i}));
    d.velocity = {3.0, 0.0, 150.0};
    add_part(*structure, d);
    return structure;
}

TEST(Structure, EmptyOneCostsNothing)
{
    Structure empty;
    Clock clock;
    clock.begin_step(1e-6);
    EXPECT_EQ(stable_step(empty), std::numeric_limits<double>::infinity());
    EXPECT_TRUE(accelerate(empty, clock).empty());
    resist(empty, clock);
    EXPECT_EQ(energy(empty).total(), 0.0);
    EXPECT_EQ(node_fields(empty).fields[0].count, 0);
    EXPECT_TRUE(cells(empty).empty());
}

TEST(Structure, StepOfASquareIsItsPlateWaveTransit)
{
    Structure structure;
    add_part(structure, plate(square_mesh(3, 0.3), elastic_steel(), 0.002));
    const double speed = std::sqrt(212e9 / (7838.0 * (1.0 - 0.28 * 0.28)));
    EXPECT_NEAR(stable_step(structure), 0.9 * 0.1 / (speed * std::sqrt(1.28)), 1e-12);
}

TEST(Structure, ContactSeesWaitingImpulses)
{
    Structure structure;
    PartDescription d = plate(square_mesh(1, 0.1), elastic_steel(), 0.01);
    d.holds = {clamp({0})};
    add_part(structure, d);
    Nodes& n = structure.nodes;
    n.impulse[0] = n.impulse[1] = {0.0, 0.0, 2.0};
    EXPECT_EQ(n.contact_velocity(0), Vector3d());
    EXPECT_DOUBLE_EQ(n.contact_velocity(1).z, 2.0 / n.mass[1]);
}

TEST(Structure, ImpulsesAndSupportsBalanceMomentum)
{
    auto structure = thrown_plate();
    Clock clock;
    Vector3d given = momentum(*structure);
    for (int i = 0; i < 200; ++i) {
        structure->nodes.impulse[10] += {0.0, 0.0, 1.0};  // on a held node
        structure->nodes.impulse[300] += {0.1, 0.2, -0.5};
        given += Vector3d{0.1, 0.2, 0.5};
        clock.begin_step(stable_step(*structure));
        const std::vector<Transfer> transfers = accelerate(*structure, clock);
        ASSERT_EQ(transfers.size(), 1);
        EXPECT_EQ(transfers[0].from, "support");
        EXPECT_EQ(transfers[0].energy, 0.0);
        given += transfers[0].momentum;
        resist(*structure, clock);
        clock.end_step();
        EXPECT_NEAR(norm(momentum(*structure) - given), 0.0, 1e-9);
    }
    EXPECT_GT(norm(given), 1.0);
}

TEST(Structure, EnergyClosesAgainstTheWorkOfImpulses)
{
    auto structure = thrown_plate();
    Clock clock;
    double expected = energy(*structure).total();
    for (int i = 0; i < 300; ++i) {
        const Vector3d push{0.0, 0.0, 0.3};
        const Vector3d before = structure->nodes.contact_velocity(250);
        structure->nodes.impulse[250] += push;
        expected += 0.5 * dot(push, before + structure->nodes.contact_velocity(250));
        step(*structure, clock, stable_step(*structure));
    }
    EXPECT_NEAR(energy(*structure).total(), expected, 1e-10 * expected);
    EXPECT_GT(energy(*structure).plastic, 0.01 * expected);
}

TEST(Structure, IntegrationEnergyIsWorkInTransitWhenTheStepIsConstant)
{
    auto structure = thrown_plate();
    Clock clock;
    const double duration = 0.8 * stable_step(*structure);
    for (int i = 0; i < 400; ++i) step(*structure, clock, duration);
    const StructureEnergy e = energy(*structure);
    EXPECT_NEAR(e.integration, work_in_transit(*structure, duration), 1e-10 * e.total());
}

TEST(Structure, ThreadsDoNotChangeABit)
{
    std::vector<Vector3d> ends[2];
    for (const int threads : {1, 2}) {
        auto structure = thrown_plate(threads);
        Clock clock;
        for (int i = 0; i < 100; ++i) step(*structure, clock, stable_step(*structure));
        ends[threads - 1] = structure->nodes.position;
    }
    EXPECT_EQ(ends[0], ends[1]);
}

/// Copies one structure's state into another by way of the bytes a file would hold.
void carry_over(Structure& from, Structure& to)
{
    FieldSet saved = state(from), taken = state(to);
    ASSERT_EQ(saved.fields.size(), taken.fields.size());
    for (std::size_t i = 0; i < saved.fields.size(); ++i) {
        const Field& f = saved.fields[i];
        ASSERT_EQ(f.name, taken.fields[i].name);
        std::vector<double> bytes(f.count * f.components);
        f.gather(bytes.data());
        taken.fields[i].restore(bytes.data(), f.count);
    }
}

TEST(Structure, RestartContinuesToTheSameBits)
{
    auto first = thrown_plate();
    Clock clock;
    for (int i = 0; i < 100; ++i) step(*first, clock, stable_step(*first));
    auto second = thrown_plate();
    carry_over(*first, *second);
    Clock other;
    other.restore(clock.time(), clock.duration(), clock.previous_duration(), clock.step());
    for (int i = 0; i < 100; ++i) {
        step(*first, clock, stable_step(*first));
        step(*second, other, stable_step(*second));
    }
    EXPECT_EQ(first->nodes.position, second->nodes.position);
    EXPECT_EQ(energy(*first).total(), energy(*second).total());
    EXPECT_EQ(energy(*first).plastic, energy(*second).plastic);
}

TEST(Structure, RestartRefusesAnotherModel)
{
    auto big = thrown_plate();
    Structure small;
    add_part(small, plate(square_mesh(2, 0.2), armour_steel(), 0.005));
    FieldSet taken = state(small);
    std::vector<double> bytes(big->nodes.size() * 3);
    EXPECT_THROW(taken.fields[0].restore(bytes.data(), big->nodes.size()), InputError);
    EXPECT_THROW(taken.find("plate.shells")->restore(bytes.data(), 3), InputError);
}

TEST(Structure, FastestElementIsNamed)
{
    EXPECT_EQ(fastest_element(Structure{}), "");
    Structure structure;
    add_part(structure, plate(square_mesh(2, 0.2), elastic_steel(), 0.002));
    EXPECT_EQ(fastest_element(structure), "");
    structure.nodes.velocity[4] = {0, 30, 40};  // the middle one: the first corner of the last element
    EXPECT_THAT(fastest_element(structure), HasSubstr("element 4 of part 'plate'"));
    EXPECT_THAT(fastest_element(structure), HasSubstr("at 50 m/s"));
}

TEST(Structure, WhatIsNoLongerANumberIsNamed)
{
    auto structure = thrown_plate();
    Clock clock;
    step(*structure, clock, stable_step(*structure));
    structure->nodes.velocity[440].z = std::numeric_limits<double>::quiet_NaN();  // the last node: only of element 400
    try {
        step(*structure, clock, stable_step(*structure));
        FAIL() << "went on with a velocity that is not a number";
    } catch (const SafetyStop& stop) {
        EXPECT_THAT(stop.problem(), HasSubstr("element 400 of part 'plate'"));
        EXPECT_FALSE(stop.remedy().empty());
    }
}

TEST(Structure, FieldsShowWhatIsThere)
{
    auto structure = thrown_plate();
    Clock clock;
    for (int i = 0; i < 300; ++i) step(*structure, clock, stable_step(*structure));
    FieldSet nodes = node_fields(*structure), elements = element_fields(*structure);
    std::vector<Vector3f> displacement(structure->nodes.size());
    nodes.find("displacement")->gather(displacement.data());
    EXPECT_FLOAT_EQ(displacement[440].z, static_cast<float>(structure->nodes.position[440].z));
    std::vector<float> strain(400), stress(400), thickness(400);
    std::vector<std::int32_t> part(400);
    elements.find("plastic_strain")->gather(strain.data());
    elements.find("von_mises")->gather(stress.data());
    elements.find("thickness")->gather(thickness.data());
    elements.find("part")->gather(part.data());
    EXPECT_FLOAT_EQ(*std::max_element(strain.begin(), strain.end()), static_cast<float>(max_plastic_strain(structure->parts[0])));
    EXPECT_GT(*std::max_element(strain.begin(), strain.end()), 0.001f);
    EXPECT_GT(*std::max_element(stress.begin(), stress.end()), 1200e6f);
    EXPECT_LT(*std::min_element(thickness.begin(), thickness.end()), 0.005f);
    EXPECT_EQ(part[399], 0);
    ASSERT_EQ(cells(*structure).size(), 400);
    EXPECT_EQ(cells(*structure)[399].node[2], 440);
}

}  // namespace
}  // namespace corpuscle
