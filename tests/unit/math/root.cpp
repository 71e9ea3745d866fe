#include "math/root.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace corpuscle {
namespace {

TEST(FindRoot, smooth_steep_flat_and_broken_functions)
{
    EXPECT_NEAR(find_root([](double x) { return x * x - 2; }, 0, 2), std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(find_root([](double x) { return std::cos(x) - x; }, 0, 1), 0.73908513321516064166, 1e-15);
    EXPECT_NEAR(find_root([](double x) { return std::exp(x) - 1e20; }, -700, 700), std::log(1e20), 1e-13);
    EXPECT_NEAR(find_root([](double x) { return std::pow(x - 1, 9); }, 0, 5), 1, 1e-8);
    EXPECT_NEAR(find_root([](double x) { return x < 0.3 ? -1.0 : 1.0; }, 0, 1), 0.3, 1e-15);
    EXPECT_NEAR(find_root([](double x) { return 1e-12 - x; }, 1, -1), 1e-12, 1e-27);
}

TEST(FindRoot, ends_of_the_interval_count)
{
    EXPECT_EQ(find_root([](double x) { return x; }, 0, 1), 0);
    EXPECT_EQ(find_root([](double x) { return x - 1; }, 0, 1), 1);
}

TEST(FindRoot, no_change_of_sign_is_no_root)
{
    EXPECT_TRUE(std::isnan(find_root([](double x) { return x * x + 1; }, -1, 1)));
}

TEST(FindRoot, takes_few_steps_on_smooth_functions)
{
    int calls = 0;
    find_root(
        [&](double x) {
            ++calls;
            return x * x * x - 5;
        },
        0, 10);
    EXPECT_LT(calls, 20);
}

}  // namespace
}  // namespace corpuscle
