#include "laws/strength/bilinear_plastic.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "laws/strength/elastic.hpp"

namespace corpuscle {
namespace {

const PlaneStiffness steel{212e9, 0.28};
const BilinearPlastic armour{1200e6, 6500e6, 300.0, 5.0, 0.0};

/// Stretches along x with the lateral strain that keeps yy free of stress (secant on the increment).
PlaneResponse<double> pull(const BilinearPlastic& law, PlanePoint<double>& point, double strain, double duration)
{
    const auto lateral_stress = [&](double lateral) {
        PlanePoint<double> trial = point;
        law.stretch(steel, trial, PlaneStrain<double>{strain, lateral, 0, 0, 0}, duration);
        return trial.stress.yy;
    };
    double a = -0.2 * strain, b = -0.5 * strain, fa = lateral_stress(a), fb = lateral_stress(b);
    for (int i = 0; i < 60 && std::abs(fb) > 1e-3 && fa != fb; ++i) {
        const double c = b - fb * (b - a) / (fb - fa);
        a = b;
        fa = fb;
        b = c;
        fb = lateral_stress(b);
    }
    return law.stretch(steel, point, PlaneStrain<double>{strain, b, 0, 0, 0}, duration);
}

TEST(BilinearPlastic, UniaxialCurveIsExact)
{
    BilinearPlastic law = armour;
    law.rate_constant = 0;
    PlanePoint<double> point;
    double strain = 0, thickness = 0, work = 0;
    for (int i = 0; i < 200; ++i) {
        const PlaneResponse<double> r = pull(law, point, 1e-4, 1e-6);
        strain += 1e-4;
        thickness += r.thickness_strain;
        work += r.plastic_work;
    }
    const double h = law.hardening_modulus, e = steel.young();
    const double plastic = (strain - law.yield_stress / e) / (1.0 + h / e);
    EXPECT_NEAR(point.plastic_strain, plastic, 1e-9 * plastic);
    EXPECT_NEAR(point.stress.xx, law.yield_stress + h * plastic, 1.0);
    EXPECT_NEAR(thickness, -steel.poisson() * point.stress.xx / e - 0.5 * plastic, 1e-9 * plastic);
    const double exact_work = law.yield_stress * plastic + 0.5 * h * plastic * plastic;
    EXPECT_NEAR(work, exact_work, 2e-4 * exact_work);  // one step crosses the yield point: the trapezoid is off there by its elastic share
}

TEST(BilinearPlastic, StressFollowsCowperAndSymonds)
{
    for (const double rate : {1e-3, 1.0, 300.0, 5000.0}) {  // long enough for the start to be forgotten
        PlanePoint<double> point;
        double before = 0;
        const double step = 2e-5, duration = step / rate;
        for (int i = 0; i < 4000; ++i) {
            before = point.plastic_strain;
            pull(armour, point, step, duration);
        }
        const double plastic_rate = (point.plastic_strain - before) / duration;
        const double hardening = 6500e6 * (1.0 + std::pow(plastic_rate / 300.0, 0.2));  // the rest of the strain is elastic
        EXPECT_NEAR(plastic_rate * (1.0 + hardening / steel.young()), rate, 1e-4 * rate);
        EXPECT_NEAR(point.stress.xx, (1200e6 + 6500e6 * point.plastic_strain) * (1.0 + std::pow(plastic_rate / 300.0, 0.2)),
                    1e-7 * point.stress.xx);
        EXPECT_NEAR(point.stress.xx, armour.yield_at(point.plastic_strain, plastic_rate), 1e-7 * point.stress.xx);
    }
}

TEST(BilinearPlastic, RateFactorDoublesTheYieldStressAtC)
{
    EXPECT_DOUBLE_EQ(armour.yield_at(0.1, 300.0), 2.0 * (1200e6 + 650e6));
}

// ---- the same step in three dimensions, with the strain across found by bisection: an independent way to the same answer

using Tensor = std::array<double, 6>;  // xx yy zz xy yz zx

struct Solid {
    Tensor stress{}, back{};
    double plastic_strain = 0;
};

double equivalent(const Tensor& s)
{
    const double mean = (s[0] + s[1] + s[2]) / 3.0;
    double square = 0;
    for (int i = 0; i < 3; ++i) square += (s[i] - mean) * (s[i] - mean) + 2.0 * s[i + 3] * s[i + 3];
    return std::sqrt(1.5 * square);
}

/// Radial return in three dimensions; the equivalent plastic strain by bisection.
Solid solid_step(const BilinearPlastic& law, const Solid& start, const Tensor& strain, double duration)
{
    const double g = steel.shear(), lame = 2.0 * g * steel.poisson() / (1.0 - 2.0 * steel.poisson());
    Solid now = start;
    const double volume = strain[0] + strain[1] + strain[2];
    for (int i = 0; i < 3; ++i) {
        now.stress[i] += lame * volume + 2.0 * g * strain[i];
        now.stress[i + 3] += g * strain[i + 3];
    }
    Tensor relative;
    for (int i = 0; i < 6; ++i) relative[i] = now.stress[i] - start.back[i];
    const double trial = equivalent(relative), back_modulus = law.kinematic_fraction * law.hardening_modulus;
    const auto excess = [&](double p) {
        return trial - (3.0 * g + back_modulus) * p - law.yield_at(start.plastic_strain + p, p / duration);
    };
    if (excess(0.0) <= 0) return now;
    double low = 0, high = trial / (3.0 * g);
    for (int i = 0; i < 200; ++i) (excess(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
    now.plastic_strain += low;
    const double mean = (relative[0] + relative[1] + relative[2]) / 3.0;
    for (int i = 0; i < 6; ++i) {
        const double direction = 1.5 * (relative[i] - (i < 3 ? mean : 0.0)) / trial;
        now.stress[i] -= 2.0 * g * low * direction;
        now.back[i] += 2.0 / 3.0 * back_modulus * low * direction;
    }
    return now;
}

/// The solid step whose stress across vanishes; returns the strain across.
double free_solid_step(const BilinearPlastic& law, Solid& solid, const PlaneStrain<double>& e, double duration)
{
    double low = -0.2, high = 0.2;
    const auto stepped = [&](double across) { return solid_step(law, solid, {e.xx, e.yy, across, e.xy, e.yz, e.zx}, duration); };
    for (int i = 0; i < 200; ++i) (stepped(0.5 * (low + high)).stress[2] < 0 ? low : high) = 0.5 * (low + high);
    solid = stepped(low);
    return low;
}

class PlaneStressAgainstSolid : public testing::TestWithParam<BilinearPlastic> {};

TEST_P(PlaneStressAgainstSolid, GivesTheSameStressAndThickness)
{
    const BilinearPlastic law = GetParam();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> strain(-0.01, 0.01);
    PlanePoint<double> point;
    Solid solid;
    for (int i = 0; i < 40; ++i) {
        const PlaneStrain<double> e{strain(random), strain(random), strain(random), strain(random), strain(random)};
        const PlaneResponse<double> response = law.stretch(steel, point, e, 2e-6);
        const double across = free_solid_step(law, solid, e, 2e-6);
        const double scale = 1e-7 * law.yield_stress;
        EXPECT_NEAR(point.stress.xx, solid.stress[0], scale);
        EXPECT_NEAR(point.stress.yy, solid.stress[1], scale);
        EXPECT_NEAR(point.stress.xy, solid.stress[3], scale);
        EXPECT_NEAR(point.stress.yz, solid.stress[4], scale);
        EXPECT_NEAR(point.stress.zx, solid.stress[5], scale);
        EXPECT_NEAR(point.plastic_strain, solid.plastic_strain, 1e-8);
        EXPECT_NEAR(response.thickness_strain, across, 1e-8);
        if (!law.has_back_stress()) {
            EXPECT_GE(response.plastic_work, 0.0);  // a back stress may give some of its work back
        }
    }
    EXPECT_GT(point.plastic_strain, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Laws, PlaneStressAgainstSolid,
                         testing::Values(BilinearPlastic{1200e6, 6500e6, 0, 1, 0}, BilinearPlastic{1200e6, 0, 0, 1, 0},
                                         BilinearPlastic{400e6, 9000e6, 0, 1, 1.0}, BilinearPlastic{400e6, 9000e6, 0, 1, 0.4},
                                         BilinearPlastic{1200e6, 6500e6, 300, 5, 0}, BilinearPlastic{300e6, 500e6, 40.4, 4.7, 0.3},
                                         BilinearPlastic{300e6, 500e6, 40.4, 1, 0}));

TEST(BilinearPlastic, OneLargeStepStillMeetsTheYieldCondition)
{
    for (const double duration : {1e-7, 1e-3, 10.0}) {
        PlanePoint<double> point;
        armour.stretch(steel, point, PlaneStrain<double>{0.08, -0.03, 0.05, 0.02, 0.01}, duration);
        EXPECT_NEAR(von_mises(point.stress) / armour.yield_at(point.plastic_strain, point.plastic_strain / duration), 1.0, 1e-8)
            << duration;
    }
}

TEST(BilinearPlastic, LanesGiveTheSameAsSingleNumbers)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> strain(-0.006, 0.006);
    PlanePoint<Lanes> side;
    std::array<PlanePoint<double>, lane_count> single;
    for (int i = 0; i < 50; ++i) {
        double values[5][lane_count];
        for (auto& row : values)
            for (double& value : row) value = strain(random);
        const PlaneStrain<Lanes> e{load_lanes(values[0]), load_lanes(values[1]), load_lanes(values[2]), load_lanes(values[3]),
                                   load_lanes(values[4])};
        armour.stretch(steel, side, e, 1e-6);
        for (int lane = 0; lane < lane_count; ++lane) {
            armour.stretch(steel, single[lane],
                           PlaneStrain<double>{values[0][lane], values[1][lane], values[2][lane], values[3][lane], values[4][lane]}, 1e-6);
            EXPECT_NEAR(side.stress.xx[lane], single[lane].stress.xx, 1e-9 * 1200e6);
            EXPECT_NEAR(side.plastic_strain[lane], single[lane].plastic_strain, 1e-12);
        }
    }
}

TEST(BilinearPlastic, ReverseYieldShowsTheBauschingerEffect)
{
    for (const double kinematic : {0.0, 0.5, 1.0}) {
        const BilinearPlastic law{1200e6, 6500e6, 0, 1, kinematic};
        PlanePoint<double> point;
        for (int i = 0; i < 300; ++i) pull(law, point, 1e-4, 1e-6);
        const double top = point.stress.xx, plastic = point.plastic_strain;
        EXPECT_NEAR(top, 1200e6 + 6500e6 * plastic, 1.0);
        while (point.plastic_strain == plastic) pull(law, point, -1e-6, 1e-6);
        EXPECT_NEAR(top - point.stress.xx, 2.0 * (1200e6 + (1.0 - kinematic) * 6500e6 * plastic), 1e-6 * 212e9);
    }
}

TEST(Elastic, FollowsHooke)
{
    PlanePoint<double> point;
    const PlaneResponse<double> r = Elastic{}.stretch(steel, point, PlaneStrain<double>{1e-3, -0.28e-3, 2e-3, 0, 3e-3}, 1.0);
    EXPECT_NEAR(point.stress.xx, 212e6, 1e-3);
    EXPECT_NEAR(point.stress.yy, 0.0, 1e-3);
    EXPECT_NEAR(point.stress.xy, 212e9 / 2.56 * 2e-3, 1e-3);
    EXPECT_NEAR(point.stress.zx, 212e9 / 2.56 * 3e-3, 1e-3);
    EXPECT_NEAR(r.thickness_strain, -0.28e-3, 1e-15);
    EXPECT_EQ(r.plastic_work, 0.0);
}

}  // namespace
}  // namespace corpuscle
