#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "../../unit/gas/gas_samples.hpp"

namespace corpuscle {
namespace {

constexpr std::size_t count = 30000;
constexpr int warm_steps = 40, batches = 10, steps_a_batch = 100;
constexpr double reference_density = 1630;  ///< [kg/m3]
constexpr double reference_energy = 7e9;    ///< of the explosive [J/m3]

/// Impulse that the six rigid walls have got [N s].
double impulse(const Gas& gas)
{
    double sum = 0;
    for (int face = 0; face < face_count; ++face) sum += std::abs(gas.passages.face[face].momentum[face / 2]);
    return sum;
}

/// Gas at rest in a closed cube of 1 m: the mean pressure on its walls against the law.
///
/// Bound: 1.5 % of systematic rest plus 4 standard errors of the batches' mean, which themselves must stay below 0.5 % (hits of a
/// Maxwellian: sqrt(4/(pi hits)), 0.3 %). What the rest is: (1) within about a spacing of a wall, cells see gas on one side only, and
/// displaced particles are mirrored: the layer's share of all particles is 6 spacings of 31; (2) the density of a group of up to 64
/// particles fluctuates; second order is taken off (laws/collision/virial.hpp), third order is not; (3) where more than one collision falls
/// to a particle in a step, the survival of displacements is a mean. All three fall with the number of particles or the step.
void expect_law(const EquationOfState& law, double expansion, const GasSettings& settings = {})
{
    const double density = reference_density / expansion, energy = reference_energy / reference_density;
    Gas gas = filled_box(unit_box, law, density, energy, count);
    gas.settings = settings;
    const double total = contents(gas).gas.energy, expected = pressure(law, density, energy);
    Clock clock;
    for (int i = 0; i < warm_steps; ++i) advance(gas, clock);
    std::vector<double> ratios;
    for (int b = 0; b < batches; ++b) {
        const double before = impulse(gas), start = clock.time();
        for (int i = 0; i < steps_a_batch; ++i) advance(gas, clock);
        ratios.push_back((impulse(gas) - before) / (6 * (clock.time() - start)) / expected);
    }
    const Statistics ratio(ratios);
    const double sigma = ratio.error() * std::sqrt(batches / (batches - 1.0));
    std::printf("%s V %.2f: wall pressure/law %.4f, sigma %.4f; kinetic share %.3f\n", law_name(law).c_str(), expansion, ratio.mean, sigma,
                (heat_capacity_ratio(law) - 1) * density * energy / expected);
    EXPECT_LT(sigma, 0.005);
    EXPECT_NEAR(ratio.mean, 1, 0.015 + 4 * sigma);
    EXPECT_NEAR(contents(gas).gas.energy, total, 1e-6 * total);
}

TEST(WallPressure, ideal)
{
    for (const double gamma : {1.2, 1.4, 5.0 / 3}) expect_law(IdealGas{gamma}, 10);
}
TEST(WallPressure, noble_abel_b_0_1)
{
    for (const double expansion : {1.2, 1.5, 3.0, 10.0, 30.0}) expect_law(NobleAbel{1.3, 0.1, reference_density}, expansion);
}
TEST(WallPressure, noble_abel_b_0_3)
{
    for (const double expansion : {1.2, 1.5, 3.0, 10.0, 30.0}) expect_law(NobleAbel{1.3, 0.3, reference_density}, expansion);
}
TEST(WallPressure, noble_abel_b_0_6)
{
    for (const double expansion : {1.2, 1.5, 3.0, 10.0, 30.0}) expect_law(NobleAbel{1.3, 0.6, reference_density}, expansion);
}
TEST(WallPressure, jwl_dense)
{
    for (const double expansion : {0.8, 1.0, 1.5}) expect_law(Jwl{371.2e9, 3.231e9, 4.15, 0.95, 0.3, reference_density}, expansion);
}
TEST(WallPressure, jwl_expanded)
{
    for (const double expansion : {2.0, 3.0, 5.0, 10.0}) expect_law(Jwl{371.2e9, 3.231e9, 4.15, 0.95, 0.3, reference_density}, expansion);
}

/// Partners near each other, a short path and small cells, at the usual step: what sharpens fronts must not touch the pressure.
TEST(WallPressure, with_near_partners)
{
    const GasSettings sharp{.cell_limit = 8, .partners = 4, .mean_free_path = 0.25};
    expect_law(IdealGas{1.4}, 10, sharp);
    expect_law(NobleAbel{1.3, 0.3, reference_density}, 1.5, sharp);
    expect_law(Jwl{371.2e9, 3.231e9, 4.15, 0.95, 0.3, reference_density}, 1, sharp);
    expect_law(Jwl{371.2e9, 3.231e9, 4.15, 0.95, 0.3, reference_density}, 3, sharp);
}

}  // namespace
}  // namespace corpuscle
