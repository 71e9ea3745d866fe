#include "input/meshes/read_mesh.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include <unistd.h>

#include <fmt/format.h>

#include "input/meshes/gmsh.hpp"
#include "input/meshes/scanner.hpp"
#include "input/meshes/stl.hpp"
#include "math/random.hpp"
#include "mesh/boundary.hpp"
#include "mesh/measure.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"
#include "mesh/shape.hpp"
#include "unit/input/meshes/refusal.hpp"

namespace corpuscle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

std::string data(const std::string& name)
{
    return std::string(CORPUSCLE_SOURCE_DIR) + "/tests/data/meshes/" + name;
}

std::string content(const std::string& name)
{
    std::ifstream stream(data(name), std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::string gmsh_refusal(const std::string& text)
{
    return refusal_of([&] { return read_gmsh(Scanner("case.msh", text)); });
}

std::string stl_refusal(const std::string& text)
{
    return refusal_of([&] { return read_stl(Scanner("case.stl", text)); });
}

std::string replaced(std::string text, const std::string& what, const std::string& with)
{
    const auto at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), with);
}

double volume_of_tetrahedra(const Mesh& mesh)
{
    double volume = 0.0;
    for (const MeshElement& e : mesh.elements) {
        const Vector3d origin = mesh.nodes[e.node[0]];
        volume += dot(cross(mesh.nodes[e.node[1]] - origin, mesh.nodes[e.node[2]] - origin), mesh.nodes[e.node[3]] - origin) / 6.0;
    }
    return volume;
}

class GmshFlavour : public testing::TestWithParam<const char*> {
protected:
    static std::string file(const std::string& body) { return body + "_" + GetParam() + ".msh"; }
};

TEST_P(GmshFlavour, SheetHasItsElementsAndSets)
{
    const Mesh mesh = read_mesh(data(file("sheet")));
    EXPECT_THAT(validate(mesh, "sheet"), IsEmpty());
    EXPECT_EQ(mesh.nodes.size(), 15u);
    EXPECT_EQ(mesh.elements.size(), 12u);
    EXPECT_NEAR(total_area(mesh), 2.0, 1e-9);
    for (const MeshElement& element : mesh.elements) EXPECT_GT(area_vector(mesh, element).z, 0.0);
    EXPECT_EQ(mesh.element_sets.at("quads").size(), 4u);
    EXPECT_EQ(mesh.element_sets.at("all of it").size(), 12u);
    EXPECT_EQ(mesh.element_sets.count("left edge"), 0u);
    EXPECT_EQ(select_nodes(mesh, "left edge"), select_nodes(mesh, "x=0"));
    EXPECT_EQ(select_nodes(mesh, "curve_9"), select_nodes(mesh, "x=2"));
    EXPECT_EQ(select_nodes(mesh, "quads").size(), 9u);
    ASSERT_EQ(select_nodes(mesh, "corner").size(), 1u);
    EXPECT_EQ(mesh.nodes[select_nodes(mesh, "corner")[0]], Vector3d{});
    for (const std::uint32_t e : mesh.element_sets.at("quads")) {
        EXPECT_EQ(mesh.elements[e].shape, ElementShape::quadrilateral);
        EXPECT_LT(center(mesh, mesh.elements[e]).x, 1.0);
    }
}

TEST_P(GmshFlavour, BrickKeepsItsHexahedraOnly)
{
    const Mesh mesh = read_mesh(data(file("brick")), 1e-3);
    EXPECT_THAT(validate(mesh, "brick"), IsEmpty());
    EXPECT_EQ(mesh.nodes.size(), 27u);
    ASSERT_EQ(mesh.elements.size(), 8u);
    for (const MeshElement& element : mesh.elements) EXPECT_EQ(element.shape, ElementShape::hexahedron);
    EXPECT_NEAR(check(mesh).min_scaled_jacobian, 1.0, 1e-9);
    EXPECT_NEAR(check(mesh).max_edge, 0.5e-3, 1e-12);
    EXPECT_EQ(select_nodes(mesh, "floor"), select_nodes(mesh, "z=0"));
    EXPECT_EQ(mesh.element_sets.at("brick").size(), 8u);
    EXPECT_EQ(mesh.element_sets.count("floor"), 0u);
}

TEST_P(GmshFlavour, CornerIsFilledWithTetrahedra)
{
    const Mesh mesh = read_mesh(data(file("corner")));
    EXPECT_THAT(validate(mesh, "corner"), IsEmpty());
    for (const MeshElement& element : mesh.elements) ASSERT_EQ(element.shape, ElementShape::tetrahedron);
    EXPECT_NEAR(volume_of_tetrahedra(mesh), 1.0 / 6.0, 1e-9);
    for (const std::uint32_t node : select_nodes(mesh, "slope"))
        EXPECT_NEAR(mesh.nodes[node].x + mesh.nodes[node].y + mesh.nodes[node].z, 1.0, 1e-9);
    EXPECT_EQ(select_nodes(mesh, "slope").size(), 6u);
}

