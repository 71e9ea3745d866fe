#include "simulation/resolution.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "euler/fill.hpp"

namespace corpuscle {
namespace {

/// A charge lit at the origin whose particles, a cube of 10 mm of explosive each, reach out to 100 mm, 400 mm above a gauged face of the
/// box.
std::unique_ptr<Model> charge_over_floor()
{
    Gas gas;
    gas.domain.box = {{-1, -1, -0.4}, {1, 1, 1}};
    gas.species.push_back({"explosive", IdealGas{1.3}, 1600 * 1e-6, internal_freedoms(1.3)});
    gas.species.push_back({"air", IdealGas{1.4}, 1.2 * 1e-6, internal_freedoms(1.4)});
    gas.charges.push_back({"charge", 0, 7000, 4e6, 1600, {{{0, 0, 0}, 0}}, 2});
    for (const float x : {0.05f, 0.1f}) gas.particles.push_back({{x, 0, 0}, 0, {}, particle_tag::make(0, 0, particle_tag::unburnt)});
    gas.particles.push_back({{0.9f, 0, 0}, 0, {}, particle_tag::make(1)});
    auto model = std::make_unique<Model>(std::move(gas), Structure{});
    model->gauges.push_back({"floor", FaceGauge{4}, 1e-5});
    return model;
}

/// 10 mm in 200 mm across; at the floor the products are 10 mm 400/100 = 40 mm apart.
TEST(Resolution, CountsSpacingsAcrossTheChargeAndOnTheWay)
{
    const std::vector<Verdict> verdicts = judge_resolution(*charge_over_floor());
    ASSERT_EQ(verdicts.size(), 2U);
    EXPECT_EQ(verdicts[0].name, "charge");
    EXPECT_NEAR(verdicts[0].value, 0.05, 1e-8);
    EXPECT_EQ(verdicts[1].name, "resolution");
    EXPECT_NEAR(verdicts[1].value, 0.1, 1e-8);
}

/// Air whose particles are wider apart than the products' decides.
TEST(Resolution, TheWiderSpacingCounts)
{
    const std::unique_ptr<Model> model = charge_over_floor();
    model->gas.ambient = {1, 1.2, 1e5, 8e4};
    model->gas.species[1].particle_mass = 1.2 * 0.08 * 0.08 * 0.08;
    EXPECT_NEAR(judge_resolution(*model)[1].value, 0.2, 1e-8);
    EXPECT_FALSE(judge_resolution(*model)[1].passed());
}

/// Nothing to load: only the charge is judged; no charge: nothing is.
TEST(Resolution, JudgesOnlyWhatIsThere)
{
    const std::unique_ptr<Model> model = charge_over_floor();
    model->gauges.clear();
    EXPECT_EQ(judge_resolution(*model).size(), 1U);
    model->gas.charges.clear();
    model->gas.particles.clear();
    EXPECT_TRUE(judge_resolution(*model).empty());
}

/// A ball of 0.2 m radius, lit in the corner of an octant of cells of 0.05 m that widen beyond 0.5 m to 0.1 m; a gauged wall 1 m away.
TEST(Resolution, OfAGridIsThatOfItsCells)
{
    auto model = std::make_unique<Model>(Gas{}, Structure{});
    const std::vector<double> faces = faces_with_fine_part(0, 1, {0, 0.5}, 0.05, 0.1);
    EulerMaterial products{"products", IdealGas{1.3}, {}, 0};
    products.explosive.energy = 4e6;
    products.explosive.detonation_velocity = 7000;
    products.explosive.lightings = {{{0, 0, 0}, 0}};
    model->euler = make_grid(EulerSpace::planar, {faces, faces, faces}, {}, {products, {"air", IdealGas{1.4}, {}, 0}});
    fill(model->euler, [](const Vector3d& at) {
        return norm(at) < 0.2 ? EulerSample{0, 1600, 1e5, {}, 0, true} : EulerSample{1, 1.2, 1e5, {}, 0, false};
    });
    model->gauges.push_back({"wall", GridFaceGauge{1}, 1e-5});
    const std::vector<Verdict> verdicts = judge_resolution(*model);
    ASSERT_EQ(verdicts.size(), 2U);
    EXPECT_NEAR(verdicts[0].value, 0.05 / 0.4, 0.03);  // the cells' middles reach out to nearly the radius
    EXPECT_NEAR(verdicts[1].value, 0.1, 0.01);
    EXPECT_FALSE(verdicts[1].passed());
}

}  // namespace
}  // namespace corpuscle
