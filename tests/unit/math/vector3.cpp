#include "math/vector3.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace corpuscle {
namespace {

constexpr Vector3d a{1.0, -2.0, 3.0};
constexpr Vector3d b{4.0, 0.5, -1.0};

TEST(Vector3, AddsScalesAndNegatesByComponents)
{
    EXPECT_EQ(a + b, Vector3d(5.0, -1.5, 2.0));
    EXPECT_EQ(a - b, Vector3d(-3.0, -2.5, 4.0));
    EXPECT_EQ(2.0 * a, Vector3d(2.0, -4.0, 6.0));
    EXPECT_EQ(a * 2.0, 2.0 * a);
    EXPECT_EQ(a / 4.0, Vector3d(0.25, -0.5, 0.75));
    EXPECT_EQ(-a, Vector3d(-1.0, 2.0, -3.0));
    EXPECT_EQ(scaled(a, b), Vector3d(4.0, -1.0, -3.0));
}

TEST(Vector3, ChangesInPlace)
{
    Vector3d c = a;
    c += b;
    c -= 2.0 * a;
    c *= 3.0;
    EXPECT_EQ(c, 3.0 * (b - a));
}

TEST(Vector3, IndexIsTheAxis)
{
    Vector3d c = a;
    EXPECT_EQ(c[0], 1.0);
    EXPECT_EQ(c[1], -2.0);
    EXPECT_EQ(c[2], 3.0);
    c[1] = 7.0;
    EXPECT_EQ(c, Vector3d(1.0, 7.0, 3.0));
}

TEST(Vector3, ProductsObeyTheirIdentities)
{
    EXPECT_EQ(dot(a, b), 0.0);
    EXPECT_EQ(cross(Vector3d(1, 0, 0), Vector3d(0, 1, 0)), Vector3d(0, 0, 1));
    EXPECT_EQ(cross(a, b), -cross(b, a));
    EXPECT_EQ(dot(cross(a, b), a), 0.0);
    EXPECT_EQ(dot(cross(a, b), b), 0.0);
    // Lagrange: |a x b|^2 = |a|^2 |b|^2 - (a.b)^2
    EXPECT_DOUBLE_EQ(norm_squared(cross(a, b)), norm_squared(a) * norm_squared(b) - dot(a, b) * dot(a, b));
}

TEST(Vector3, LengthAndDirection)
{
    EXPECT_EQ(norm(Vector3d(2.0, 3.0, 6.0)), 7.0);
    EXPECT_NEAR(norm(normalized(a)), 1.0, 4e-16);
    EXPECT_NEAR(norm(cross(normalized(a), a)), 0.0, 1e-15);
}

TEST(Vector3, ChangesPrecisionOnlyWhenAsked)
{
    const Vector3f single(Vector3d(0.1, 0.2, 0.3));
    EXPECT_EQ(single, Vector3f(0.1f, 0.2f, 0.3f));
    static_assert(!std::is_convertible_v<Vector3d, Vector3f>);
}

}  // namespace
}  // namespace corpuscle