TEST_P(GmshFlavour, FilesCutShortAreRefusedWhereverTheyEnd)
{
    for (const std::string body : {"sheet", "brick", "corner"}) {
        const std::string whole = content(file(body));
        const std::size_t last = whole.find_last_not_of("\n");
        for (std::size_t length = 12; length <= last; ++length)
            EXPECT_THAT(gmsh_refusal(whole.substr(0, length)), HasSubstr("case.msh:")) << body << " " << length;
    }
}

TEST_P(GmshFlavour, DamagedFilesAreReadOrRefusedButNeverMore)
{
    const std::string whole = content(file("sheet"));
    Random random(1, Purpose::fill, 0, 0);
    int refused = 0;
    for (int i = 0; i < 2000; ++i) {
        std::string damaged = whole;
        for (int k = 0; k < 3; ++k) damaged[random.below(static_cast<std::uint32_t>(whole.size()))] = static_cast<char>(random.word());
        refused += gmsh_refusal(damaged) != "accepted";
    }
    EXPECT_GT(refused, 1000);
}

INSTANTIATE_TEST_SUITE_P(All, GmshFlavour, testing::Values("2.2_text", "2.2_binary", "4.1_text", "4.1_binary"));

TEST(ReadGmsh, PartitionedMeshesAreWhole)
{
    const Mesh whole = read_mesh(data("sheet_4.1_text.msh"));
    for (const std::string flavour : {"text", "binary"}) {
        const Mesh mesh = read_mesh(data("sheet_parts_4.1_" + flavour + ".msh"));
        EXPECT_EQ(mesh.elements.size(), whole.elements.size()) << flavour;
        EXPECT_NEAR(total_area(mesh), total_area(whole), 1e-12) << flavour;
        for (const char* set : {"quads", "all of it"}) {
            EXPECT_EQ(mesh.element_sets.at(set).size(), whole.element_sets.at(set).size()) << flavour << " " << set;
            EXPECT_EQ(select_nodes(mesh, set).size(), select_nodes(whole, set).size()) << flavour << " " << set;
        }
        EXPECT_EQ(select_nodes(mesh, "left edge"), select_nodes(mesh, "x=0")) << flavour;
        EXPECT_EQ(select_nodes(mesh, "curve_9"), select_nodes(mesh, "x=2")) << flavour;
        EXPECT_EQ(select_nodes(mesh, "corner").size(), 1u) << flavour;
    }
}

/// Parameters behind the coordinates of a surface's nodes, a group turned round, elements in two groups, a name of blanks and quotes.
TEST(ReadGmsh, ReadsWhatElseVersion41May)
{
    const std::string text =
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"the \"left\" half\"\n2 2 \"all\"\n$EndPhysicalNames\n$Entities\n"
        "0 0 1 0\n3 0 0 0 1 1 0 2 -1 2 0\n$EndEntities\n$Nodes\n2 4 7 1000000\n2 3 1 2\n7\n1000000\n0 0 0 .1 .2\n1 0 0 .3 .4\n2 3 0 "
        "2\n9\n8\n"
        "1 1 0\n0 1 0\n$EndNodes\n$Elements\n1 1 5 5\n2 3 3 1\n5 7 1000000 9 8\n$EndElements\n$Periodic\n0\n$EndPeriodic\n";
    const Mesh mesh = read_gmsh(Scanner("case.msh", text));
    ASSERT_EQ(mesh.nodes.size(), 4u);
    EXPECT_EQ(mesh.nodes[1], (Vector3d{1, 0, 0}));
    EXPECT_EQ(mesh.nodes[2], (Vector3d{1, 1, 0}));
    EXPECT_THAT(mesh.element_sets.at("the \"left\" half"), testing::ElementsAre(0));
    EXPECT_THAT(mesh.element_sets.at("all"), testing::ElementsAre(0));
}

TEST(ReadGmsh, ReadsWindowsLineEnds)
{
    std::string text = content("sheet_4.1_text.msh");
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.replace(at, 1, "\r\n");
    const Mesh mesh = read_gmsh(Scanner("case.msh", text));
    EXPECT_EQ(mesh.elements.size(), 12u);
    EXPECT_EQ(mesh.element_sets.count("all of it"), 1u);
}

TEST(ReadGmsh, SkipsSectionsItDoesNotNeed)
{
    const std::string text = replaced(content("sheet_2.2_text.msh"), "$Nodes", "$Comments\nanything 7 $ at all\n$EndComments\n$Nodes");
    EXPECT_EQ(read_gmsh(Scanner("case.msh", text)).elements.size(), 12u);
}

