#include "math/student.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace corpuscle {
namespace {

/// The table every textbook has: two-sided limits of 95 % and 99 %.
TEST(Student, limits_are_those_of_the_tables)
{
    struct Row {
        int degrees;
        double at_95, at_99;
    };
    const std::array<Row, 8> rows{{{1, 12.706, 63.657},
                                   {2, 4.303, 9.925},
                                   {3, 3.182, 5.841},
                                   {4, 2.776, 4.604},
                                   {7, 2.365, 3.499},
                                   {10, 2.228, 3.169},
                                   {30, 2.042, 2.750},
                                   {120, 1.980, 2.617}}};
    for (const Row& row : rows) {
        EXPECT_NEAR(student_limit(0.95, row.degrees), row.at_95, 5e-4) << row.degrees;
        EXPECT_NEAR(student_limit(0.99, row.degrees), row.at_99, 5e-4) << row.degrees;
    }
}

/// One degree is Cauchy's law, within(t) = 2 atan(t)/pi; two have within(t) = t/sqrt(2 + t^2); many are normal, up to 1/degrees.
TEST(Student, known_laws)
{
    for (const double t : {0.1, 1.0, 3.7, 40.0}) {
        EXPECT_NEAR(student_within(t, 1), 2 * std::atan(t) / std::numbers::pi, 1e-14);
        EXPECT_NEAR(student_within(t, 2), t / std::sqrt(2 + t * t), 1e-14);
        EXPECT_NEAR(student_within(t, 9999), std::erf(t / std::numbers::sqrt2), 1e-4);
        EXPECT_EQ(student_within(-t, 5), -student_within(t, 5));
    }
    EXPECT_NEAR(student_limit(0.95, 9999), 1.9600, 5e-4);
}

TEST(Student, a_limit_holds_what_it_says)
{
    for (const int degrees : {1, 2, 5, 8, 33, 400})
        for (const double confidence : {0.01, 0.5, 0.95, 0.9999})
            EXPECT_NEAR(student_within(student_limit(confidence, degrees), degrees), confidence, 1e-12);
}

}  // namespace
}  // namespace corpuscle
