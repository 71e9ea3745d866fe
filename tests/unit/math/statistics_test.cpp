#include "math/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "math/random.hpp"

namespace corpuscle {
namespace {

/// 2, 4, 4, 4, 5, 5, 7, 9: mean 5, sum of squares 32; with 7 degrees t is 2.365.
TEST(Statistics, of_a_few_numbers)
{
    const Statistic found = statistic_of(std::vector<double>{2, 4, 4, 4, 5, 5, 7, 9});
    EXPECT_EQ(found.count, 8u);
    EXPECT_EQ(found.mean, 5);
    EXPECT_DOUBLE_EQ(found.deviation, std::sqrt(32.0 / 7));
    EXPECT_DOUBLE_EQ(found.standard_error, std::sqrt(32.0 / 7 / 8));
    EXPECT_NEAR(found.high - found.mean, 2.3646 * found.standard_error, 1e-4);
    EXPECT_DOUBLE_EQ(found.mean - found.low, found.high - found.mean);
}

TEST(Statistics, of_too_few_numbers_say_so)
{
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(statistic_of({}).count, 0u);
    EXPECT_TRUE(std::isnan(statistic_of({}).mean));
    const Statistic one = statistic_of(std::vector<double>{nothing, 3, nothing});
    EXPECT_EQ(one.count, 1u);
    EXPECT_EQ(one.mean, 3);
    EXPECT_TRUE(std::isnan(one.deviation) && std::isnan(one.low) && std::isnan(one.high));
}

/// Intervals hold the true mean as often as they claim, however few samples they are made from: 4000 intervals from 2, 3, 8 normal
/// samples each; 4 sigma of a share p is 4 sqrt(p (1 - p)/4000).
TEST(Statistics, intervals_hold_the_truth_as_often_as_they_claim)
{
    constexpr int trials = 4000;
    for (const double confidence : {0.5, 0.95}) {
        for (const std::size_t size : {2, 3, 8}) {
            int held = 0;
            for (int trial = 0; trial < trials; ++trial) {
                Random random(size, Purpose::fill, 0, static_cast<std::uint64_t>(trial));
                std::vector<double> samples(size);
                for (double& sample : samples) sample = 7 + 3 * random.normal();
                const Statistic found = statistic_of(samples, confidence);
                held += found.low <= 7 && 7 <= found.high;
            }
            EXPECT_NEAR(held / double{trials}, confidence, 4 * std::sqrt(confidence * (1 - confidence) / trials)) << size;
        }
    }
}

}  // namespace
}  // namespace corpuscle
