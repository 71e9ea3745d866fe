#include "gas/curve.hpp"

#include <gtest/gtest.h>

#include "math/random.hpp"

namespace corpuscle {
namespace {

/// A cube, a box away from the origin, a flat one, a long one.
const std::vector<Box> boxes{
    {{0, 0, 0}, {1, 1, 1}}, {{-1.3, 0.2, 5}, {1.4, 1.2, 5.4}}, {{0, 0, -0.01}, {3, 2, 0.01}}, {{-50, 0, 0}, {50, 1, 1}}};

Vector3f random_point(const Box& box, Random& random)
{
    Vector3d p;
    for (int a = 0; a < 3; ++a) p[a] = box.lower[a] + box.size()[a] * random.uniform_double();
    return Vector3f(p);
}

/// A coordinate is known to half a unit of the last place of a float, at the box's offset and again in its distance from the corner.
double rounding(const Box& box)
{
    double largest = 0;
    for (int a = 0; a < 3; ++a) largest = std::max({largest, std::abs(box.lower[a]), std::abs(box.upper[a]), box.size()[a]});
    return 2 * largest * 0x1p-23;
}

TEST(CellCurve, box_of_a_key_holds_its_point)
{
    Random random(1, Purpose::fill, 0, 0);
    for (const Box& box : boxes) {
        const CellCurve curve(box);
        for (int i = 0; i < 500; ++i) {
            const Vector3f point = random_point(box, random);
            for (int depth = 0; depth <= 45; ++depth) {
                Box cell = curve.cell(curve.key(point), depth);
                cell.grow(rounding(box));
                ASSERT_TRUE(cell.contains(Vector3d(point))) << "depth " << depth;
            }
        }
    }
}

TEST(CellCurve, middle_of_a_box_has_its_key)
{
    Random random(2, Purpose::fill, 0, 0);
    for (const Box& box : boxes) {
        const CellCurve curve(box);
        for (int depth = 0; depth <= 24; ++depth) {
            const std::uint64_t first = CellCurve::first_key(curve.key(random_point(box, random)), depth);
            const Vector3f middle(curve.cell(first, depth).center());
            EXPECT_EQ(CellCurve::first_key(curve.key(middle), depth), first) << "depth " << depth;
        }
    }
}

TEST(CellCurve, halves_follow_each_other_and_fill_their_parent)
{
    Random random(3, Purpose::fill, 0, 0);
    for (const Box& box : boxes) {
        const CellCurve curve(box);
        for (int depth = 0; depth < 40; ++depth) {
            const std::uint64_t key = CellCurve::first_key(curve.key(random_point(box, random)), depth);
            const std::uint64_t second = key | std::uint64_t{1} << (CellCurve::depth_limit - 1 - depth);
            const Box parent = curve.cell(key, depth), left = curve.cell(key, depth + 1), right = curve.cell(second, depth + 1);
            EXPECT_EQ(left.lower, parent.lower);
            EXPECT_EQ(right.upper, parent.upper);
            EXPECT_NEAR(left.volume() + right.volume(), parent.volume(), 1e-9 * parent.volume());
            EXPECT_EQ(CellCurve::common_depth(key, second), depth);
            EXPECT_LT(key, second);
        }
    }
}

TEST(CellCurve, volumes_and_radii_are_those_of_the_boxes)
{
    for (const Box& box : boxes) {
        const CellCurve curve(box);
        for (int depth = 0; depth <= CellCurve::depth_limit; ++depth)
            EXPECT_NEAR(std::ldexp(curve.volume(depth), depth), box.volume(), 1e-12 * box.volume());
        for (int depth = 0; depth <= 24; ++depth)
            EXPECT_NEAR(curve.radius(depth), 0.5 * norm(curve.cell(0, depth).size()), 1e-9 * curve.radius(depth));
    }
}

/// Halving the longest side of a box within 1:2 leaves it within 1:2; a longer box comes there first.
TEST(CellCurve, sides_come_within_one_to_two)
{
    for (const Box& box : boxes) {
        const CellCurve curve(box);
        bool compact = false;
        for (int depth = 0; depth <= 40; ++depth) {
            const Vector3d side = curve.cell(0, depth).size();
            const double ratio = std::max({side.x, side.y, side.z}) / std::min({side.x, side.y, side.z});
            EXPECT_TRUE(!compact || ratio <= 2 + 1e-6) << "depth " << depth << ", ratio " << ratio;
            compact = compact || ratio <= 2;
        }
        EXPECT_TRUE(compact);
    }
}

TEST(CellCurve, common_depth_is_that_of_the_smallest_common_box)
{
    Random random(4, Purpose::fill, 0, 0);
    const CellCurve curve(boxes[1]);
    for (int i = 0; i < 500; ++i) {
        const std::uint64_t a = curve.key(random_point(boxes[1], random)), b = curve.key(random_point(boxes[1], random));
        const int depth = CellCurve::common_depth(a, b);
        EXPECT_EQ(CellCurve::first_key(a, depth), CellCurve::first_key(b, depth));
        EXPECT_NE(CellCurve::first_key(a, depth + 1), CellCurve::first_key(b, depth + 1));
    }
    EXPECT_EQ(CellCurve::common_depth(77, 77), CellCurve::depth_limit);
}

TEST(CellCurve, points_outside_count_as_on_the_face)
{
    for (const Box& box : boxes) {
        const CellCurve curve(box);
        const Vector3d size = box.size();
        EXPECT_EQ(curve.key(Vector3f(box.lower - 3.0 * size)), 0u);
        EXPECT_EQ(curve.key(Vector3f(box.upper + 3.0 * size)), (std::uint64_t{1} << CellCurve::depth_limit) - 1);
    }
}

TEST(CellCurve, in_a_cube_it_is_mortons)
{
    const CellCurve curve(boxes[0]);
    for (int octant = 0; octant < 8; ++octant) {
        const Vector3f point{octant & 4 ? 0.75f : 0.25f, octant & 2 ? 0.75f : 0.25f, octant & 1 ? 0.75f : 0.25f};
        EXPECT_EQ(curve.key(point) >> 60, static_cast<std::uint64_t>(octant));
    }
}

TEST(CellCurve, extent_of_a_box_holds_its_places_and_no_others)
{
    Random random(8, Purpose::fill, 0, 0);
    for (const Box& box : boxes) {
        const CellCurve curve(box);
        for (int i = 0; i < 300; ++i) {
            const Vector3f a = random_point(box, random), b = random_point(box, random);
            for (const int depth : {0, 1, 2, 3, 5, 8, 13, 40, 63}) {
                const CellCurve::Extent extent = curve.extent(CellCurve::first_key(curve.key(a), depth), depth);
                EXPECT_TRUE(extent.holds(curve.steps(a)));
                EXPECT_EQ(extent.holds(curve.steps(b)), CellCurve::common_depth(curve.key(a), curve.key(b)) >= depth);
            }
        }
    }
}

TEST(CurveBranch, numbers_boxes_as_the_key_does)
{
    Random random(9, Purpose::fill, 0, 0);
    CurveBranch branch;
    for (const Box& box : boxes) {
        const CellCurve curve(box);
        for (const int depth : {0, 4, 17, 50, 63}) {
            for (const int levels : {0, 1, 5, CurveBranch::level_limit}) {
                if (depth + levels > CellCurve::depth_limit) continue;
                branch.set(curve, depth, levels);
                for (int i = 0; i < 50; ++i) {
                    const Vector3f point = random_point(box, random);
                    const std::uint64_t in_box = curve.key(point) & (CellCurve::keys_of(depth) - 1);
                    EXPECT_EQ(branch.index(curve.steps(point)), in_box >> (CellCurve::depth_limit - depth - levels));
                }
            }
        }
    }
}

}  // namespace
}  // namespace corpuscle
