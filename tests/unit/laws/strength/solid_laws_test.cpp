#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "laws/strength/strength.hpp"

// Every plastic law, as a shell's and as a solid's point.

namespace corpuscle {
namespace {

constexpr double young = 200e9, poisson = 0.3;
const PlaneStiffness flat{young, poisson};
const SolidStiffness solid{young, poisson};

const BilinearPlastic mixed{400e6, 1000e6, 40.4, 5.0, 0.5};
const CurvePlastic table{{{1.0, {{0.0, 300e6}, {0.05, 400e6}, {0.3, 500e6}}}, {1000.0, {{0.0, 400e6}, {0.05, 480e6}, {0.3, 560e6}}}}, 0, 1};
JohnsonCook steel()
{
    JohnsonCook law;
    law.a = 490e6;
    law.b = 383e6;
    law.n = 0.45;
    law.c = 0.0123;
    law.reference_rate = 5e-4;
    law.m = 0.94;
    law.melting_temperature = 1800;
    law.heat_capacity = 7850.0 * 452.0;
    return law;
}

/// A solid's point under uniaxial stress: lateral strains found by the secant method so that they carry nothing.
template <class Law>
SolidResponse<double> pull(const Law& law, SolidPoint<double>& point, double strain, double duration)
{
    const auto lateral_stress = [&](double lateral) {
        SolidPoint<double> trial = point;
        law.stretch(solid, trial, SolidStrain<double>{strain, lateral, lateral, 0, 0, 0}, duration);
        return trial.stress.yy;
    };
    double a = -poisson * strain, b = -0.5 * strain, fa = lateral_stress(a), fb = lateral_stress(b);
    for (int i = 0; i < 60 && std::abs(fb) > 1e-4 && fa != fb; ++i) {
        const double c = b - fb * (b - a) / (fb - fa);
        a = b;
        fa = fb;
        b = c;
        fb = lateral_stress(b);
    }
    return law.stretch(solid, point, SolidStrain<double>{strain, b, b, 0, 0, 0}, duration);
}

/// The uniaxial curve is the law's own yield stress at the plastic strain and rate of the step.
template <class Law>
void expect_on_curve(const Law& law, const std::function<double(double, double, double)>& yield)
{
    for (const double duration : {1e-2, 1e-6}) {
        SolidPoint<double> point;
        double work = 0, summed = 0, heat = 0, before = 0;
        for (int i = 0; i < 500; ++i) {
            before = point.plastic_strain;
            heat = point.heat;
            const double stress_before = point.stress.xx;
            const SolidResponse<double> r = pull(law, point, 2e-4, duration);
            work += r.plastic_work;
            summed += 0.5 * (stress_before + point.stress.xx) * (point.plastic_strain - before);
        }
        const double rate = (point.plastic_strain - before) / duration;
        ASSERT_GT(rate, 0.0);
        EXPECT_NEAR(point.stress.xx, yield(point.plastic_strain, rate, heat), 1e-6 * point.stress.xx) << duration;
        EXPECT_NEAR(point.plastic_strain + point.stress.xx / young, 0.1, 1e-6);
        EXPECT_NEAR(work, summed, 1e-9 * work);
    }
}

TEST(SolidLaws, UniaxialStressIsOnTheCurve)
{
    BilinearPlastic plain = mixed;
    plain.kinematic_fraction = 0;
    expect_on_curve(plain, [&](double strain, double rate, double) { return plain.yield_at(strain, rate); });
    expect_on_curve(table, [&](double strain, double rate, double) { return table.yield_stress(strain, rate, 0); });
    expect_on_curve(steel(), [&](double strain, double rate, double heat) { return steel().yield_stress(strain, rate, heat); });
}

TEST(SolidLaws, KinematicHardeningShiftsTheSurface)
{
    BilinearPlastic law = mixed;
    law.rate_constant = 0;
    law.kinematic_fraction = 1;
    SolidPoint<double> point;
    for (int i = 0; i < 200; ++i) pull(law, point, 1e-4, 1.0);
    const double top = point.stress.xx;
    int steps = 0;
    for (const double start = point.plastic_strain; point.plastic_strain == start && steps < 1000; ++steps) pull(law, point, -1e-5, 1.0);
    EXPECT_NEAR(top - point.stress.xx, 2 * 400e6, 2 * 1e-5 * young);  // it yields again 2 sigma0 below, to within two steps
}

/// A long way of stretch, shear and growth of volume in one point, in `steps`; its end is compared with ten times as many.
template <class Law, class Point, class Strain>
Point walked(const Law& law, const auto& stiffness, const Strain& total, int steps, double time)
{
    Point point;
    const double share = 1.0 / steps;
    Strain e = total;
    double* parts = &e.xx;
    for (std::size_t i = 0; i < sizeof(Strain) / sizeof(double); ++i) parts[i] *= share;
    for (int i = 0; i < steps; ++i) law.stretch(stiffness, point, e, time * share);
    return point;
}

/// The return is of first order in the step: a tenth of the step leaves a tenth of the difference. 100 steps of 0.1 % strain: within 0.5 %.
template <class Law>
void expect_converged(const Law& law)
{
    const SolidStrain<double> way{0.06, -0.03, -0.025, 0.04, -0.02, 0.03};
    using S = SolidPoint<double>;
    const S a = walked<Law, S>(law, solid, way, 100, 1e-3), b = walked<Law, S>(law, solid, way, 10000, 1e-3);
    const double scale = von_mises(b.stress);
    EXPECT_NEAR(von_mises(a.stress), scale, 0.005 * scale);
    EXPECT_NEAR(a.plastic_strain, b.plastic_strain, 0.005 * b.plastic_strain);
    EXPECT_NEAR(a.stress.xy, b.stress.xy, 0.005 * scale);
    const PlaneStrain<double> flat_way{0.06, -0.03, 0.04, -0.02, 0.03};
    using P = PlanePoint<double>;
    const P c = walked<Law, P>(law, flat, flat_way, 100, 1e-3), d = walked<Law, P>(law, flat, flat_way, 10000, 1e-3);
    EXPECT_NEAR(von_mises(c.stress), von_mises(d.stress), 0.005 * von_mises(d.stress));
    EXPECT_NEAR(c.plastic_strain, d.plastic_strain, 0.005 * d.plastic_strain);
}

TEST(SolidLaws, ReturnAgreesWithFineSteps)
{
    expect_converged(mixed);
    expect_converged(table);
    expect_converged(steel());
}

TEST(SolidLaws, LanesGiveWhatPointsGiveAlone)
{
    std::visit(
        [](const auto& law) {
            SolidPoint<Lanes> side_by_side;
            std::array<SolidPoint<double>, lane_count> alone;
            for (int step = 0; step < 30; ++step) {
                const Lanes x([&](auto lane) { return 1e-3 * (1.0 + lane) * (step < 20 ? 1.0 : -1.0); });
                law.stretch(solid, side_by_side, SolidStrain<Lanes>{x, -0.4 * x, -0.5 * x, 0.3 * x, 0.1 * x, -0.2 * x}, 1e-6);
                for (int lane = 0; lane < lane_count; ++lane) {
                    const double a = x[lane];
                    law.stretch(solid, alone[lane], SolidStrain<double>{a, -0.4 * a, -0.5 * a, 0.3 * a, 0.1 * a, -0.2 * a}, 1e-6);
                }
            }
            for (int lane = 0; lane < lane_count; ++lane) {
                const double scale = von_mises(alone[lane].stress);
                EXPECT_NEAR(side_by_side.stress.xx[lane], alone[lane].stress.xx, 1e-7 * scale);
                EXPECT_NEAR(side_by_side.stress.xy[lane], alone[lane].stress.xy, 1e-7 * scale);
                EXPECT_NEAR(side_by_side.plastic_strain[lane], alone[lane].plastic_strain, 1e-7 * alone[lane].plastic_strain);
            }
        },
        std::variant<BilinearPlastic, CurvePlastic, JohnsonCook>(steel()));
}

TEST(JohnsonCook, AdiabaticHeatSoftens)
{
    const JohnsonCook law = steel();
    SolidPoint<double> point;
    double work = 0;
    for (int i = 0; i < 1000; ++i) work += pull(law, point, 5e-4, 1e-7).plastic_work;
    EXPECT_NEAR(point.heat, 0.9 * work / law.heat_capacity, 1e-9 * point.heat);
    EXPECT_GT(point.heat, 50.0);
    EXPECT_NEAR(law.yield_stress(0.2, 5e-4, 1507.0), 1e-6 * law.yield_stress(0.2, 5e-4, 0.0), 1e-9 * law.a);  // molten
}

TEST(JohnsonCook, DamageIsStrainOverStrainAtFailure)
{
    JohnsonCook law = steel();
    law.c = 0;
    law.heat_capacity = 0;
    law.d1 = 0.05;
    law.d2 = 3.44;
    law.d3 = -2.12;
    SolidPoint<double> point;
    for (int i = 0; i < 1000; ++i) pull(law, point, 2e-4, 10.0);  // uniaxial: a third of the equivalent stress is mean stress
    const double failure = 0.05 + 3.44 * std::exp(-2.12 / 3.0);
    EXPECT_NEAR(point.damage, point.plastic_strain / failure, 1e-6 * point.damage);
}

TEST(HydroPlastic, ShockIsOnTheHugoniot)
{
    HydroPlastic law;
    law.deviator = {1.0, 0.0, 0.0, 1.0, 0.0};  // next to no strength
    law.density = 8930;
    law.sound_speed = 3940;
    law.slope = 1.489;
    law.grueneisen = 1.99;
    const SolidStiffness copper(117e9, 0.35);
    for (const double eta : {0.05, 0.15, 0.25}) {
        // along the Rayleigh line the whole work is p_H eta / 2: set the energy of the Hugoniot and read the pressure there
        const double room = 1.0 - law.slope * eta, hugoniot = 8930 * 3940.0 * 3940.0 * eta / (room * room);
        EXPECT_NEAR(law.pressure(1.0 - eta, 0.5 * hugoniot * eta), hugoniot, 1e-9 * hugoniot);
    }
    SolidPoint<double> point;  // slow compression is isentropic: dE = -p dV
    double energy = 0, before = 0;
    for (int i = 0; i < 2000; ++i) {
        const double volume = point.volume;
        law.stretch(copper, point, SolidStrain<double>{-1e-4, 0, 0, 0, 0, 0}, 1.0);
        const double pressure = law.pressure(point.volume, point.energy);
        energy -= 0.5 * (pressure + before) * (point.volume - volume);
        before = pressure;
    }
    EXPECT_NEAR(point.volume, std::exp(-0.2), 1e-6);
    EXPECT_NEAR(point.energy, energy, 1e-5 * energy);  // and the 1 Pa of strength
    EXPECT_NEAR(-mean_stress(point.stress), before, 1e-9 * before);
}

TEST(Fabric, CarriesTensionOnly)
{
    const Fabric law;
    const PlaneStiffness cloth(300e6, 0.3);
    PlanePoint<double> point;
    law.stretch(cloth, point, PlaneStrain<double>{0.01, 0.005, 0.002, 0, 0}, 1.0);
    EXPECT_NEAR(point.stress.xx, cloth.plane() * (0.01 + 0.3 * 0.005), 1.0);  // taut: elastic
    EXPECT_NEAR(point.stress.xy, cloth.shear() * 0.002, 1.0);
    law.stretch(cloth, point, PlaneStrain<double>{0, -0.055, -0.002, 0, 0}, 1.0);
    EXPECT_NEAR(point.stress.xx, 300e6 * 0.01, 1.0);  // wrinkled: uniaxial
    EXPECT_NEAR(point.stress.yy, 0.0, 1.0);
    law.stretch(cloth, point, PlaneStrain<double>{-0.03, 0, 0, 0, 0}, 1.0);
    EXPECT_NEAR(std::abs(point.stress.xx) + std::abs(point.stress.yy) + std::abs(point.stress.xy), 0.0, 1.0);  // slack
    law.stretch(cloth, point, PlaneStrain<double>{0.03, 0, 0, 0, 0}, 1.0);
    EXPECT_NEAR(point.stress.xx, 300e6 * 0.01, 1.0);  // and taut again where it was
}

}  // namespace
}  // namespace corpuscle
