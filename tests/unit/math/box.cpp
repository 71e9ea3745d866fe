#include "math/box.hpp"

#include <gtest/gtest.h>

namespace corpuscle {
namespace {

constexpr Box unit{{0, 0, 0}, {1, 1, 1}};

TEST(Box, IsEmptyUntilSomethingIsPutIn)
{
    Box box;
    EXPECT_FALSE(box.contains({0, 0, 0}));
    box.include({1, 2, 3});
    EXPECT_TRUE(box.contains({1, 2, 3}));
    EXPECT_EQ(box.volume(), 0.0);
    box.include({-1, 5, 2});
    EXPECT_EQ(box.lower, Vector3d(-1, 2, 2));
    EXPECT_EQ(box.upper, Vector3d(1, 5, 3));
    EXPECT_EQ(box.volume(), 6.0);
    EXPECT_EQ(box.center(), Vector3d(0, 3.5, 2.5));
    EXPECT_EQ(box.size(), Vector3d(2, 3, 1));
}

TEST(Box, HoldsItsWalls)
{
    EXPECT_TRUE(unit.contains({0, 1, 0.5}));
    EXPECT_FALSE(unit.contains({0, 1.0000001, 0.5}));
    EXPECT_FALSE(unit.contains({-1e-9, 0.5, 0.5}));
}

TEST(Box, OverlapsWhenEveryAxisDoes)
{
    EXPECT_TRUE(unit.overlaps({{0.5, 0.5, 0.5}, {2, 2, 2}}));
    EXPECT_TRUE(unit.overlaps({{1, 0, 0}, {2, 1, 1}}));  // touching counts
    EXPECT_FALSE(unit.overlaps({{0.5, 0.5, 1.5}, {2, 2, 2}}));
    EXPECT_FALSE(unit.overlaps(Box{}));
}

TEST(Box, GrowsOnEverySide)
{
    Box box = unit;
    box.grow(0.5);
    EXPECT_EQ(box.lower, Vector3d(-0.5, -0.5, -0.5));
    EXPECT_EQ(box.upper, Vector3d(1.5, 1.5, 1.5));
}

}  // namespace
}  // namespace corpuscle
