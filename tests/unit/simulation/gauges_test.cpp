#include "simulation/gauges.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>

namespace corpuscle {
namespace {

/// A box of gas, 2 by 1 by 1, with one gauge.
std::unique_ptr<Model> boxed(Gauge gauge)
{
    Gas gas;
    gas.domain.box = {{0, 0, 0}, {2, 1, 1}};
    gas.species.push_back({"gas", IdealGas{1.4}, 0.01, internal_freedoms(1.4), 0.029});
    auto model = std::make_unique<Model>(std::move(gas), Structure{});
    model->gauges.push_back(std::move(gauge));
    return model;
}

/// What the gauge's columns show now, by name.
std::map<std::string, double> shown(OutputPlan& plan)
{
    HistorySource& source = plan.history.at(0);
    std::vector<double> values(source.columns.size());
    source.sample(values);
    std::map<std::string, double> result;
    for (std::size_t i = 0; i < values.size(); ++i) result[source.columns[i].name] = values[i];
    return result;
}

/// Impulses of -3 N s on 1 m2 with a variance of 4, then as much again in half the time, with a variance of 5.
TEST(Gauges, OnAFaceShowMeansOverTheIntervalAndTheirErrors)
{
    const std::unique_ptr<Model> model = boxed({"wall", FaceGauge{0}, 1e-3});
    Clock clock;
    Gauges gauges(*model);
    OutputPlan plan;
    gauges.add_to(plan, clock);
    shown(plan);
    clock.begin_step(2);
    model->gas.passages.face[0].momentum.x = -3;
    model->gas.passages.squares[0] = 4;
    std::map<std::string, double> seen = shown(plan);
    EXPECT_EQ(seen.at("wall.pressure"), 1.5);
    EXPECT_EQ(seen.at("wall.pressure_error"), 1);
    EXPECT_EQ(seen.at("wall.impulse"), 3);
    EXPECT_EQ(seen.at("wall.impulse_error"), 2);
    clock.end_step();
    clock.begin_step(1);
    model->gas.passages.face[0].momentum.x = -6;
    model->gas.passages.squares[0] = 9;
    seen = shown(plan);
    EXPECT_EQ(seen.at("wall.pressure"), 3);
    EXPECT_DOUBLE_EQ(seen.at("wall.pressure_error"), std::sqrt(5.0));
    EXPECT_EQ(seen.at("wall.impulse_error"), 3);
}

/// The impulse of a region starts without error; later it has that of the pressures it sums up and that of the first one, which is
/// taken off all along: with samples that do not change, far closer together than gas takes through the region, errors simply add up.
TEST(Gauges, InARegionCarryTheErrorOfThePressureTheyStartFrom)
{
    const Box half{{0, 0, 0}, {1, 1, 1}};
    const std::unique_ptr<Model> model = boxed({"room", RegionGauge{Shape::box(half), 1}, 1e-3});
    for (const float side : {-1.0f, 1.0f}) model->gas.particles.push_back({{0.5f, 0.5f, 0.5f}, 1, {side, 2 * side, -side}, 0});
    Clock clock;
    Gauges gauges(*model);
    OutputPlan plan;
    gauges.add_to(plan, clock);
    std::map<std::string, double> seen = shown(plan);
    EXPECT_EQ(seen.at("room.impulse_error"), 0);
    const double error = seen.at("room.pressure_error");
    EXPECT_NEAR(error, std::sqrt(2.0) * 0.01 * 6 / 3, 1e-12);
    for (int step = 0; step < 10; ++step) {
        clock.begin_step(1e-4);
        seen = shown(plan);
        clock.end_step();
    }
    EXPECT_EQ(seen.at("room.impulse"), 0);
    EXPECT_NEAR(seen.at("room.impulse_error"), std::sqrt(2.0) * error * 1e-3, 0.01 * error * 1e-3);
    EXPECT_EQ(seen.at("room.particles"), 2);
    EXPECT_NEAR(seen.at("room.velocity_error_y"), std::sqrt(2.0) * 0.01 * 2 / 0.02, 1e-12);
}

/// A gauge brought back from its saved state goes on with the same bits.
TEST(Gauges, GoOnFromTheirState)
{
    const std::unique_ptr<Model> model = boxed({"wall", FaceGauge{1}, 1e-3});
    Clock clock;
    Gauges first(*model), second(*model);
    OutputPlan plan, other;
    first.add_to(plan, clock);
    second.add_to(other, clock);
    clock.begin_step(0.3);
    model->gas.passages.face[1].momentum.x = 0.7;
    model->gas.passages.squares[1] = 0.1;
    shown(plan);
    FieldSet from = first.state(), to = second.state();
    for (std::size_t i = 0; i < from.fields.size(); ++i) {
        std::vector<double> values(from.fields[i].count * static_cast<std::size_t>(from.fields[i].components));
        from.fields[i].gather(values.data());
        to.fields[i].restore(values.data(), from.fields[i].count);
    }
    clock.end_step();
    clock.begin_step(0.1);
    model->gas.passages.face[1].momentum.x = 0.9;
    model->gas.passages.squares[1] = 0.3;
    EXPECT_EQ(shown(plan), shown(other));
}

}  // namespace
}  // namespace corpuscle
