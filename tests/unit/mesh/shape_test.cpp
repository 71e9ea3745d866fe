#include "mesh/shape.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "base/error.hpp"
#include "math/random.hpp"
#include "mesh/boundary.hpp"
#include "mesh/generators.hpp"
#include "mesh/quality.hpp"
#include "mesh/transform.hpp"
#include "mesh/triangles.hpp"

namespace corpuscle {
namespace {

constexpr double pi = std::numbers::pi;

/// A cube's surface blown up to a sphere: closed, of quadrilaterals that are not flat.
Mesh ball_surface(const Vector3d& center, double radius, double element_size)
{
    Mesh mesh = box_mesh({{-1, -1, -1}, {1, 1, 1}}, element_size);
    for (Vector3d& node : mesh.nodes) node = center + radius * normalized(node);
    return mesh;
}

struct Sample {
    double volume;
    double deviation;  ///< of the mean: one sigma
};

/// Volume by drawing points in a box, stratified in x.
Sample monte_carlo(const Shape& shape, const Box& box, int count)
{
    Random random(7, Purpose::fill, 0, 0);
    int hits = 0;
    for (int i = 0; i < count; ++i) {
        const Vector3d unit{(i + random.uniform_double()) / count, random.uniform_double(), random.uniform_double()};
        hits += shape.contains(box.lower + scaled(unit, box.size()));
    }
    const double share = static_cast<double>(hits) / count;
    return {share * box.volume(), std::sqrt(std::max(share * (1 - share), 1.0 / count) / count) * box.volume()};
}

struct NamedShape {
    const char* name;
    Shape shape;
};

std::vector<NamedShape> all_shapes()
{
    return {{"box", Shape::box({{-0.3, -0.2, 0.1}, {0.4, 0.5, 0.6}})},
            {"sphere", Shape::sphere({0.1, -0.2, 0.3}, 0.4)},
            {"hemisphere", Shape::hemisphere({0.1, 0.2, 0.3}, 0.4, {0, 0, -2})},
            {"tilted hemisphere", Shape::hemisphere({0.1, 0.2, 0.3}, 0.4, {1, -2, 0.5})},
            {"cylinder", Shape::cylinder({0.1, 0.2, 0.3}, 0.3, 0.7, {0, 3, 0})},
            {"tilted cylinder", Shape::cylinder({0.1, 0.2, 0.3}, 0.3, 0.7, {1, 2, -1})},
            {"ellipsoid", Shape::ellipsoid({0.1, 0.2, 0.3}, {0.5, 0.3, 0.2})},
            {"surface", Shape::surface(ball_surface({0.1, 0.2, 0.3}, 0.4, 0.4), "ball")}};
}

TEST(Shape, VolumesAreExact)
{
    EXPECT_DOUBLE_EQ(Shape::box({{0, 0, 0}, {1, 2, 3}}).volume(), 6.0);
    EXPECT_DOUBLE_EQ(Shape::sphere({1, 2, 3}, 2.0).volume(), 32.0 / 3.0 * pi);
    EXPECT_DOUBLE_EQ(Shape::hemisphere({1, 2, 3}, 2.0, {1, 1, 1}).volume(), 16.0 / 3.0 * pi);
    EXPECT_DOUBLE_EQ(Shape::cylinder({1, 2, 3}, 2.0, 5.0, {1, 1, 1}).volume(), 20.0 * pi);
    EXPECT_DOUBLE_EQ(Shape::ellipsoid({1, 2, 3}, {1, 2, 3}).volume(), 8.0 * pi);
    EXPECT_NEAR(Shape::surface(box_mesh({{9, 9, 9}, {10, 11, 12}}, 0.3), "box").volume(), 6.0, 1e-13);
}

TEST(Shape, ContainsAndVolumeAgree)
{
    for (const auto& [name, shape] : all_shapes()) {
        const Sample sample = monte_carlo(shape, shape.bounds(), 100'000);
        EXPECT_NEAR(sample.volume, shape.volume(), 4 * sample.deviation) << name;
    }
}

TEST(Shape, BoundsTouchTheShapeOnEverySide)
{
    for (const auto& [name, shape] : all_shapes()) {
        const Box bounds = shape.bounds();
        for (int axis = 0; axis < 3; ++axis)
            for (const bool upper : {false, true}) {
                Box slab = bounds;
                const double thickness = 0.01 * bounds.size()[axis];
                if (upper)
                    slab.lower[axis] = bounds.upper[axis] - thickness;
                else
                    slab.upper[axis] = bounds.lower[axis] + thickness;
                EXPECT_GT(shape.volume_within(slab), 0.0) << name << " axis " << axis << " upper " << upper;
            }
    }
}

TEST(Shape, VolumeWithinABoxAgreesWithPointsDrawnInIt)
{
    const std::vector<Box> boxes{{{0, 0, 0}, {1, 1, 1}}, {{-0.1, -0.1, 0.2}, {0.3, 0.15, 0.5}}, {{0.05, 0.1, -1}, {0.2, 1, 0.33}}};
    for (const auto& [name, shape] : all_shapes())
        for (const Box& box : boxes) {
            const Sample sample = monte_carlo(shape, box, 100'000);
            EXPECT_NEAR(sample.volume, shape.volume_within(box), 4 * sample.deviation) << name;
        }
}

TEST(Shape, PartsOfASplitSpaceAddUpToTheWhole)
{
    const Vector3d split{0.17, 0.13, 0.29};
    for (const auto& [name, shape] : all_shapes()) {
        double sum = 0.0;
        for (int octant = 0; octant < 8; ++octant) {
            Box box{{-2, -2, -2}, {2, 2, 2}};
            for (int axis = 0; axis < 3; ++axis) (octant >> axis & 1 ? box.lower : box.upper)[axis] = split[axis];
            sum += shape.volume_within(box);
        }
        EXPECT_NEAR(sum / shape.volume(), 1.0, 1e-9) << name;
    }
}

TEST(Shape, CutsThroughTheCenterAreExact)
{
    const Box quarter{{0, 0, -1}, {1, 1, 1}}, octant{{0, 0, 0}, {1, 1, 1}};
    EXPECT_NEAR(Shape::sphere({}, 0.3).volume_within(octant) / (pi * 0.3 * 0.3 * 0.3 / 6), 1.0, 1e-14);
    EXPECT_NEAR(Shape::sphere({0, 0, 0.4}, 0.3).volume_within(quarter) / (pi * 0.3 * 0.3 * 0.3 / 3), 1.0, 1e-14);
    EXPECT_NEAR(Shape::cylinder({}, 0.3, 0.8, {0, 0, 1}).volume_within(quarter) / (pi * 0.09 * 0.2), 1.0, 1e-14);
    EXPECT_NEAR(Shape::hemisphere({}, 0.3, {0, 0, 1}).volume_within(quarter) / (pi * 0.3 * 0.3 * 0.3 / 6), 1.0, 1e-14);
    EXPECT_NEAR(Shape::ellipsoid({}, {0.3, 0.4, 0.5}).volume_within(octant) / (pi * 0.06 / 6), 1.0, 1e-14);
    EXPECT_NEAR(Shape::hemisphere({}, 0.3, {1, 1, 0}).volume_within({{0, 0, 0}, {1, 1, 1}}) / (pi * 0.027 / 6), 1.0, 1e-9);
}

TEST(Shape, CapOfASphereHasItsTextbookVolume)
{
    const double radius = 0.5, height = 0.2;
    const double cap = pi * height * height * (3 * radius - height) / 3;
    for (int axis = 0; axis < 3; ++axis) {
        Box box{{-1, -1, -1}, {1, 1, 1}};
        box.lower[axis] = radius - height;
        EXPECT_NEAR(Shape::sphere({}, radius).volume_within(box) / cap, 1.0, 1e-10);
    }
}

TEST(Shape, BoxInsideAShapeCountsWhole)
{
    const Box small{{0.05, 0.05, 0.31}, {0.12, 0.1, 0.36}};
    int counted = 0;
    for (const auto& [name, shape] : all_shapes()) {
        bool inside = true;  // all shapes here are convex
        for (int i = 0; i < 8; ++i)
            inside = inside && shape.contains({i & 1 ? small.upper.x : small.lower.x, i & 2 ? small.upper.y : small.lower.y,
                                               i & 4 ? small.upper.z : small.lower.z});
        if (!inside) continue;
        ++counted;
        EXPECT_NEAR(shape.volume_within(small) / small.volume(), 1.0, 1e-9) << name;
        EXPECT_TRUE(shape.overlaps(small)) << name;
    }
    EXPECT_GE(counted, 5);
}

TEST(Shape, NothingIsSharedWithABoxFarAway)
{
    const Box far{{5, 5, 5}, {6, 6, 6}};
    const Box corner{{0.45, 0.15, 0.65}, {0.6, 0.3, 0.8}};  // within the sphere's bounds, outside the sphere
    for (const auto& [name, shape] : all_shapes()) {
        EXPECT_EQ(shape.volume_within(far), 0.0) << name;
        EXPECT_FALSE(shape.overlaps(far)) << name;
    }
    EXPECT_FALSE(Shape::sphere({0.1, -0.2, 0.3}, 0.4).overlaps(corner));
}

TEST(Shape, HemisphereFacesItsAxis)
{
    const Shape up = Shape::hemisphere({0, 0, 1}, 0.5, {0, 0, 1});
    EXPECT_TRUE(up.contains({0, 0, 1.4}));
    EXPECT_FALSE(up.contains({0, 0, 0.6}));
    EXPECT_EQ(up.bounds().lower.z, 1.0);
    EXPECT_EQ(up.bounds().upper.z, 1.5);
    EXPECT_EQ(up.bounds().lower.x, -0.5);
}

TEST(SurfaceShape, LinesThroughNodesAndEdgesDoNotLeak)
{
    const Shape ball = Shape::surface(ball_surface({}, 1.0, 0.25), "ball");
    const Mesh mesh = ball_surface({}, 1.0, 0.25);
    for (const Vector3d& node : mesh.nodes) {
        // The line along x through these points meets the surface in nodes and, for faces of the grid, in edges.
        EXPECT_TRUE(ball.contains({0.9 * node.x, 0.9 * node.y, 0.9 * node.z}));
        EXPECT_FALSE(ball.contains({1.1 * node.x, 1.1 * node.y, 1.1 * node.z}));
        if (node.x < 0.5) continue;
        EXPECT_TRUE(ball.contains({node.x - 1e-3, node.y, node.z}));
        EXPECT_FALSE(ball.contains({node.x + 1e-9, node.y, node.z}));
    }
}

TEST(SurfaceShape, RayAndWindingNumberAgreeEverywhere)
{
    Mesh mesh = ball_surface({0.1, 0.2, 0.3}, 0.4, 0.3);
    for (Vector3d& node : mesh.nodes) node.x += 0.6 * node.z * node.z;  // bent
    const Shape shape = Shape::surface(mesh, "bent ball");
    const auto triangles = triangles_of(mesh);
    Random random(3, Purpose::fill, 1, 2);
    const Box box = shape.bounds();
    for (int i = 0; i < 3000; ++i) {
        const Vector3d point = box.lower + scaled({random.uniform_double(), random.uniform_double(), random.uniform_double()}, box.size());
        EXPECT_EQ(shape.contains(point), winding_number(mesh.nodes, triangles, point) > 0.5);
    }
}

TEST(SurfaceShape, TakesHollowBodiesAndTurnedElements)
{
    Mesh mesh = box_mesh({{0, 0, 0}, {1, 1, 1}}, 0.5);
    append(mesh, box_mesh({{0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}}, 0.25));
    std::swap(mesh.elements[3].node[1], mesh.elements[3].node[3]);
    const Shape shape = Shape::surface(mesh, "hollow box");
    EXPECT_NEAR(shape.volume(), 1 - 0.125, 1e-14);
    EXPECT_TRUE(shape.contains({0.1, 0.5, 0.5}));
    EXPECT_FALSE(shape.contains({0.5, 0.5, 0.5}));
    EXPECT_NEAR(shape.volume_within({{0.5, 0.5, 0.5}, {2, 2, 2}}), (1 - 0.125) / 8, 1e-14);
}

TEST(Shape, RefusesNonsense)
{
    EXPECT_THROW((void)Shape::sphere({}, 0.0), InputError);
    EXPECT_THROW((void)Shape::sphere({std::nan(""), 0, 0}, 1.0), InputError);
    EXPECT_THROW((void)Shape::box({{0, 0, 0}, {1, -1, 1}}), InputError);
    EXPECT_THROW((void)Shape::cylinder({}, 1, 1, {0, 0, 0}), InputError);
    EXPECT_THROW((void)Shape::hemisphere({}, 1, {0, 0, 0}), InputError);
    EXPECT_THROW((void)Shape::ellipsoid({}, {1, 0, 1}), InputError);
    EXPECT_THROW((void)Shape::surface(rectangle_mesh({}, {1, 0, 0}, {0, 1, 0}, 0.5), "sheet"), InputError);
}

}  // namespace
}  // namespace corpuscle
