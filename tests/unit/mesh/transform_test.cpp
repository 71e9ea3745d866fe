#include "mesh/transform.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "base/error.hpp"
#include "mesh/boundary.hpp"
#include "mesh/generators.hpp"
#include "mesh/measure.hpp"
#include "mesh/quality.hpp"

namespace corpuscle {
namespace {

TEST(Transform, MovesTurnsAndScales)
{
    Mesh mesh = rectangle_mesh({1, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1.0);
    rotate(mesh, {0, 0, 5}, std::numbers::pi / 2, {1, 0, 0});
    EXPECT_NEAR(norm(mesh.nodes[2] - Vector3d{1, 1, 0}), 0.0, 1e-15);
    EXPECT_NEAR(norm(mesh.nodes[1] - Vector3d{0, 0, 0}), 0.0, 1e-15);
    scale(mesh, 2.0);
    translate(mesh, {0, 0, 3});
    EXPECT_NEAR(norm(mesh.nodes[2] - Vector3d{2, 2, 3}), 0.0, 1e-15);
    EXPECT_NEAR(total_area(mesh), 4.0, 1e-14);
    EXPECT_THROW(rotate(mesh, {}, 1.0), InputError);
    EXPECT_THROW(scale(mesh, 0.0), InputError);
}

TEST(Append, UnitesSetsOfTheSameName)
{
    Mesh mesh = disk_mesh(0.5, 0.1, true);
    const std::size_t nodes = mesh.nodes.size(), rim = mesh.node_sets.at("rim").size();
    append(mesh, disk_mesh(0.5, 0.1, true));
    EXPECT_EQ(mesh.nodes.size(), 2 * nodes);
    EXPECT_EQ(mesh.node_sets.at("rim").size(), 2 * rim);
    EXPECT_EQ(mesh.node_sets.at("rim").back(), mesh.node_sets.at("rim")[rim - 1] + nodes);
}

TEST(MergeNodes, JoinsTwoSheetsAlongTheirSeam)
{
    Mesh mesh = rectangle_mesh({}, {1, 0, 0}, {0, 1, 0}, 0.25);
    append(mesh, rectangle_mesh({1 + 1e-7, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.25));
    EXPECT_EQ(merge_nodes(mesh, 1e-9), 0u);
    EXPECT_EQ(boundary_loops(mesh).size(), 2u);
    EXPECT_EQ(merge_nodes(mesh, 1e-6), 5u);
    EXPECT_EQ(boundary_loops(mesh).size(), 1u);
    EXPECT_EQ(mesh.nodes.size(), 45u);
    EXPECT_EQ(mesh.node_sets.at("end_1").size(), 10u);
    EXPECT_EQ(mesh.node_sets.at("start_1").size(), 10u);
    EXPECT_TRUE(validate(mesh, "sheets").empty());
}

TEST(MergeNodes, ToleranceIsADistanceInEveryDirection)
{
    const double side = 1e-3;
    for (int i = 0; i < 200; ++i) {
        const double angle = 0.1 * i;
        const Vector3d direction{std::cos(angle) * std::sin(3 * angle), std::sin(angle) * std::sin(3 * angle), std::cos(3 * angle)};
        const Vector3d start{0.37 * i * side, -1.1 * i * side, 0.5 * side};
        Mesh near, far;
        near.nodes = {start, start + 0.999 * side * direction};
        far.nodes = {start, start + 1.001 * side * direction};
        EXPECT_EQ(merge_nodes(near, side), 1u);
        EXPECT_EQ(merge_nodes(far, side), 0u);
    }
}

TEST(MergeNodes, OfNoToleranceJoinsEqualNodes)
{
    Mesh mesh = box_mesh({{0, 0, 0}, {1, 1, 1}}, 0.5);
    Mesh twice = mesh;
    append(twice, mesh);
    EXPECT_EQ(merge_nodes(twice, 0.0), mesh.nodes.size());
    Mesh empty;
    EXPECT_EQ(merge_nodes(empty, 1.0), 0u);
}

TEST(MergeNodes, WorksFarFromTheOrigin)
{
    Mesh mesh = box_mesh({{1e7, 1e7, 1e7}, {1e7 + 1, 1e7 + 1, 1e7 + 1}}, 0.5);
    const std::size_t nodes = mesh.nodes.size();
    append(mesh, Mesh(mesh));
    EXPECT_EQ(merge_nodes(mesh, 0.0), nodes);
}

TEST(RemoveUnusedNodes, KeepsElementsAndSetsInStep)
{
    Mesh mesh = rectangle_mesh({}, {1, 0, 0}, {0, 1, 0}, 0.5);
    mesh.nodes.insert(mesh.nodes.begin(), Vector3d{9, 9, 9});
    for (MeshElement& element : mesh.elements)
        for (std::uint32_t& node : element.node) ++node;
    mesh.node_sets = {{"lost", {0}}, {"mixed", {0, 1, 9}}};
    EXPECT_EQ(remove_unused_nodes(mesh), 1u);
    EXPECT_EQ(mesh.nodes.size(), 9u);
    EXPECT_NEAR(total_area(mesh), 1.0, 1e-15);
    EXPECT_EQ(mesh.node_sets.count("lost"), 0u);
    EXPECT_THAT(mesh.node_sets.at("mixed"), testing::ElementsAre(0, 8));
}

}  // namespace
}  // namespace corpuscle
