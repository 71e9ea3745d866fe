#include "simulation/empirical_gauges.hpp"

#include <gtest/gtest.h>

#include <map>
#include <memory>

namespace corpuscle {
namespace {

/// A kilogram of TNT at the origin of a wide box of air.
std::unique_ptr<Model> kilogram_in_a_box()
{
    Gas gas;
    gas.domain.box = {{-1, -1, -1}, {3, 3, 3}};
    auto model = std::make_unique<Model>(std::move(gas), Structure{});
    model->known_blast = KnownBlast{1, {0, 0, 0}, Burst::spherical, 1e-5, 1e5};
    return model;
}

std::map<std::string, double> columns(OutputPlan& plan, std::size_t source)
{
    std::vector<double> values(plan.history.at(source).columns.size());
    plan.history.at(source).sample(values);
    std::map<std::string, double> result;
    for (std::size_t i = 0; i < values.size(); ++i) result[plan.history.at(source).columns[i].name] = values[i];
    return result;
}

/// In the gas the pulse is the incident one, over the ambient pressure; long after it the impulse is that of the curves.
TEST(EmpiricalGauges, InTheGasShowTheIncidentPulse)
{
    const auto model = kilogram_in_a_box();
    model->gauges.push_back({"g", RegionGauge{Shape::sphere({1, 0, 0}, 0.01), 1e-6}, 1e-5});
    const EmpiricalGauges gauges(*model);
    Clock clock;
    OutputPlan plan;
    gauges.add_to(plan, clock);
    auto seen = columns(plan, 0);
    EXPECT_DOUBLE_EQ(seen.at("g (Kingery-Bulmash).pressure"), 1e5);
    EXPECT_DOUBLE_EQ(seen.at("g (Kingery-Bulmash).impulse"), 0);
    const BlastWave wave = kingery_bulmash(Burst::spherical, 1, 1);
    clock.begin_step(wave.arrival + 1e-5 + 1e-9);
    EXPECT_NEAR(columns(plan, 0).at("g (Kingery-Bulmash).pressure"), 1e5 + wave.incident_pressure, 1e-4 * wave.incident_pressure);
    clock.begin_step(1);
    EXPECT_NEAR(columns(plan, 0).at("g (Kingery-Bulmash).impulse"), wave.incident_impulse, 1e-6 * wave.incident_impulse);
}

/// On a face the pulses are reflected, mean over its area: less than head-on in its middle, more than in its corner; the air's own pressure
/// counts.
TEST(EmpiricalGauges, OnAFaceShowTheMeanOfReflectedPulses)
{
    const auto model = kilogram_in_a_box();
    model->gauges.push_back({"wall", FaceGauge{0}, 1e-5});
    const EmpiricalGauges gauges(*model);
    Clock clock;
    OutputPlan plan;
    gauges.add_to(plan, clock);
    clock.begin_step(1);
    const double impulse = columns(plan, 0).at("wall (Kingery-Bulmash).impulse") - 1e5;
    EXPECT_LT(impulse, kingery_bulmash(Burst::spherical, 1, 1).reflected_impulse);
    EXPECT_GT(impulse, kingery_bulmash(Burst::spherical, 1, std::sqrt(1 + 9 + 9)).incident_impulse);
}

/// A small plate of shell that faces the charge gets the head-on pulse, as ConWep gives it; turned over, its gauge counts the other way.
TEST(EmpiricalGauges, OnAPartCountPushesAgainstItsNormals)
{
    for (const bool turned : {false, true}) {
        const auto model = kilogram_in_a_box();
        Structure& structure = model->structure;
        structure.nodes.reference = {{1, 0, 0}, {1, 1e-3, 0}, {1, 0, 1e-3}};
        structure.parts.emplace_back().name = "plate";
        Facet facet;
        facet.node = {0, turned ? 1U : 2U, turned ? 2U : 1U};
        facet.part = 0;
        structure.surface.facets.push_back(facet);
        model->gauges.push_back({"plate", PartGauge{0}, 1e-5});
        const EmpiricalGauges gauges(*model);
        Clock clock;
        OutputPlan plan;
        gauges.add_to(plan, clock);
        clock.begin_step(1);
        const double head_on = kingery_bulmash(Burst::spherical, 1, 1).reflected_impulse;
        EXPECT_NEAR(columns(plan, 0).at("plate (Kingery-Bulmash).impulse"), turned ? -head_on : head_on, 1e-3 * head_on);
    }
}

/// Without a known blast, or out of the curves' reach, nothing is shown beside a gauge.
TEST(EmpiricalGauges, AreNoneWhereTheCurvesSayNothing)
{
    const auto model = kilogram_in_a_box();
    model->gauges.push_back({"g", RegionGauge{Shape::sphere({0.02, 0, 0}, 0.01), 1e-6}, 1e-5});
    const Clock clock;
    OutputPlan plan;
    EmpiricalGauges(*model).add_to(plan, clock);
    model->known_blast.reset();
    model->gauges.push_back({"far", RegionGauge{Shape::sphere({1, 0, 0}, 0.01), 1e-6}, 1e-5});
    EmpiricalGauges(*model).add_to(plan, clock);
    EXPECT_TRUE(plan.history.empty());
}

}  // namespace
}  // namespace corpuscle
