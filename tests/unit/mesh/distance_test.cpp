#include "mesh/distance.hpp"

#include <gtest/gtest.h>

namespace corpuscle {
namespace {

/// A right triangle with legs 3 and 4 in the plane z = 1: above its inside, beside each edge, beyond each corner, and in its plane.
TEST(Distance, to_a_triangle_from_all_around)
{
    const std::array<Vector3d, 3> corner{Vector3d{0, 0, 1}, Vector3d{3, 0, 1}, Vector3d{0, 4, 1}};
    EXPECT_DOUBLE_EQ(distance_to_triangle({1, 1, 3}, corner), 2);
    EXPECT_DOUBLE_EQ(distance_to_triangle({1, 1, -3}, corner), 4);
    EXPECT_DOUBLE_EQ(distance_to_triangle({1, 1, 1}, corner), 0);
    EXPECT_DOUBLE_EQ(distance_to_triangle({1, -2, 1}, corner), 2);
    EXPECT_DOUBLE_EQ(distance_to_triangle({-3, 2, 5}, corner), 5);
    EXPECT_DOUBLE_EQ(distance_to_triangle({3, 4, 1}, corner), 2.4);  // 12/5, the height over the long side, mirrored
    EXPECT_DOUBLE_EQ(distance_to_triangle({6, -4, 1}, corner), 5);
    EXPECT_DOUBLE_EQ(distance_to_triangle({-3, -4, 13}, corner), 13);
}

TEST(Distance, to_a_triangle_without_area_is_that_to_its_edges)
{
    const Vector3d a{0, 0, 0}, b{1, 0, 0};
    EXPECT_DOUBLE_EQ(distance_to_triangle({0.5, 2, 0}, {a, b, a}), 2);
    EXPECT_DOUBLE_EQ(distance_to_segment({3, 0, 0}, a, b), 2);
    EXPECT_DOUBLE_EQ(distance_to_segment({0, 3, 4}, a, a), 5);
}

}  // namespace
}  // namespace corpuscle
