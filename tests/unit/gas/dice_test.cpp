#include "gas/dice.hpp"

#include <gtest/gtest.h>

#include "gas_samples.hpp"

namespace corpuscle {
namespace {

const std::vector<LarsenBorgnakke> exchanges{LarsenBorgnakke(2), LarsenBorgnakke(11.0 / 3), LarsenBorgnakke(0)};

/// Means of n numbers, each of variance v, scatter by sqrt(v/n): bounds are four times that.
TEST(Dice, directions_are_uniform_on_the_sphere)
{
    Dice dice(5, 3, 11, exchanges);
    const int count = 200000;
    Vector3d mean, mean_square;
    for (int i = 0; i < count; ++i) {
        const Vector3d d(dice.direction());
        ASSERT_NEAR(norm(d), 1, 3e-7);
        mean += d / count;
        for (int a = 0; a < 3; ++a) mean_square[a] += d[a] * d[a] / count;
    }
    for (int a = 0; a < 3; ++a) {
        EXPECT_NEAR(mean[a], 0, 4 * std::sqrt(1.0 / 3 / count));
        EXPECT_NEAR(mean_square[a], 1.0 / 3, 4 * std::sqrt(4.0 / 45 / count));
    }
}

/// Beta(zeta/2, 2) has mean a/(a + 2) and variance 2 a/((a + 2)^2 (a + 3)), a = zeta/2.
/// Each collision scales its pair's energy by the squared length: a bias would cool or heat the gas with the number of collisions. One
/// squared length is wrong by up to 1.3e-7, 4.5e-8 in the root mean square: 4 sigma of a million directions are 1.8e-10.
TEST(Dice, directions_have_unit_length_in_the_mean)
{
    double excess = 0;
    for (std::uint64_t index = 0; index < 50; ++index) {
        Dice dice(1, 0, index, {});
        for (int i = 0; i < 20000; ++i) excess += norm_squared(Vector3d(dice.direction())) - 1;
    }
    EXPECT_NEAR(excess / 1e6, 0, 1.8e-10);
}

TEST(Dice, internal_shares_are_beta_distributed)
{
    Dice dice(5, 3, 12, exchanges);
    for (std::uint32_t s = 0; s < 2; ++s) {
        const double a = s == 0 ? 1 : 11.0 / 6;
        std::vector<double> shares(200000);
        for (double& share : shares) share = static_cast<double>(dice.internal_share(s));
        const Statistics found(shares);
        const double variance = 2 * a / ((a + 2) * (a + 2) * (a + 3));
        EXPECT_NEAR(found.mean, a / (a + 2), 4 * std::sqrt(variance / found.count));
        EXPECT_NEAR(found.variance / variance, 1, 4 * std::sqrt((found.kurtosis - 1) / found.count));
    }
}

TEST(Dice, depends_on_seed_step_and_index_and_on_nothing_else)
{
    const auto words = [](std::uint64_t seed, std::uint64_t step, std::uint64_t index) {
        Dice dice(seed, step, index, exchanges);
        std::vector<std::uint32_t> drawn;
        for (int i = 0; i < 200; ++i) drawn.push_back(dice.word());
        return drawn;
    };
    EXPECT_EQ(words(1, 2, 3), words(1, 2, 3));
    EXPECT_NE(words(1, 2, 3), words(2, 2, 3));
    EXPECT_NE(words(1, 2, 3), words(1, 3, 3));
    EXPECT_NE(words(1, 2, 3), words(1, 2, 4));
}

}  // namespace
}  // namespace corpuscle