TEST(ReadGmsh, NamesLineAndColumn)
{
    const std::string text = replaced(content("sheet_2.2_text.msh"), "3 2 0 0", "3 2 O 0");
    EXPECT_THAT(gmsh_refusal(text), AllOf(HasSubstr("case.msh:15:5:"), HasSubstr("'O' is not a number")));
}

TEST(ReadGmsh, RefusesHigherOrdersByName)
{
    EXPECT_THAT(refusal_of([] { return read_mesh(data("second_order.msh")); }),
                AllOf(HasSubstr("second_order.msh:"), HasSubstr("(second order) is not supported"), HasSubstr("ElementOrder")));
    EXPECT_THAT(gmsh_refusal(replaced(content("sheet_2.2_text.msh"), "14 3 2 10 1 1 7 14 10", "14 6 2 10 1 1 7 14 10")),
                HasSubstr("6-node prism"));
    EXPECT_THAT(gmsh_refusal(replaced(content("sheet_2.2_text.msh"), "14 3 2 10 1 1 7 14 10", "14 0 2 10 1 1 7 14 10")),
                HasSubstr("element type 0"));
}

TEST(ReadGmsh, RefusesOtherVersionsAndByteOrders)
{
    EXPECT_THAT(gmsh_refusal(replaced(content("sheet_4.1_text.msh"), "4.1 0 8", "4 0 8")),
                AllOf(HasSubstr("gmsh format 4 is not supported"), HasSubstr("-format msh41")));
    EXPECT_THAT(gmsh_refusal(replaced(content("sheet_4.1_text.msh"), "4.1 0 8", "4.1 0 4")), HasSubstr("4 bytes"));
    std::string swapped = content("sheet_4.1_binary.msh");
    std::swap(swapped[swapped.find('\1')], swapped[swapped.find('\1') + 3]);
    EXPECT_THAT(gmsh_refusal(swapped), AllOf(HasSubstr("byte order"), HasSubstr("at byte")));
}

TEST(ReadGmsh, RefusesWhatDoesNotFit)
{
    const std::string text = content("sheet_2.2_text.msh");
    EXPECT_THAT(gmsh_refusal(replaced(text, "14 3 2 10 1 1 7 14 10", "14 3 2 10 1 1 7 14 99")), HasSubstr("uses node 99"));
    EXPECT_THAT(gmsh_refusal(replaced(text, "\n3 2 0 0", "\n2 2 0 0")), HasSubstr("node 2 is given twice"));
    EXPECT_THAT(gmsh_refusal(replaced(text, "$Nodes\n15", "$Nodes\n999999999999")), HasSubstr("999999999999 nodes are announced"));
    EXPECT_THAT(gmsh_refusal(replaced(text, "$Nodes\n15", "$Nodes\n-1")), HasSubstr("-1 nodes"));
    EXPECT_THAT(gmsh_refusal(replaced(text, "\"quads\"", "quads")), HasSubstr("not in quotes"));
    EXPECT_THAT(gmsh_refusal("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"), HasSubstr("no triangles"));
    EXPECT_THAT(gmsh_refusal(replaced(content("sheet_4.1_text.msh"), "$Nodes", "$PartitionedEntities\n1\n$EndPartitionedEntities\n$Nodes")),
                HasSubstr("ghost entities was expected"));
}

class StlFlavour : public testing::TestWithParam<const char*> {};

TEST_P(StlFlavour, CornerIsClosedAndHasItsVolume)
{
    const Mesh mesh = read_mesh(data(GetParam()), 0.1);
    EXPECT_NO_THROW(require_closed(mesh, "corner"));
    EXPECT_EQ(mesh.elements.size(), mesh.nodes.size() * 2 - 4);  // Euler
    EXPECT_NEAR(Shape::surface(mesh, "corner").volume(), 1e-3 / 6, 1e-10);
    EXPECT_TRUE(Shape::surface(mesh, "corner").contains({0.02, 0.02, 0.02}));
    EXPECT_FALSE(Shape::surface(mesh, "corner").contains({0.04, 0.04, 0.04}));
}

TEST_P(StlFlavour, FilesCutShortAreRefusedWhereverTheyEnd)
{
    const std::string whole = content(GetParam());
    const std::size_t last = whole.find_last_not_of("\n");
    const std::size_t end = whole.starts_with("solid") ? whole.rfind("endsolid") + 7 : last;
    for (std::size_t length = 0; length <= end; ++length)
        EXPECT_THAT(stl_refusal(whole.substr(0, length)), HasSubstr("case.stl:")) << length;
}

INSTANTIATE_TEST_SUITE_P(All, StlFlavour, testing::Values("corner_text.stl", "corner_binary.stl"));

