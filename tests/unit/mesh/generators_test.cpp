#include "mesh/generators.hpp"

#include <gmock/gmock.h>

#include <numbers>
#include <set>
#include <tuple>

#include "base/error.hpp"
#include "mesh/boundary.hpp"
#include "mesh/measure.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"

namespace corpuscle {
namespace {

constexpr double pi = std::numbers::pi;

std::set<std::tuple<double, double, double>> positions(const Mesh& mesh, const std::string& set)
{
    std::set<std::tuple<double, double, double>> points;
    for (const std::uint32_t node : mesh.node_sets.at(set)) points.emplace(mesh.nodes[node].x, mesh.nodes[node].y, mesh.nodes[node].z);
    return points;
}

/// Area of the regular polygon with `corners` corners on the circle, or a quarter of it.
double polygon_area(double radius, int corners)
{
    return 0.5 * corners * radius * radius * std::sin(2.0 * pi / corners);
}

class DiskOfSize : public testing::TestWithParam<double> {};

TEST_P(DiskOfSize, HasGoodElementsOfTheSizeAskedFor)
{
    for (const bool quarter : {true, false}) {
        const double size = GetParam(), radius = 0.5;
        const Mesh mesh = disk_mesh(radius, size, quarter);
        const MeshQuality quality = check(mesh);
        EXPECT_GT(quality.min_scaled_jacobian, 0.75);
        EXPECT_GT(quality.min_edge, 0.5 * size);
        EXPECT_LT(quality.max_edge, 1.5 * size);
        EXPECT_LT(quality.worst_aspect, 2.0);
        EXPECT_LT(quality.worst_warp, 1e-12);
        EXPECT_THAT(validate(mesh, "disk"), testing::IsEmpty());
    }
}

INSTANTIATE_TEST_SUITE_P(FromCoarseToFine, DiskOfSize, testing::Values(0.4, 0.25, 0.2, 0.13, 0.1, 0.07, 0.05, 0.031, 0.02, 0.01, 0.005));

TEST(DiskMesh, AreaIsThatOfItsRimPolygon)
{
    for (const double size : {0.2, 0.05, 0.01}) {
        const int corners = rim_divisions(0.5, size, false);
        EXPECT_NEAR(total_area(disk_mesh(0.5, size, false)), polygon_area(0.5, corners), 1e-13);
        EXPECT_NEAR(total_area(disk_mesh(0.5, size, true)), polygon_area(0.5, corners) / 4.0, 1e-13);
    }
}

TEST(DiskMesh, AreaConvergesToTheCircleWithSecondOrder)
{
    const auto error = [](double size) { return pi * 0.25 - total_area(disk_mesh(0.5, size, false)); };
    EXPECT_NEAR(std::log2(error(0.02) / error(0.01)), 2.0, 0.1);
}

TEST(DiskMesh, RimNodesLieOnTheCircleAndSymmetryNodesOnTheirPlanes)
{
    const Mesh mesh = disk_mesh(0.5, 0.02, true);
    for (const std::uint32_t node : mesh.node_sets.at("rim")) EXPECT_NEAR(norm(mesh.nodes[node]), 0.5, 1e-15);
    EXPECT_EQ(mesh.node_sets.at("rim").size(), rim_divisions(0.5, 0.02, true) + 1u);
    int on_x = 0, on_y = 0;
    for (const Vector3d& node : mesh.nodes) {
        EXPECT_GE(node.x, 0.0);
        EXPECT_GE(node.y, 0.0);
        EXPECT_EQ(node.z, 0.0);
        on_x += node.x == 0.0;
        on_y += node.y == 0.0;
    }
    EXPECT_EQ(on_x, on_y);
    EXPECT_EQ(static_cast<std::size_t>(on_x), select_nodes(mesh, "x=0").size());
    EXPECT_EQ(nearest_node(mesh, {}), 0u);
    EXPECT_EQ(mesh.nodes[0], Vector3d{});
}

TEST(DiskMesh, WholeDiskIsFourQuartersJoinedWithoutSeams)
{
    const Mesh quarter = disk_mesh(0.5, 0.04, true), whole = disk_mesh(0.5, 0.04, false);
    EXPECT_EQ(whole.elements.size(), 4 * quarter.elements.size());
    const auto loops = boundary_loops(whole);
    ASSERT_EQ(loops.size(), 1u);
    EXPECT_EQ(loops[0].size(), static_cast<std::size_t>(rim_divisions(0.5, 0.04, false)));
    EXPECT_EQ(whole.node_sets.at("rim").size(), loops[0].size());
    for (const MeshElement& element : whole.elements) EXPECT_GT(area_vector(whole, element).z, 0.0);
}

TEST(RingMesh, InnerNodesAreTheDisksRimNodesBitForBit)
{
    for (const bool quarter : {true, false})
        for (const double size : {0.02, 0.033, 0.11}) {
            const Mesh disk = disk_mesh(0.5, size, quarter);
            const Mesh ring = ring_mesh(0.5, 1.7, 0.05, quarter, rim_divisions(0.5, size, quarter));
            EXPECT_EQ(positions(disk, "rim"), positions(ring, "inner"));
            EXPECT_EQ(validate(ring, "ring"), std::vector<std::string>{});
        }
}

TEST(RingMesh, AreaIsThatBetweenItsPolygons)
{
    const int corners = 4 * 24;
    EXPECT_NEAR(total_area(ring_mesh(0.5, 1.7, 0.05, false, corners)), polygon_area(1.7, corners) - polygon_area(0.5, corners), 1e-12);
    EXPECT_NEAR(total_area(ring_mesh(0.5, 1.7, 0.05, true, 24)), (polygon_area(1.7, corners) - polygon_area(0.5, corners)) / 4, 1e-12);
}

TEST(RingMesh, WholeRingIsClosedAroundAndFacesUp)
{
    const Mesh ring = ring_mesh(0.5, 0.8, 0.05, false);
    EXPECT_EQ(boundary_loops(ring).size(), 2u);
    for (const MeshElement& element : ring.elements) EXPECT_GT(area_vector(ring, element).z, 0.0);
    for (const std::uint32_t node : ring.node_sets.at("outer")) EXPECT_NEAR(norm(ring.nodes[node]), 0.8, 1e-15);
}

TEST(RectangleMesh, DividesItsEdges)
{
    const Mesh mesh = rectangle_mesh({1, 2, 3}, {0, 0.4, 0}, {0, 0, 0.3}, 0.1);
    EXPECT_EQ(mesh.elements.size(), 12u);
    EXPECT_EQ(mesh.nodes.size(), 20u);
    EXPECT_NEAR(total_area(mesh), 0.12, 1e-15);
    for (const MeshElement& element : mesh.elements) EXPECT_GT(area_vector(mesh, element).x, 0.0);
    EXPECT_EQ(mesh.node_sets.at("rim").size(), 14u);
    EXPECT_EQ(mesh.node_sets.at("start_1").size(), 4u);
    EXPECT_EQ(mesh.node_sets.at("end_2").size(), 5u);
    for (const std::uint32_t node : mesh.node_sets.at("end_1")) EXPECT_NEAR(mesh.nodes[node].y, 2.4, 1e-15);
}

TEST(BoxMesh, IsClosedWithOutwardNormals)
{
    const Mesh mesh = box_mesh({{-1, 0, 2}, {1, 0.5, 3}}, 0.25);
    EXPECT_NO_THROW(require_closed(mesh, "box"));
    EXPECT_EQ(mesh.elements.size(), 2u * (8 * 2 + 8 * 4 + 2 * 4));
    EXPECT_NEAR(total_area(mesh), 2 * (2 * 0.5 + 2 * 1 + 0.5), 1e-14);
    const Vector3d middle{0, 0.25, 2.5};
    for (const MeshElement& element : mesh.elements) EXPECT_GT(dot(area_vector(mesh, element), center(mesh, element) - middle), 0.0);
    ASSERT_EQ(mesh.element_sets.at("z_max").size(), 16u);
    for (const std::uint32_t element : mesh.element_sets.at("z_max")) EXPECT_EQ(center(mesh, mesh.elements[element]).z, 3.0);
}

TEST(Generators, RefuseNonsense)
{
    EXPECT_THROW((void)disk_mesh(0.0, 0.1, true), InputError);
    EXPECT_THROW((void)disk_mesh(0.5, -0.1, true), InputError);
    EXPECT_THROW((void)disk_mesh(0.5, std::nan(""), true), InputError);
    EXPECT_THROW((void)disk_mesh(0.5, 1e-9, true), InputError);
    EXPECT_THROW((void)ring_mesh(0.5, 0.5, 0.1, true), InputError);
    EXPECT_THROW((void)ring_mesh(0.5, 0.8, 0.1, false, 7), InputError);
    EXPECT_THROW((void)rectangle_mesh({}, {1, 0, 0}, {2, 0, 0}, 0.1), InputError);
    EXPECT_THROW((void)box_mesh({{0, 0, 0}, {1, 1, 0}}, 0.1), InputError);
}

}  // namespace
}  // namespace corpuscle
