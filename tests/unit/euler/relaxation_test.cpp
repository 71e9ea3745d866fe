#include "euler/relaxation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "laws/eos/chapman_jouguet.hpp"
#include "unit/euler/euler_samples.hpp"

namespace corpuscle {
namespace {

/// A gas of a density [kg/m3] and a pressure [Pa] in a share of a cell.
PhasePart part(const MieGrueneisen& law, double share, double density, double pressure)
{
    return {&law, share, share * density, share * density * law.energy(density, pressure)};
}

/// Two ideal gases of one gamma that share a volume by isentropes: p (share/start)^gamma equal, so the shares go as p^(1/gamma).
TEST(EulerRelaxation, shares_volume_as_ideal_isentropes_say)
{
    const MieGrueneisen law = mie_grueneisen(IdealGas{1.4});
    for (const double ratio : {1e-4, 0.5, 1.001, 30.0, 1e6}) {
        const double found = relaxed_share(part(law, 0.3, 2, 1e5 * ratio), part(law, 0.6, 1, 1e5));
        const double wanted = 0.9 * 0.3 * std::pow(ratio, 1 / 1.4) / (0.3 * std::pow(ratio, 1 / 1.4) + 0.6);
        EXPECT_NEAR(found / wanted, 1, 1e-7) << ratio;
    }
}

/// Of several such gases too; the pressures that the sweeps call the same differ by 1e-6.
TEST(EulerRelaxation, shares_volume_among_many)
{
    const MieGrueneisen law = mie_grueneisen(IdealGas{1.4});
    const std::array<double, 4> start{0.3, 0.6, 1e-5, 0.1 - 1e-5}, pressure{1e5, 3e7, 2e9, 5e3};
    std::array<PhasePart, 4> parts;
    double sum = 0;
    for (std::size_t m = 0; m < 4; ++m) {
        parts[m] = part(law, start[m], 1.0, pressure[m]);
        sum += start[m] * std::pow(pressure[m], 1 / 1.4);
    }
    std::array<double, 4> found{};
    relax_shares(parts, found);
    for (std::size_t m = 0; m < 4; ++m) EXPECT_NEAR(found[m] / (start[m] * std::pow(pressure[m], 1 / 1.4) / sum), 1, 2e-6) << m;
    EXPECT_NEAR(found[0] + found[1] + found[2] + found[3], 1, 1e-14);
}

TEST(EulerRelaxation, leaves_one_pressure_alone)
{
    const MieGrueneisen air = mie_grueneisen(IdealGas{1.4}), products = mie_grueneisen(tnt_products);
    EXPECT_EQ(relaxed_share(part(products, 0.25, 900, 3e9), part(air, 0.75, 5, 3e9)), 0.25);
}

/// Products under 8 GPa and air: at the end both are in one pressure, on the isentrope that the laws themselves give by integration.
TEST(EulerRelaxation, ends_in_one_pressure_on_both_isentropes)
{
    const MieGrueneisen air = mie_grueneisen(IdealGas{1.4}), products = mie_grueneisen(tnt_products);
    const double start = tnt_products.pressure(1630, tnt_energy);
    for (const double share : {1e-6, 0.1, 0.9, 1 - 1e-6}) {
        const double found = relaxed_share(part(products, share, 1630, start), part(air, 1 - share, 1.2, 101325));
        const double density = 1630 * share / found, air_density = 1.2 * (1 - share) / (1 - found);
        const double energy = energy_on_isentrope(tnt_products, 1630, tnt_energy, density, 4000);
        EXPECT_NEAR(tnt_products.pressure(density, energy) / (101325 * std::pow(air_density / 1.2, 1.4)), 1, 1e-5) << share;
    }
}

}  // namespace
}  // namespace corpuscle
