#include <gtest/gtest.h>

#include <cstdio>

#include "../../unit/structure/plates.hpp"

namespace corpuscle {
namespace {

/// Stress of a bar pulled at a constant true strain rate: elastic strain plus viscoplastic strain make the whole, integrated with a
/// hundred thousand explicit steps.
double pulled_bar(double rate, double strain)
{
    const double e = 212e9, step = strain / 100000;
    double stress = 0, plastic = 0;
    for (int i = 0; i < 100000; ++i) {
        const double over = stress / (1200e6 + 6500e6 * plastic) - 1.0;
        const double plastic_step = over > 0 ? 300.0 * std::pow(over, 5) * step / rate : 0.0;
        plastic += plastic_step;
        stress += e * (step - plastic_step);
    }
    return stress;
}

/// One element drawn along x at a constant true strain rate, free to shrink along y.
TEST(Plasticity, OneElementFollowsTheRateDependentCurve)
{
    for (const double rate : {50.0, 1000.0}) {
        const double side = 0.001;  // so small that it is in balance across at all times
        Structure structure;
        PartDescription d = plate(square_mesh(1, side), armour_steel(), 0.0005);
        d.holds = {symmetry({0, 2}, 0), symmetry({0, 1}, 1)};
        add_part(structure, d);
        Nodes& n = structure.nodes;
        const auto& shells = std::get<QuadrilateralShells>(structure.parts[0].elements);
        Clock clock;
        int compared = 0;
        double next = 0.01;
        while (next < 0.085) {
            const double duration = 0.5 * stable_step(structure);
            for (const int i : {1, 3}) {
                n.inverse_mass[i].x = 0;  // led, not pushed
                n.velocity[i].x = n.position[i].x * std::expm1(rate * duration) / duration;
            }
            step(structure, clock, duration);
            const double strain = std::log(n.position[1].x / side);
            if (strain < next) continue;
            const PlaneStress<double> stress = shells.point(0, 2).stress;
            const double exact = pulled_bar(rate, strain);
            EXPECT_NEAR(stress.xx / exact, 1.0, 0.003) << rate << ' ' << strain;
            EXPECT_LT(std::abs(stress.yy), 0.01 * exact);
            next += 0.01;
            ++compared;
        }
        EXPECT_EQ(compared, 8);
    }
}

/// Where the energy of a plate thrown against its clamped rim goes: nowhere but into strain, plastic work and what still moves.
TEST(Plasticity, EnergyOfAThrownPlateIsAllFound)
{
    Structure structure;
    PartDescription d = plate(square_mesh(20, 0.5), armour_steel(), 0.01);
    for (std::uint32_t j = 0; j <= 20; ++j)
        for (std::uint32_t i = 0; i <= 20; ++i)
            if (i == 0 || j == 0 || i == 20 || j == 20) d.holds.push_back(clamp({21 * j + i}));
    d.velocity = {0.0, 0.0, 80.0};
    add_part(structure, d);
    const double start = energy(structure).kinetic;
    Clock clock;
    double drift = 0, elastic_least = start;
    while (clock.time() < 2e-3) {
        const double duration = stable_step(structure);
        step(structure, clock, duration);
        const StructureEnergy e = energy(structure);
        drift = std::max(drift, std::abs(e.integration - work_in_transit(structure, duration)));
        elastic_least = std::min(elastic_least, e.internal - e.plastic);
        ASSERT_NEAR(e.total(), start, 1e-10 * start);
    }
    const StructureEnergy e = energy(structure);
    std::printf("energy gained or lost by the change of the step: %.2e of the start; plastic %.3f, hourglass %.4f\n", drift / start,
                e.plastic / start, e.hourglass / start);
    EXPECT_LT(drift, 1e-4 * start);
    EXPECT_GT(e.plastic, 0.3 * start);
    EXPECT_GT(elastic_least, -1e-3 * start);
    EXPECT_LT(e.hourglass, 0.01 * start);
    EXPECT_GT(max_plastic_strain(structure.parts[0]), 0.01);
}

}  // namespace
}  // namespace corpuscle
