#include "mesh/quality.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "base/error.hpp"
#include "mesh/generators.hpp"

namespace corpuscle {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

Mesh single(ElementShape shape, std::vector<Vector3d> nodes)
{
    Mesh mesh;
    mesh.nodes = std::move(nodes);
    MeshElement element{shape, {}};
    for (std::uint32_t i = 0; i < mesh.nodes.size(); ++i) element.node[i] = i;
    mesh.elements.push_back(element);
    return mesh;
}

Mesh cube()
{
    return single(ElementShape::hexahedron, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}});
}

std::string refusal(const Mesh& mesh)
{
    try {
        validate(mesh, "thing");
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(ScaledJacobian, IsOneForRegularElements)
{
    const double h = std::sqrt(3.0) / 2;
    EXPECT_NEAR(check(single(ElementShape::triangle, {{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}})).min_scaled_jacobian, 1.0, 1e-15);
    EXPECT_NEAR(check(single(ElementShape::quadrilateral, {{0, 0, 0}, {0, 2, 0}, {0, 2, 2}, {0, 0, 2}})).min_scaled_jacobian, 1.0, 1e-15);
    EXPECT_NEAR(check(single(ElementShape::tetrahedron, {{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}})).min_scaled_jacobian, 1.0,
                1e-14);
    EXPECT_NEAR(check(cube()).min_scaled_jacobian, 1.0, 1e-15);
}

TEST(ScaledJacobian, IsTheSineOfTheWorstAngleOfAParallelogram)
{
    const double angle = 0.6;
    const Vector3d a{1, 0, 0}, b{2 * std::cos(angle), 2 * std::sin(angle), 0};
    const MeshQuality quality = check(single(ElementShape::quadrilateral, {{}, a, a + b, b}));
    EXPECT_NEAR(quality.min_scaled_jacobian, std::sin(angle), 1e-14);
    EXPECT_NEAR(quality.worst_aspect, 2.0, 1e-14);
    EXPECT_DOUBLE_EQ(quality.min_edge, 1.0);
    EXPECT_NEAR(quality.max_edge, 2.0, 1e-14);
}

TEST(Warp, IsTheAngleBetweenTheTrianglesOfAFoldedQuadrilateral)
{
    const double fold = 0.3;
    const MeshQuality quality =
        check(single(ElementShape::quadrilateral, {{0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-std::cos(fold), 0, std::sin(fold)}}));
    EXPECT_GE(quality.worst_warp, fold - 1e-12);  // about the diagonal through (0, -1) and (0, 1) exactly the fold
    EXPECT_LT(quality.worst_warp, 1.1 * fold);
}

TEST(Validate, AcceptsGoodMeshes)
{
    EXPECT_THAT(validate(cube(), "cube"), IsEmpty());
    EXPECT_THAT(validate(disk_mesh(0.5, 0.1, true), "disk"), IsEmpty());
}

TEST(Validate, WarnsOfUnusedNodesAndPoorElements)
{
    Mesh mesh = cube();
    mesh.nodes.push_back({5, 5, 5});
    EXPECT_THAT(validate(mesh, "cube"), testing::ElementsAre(HasSubstr("1 nodes are used by no element")));
    EXPECT_THAT(validate(single(ElementShape::triangle, {{0, 0, 0}, {1, 0, 0}, {0.5, 0.05, 0}}), "sliver"),
                testing::ElementsAre(
                    HasSubstr("1 element is badly shaped: scaled Jacobian below 0.2 (element 1), the first near (0.5, 0.0166667, 0)")));
    Mesh numbered = single(ElementShape::quadrilateral, {{0, 0, 0}, {1, 0, 0}, {1, 0.05, 0}, {0, 0.05, 0}});
    numbered.elements[0].number = 170;
    EXPECT_THAT(validate(numbered, "strip"), testing::ElementsAre(HasSubstr("slender: longest over shortest edge above 10 (element 170)")));
    EXPECT_THAT(validate(single(ElementShape::quadrilateral, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.8}, {0, 1, 0}}), "bent"),
                testing::ElementsAre(HasSubstr("warped by more than 20 degrees (element 1)")));
}

TEST(Validate, RefusesFlatElements)
{
    EXPECT_THAT(refusal(single(ElementShape::triangle, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}})), HasSubstr("without area"));
    EXPECT_THAT(refusal(single(ElementShape::tetrahedron, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}})), HasSubstr("without volume"));
    EXPECT_THAT(refusal(single(ElementShape::quadrilateral, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}})), HasSubstr("without area"));
    EXPECT_THAT(refusal(single(ElementShape::quadrilateral, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}})), HasSubstr("without area"));
}

TEST(Validate, RefusesTangledElements)
{
    EXPECT_THAT(refusal(single(ElementShape::quadrilateral, {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1.5, 0}})), HasSubstr("tangled"));
    EXPECT_THAT(refusal(single(ElementShape::quadrilateral, {{0, 0, 0}, {1, 0, 0}, {0.2, 0.2, 0}, {0, 1, 0}})), HasSubstr("concave"));
    Mesh inside_out = cube();
    std::swap(inside_out.elements[0].node[1], inside_out.elements[0].node[3]);
    std::swap(inside_out.elements[0].node[5], inside_out.elements[0].node[7]);
    EXPECT_THAT(refusal(inside_out), HasSubstr("tangled"));
}

TEST(Validate, RefusesABowTieWhoseDiagonalsSpanNoArea)
{
    EXPECT_THAT(refusal(single(ElementShape::quadrilateral, {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}})), HasSubstr("thing': element 1"));
}

TEST(Validate, RefusesDuplicateAndCollapsedElements)
{
    Mesh mesh = rectangle_mesh({}, {1, 0, 0}, {0, 1, 0}, 0.25);
    MeshElement twin = mesh.elements[6];
    std::rotate(twin.node.begin(), twin.node.begin() + 1, twin.node.begin() + 4);
    mesh.elements.push_back(twin);
    EXPECT_THAT(refusal(mesh), testing::AllOf(HasSubstr("element 17"), HasSubstr("same nodes as element 7")));
    mesh.elements.back().node[1] = mesh.elements.back().node[2];
    EXPECT_THAT(refusal(mesh), HasSubstr("uses a node twice"));
}

TEST(Validate, RefusesWhatPointsNowhere)
{
    EXPECT_THAT(refusal({}), HasSubstr("no elements"));
    Mesh mesh = cube();
    mesh.elements[0].node[7] = 8;
    EXPECT_THAT(refusal(mesh), HasSubstr("uses node 9 of 8"));
    mesh = cube();
    mesh.node_sets["edge"] = {0, 99};
    EXPECT_THAT(refusal(mesh), HasSubstr("set 'edge'"));
    mesh = cube();
    mesh.nodes[3].y = std::numeric_limits<double>::infinity();
    EXPECT_THAT(refusal(mesh), HasSubstr("node 4 is not a finite number"));
}

TEST(Check, OfNothingIsNothing)
{
    EXPECT_EQ(check({}).elements, 0u);
}

}  // namespace
}  // namespace corpuscle
