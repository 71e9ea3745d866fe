#include "math/fast.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace corpuscle {
namespace {

TEST(Fast, logarithm_is_as_near_as_said)
{
    double worst = 0;
    for (float x = 1.2e-38f; x < 1e38f; x *= 1.0003f) {
        const double exact = std::log2(static_cast<double>(x));
        worst = std::max(worst, std::abs(static_cast<double>(fast_log2(x)) - exact) - 0x1p-24 * std::abs(exact));
    }
    EXPECT_LT(worst, 1e-7);
    EXPECT_EQ(fast_log2(1.0f), 0.0f);
}

TEST(Fast, power_of_two_is_as_near_as_said)
{
    double worst = 0;
    for (float x = -126; x < 127; x += 0.0007f) {
        worst = std::max(worst, std::abs(static_cast<double>(fast_exp2(x)) / std::exp2(static_cast<double>(x)) - 1));
    }
    EXPECT_LT(worst, 3e-7);
    EXPECT_EQ(fast_exp2(0.0f), 1.0f);
    EXPECT_EQ(fast_exp2(-1e9f), std::exp2(-126.0f));
}

TEST(Fast, turn_is_as_near_as_said)
{
    double worst = 0;
    for (float u = 0; u <= 1; u += 1e-5f) {
        const Turn turn = fast_turn(u);
        const double angle = 2 * std::numbers::pi * static_cast<double>(u);
        worst = std::max({worst, std::abs(static_cast<double>(turn.cosine) - std::cos(angle)),
                          std::abs(static_cast<double>(turn.sine) - std::sin(angle))});
    }
    EXPECT_LT(worst, 5e-7);
}

/// Against std::exp, itself within one unit of the last place.
TEST(Fast, exponential)
{
    double worst = 0;
    for (double x = -708; x < 709; x += 0.00917) worst = std::max(worst, std::abs(fast_exp(x) / std::exp(x) - 1));
    EXPECT_LT(worst, 6e-16);
    EXPECT_EQ(fast_exp(0), 1);
    EXPECT_EQ(fast_exp(-1e9), fast_exp(-708));
}

TEST(Fast, rounding_at_random_is_right_in_the_mean)
{
    for (const double exact : {1.0 / 3, -2.0 / 3, 0.1, 1e-30, 0.0, 0.75}) {
        double mean = 0;
        for (std::uint32_t random = 0; random < 256; ++random) {
            const float rounded = round_at_random(exact, random);
            mean += static_cast<double>(rounded) / 256;
            EXPECT_LT(std::abs(static_cast<double>(rounded) - exact), std::abs(exact) * 0x1p-23 + 1e-300);
        }
        EXPECT_NEAR(mean, exact, std::abs(exact) * 0x1p-23 / 256);
    }
}

}  // namespace
}  // namespace corpuscle
