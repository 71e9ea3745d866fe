#include <gtest/gtest.h>

#include <map>

#include "base/error.hpp"
#include "mesh/extrude.hpp"
#include "mesh/generators.hpp"
#include "mesh/quality.hpp"
#include "mesh/solid_faces.hpp"
#include "mesh/triangles.hpp"

namespace corpuscle {
namespace {

/// Volume enclosed by the outer faces, positive if they face outward.
double enclosed(const Mesh& mesh)
{
    std::vector<Triangle> triangles;
    for (const SolidFace& face : solid_faces(mesh.elements)) {
        if (!face.is_outer()) continue;
        triangles.push_back({face.node[0], face.node[1], face.node[2]});
        if (face.corners == 4) triangles.push_back({face.node[0], face.node[2], face.node[3]});
    }
    return signed_volume(mesh.nodes, triangles);
}

TEST(Extrude, MakesSoundSolidsWhicheverWayTheSurfaceFaces)
{
    for (const double way : {0.02, -0.02}) {
        const Mesh disk = disk_mesh(0.1, 0.02, false), solid = extruded(disk, {0, 0, way}, 3);
        EXPECT_EQ(solid.elements.size(), 3 * disk.elements.size());
        EXPECT_EQ(solid.nodes.size(), 4 * disk.nodes.size());
        EXPECT_TRUE(validate(solid, "solid").empty());
        EXPECT_GT(check(solid).min_scaled_jacobian, 0.7);
        EXPECT_EQ(solid.node_sets.at("rim").size(), 4 * disk.node_sets.at("rim").size());
        EXPECT_EQ(solid.node_sets.at("end").size(), disk.nodes.size());
        EXPECT_DOUBLE_EQ(solid.nodes[solid.node_sets.at("end").front()].z, way);
    }
    const Mesh box = extruded(rectangle_mesh({1, 2, 3}, {0.3, 0, 0}, {0, 0.2, 0}, 0.1), {0, 0, 0.5}, 4);
    EXPECT_NEAR(enclosed(box), 0.3 * 0.2 * 0.5, 1e-15);
}

TEST(Extrude, RefusesWhatSweepsNothing)
{
    const Mesh square = rectangle_mesh({}, {1, 0, 0}, {0, 1, 0}, 0.5);
    EXPECT_THROW(static_cast<void>(extruded(square, {0, 0, 1}, 0)), InputError);
    EXPECT_THROW(static_cast<void>(extruded(square, {}, 1)), InputError);
    Mesh triangle = square;
    triangle.elements[0].shape = ElementShape::triangle;
    EXPECT_THROW(static_cast<void>(extruded(triangle, {0, 0, 1}, 1)), InputError);
}

TEST(SolidFaces, InnerFacesHaveTwoElementsAndOuterOnesEnclose)
{
    const Mesh box = extruded(rectangle_mesh({}, {0.3, 0, 0}, {0, 0.2, 0}, 0.1), {0, 0, 0.2}, 2);  // 3 by 2 by 2
    const std::vector<SolidFace> faces = solid_faces(box.elements);
    std::size_t outer = 0;
    for (const SolidFace& face : faces) {
        outer += face.is_outer();
        EXPECT_TRUE(face.is_outer() || face.element < face.other);
    }
    EXPECT_EQ(outer, 2u * (3 * 2 + 2 * 2 + 3 * 2));
    EXPECT_EQ(faces.size() - outer, (6u * 12 - outer) / 2);
    Mesh tetrahedron;
    tetrahedron.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    tetrahedron.elements = {{ElementShape::tetrahedron, {0, 1, 2, 3}}};
    EXPECT_NEAR(enclosed(tetrahedron), 1.0 / 6, 1e-15);
}

}  // namespace
}  // namespace corpuscle
