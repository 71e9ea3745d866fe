#include "mesh/selection.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "mesh/generators.hpp"

namespace corpuscle {
namespace {

using testing::HasSubstr;

Mesh sheet()
{
    return rectangle_mesh({-0.5, 0, 0.0015}, {1, 0, 0}, {0, 1, 0}, 0.25);
}

std::string refusal(const std::string& where)
{
    try {
        (void)select_nodes(sheet(), where);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(SelectNodes, KnowsAllSetsAndPlanes)
{
    const Mesh mesh = sheet();
    EXPECT_EQ(select_nodes(mesh, "all").size(), mesh.nodes.size());
    EXPECT_EQ(select_nodes(mesh, "start_1"), mesh.node_sets.at("start_1"));
    EXPECT_EQ(select_nodes(mesh, "x=-0.5"), mesh.node_sets.at("start_1"));
    EXPECT_EQ(select_nodes(mesh, " y = 1 "), mesh.node_sets.at("end_2"));
    EXPECT_EQ(select_nodes(mesh, "z=0.0015").size(), mesh.nodes.size());
    EXPECT_EQ(select_nodes(mesh, "z=+1.5 mm").size(), mesh.nodes.size());
    EXPECT_EQ(select_nodes(mesh, "x=-50 cm"), mesh.node_sets.at("start_1"));
}

TEST(SelectNodes, AllowsRoundOffOnPlanesButNoMore)
{
    Mesh mesh = sheet();
    for (Vector3d& node : mesh.nodes) node.x += 1e-9;
    EXPECT_EQ(select_nodes(mesh, "x=0").size(), 5u);
    for (Vector3d& node : mesh.nodes) node.x += 1e-4;
    EXPECT_THROW((void)select_nodes(mesh, "x=0"), InputError);
}

TEST(SelectNodes, ASetNamedLikeAPlaneComesFirst)
{
    Mesh mesh = sheet();
    mesh.node_sets["x=0"] = {7, 3, 7};
    EXPECT_THAT(select_nodes(mesh, "x=0"), testing::ElementsAre(3, 7));
}

TEST(SelectNodes, TakesTheNodesOfElementSets)
{
    const Mesh mesh = box_mesh({{0, 0, 0}, {1, 1, 1}}, 0.5);
    EXPECT_EQ(select_nodes(mesh, "z_max"), select_nodes(mesh, "z=1"));
}

TEST(SelectNodes, RefusesWithTheNearestName)
{
    EXPECT_THAT(refusal("start1"), testing::AllOf(HasSubstr("no set of nodes 'start1'"), HasSubstr("start_1")));
    EXPECT_THAT(refusal("x=7"), testing::AllOf(HasSubstr("no node lies on the plane 'x=7'"), HasSubstr("(0.5, 1, 0.0015) m")));
    EXPECT_THROW((void)select_nodes(sheet(), "x=left"), InputError);
    EXPECT_THROW((void)select_nodes(sheet(), "x=3 kg"), InputError);
    EXPECT_THROW((void)select_nodes(sheet(), "x=inf"), InputError);
    EXPECT_THROW((void)select_nodes(sheet(), "w=0"), InputError);
    EXPECT_THROW((void)select_nodes(sheet(), ""), InputError);
}

TEST(NearestNode, IsTheNearest)
{
    const Mesh mesh = sheet();
    EXPECT_EQ(mesh.nodes[nearest_node(mesh, {0.3, 0.6, 5})], (Vector3d{0.25, 0.5, 0.0015}));
    EXPECT_THROW((void)nearest_node({}, {}), InputError);
}

}  // namespace
}  // namespace corpuscle