TEST(ReadStl, TakesSolidsAsSetsAndDropsWhatHasNoArea)
{
    const std::string facet = "facet normal nan nan nan\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 0\nendloop\nendfacet\n";
    const std::string flat = "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 0 1e-9\nendloop\nendfacet\n";
    const std::string text = "solid one\n" + flat + facet + "endsolid one\nsolid\n" + replaced(facet, "0 1e0 0", "0 0 1") + "endsolid\n";
    const Mesh mesh = read_stl(Scanner("case.stl", text));
    EXPECT_EQ(mesh.elements.size(), 2u);
    EXPECT_EQ(mesh.nodes.size(), 4u);
    EXPECT_THAT(mesh.element_sets.at("one"), testing::ElementsAre(0));
    EXPECT_THAT(mesh.element_sets.at("solid"), testing::ElementsAre(1));
    EXPECT_THAT(stl_refusal("solid x\n" + flat + "endsolid x\n"), HasSubstr("without area"));
}

TEST(ReadStl, TakesNamesWithBlanksCapitalsAndExponents)
{
    const std::string facet = "FACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1E+00 0 0\nVERTEX 0 +1.0e0 0\nENDLOOP\nENDFACET\n";
    const std::string text = "SOLID left door\n" + facet + "ENDSOLID left door\nsolid  left wall\r\n" +
                             replaced(facet, "0 +1.0e0 0", "0 0 -1e-1") + "endsolid\n";
    ASSERT_TRUE(looks_like_stl(Scanner("case.stl", text)));
    const Mesh mesh = read_stl(Scanner("case.stl", text));
    EXPECT_THAT(mesh.element_sets.at("left door"), testing::ElementsAre(0));
    EXPECT_THAT(mesh.element_sets.at("left wall"), testing::ElementsAre(1));
    EXPECT_EQ(mesh.nodes[3], (Vector3d{0, 0, -0.1}));
}

TEST(ReadStl, BinaryMayBeginWithSolidAndEndWithMore)
{
    const std::string binary = content("corner_binary.stl");
    const Mesh mesh = read_stl(Scanner("case.stl", binary));
    std::string named = binary;
    named.replace(0, 14, "solid facet up");
    for (const std::string& text : {named, binary + "\n", named + std::string(100, '\0')}) {
        ASSERT_TRUE(looks_like_stl(Scanner("case.stl", text)));
        EXPECT_EQ(read_stl(Scanner("case.stl", text)).elements.size(), mesh.elements.size());
    }
}

TEST(ReadStl, RefusesWithLineOrByte)
{
    const std::string text = content("corner_text.stl");
    EXPECT_THAT(stl_refusal(replaced(text, "outer loop", "outer lop")), AllOf(HasSubstr("case.stl:3:"), HasSubstr("'lop' where 'loop'")));
    EXPECT_THAT(stl_refusal(replaced(text, "vertex 0", "vertex O")), HasSubstr("'O' is not a number"));
    EXPECT_THAT(stl_refusal("solid nothing\nendsolid nothing\n"), HasSubstr("no triangles"));
    std::string binary = content("corner_binary.stl");
    for (int i = 0; i < 4; ++i) binary[84 + 12 + i] = static_cast<char>(0xFF);
    EXPECT_THAT(stl_refusal(binary), AllOf(HasSubstr("at byte"), HasSubstr("triangle 1 has a corner")));
}

TEST(ReadMesh, RefusesOtherFilesAndUnits)
{
    EXPECT_THAT(refusal_of([] { return read_mesh(data("none.msh")); }), HasSubstr("cannot be read"));
    EXPECT_THAT(refusal_of([] { return read_mesh(data("brick.geo")); }),
                AllOf(HasSubstr("brick.geo:1:1"), HasSubstr("no mesh file that is known")));
    EXPECT_THAT(refusal_of([] { return read_mesh(data("sheet_2.2_text.msh"), 0.0); }), HasSubstr("unit"));
    const auto file = std::filesystem::temp_directory_path() / fmt::format("corpuscle_old_{}.msh", ::getpid());
    std::ofstream(file) << "$NOD\n1\n1 0 0 0\n$ENDNOD\n";
    EXPECT_THAT(refusal_of([&] { return read_mesh(file.string()); }), HasSubstr("gmsh format 1 is not supported"));
    std::ofstream(file) << "$Comments\nby hand\n$EndComments\n" << content("sheet_2.2_text.msh");
    EXPECT_EQ(read_mesh(file.string()).elements.size(), 12u);
    std::filesystem::remove(file);
    EXPECT_THAT(refusal_of([] { return read_mesh(std::string(CORPUSCLE_SOURCE_DIR)); }), HasSubstr("cannot be read"));
}

}  // namespace
}  // namespace corpuscle
