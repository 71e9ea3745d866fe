#include "math/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace corpuscle {
namespace {

double integral(const std::vector<QuadraturePoint>& rule, int degree)
{
    double total = 0;
    for (const QuadraturePoint& p : rule) total += p.weight * std::pow(p.position, degree);
    return total;
}

double exact(int degree)
{
    return degree % 2 == 1 ? 0.0 : 2.0 / (degree + 1);
}

TEST(Quadrature, GaussIsExactToItsDegreeAndNoFurther)
{
    for (int n = 1; n <= 10; ++n) {
        const auto rule = gauss_rule(n);
        ASSERT_EQ(rule.size(), n);
        for (int degree = 0; degree <= 2 * n - 1; ++degree) EXPECT_NEAR(integral(rule, degree), exact(degree), 1e-13) << n << ' ' << degree;
        EXPECT_GT(std::abs(integral(rule, 2 * n) - exact(2 * n)), 1e-7) << n;
    }
}

TEST(Quadrature, LobattoIsExactToItsDegreeAndHasBothEnds)
{
    for (int n = 2; n <= 10; ++n) {
        const auto rule = lobatto_rule(n);
        ASSERT_EQ(rule.size(), n);
        EXPECT_EQ(rule.front().position, -1.0);
        EXPECT_EQ(rule.back().position, 1.0);
        for (int degree = 0; degree <= 2 * n - 3; ++degree) EXPECT_NEAR(integral(rule, degree), exact(degree), 1e-13) << n << ' ' << degree;
        EXPECT_GT(std::abs(integral(rule, 2 * n - 2) - exact(2 * n - 2)), 1e-7) << n;
    }
}

TEST(Quadrature, PointsAscend)
{
    for (const auto& rule : {gauss_rule(9), lobatto_rule(9)})
        for (std::size_t i = 1; i < rule.size(); ++i) EXPECT_LT(rule[i - 1].position, rule[i].position);
}

}  // namespace
}  // namespace corpuscle
