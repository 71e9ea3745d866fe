#include <gtest/gtest.h>

#include "gas/sample.hpp"
#include "gas_samples.hpp"

namespace corpuscle {
namespace {

/// A charge that is still burning, in air with rigid and ambient edges: everything that a restart must know.
Gas busy()
{
    Gas gas;
    gas.domain = {unit_box, {Edge::rigid, Edge::ambient, Edge::rigid, Edge::open, Edge::rigid, Edge::ambient}};
    const Shape ball = Shape::sphere({0, 0, 0}, 0.2);
    gas.species = {species_of(IdealGas{1.4}, 1.2 / 5000),
                   species_of(Jwl{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630}, 1630 * ball.volume_within(unit_box) / 5000)};
    gas.charges.push_back({"charge", 1, 6930, 4.29e6, 1630, {{{0, 0, 0}, 2e-6}}});
    gas.ambient = ambient_like(gas.species[0], 1.2, 2.1e5);
    fill(gas, {Shape::box(unit_box), {ball}, 0, 1.2, 2.1e5, {}, -1}, 5000);
    fill(gas, {ball, {}, 1, 1630, 4.29e6, {}, 0}, 5000);
    return gas;
}

/// A field set's values, as a restart file holds them.
std::vector<std::vector<std::byte>> saved(const FieldSet& set)
{
    std::vector<std::vector<std::byte>> values;
    for (const Field& field : set.fields) {
        values.emplace_back(field.count * static_cast<std::size_t>(field.components) * size_of(field.scalar));
        field.gather(values.back().data());
    }
    return values;
}

void restore(const FieldSet& set, const FieldSet& of, const std::vector<std::vector<std::byte>>& values)
{
    for (std::size_t f = 0; f < set.fields.size(); ++f) set.fields[f].restore(values[f].data(), of.fields[f].count);
}

void expect_same(const Gas& a, const Gas& b)
{
    EXPECT_TRUE(same_bits(a.particles, b.particles));
    for (int face = 0; face < face_count; ++face) EXPECT_TRUE(same_bits(a.passages.face[face], b.passages.face[face])) << "face " << face;
    EXPECT_EQ(a.inflow_debt, b.inflow_debt);
    EXPECT_EQ(a.step_limit, b.step_limit);
    EXPECT_EQ(a.charges[0].unburnt, b.charges[0].unburnt);
}

TEST(GasState, restored_goes_on_to_the_same_bits)
{
    Gas gas = busy();
    Clock clock;
    const double step = 1e-5;  // long enough for gas to come in while the charge burns
    while (clock.time() < 5e-6) advance(gas, clock, step);
    ASSERT_GT(gas.charges[0].unburnt, 0u);
    ASSERT_LT(gas.charges[0].unburnt, 5000u);
    const FieldSet set = state(gas);
    const auto values = saved(set);

    Gas other = busy();
    Clock other_clock;
    advance(other, other_clock, step);  // into another order and another state
    restore(state(other), set, values);
    other.step_limit = gas.step_limit;  // kept by the simulation
    other_clock.restore(clock.time(), clock.duration(), clock.previous_duration(), clock.step());
    expect_same(gas, other);
    while (clock.time() < 4e-5) {
        advance(gas, clock, step);
        advance(other, other_clock, step);
    }
    expect_same(gas, other);
    EXPECT_EQ(gas.charges[0].unburnt, 0u);
}

}  // namespace
}  // namespace corpuscle
