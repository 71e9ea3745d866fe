#include <gtest/gtest.h>

#include <cstdio>

#include "verification/gas/kinetics/vessel.hpp"

namespace corpuscle {
namespace {

/// A charge that has burnt in a closed vessel comes to the pressure of its law at the vessel's volume: no energy is lost, and what motion
/// there was is heat. Bound as for gas that was even from the start (wall_pressure.cpp): 1.5 % and 4 standard errors.
void expect_equilibrium(const Vessel& set, const char* what)
{
    const VesselFound found = burn_in_vessel(set);
    std::printf(
        "%s, V %.0f%s: pressure over the law's %.4f, sigma %.4f (%.4g MPa); products' share of energy %.4f of equipartition; %llu steps\n",
        what, set.expansion, set.air_density > 0 ? ", air" : "", found.pressure, found.error, found.expected * 1e-6, found.first_share,
        static_cast<unsigned long long>(found.steps));
    EXPECT_LT(found.error, 0.01);
    EXPECT_NEAR(found.pressure, 1, 0.015 + 4 * found.error);
}

TEST(ClosedVessel, ideal)
{
    expect_equilibrium({.law = IdealGas{1.3}}, "ideal");
}
TEST(ClosedVessel, noble_abel)
{
    expect_equilibrium({.law = NobleAbel{1.3, 0.3, 1630}, .expansion = 3}, "Noble-Abel b 0.3");
}
TEST(ClosedVessel, jwl)
{
    expect_equilibrium({.law = Jwl{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630}, .expansion = 3}, "JWL");
}
TEST(ClosedVessel, two_gases)
{
    expect_equilibrium({.law = Jwl{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630}, .expansion = 100, .air_density = 12}, "JWL");
    expect_equilibrium({.law = NobleAbel{1.3, 0.3, 1630}, .expansion = 100, .air_density = 12}, "Noble-Abel b 0.3");
}

}  // namespace
}  // namespace corpuscle
