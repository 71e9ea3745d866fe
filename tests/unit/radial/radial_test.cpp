#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "radial/charge.hpp"
#include "radial/gauge.hpp"
#include "radial/zoning.hpp"

namespace corpuscle {
namespace {

TEST(Symmetry, volumes_of_shells)
{
    EXPECT_DOUBLE_EQ(whole(Symmetry::spherical) * volume_between(Symmetry::spherical, 1, 2), 4 * std::numbers::pi / 3 * 7);
    EXPECT_DOUBLE_EQ(whole(Symmetry::cylindrical) * volume_between(Symmetry::cylindrical, 1, 2), std::numbers::pi * 3);
    EXPECT_DOUBLE_EQ(whole(Symmetry::planar) * volume_between(Symmetry::planar, -1, 2), 3);
}

TEST(Zoning, widths_go_from_the_first_to_the_last_in_equal_ratios)
{
    const std::vector<double> edges = graded_edges(1, 3, 0.1, 0.01);
    EXPECT_EQ(edges.front(), 1);
    EXPECT_EQ(edges.back(), 3);
    const double ratio = (edges[2] - edges[1]) / (edges[1] - edges[0]);
    for (std::size_t i = 2; i < edges.size(); ++i) EXPECT_NEAR((edges[i] - edges[i - 1]) / (edges[i - 1] - edges[i - 2]), ratio, 1e-9);
    // A whole number of cells cannot meet both ends' widths: within one cell in the fifty there are.
    EXPECT_NEAR(edges[1] - edges[0], 0.1, 0.1 / 20);
    EXPECT_NEAR((edges[edges.size() - 1] - edges[edges.size() - 2]) / (edges[1] - edges[0]), 0.1, 1e-9);
    EXPECT_EQ(graded_edges(0, 1, 0.25, 0.25).size(), 5u);
    EXPECT_EQ(graded_edges(0, 1, 9, 9).size(), 3u);
}

TEST(Zoning, cells_grow_with_the_radius)
{
    const std::vector<double> edges = growing_edges(1, 4, 0.01, 1);
    EXPECT_GE(edges.back(), 4);
    for (std::size_t i = 1; i < edges.size(); ++i) EXPECT_NEAR(edges[i] - edges[i - 1], 0.01 * edges[i - 1], 1e-12);
    EXPECT_EQ(growing_edges(0, 1, 0.25, 0).size(), 5u);
}

RadialZone still_air(std::vector<double> edges)
{
    return {std::move(edges), IdealGas{1.4}, 1.2, 2e5};
}

TEST(RadialFlow, still_gas_stays_still)
{
    for (const Symmetry symmetry : {Symmetry::planar, Symmetry::cylindrical, Symmetry::spherical}) {
        RadialFlow flow(symmetry, {still_air({0, 0.1, 0.3, 0.7}), still_air({0.7, 1.0})});
        flow.run(1e-2);
        EXPECT_EQ(flow.edges(), (std::vector<double>{0, 0.1, 0.3, 0.7, 1.0}));
        EXPECT_DOUBLE_EQ(flow.time(), 1e-2);
    }
}

TEST(RadialFlow, explosive_waits_for_its_detonation)
{
    RadialCharge charge{Jwl{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630}, 1630, 4.29e6, 6930, 0.1, IdealGas{1.4}, 1.2, 1e5};
    RadialFlow flow = lay_charge(charge, {20, 1, 0}, 0.2);
    EXPECT_TRUE(flow.burning());
    EXPECT_EQ(sample(flow, 0.05).pressure, 0);
    flow.run(0.5 * 0.1 / 6930);
    EXPECT_GT(sample(flow, 0.03).pressure, 1e9);
    EXPECT_EQ(sample(flow, 0.07).pressure, 0);
    flow.run(1.2 * 0.1 / 6930);
    EXPECT_FALSE(flow.burning());
    const double mass = whole(Symmetry::spherical) * flow.contents(0).mass;
    EXPECT_NEAR(mass, 4 * std::numbers::pi / 3 * 1e-3 * 1630, 1e-9);
    EXPECT_NEAR(ball_radius(mass, 1630), 0.1, 1e-12);
}

TEST(RadialFlow, refuses_zones_that_cannot_be)
{
    const auto flow = [](std::vector<RadialZone> zones) { return RadialFlow(Symmetry::spherical, zones); };
    EXPECT_THROW(flow({}), InputError);
    EXPECT_THROW(flow({still_air({0})}), InputError);
    EXPECT_THROW(flow({still_air({0, 1, 1})}), InputError);
    EXPECT_THROW(flow({still_air({-1, 1})}), InputError);
    EXPECT_THROW(flow({still_air({0, 1}), still_air({2, 3})}), InputError);
    RadialZone cold = still_air({0, 1});
    cold.energy = 0;
    EXPECT_THROW(flow({cold}), InputError);
}

TEST(RadialGauge, reads_straight_lines_between_cells)
{
    RadialZone inner = still_air({0, 1}), outer = still_air({1, 3});
    outer.energy = 4e5;
    outer.velocity = 10;
    RadialFlow flow(Symmetry::planar, {inner, outer});
    const double low = flow.pressures()[0], high = flow.pressures()[1];
    EXPECT_DOUBLE_EQ(sample(flow, 0.2).pressure, low);
    EXPECT_NEAR(sample(flow, 1.25).pressure, 0.5 * (low + high), 1e-9 * high);
    EXPECT_DOUBLE_EQ(sample(flow, 2.9).pressure, high);
    EXPECT_DOUBLE_EQ(sample(flow, 1.0).velocity, 5);
    EXPECT_DOUBLE_EQ(sample(flow, 2.0).velocity, 7.5);
}

TEST(BlastMeasures, of_a_record_made_by_hand)
{
    // Ambient 100: a rise to 300, a fall to 100 at 5, a second shock that does not count.
    const std::vector<RadialSample> samples{{0, 100, 1, 0}, {1, 190, 1, 0}, {2, 300, 1, 0}, {3, 200, 1, 0},
                                            {4, 150, 1, 0}, {5, 100, 1, 0}, {6, 80, 1, 0},  {7, 500, 1, 0}};
    const BlastMeasures measures = measure_blast(samples, 100, 1);
    EXPECT_EQ(measures.overpressure, 200);
    EXPECT_EQ(measures.arrival, 2);
    EXPECT_EQ(measures.impulse, 45 + 145 + 150 + 75 + 25);
    EXPECT_EQ(measures.duration, 3);
    EXPECT_TRUE(measures.complete);
    EXPECT_EQ(measure_blast(samples, 100, 300).overpressure, 400);
    EXPECT_FALSE(measure_blast({samples.begin(), samples.begin() + 4}, 100, 1).complete);
    EXPECT_EQ(measure_blast({samples.begin(), samples.begin() + 1}, 100, 1).overpressure, 0);
    EXPECT_EQ(measure_blast({}, 100, 1).overpressure, 0);
}

}  // namespace
}  // namespace corpuscle
