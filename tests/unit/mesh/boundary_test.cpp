#include "mesh/boundary.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "mesh/generators.hpp"
#include "mesh/transform.hpp"
#include "mesh/triangles.hpp"

namespace corpuscle {
namespace {

using testing::HasSubstr;

Mesh unit_box()
{
    return box_mesh({{0, 0, 0}, {1, 1, 1}}, 0.25);
}

template <class Call>
std::string refusal(Call&& call)
{
    try {
        call();
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(BoundaryLoops, FollowTheRimOfASheetInOrder)
{
    const Mesh mesh = rectangle_mesh({}, {1, 0, 0}, {0, 1, 0}, 0.25);
    const auto loops = boundary_loops(mesh);
    ASSERT_EQ(loops.size(), 1u);
    ASSERT_EQ(loops[0].size(), 16u);
    for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(norm(mesh.nodes[loops[0][i]] - mesh.nodes[loops[0][(i + 1) % 16]]), 0.25, 1e-15);
}

TEST(BoundaryLoops, FindEveryHole)
{
    Mesh mesh = unit_box();
    EXPECT_TRUE(boundary_loops(mesh).empty());
    mesh.elements.erase(mesh.elements.begin() + 40);
    mesh.elements.erase(mesh.elements.begin() + 5);
    const auto loops = boundary_loops(mesh);
    ASSERT_EQ(loops.size(), 2u);
    EXPECT_EQ(loops[0].size(), 4u);
    EXPECT_EQ(loops[1].size(), 4u);
}

TEST(BoundaryLoops, EndOnSheetsOfMixedOrientation)
{
    Mesh mesh = rectangle_mesh({}, {1, 0, 0}, {0, 1, 0}, 0.25);
    for (std::size_t e = 0; e < mesh.elements.size(); e += 2) std::swap(mesh.elements[e].node[1], mesh.elements[e].node[3]);
    EXPECT_FALSE(boundary_loops(mesh).empty());
}

TEST(RequireClosed, NamesMeshHoleAndPlace)
{
    Mesh mesh = unit_box();
    mesh.elements.erase(mesh.elements.begin());
    const std::string text = refusal([&] { require_closed(mesh, "hull"); });
    EXPECT_THAT(text, testing::AllOf(HasSubstr("mesh 'hull' has 1 hole"), HasSubstr("4 edges"), HasSubstr(") m")));
}

TEST(RequireClosed, RefusesInnerWallsAndSolids)
{
    Mesh mesh = box_mesh({{0, 0, 0}, {1, 1, 1}}, 0.5);
    append(mesh, rectangle_mesh({0.5, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.5));
    merge_nodes(mesh, 1e-9);
    EXPECT_THAT(refusal([&] { require_closed(mesh, "hull"); }), HasSubstr("3 elements share the edge"));
    Mesh solid;
    solid.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    solid.elements = {{ElementShape::tetrahedron, {0, 1, 2, 3}}};
    EXPECT_THAT(refusal([&] { require_closed(solid, "hull"); }), HasSubstr("solid element"));
    EXPECT_THAT(refusal([&] { require_closed({}, "hull"); }), HasSubstr("no elements"));
}

TEST(OrientClosed, TurnsWhatWasTurned)
{
    Mesh mesh = unit_box();
    EXPECT_EQ(orient_closed(mesh, "box"), 0u);
    for (const int e : {0, 7, 8, 50}) std::swap(mesh.elements[e].node[1], mesh.elements[e].node[3]);
    EXPECT_EQ(orient_closed(mesh, "box"), 4u);
    EXPECT_NEAR(signed_volume(mesh.nodes, triangles_of(mesh)), 1.0, 1e-14);
}

TEST(OrientClosed, TurnsABodyInsideOut)
{
    Mesh mesh = unit_box();
    for (MeshElement& element : mesh.elements) std::swap(element.node[1], element.node[3]);
    EXPECT_EQ(orient_closed(mesh, "box"), mesh.elements.size());
    EXPECT_NEAR(signed_volume(mesh.nodes, triangles_of(mesh)), 1.0, 1e-14);
}

TEST(OrientClosed, CountsBodiesApartAndOneWithinAnother)
{
    Mesh mesh = unit_box();
    Mesh other = unit_box();
    translate(other, {3, 0, 0});
    append(mesh, other);
    EXPECT_EQ(orient_closed(mesh, "boxes"), 0u);
    EXPECT_NEAR(signed_volume(mesh.nodes, triangles_of(mesh)), 2.0, 1e-13);
    append(mesh, box_mesh({{0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}}, 0.25));
    EXPECT_EQ(orient_closed(mesh, "boxes"), 24u);
    EXPECT_NEAR(signed_volume(mesh.nodes, triangles_of(mesh)), 2.0 - 0.125, 1e-13);
}

TEST(OrientClosed, RefusesOneSidedSurfaces)
{
    // The real projective plane in six triangles' worth of nodes: closed, every edge shared by two, but one-sided.
    Mesh mesh;
    mesh.nodes = {{0, 0, 0}, {1, 0, 0.1}, {0, 1, 0.2}, {1, 1, 0.3}, {0.5, 0.2, 1}, {0.1, 0.7, 0.9}};
    const std::vector<Triangle> triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                                          {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
    for (const Triangle& t : triangles) mesh.elements.push_back({ElementShape::triangle, {t[0], t[1], t[2]}});
    EXPECT_THAT(refusal([&] { orient_closed(mesh, "crosscap"); }), HasSubstr("one side only"));
}

}  // namespace
}  // namespace corpuscle
