#include <gtest/gtest.h>

#include <cstdio>

#include "verification/gas/kinetics/expansion.hpp"

namespace corpuscle {
namespace {

/// A closed box grows to a hundred times its volume: the energy left is that of the isentrope. What the walls' speed adds falls with it:
/// internal freedoms lag by the walls' rate times the relaxation time, and the pressure on a wall that recedes at the Mach number M is low
/// by its square. The excess is therefore measured at M and M/2 and taken to M = 0; bound: the 1.5 % to which the pressure on walls at rest
/// is known (wall_pressure.cpp), acting on all the work done, and the noise of the extrapolation: the thermal energy's share in a motion of
/// 3 N freedoms, as sqrt(2/3N), twice.
void follow(const EquationOfState& law, double density, double energy, double last)
{
    Expansion set{.law = law, .density = density, .energy = energy, .side = 14, .mach = 0.06, .volume_ratio = last};
    const std::vector<Expanded> fast = expand(set);
    set.mach /= 2;
    const std::vector<Expanded> slow = expand(set);
    ASSERT_FALSE(slow.empty());
    for (std::size_t i = 0; i < slow.size(); ++i) {
        const double excess = fast[i].energy / fast[i].isentrope, half = slow[i].energy / slow[i].isentrope;
        const double limit = 2 * half - excess, work = -std::log(slow[i].isentrope);
        std::printf("%s V/V0 %.1f: energy over the isentrope's %.4f at M %.3f, %.4f at M %.3f, %.4f at rest\n", law_name(law).c_str(),
                    slow[i].volume_ratio, excess, 2 * set.mach, half, set.mach, limit);
        EXPECT_NEAR(limit, 1, 0.015 * work + 4 * std::sqrt(5 * 2.0 / 3) / std::sqrt(std::pow(set.side, 3)) * work) << slow[i].volume_ratio;
    }
}

TEST(SlowExpansion, ideal)
{
    follow(IdealGas{1.4}, 1, 1, 100);
}
TEST(SlowExpansion, noble_abel)
{
    for (const double share : {0.1, 0.3, 0.6}) follow(NobleAbel{1.3, share, 1}, 1, 1, 100);
}
TEST(SlowExpansion, jwl_of_tnt)
{
    follow(Jwl{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630}, 1630, 7e9 / 1630, 100);
}

}  // namespace
}  // namespace corpuscle
