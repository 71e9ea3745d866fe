#include <gtest/gtest.h>

#include <cstdio>

#include "verification/gas/kinetics/mixture.hpp"

namespace corpuscle {
namespace {

constexpr double density = 800;  ///< [kg/m3]: half that of the explosive

/// Law `k` of the three, meant for that density.
EquationOfState law_number(int k)
{
    if (k == 0) return IdealGas{1.4};
    if (k == 1) return NobleAbel{1.3, 0.3, 1630};
    return Jwl{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630};
}

/// Two gases, the second of half the first one's density and `ratio` times its particle mass, one hot and one cold.
Mixture mixture_of(int first, int second, double ratio, std::size_t total)
{
    Mixture set{.law = {law_number(first), law_number(second)}, .density = {density, density / 2}, .energy = {4e6, 2e6}};
    set.count[0] = static_cast<std::size_t>(static_cast<double>(total) * 2 * ratio / (1 + 2 * ratio));
    set.count[1] = total - set.count[0];
    return set;
}

/// Every pair of laws: pressure on the walls as Dalton says, energy split by freedoms, and the split stays. Bounds: pressure 1.5 % and four
/// standard errors as for one gas (wall_pressure.cpp); split and drift four standard errors of batches. A
/// batch is 80 steps, about 25 collisions a particle: batches of half as many still knew of each other, and their errors came out too
/// small.
TEST(Mixtures, share_pressure_and_energy_as_dalton_says)
{
    for (int first = 0; first < 3; ++first) {
        for (int second = first; second < 3; ++second) {
            const Mixed found = mix(mixture_of(first, second, 1, 12000), 400, 20, 80);
            std::printf("laws %d and %d: pressure %.4f, sigma %.4f; split %.4f, sigma %.4f; drift %.4f, sigma %.4f\n", first, second,
                        found.pressure, found.pressure_error, found.split, found.split_error, found.drift, found.drift_error);
            EXPECT_NEAR(found.pressure, 1, 0.015 + 4 * found.pressure_error) << first << second;
            EXPECT_NEAR(found.split, 1, 4 * found.split_error + 1e-3) << first << second;
            EXPECT_NEAR(found.drift, 0, 4 * found.drift_error) << first << second;
        }
    }
}

/// The same for an ideal and a dense gas with a short path in small cells and a long step: how often particles meet there depends on the
/// density most, and must not depend on which gas has the energy.
TEST(Mixtures, share_energy_with_a_short_path_too)
{
    Mixture set = mixture_of(0, 1, 1, 12000);
    set.settings = {.cell_limit = 8, .partners = 4, .mean_free_path = 0.25, .cfl = 0.8};
    const Mixed found = mix(set, 400, 20, 80);
    std::printf("pressure %.4f, sigma %.4f; split %.4f, sigma %.4f\n", found.pressure, found.pressure_error, found.split,
                found.split_error);
    EXPECT_NEAR(found.pressure, 1, 0.015 + 4 * found.pressure_error);
    EXPECT_NEAR(found.split, 1, 4 * found.split_error + 1e-3);
}

/// Particles a hundred times lighter to a hundred times heavier keep energy and momentum. Rounding without a preferred sign leaves
/// sqrt(C/N) 1e-7 of C collisions a particle; 3e-7 would be a bias of 3e-9 a collision, a twentieth of a float's last place. While the
/// gases are not at one temperature, the rounded share of the pair's mass, wrong by up to 3e-8, moves the centre of mass's energy one way:
/// by up to 6e-8 of a heavy particle's energy a collision, for the (1 + r)^2/(4 r) collisions that it takes to be as warm as the light.
TEST(Mixtures, unlike_masses_conserve)
{
    for (const double ratio : {0.01, 0.1, 0.9995, 10.0, 100.0}) {
        const Mixed found = mix(mixture_of(0, 1, ratio, 8000), 200, 4, 50);
        std::printf("masses 1:%g, %.0f collisions a particle: energy %.1e, momentum %.1e\n", ratio, found.collisions, found.energy_error,
                    found.momentum_error);
        EXPECT_TRUE(found.counts_kept) << ratio;
        EXPECT_NEAR(found.energy_error, 0, 3e-7 + 6e-8 * (1 + ratio) * (1 + ratio) / (4 * ratio)) << ratio;
        EXPECT_LT(found.momentum_error, 1e-6) << ratio;
        EXPECT_GT(found.collisions, 30) << ratio;
    }
}

}  // namespace
}  // namespace corpuscle
