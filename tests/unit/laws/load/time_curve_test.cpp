#include "laws/load/time_curve.hpp"

#include <gtest/gtest.h>

namespace corpuscle {
namespace {

const TimeCurve hat({{1, 2}, {3, 6}, {4, 0}});

TEST(TimeCurve, IsStraightBetweenItsPointsAndLevelBeyond)
{
    EXPECT_EQ(hat.value(-5), 2);
    EXPECT_EQ(hat.value(1), 2);
    EXPECT_EQ(hat.value(2), 4);
    EXPECT_EQ(hat.value(3), 6);
    EXPECT_EQ(hat.value(3.5), 3);
    EXPECT_EQ(hat.value(9), 0);
    EXPECT_EQ(TimeCurve(7.0).value(-1), 7);
    EXPECT_EQ(TimeCurve().value(3), 0);
}

TEST(TimeCurve, IntegralsAreExact)
{
    EXPECT_DOUBLE_EQ(hat.integral(1, 4), 8 + 3);
    EXPECT_DOUBLE_EQ(hat.integral(0, 2), 2 + 3);
    EXPECT_DOUBLE_EQ(hat.integral(4, 1), -11);
    EXPECT_DOUBLE_EQ(hat.integral(4, 40), 0);
    EXPECT_DOUBLE_EQ(TimeCurve(7.0).integral(-1, 2), 21);
    EXPECT_DOUBLE_EQ(TimeCurve(7.0).way(4), 56);
}

TEST(TimeCurve, WayIsTheIntegralOfTheIntegral)
{
    constexpr int parts = 100'000;  // Simpson's rule in each: exact for the square that the integral of a straight piece is
    for (const double end : {0.7, 1.5, 3.2, 6.0}) {
        double way = 0;
        for (int i = 0; i < parts; ++i) {
            const double a = end * i / parts, b = end * (i + 1) / parts;
            way += (b - a) / 6 * (hat.integral(0, a) + 4 * hat.integral(0, 0.5 * (a + b)) + hat.integral(0, b));
        }
        EXPECT_NEAR(hat.way(end), way, 1e-10);
    }
}

}  // namespace
}  // namespace corpuscle
