#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <fmt/format.h>

#include "input/meshes/abaqus.hpp"
#include "input/meshes/dyna_mesh.hpp"
#include "input/meshes/gmsh.hpp"
#include "input/meshes/read_mesh.hpp"
#include "mesh/measure.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"
#include "unit/input/meshes/refusal.hpp"

namespace corpuscle {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string abaqus_refusal_of(const std::string& text)
{
    return refusal_of([&] { return read_abaqus(Scanner("case.inp", text)); });
}

std::string dyna_refusal_of(const std::string& text)
{
    return refusal_of([&] { return read_dyna_mesh(Scanner("case.k", text)); });
}

/// A part of two quadrilaterals and a triangle, and a set of three nodes, in each language. Node 9 is used by nothing.
const std::vector<Vector3d> places{{0, 0, 0}, {1, 0, 0}, {2, 0, 0.5}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0.5}, {3, 0, 0}, {9, 9, 9}};
const std::vector<std::int64_t> tags{1, 2, 3, 4, 5, 6, 70, 9};

std::string gmsh_text()
{
    std::string text =
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 1 \"edge\"\n2 2 \"hull\"\n$EndPhysicalNames\n$Nodes\n8\n";
    for (std::size_t i = 0; i < places.size(); ++i) text += fmt::format("{} {} {} {}\n", tags[i], places[i].x, places[i].y, places[i].z);
    return text +
           "$EndNodes\n$Elements\n5\n1 1 2 1 1 1 2\n2 1 2 1 1 2 3\n11 3 2 2 1 1 2 5 4\n12 3 2 2 1 2 3 6 5\n13 2 2 2 1 3 70 "
           "6\n$EndElements\n";
}

std::string abaqus_text()
{
    std::string text = "*Heading\n a hull\n** written by hand\n*Node, nset=everything\n";
    for (std::size_t i = 0; i < places.size(); ++i)
        text += fmt::format("{:>6}, {}, {}, {}\n", tags[i], places[i].x, places[i].y, places[i].z);
    return text +
           "*ELEMENT, type = S4R, Elset=quads\n11, 1, 2, 5,\n4\n 12,2,3,6,5\n*Element,TYPE=S3,ELSET=tips\n13, 3, 70, 6\n"
           "*Elset, elset=HULL\nquads, tips\n*Nset, nset=edge, generate\n1, 3, 1\n*SHELL SECTION, ELSET=HULL, MATERIAL=STEEL\n0.01\n";
}

std::string dyna_text(const std::string& style)
{
    const bool comma = style == "comma";
    const int wide = style == "long" ? 20 : 8, real = style == "long" ? 20 : 16, ten = style == "long" ? 20 : 10;
    const auto field = [&](auto value, int width) { return comma ? fmt::format("{},", value) : fmt::format("{:>{}}", value, width); };
    const auto card = [&](std::vector<int> values, int width) {
        std::string line;
        for (const int value : values) line += field(value, width);
        return line + "\n";
    };
    std::string text = style == "long" ? "$ long\n*KEYWORD LONG=Y\n" : "$ short\n*KEYWORD\n";
    text += "*PART\nhull\n" + card({7, 1, 1}, ten) + "*ELEMENT_SHELL\n" + card({11, 7, 1, 2, 5, 4}, wide) +
            card({12, 7, 2, 3, 6, 5}, wide) + card({13, 7, 3, 70, 6, 6}, wide) + "*NODE\n";
    for (std::size_t i = 0; i < places.size(); ++i)
        text += field(tags[i], wide) + field(places[i].x, real) + field(places[i].y, real) + field(places[i].z, real) + "\n";
    return text + "*SET_NODE_LIST_TITLE\nedge\n" + card({3}, ten) + card({1, 2, 3}, ten) + "*MAT_ELASTIC\n1,7800.,2.1e11,.3\n*END\nnothing";
}

/// The mesh as its numbers, so that two can be compared.
void expect_hull(const Mesh& mesh, const std::string& what)
{
    ASSERT_EQ(mesh.nodes.size(), 7u) << what;
    for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(mesh.nodes[i], places[i]) << what << " " << i;
    ASSERT_EQ(mesh.elements.size(), 3u) << what;
    EXPECT_EQ(mesh.elements[0].node, (std::array<std::uint32_t, 8>{0, 1, 4, 3})) << what;
    EXPECT_EQ(mesh.elements[1].node, (std::array<std::uint32_t, 8>{1, 2, 5, 4})) << what;
    EXPECT_EQ(mesh.elements[2].node, (std::array<std::uint32_t, 8>{2, 6, 5})) << what;
    EXPECT_EQ(mesh.elements[2].shape, ElementShape::triangle) << what;
    for (int e = 0; e < 3; ++e) EXPECT_EQ(mesh.elements[e].number, 11 + e) << what;
    const std::string hull = mesh.element_sets.contains("hull") ? "hull" : "HULL";
    EXPECT_THAT(mesh.element_sets.at(hull), ElementsAre(0, 1, 2)) << what;
    EXPECT_THAT(select_nodes(mesh, "edge"), ElementsAre(0, 1, 2)) << what;
    EXPECT_THAT(element_place(mesh, 2), HasSubstr("element 13 near")) << what;
}

TEST(DeckMeshes, TheSameBodyInEveryLanguageIsTheSameMesh)
{
    expect_hull(read_gmsh(Scanner("case.msh", gmsh_text())), "gmsh");
    expect_hull(read_abaqus(Scanner("case.inp", abaqus_text())), "abaqus");
    for (const char* style : {"standard", "long", "comma"}) expect_hull(read_dyna_mesh(Scanner("case.k", dyna_text(style))), style);
}

TEST(DeckMeshes, LinesMayEndAsOnWindows)
{
    for (const std::string& unix_text : {abaqus_text(), dyna_text("standard")}) {
        const bool abaqus = unix_text.find("Heading") != std::string::npos;
        std::string text;
        for (const char c : unix_text) {
            if (c == '\n') text.push_back('\r');
            text.push_back(c);
        }
        expect_hull(abaqus ? read_abaqus(Scanner("case.inp", text)) : read_dyna_mesh(Scanner("case.k", text)), abaqus ? "abaqus" : "dyna");
    }
}

TEST(DeckMeshes, LanguagesAreToldApartByContentAndUnitsAreConverted)
{
    const auto folder = std::filesystem::temp_directory_path() / fmt::format("corpuscle_decks_{}", ::getpid());
    std::filesystem::create_directories(folder);
    for (const std::string& text : {gmsh_text(), abaqus_text(), dyna_text("standard"), dyna_text("comma")}) {
        const std::string file = (folder / "mesh.txt").string();
        std::ofstream(file) << text;
        EXPECT_EQ(read_mesh(file, 1e-3).nodes[2], 1e-3 * places[2]) << text.substr(0, 20);
    }
    std::filesystem::remove_all(folder);
}

TEST(DeckMeshes, WhatIsPassedOverIsNamed)
{
    EXPECT_THAT(read_abaqus(Scanner("case.inp", abaqus_text() + "*MATERIAL, NAME=STEEL\n")).remarks,
                ElementsAre(AllOf(HasSubstr("thicknesses"), HasSubstr(": HULL 0.01")), HasSubstr("*MATERIAL")));
    EXPECT_THAT(read_dyna_mesh(Scanner("case.k", dyna_text("comma"))).remarks, ElementsAre(HasSubstr("*MAT_ELASTIC")));
    const std::string mass = abaqus_text() + "*ELEMENT, TYPE=MASS, ELSET=ballast\n99, 70\n*ELEMENT, TYPE=T3D2, ELSET=wire\n98, 1, 2\n";
    const Mesh mesh = read_abaqus(Scanner("case.inp", mass));
    EXPECT_THAT(mesh.remarks, testing::Contains(HasSubstr("point_masses")));
    EXPECT_EQ(mesh.elements.size(), 3u);
    EXPECT_THAT(select_nodes(mesh, "ballast"), ElementsAre(6));
    EXPECT_THAT(select_nodes(mesh, "wire"), ElementsAre(0, 1));
}

/// Two instances of a part of one quadrilateral: one moved, one moved and turned by 90 degrees about z through (5, 0, 0).
const std::string assembled =
    "*Part, name=Tile\n*Node\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n*Element, type=S4R\n1, 1, 2, 3, 4\n*Nset, nset=low\n1, "
    "2\n*End Part\n"
    "*Assembly, name=A\n*Instance, name=left, part=Tile\n0, 0, 2\n*End Instance\n*Instance, name=Right, part=Tile\n5, 0, 0\n5, 0, 0, 5, 0, "
    "1, 90\n"
    "*End Instance\n*Nset, nset=held, instance=Right\n 3, 4\n*Nset, nset=both\n left.low, Right.1\n*Elset, elset=all_tiles, "
    "instance=left\n1\n"
    "*Elset, elset=all_tiles, instance=Right\n1\n*End Assembly\n*Step\n*Boundary\n held, 1, 6\n*End Step\n";

TEST(Abaqus, InstancesArePutInPlace)
{
    const Mesh mesh = read_abaqus(Scanner("case.inp", assembled));
    ASSERT_EQ(mesh.nodes.size(), 8u);
    EXPECT_EQ(mesh.nodes[0], (Vector3d{0, 0, 2}));
    EXPECT_LT(norm(mesh.nodes[5] - Vector3d{5, 1, 0}), 1e-15);  // (1, 0, 0) moved to (6, 0, 0), turned to (5, 1, 0)
    EXPECT_THAT(mesh.node_sets.at("low"), ElementsAre(0, 1, 4, 5));
    EXPECT_THAT(mesh.node_sets.at("Right.low"), ElementsAre(4, 5));
    EXPECT_THAT(mesh.node_sets.at("held"), ElementsAre(6, 7));
    EXPECT_THAT(mesh.node_sets.at("both"), ElementsAre(0, 1, 4));
    EXPECT_THAT(mesh.element_sets.at("left"), ElementsAre(0));
    EXPECT_THAT(mesh.element_sets.at("Right"), ElementsAre(1));
    EXPECT_THAT(mesh.element_sets.at("all_tiles"), ElementsAre(0, 1));
    EXPECT_EQ(mesh.elements[1].number, 1);
}

TEST(Abaqus, IncludesFilesBesideIt)
{
    const auto folder = std::filesystem::temp_directory_path() / fmt::format("corpuscle_includes_{}", ::getpid());
    std::filesystem::create_directories(folder / "inner");
    std::ofstream(folder / "case.inp") << "*INCLUDE, INPUT=inner/nodes.inp\n*ELEMENT, TYPE=S3\n1, 1, 2, 3\n";
    std::ofstream(folder / "inner/nodes.inp") << "*INCLUDE, INPUT=more.inp\n*NODE\n2, 1, 0, 0\n3, 0, 1, 0\n";
    std::ofstream(folder / "inner/more.inp") << "*NODE\n1, 0, 0, 0";
    EXPECT_EQ(read_mesh((folder / "case.inp").string()).nodes.size(), 3u);
    std::ofstream(folder / "inner/more.inp") << "*NODE\n1, 0, 0, zero\n";
    EXPECT_THAT(refusal_of([&] { return read_mesh((folder / "case.inp").string()); }),
                HasSubstr("inner/more.inp:2:1: 'zero' is not a number"));
    std::ofstream(folder / "inner/more.inp") << "*INCLUDE, INPUT=nodes.inp\n";
    EXPECT_THAT(refusal_of([&] { return read_mesh((folder / "case.inp").string()); }),
                HasSubstr("more.inp:1:1: 'nodes.inp' includes itself"));
    std::ofstream(folder / "inner/more.inp") << "\n*INCLUDE, INPUT=none.inp\n";
    EXPECT_THAT(refusal_of([&] { return read_mesh((folder / "case.inp").string()); }), HasSubstr("more.inp:2:1: there is no file"));
    std::filesystem::remove_all(folder);
}

TEST(Abaqus, RefusesByLine)
{
    const std::string nodes = "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n";
    const auto with = [&](const std::string& more) { return abaqus_refusal_of(nodes + more); };
    EXPECT_THAT(with("*ELEMENT, TYPE=S8R\n"), AllOf(HasSubstr("case.inp:7:1"), HasSubstr("S8R are of second order"), HasSubstr("linear")));
    EXPECT_THAT(with("*ELEMENT, TYPE=C3D6\n"), HasSubstr("C3D6 are wedges or pyramids"));
    EXPECT_THAT(with("*ELEMENT, TYPE=XYZ\n"), HasSubstr("'XYZ' are not known"));
    EXPECT_THAT(with("*ELEMENT\n1,1,2,3\n"), HasSubstr("'' are not known"));
    EXPECT_THAT(with("*ELEMENT, TYPE=S4\n1,1,2,3\n"), AllOf(HasSubstr("case.inp:8:1"), HasSubstr("has 4 nodes, 3 are given")));
    EXPECT_THAT(with("*ELEMENT, TYPE=S3\n1,1,2,3,4\n"), HasSubstr("has 3 nodes, 4 are given"));
    EXPECT_THAT(with("*ELEMENT, TYPE=S3\n1,1,2,9\n"), AllOf(HasSubstr("case.inp:8:1"), HasSubstr("element 1 uses node 9")));
    EXPECT_THAT(with("*ELEMENT, TYPE=S3\n1,1,2,3\n1,1,2,4\n"), AllOf(HasSubstr("case.inp:9:1"), HasSubstr("element 1 is given twice")));
    EXPECT_THAT(with("*ELEMENT, TYPE=C3D8\n1,1,2,3,4,5,5,5,5\n"), HasSubstr("a pyramid"));
    EXPECT_THAT(with("*ELEMENT, TYPE=S3\n-1,1,2,3\n"), HasSubstr("numbers begin at 1"));
    EXPECT_THAT(with("*NODE\n5,0,0,2\n*ELEMENT, TYPE=S3\n1,1,2,3\n"), AllOf(HasSubstr("case.inp:8:1"), HasSubstr("node 5 is given twice")));
    EXPECT_THAT(with(""), HasSubstr("no shells"));
    EXPECT_THAT(with("*NMAP, TYPE=BLENDED\n1,5\n"), AllOf(HasSubstr("case.inp:7:1"), HasSubstr("*NMAP is not read")));
    EXPECT_THAT(with("*NODE, SYSTEM=S\n"), HasSubstr("rectangular"));
    const std::string one = "*ELEMENT, TYPE=S3\n1,1,2,3\n";
    EXPECT_THAT(with(one + "*NSET, NSET=a\n1, 99\n"), AllOf(HasSubstr("case.inp:10:1"), HasSubstr("no node 99")));
    EXPECT_THAT(with(one + "*NSET, NSET=a\nb\n"), AllOf(HasSubstr("case.inp:10:1"), HasSubstr("no set of nodes 'B'")));
    EXPECT_THAT(with(one + "*NSET, NSET=a\nb\n*NSET, NSET=b\na\n"), HasSubstr("holds itself"));
    EXPECT_THAT(with(one + "*NSET, NSET=a, GENERATE\n9, 1, 1\n"), HasSubstr("runs backwards"));
    EXPECT_THAT(with(one + "*INSTANCE, NAME=i, PART=p\n"), HasSubstr("of part 'p', which is not there"));
    EXPECT_THAT(with("*PART, NAME=p\n"), HasSubstr("ends within a part"));
}

TEST(Abaqus, RangesTakeWhatThereIs)
{
    const std::string text = "*NODE\n1,0,0,0\n3,1,0,0\n7,1,1,0\n*ELEMENT, TYPE=S3\n5,1,3,7\n*NSET, NSET=a, GENERATE\n1, 1000000000000, 2\n";
    EXPECT_THAT(read_abaqus(Scanner("case.inp", text)).node_sets.at("a"), ElementsAre(0, 1, 2));
}

/// A unit cube, one tetrahedron on it and a shell, with sets of every kind.
const std::string solids =
    "*KEYWORD\n*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n9,.5,.5,2\n"
    "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n*ELEMENT_SOLID (ten nodes "
    "format)\n2,2\n5,6,7,9,9,9,9,9,0,0\n*ELEMENT_SHELL_THICKNESS\n1,3,1,2,3,4\n.1,.1,.1,.1\n"
    "*PART\nthe block\n1,1,1\nthe "
    "tip\n2,1,1\n*SET_SOLID\n4\n2\n*SET_SHELL_GENERAL\n5\nALL\n*SET_PART_LIST_GENERATE\n6\n1,2\n*SET_NODE_GENERAL\n8\nPART,2\n"
    "*SET_SEGMENT\n9\n1,2,6,5,0.\n*SET_NODE_LIST_GENERATE\n10\n1,4\n";

TEST(DynaMesh, ReadsSolidsPartsAndSets)
{
    const Mesh mesh = read_dyna_mesh(Scanner("case.k", solids));
    ASSERT_EQ(mesh.elements.size(), 3u);
    EXPECT_EQ(mesh.elements[0].shape, ElementShape::hexahedron);
    EXPECT_EQ(mesh.elements[1].shape, ElementShape::tetrahedron);
    EXPECT_EQ(mesh.elements[1].node, (std::array<std::uint32_t, 8>{4, 5, 6, 8}));
    EXPECT_EQ(mesh.elements[1].number, 2);
    for (int e = 0; e < 3; ++e) EXPECT_GT(scaled_jacobian(mesh, mesh.elements[e]), 0.3);
    EXPECT_THAT(mesh.element_sets.at("the block"), ElementsAre(0));
    EXPECT_THAT(mesh.element_sets.at("part_2"), ElementsAre(1));
    EXPECT_THAT(mesh.element_sets.at("solid_set_4"), ElementsAre(1));
    EXPECT_THAT(mesh.element_sets.at("shell_set_5"), testing::Contains(2));
    EXPECT_THAT(mesh.element_sets.at("part_set_6"), ElementsAre(0, 1));
    EXPECT_THAT(mesh.node_sets.at("node_set_8"), ElementsAre(4, 5, 6, 8));
    EXPECT_THAT(mesh.node_sets.at("segment_set_9"), ElementsAre(0, 1, 4, 5));
    EXPECT_THAT(mesh.node_sets.at("node_set_10"), ElementsAre(0, 1, 2, 3));
}

TEST(DynaMesh, ReadsNumbersAsFortranWritesThem)
{
    const std::string text =
        "*KEYWORD\n*NODE\n       1         1.5D-3          +2.5-1          -1.E+02\n"
        "       2              1.              0.              0.\n       3              0.              1.              0.\n"
        "*ELEMENT_SHELL\n       1       1       1       2       3       3\n";
    EXPECT_EQ(read_dyna_mesh(Scanner("case.k", text)).nodes[0], (Vector3d{1.5e-3, 0.25, -100}));
}

TEST(DynaMesh, RefusesByLine)
{
    const std::string nodes = "*KEYWORD\n*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n";
    const auto with = [&](const std::string& more) { return dyna_refusal_of(nodes + more); };
    EXPECT_THAT(with("*ELEMENT_TSHELL\n1,1,1,2\n"), AllOf(HasSubstr("case.k:9:1"), HasSubstr("*ELEMENT_TSHELL are not computed")));
    EXPECT_THAT(with("*ELEMENT_BEAM\n1,1,1,2\n"), HasSubstr("no shells"));
    EXPECT_THAT(with("*ELEMENT_SHELL_COMPOSITE\n1,1,1,2,3,4\n"), HasSubstr("*ELEMENT_SHELL_COMPOSITE"));
    EXPECT_THAT(with("*ELEMENT_SHELL\n1,1,1,2,3,4,5,6,1,2\n"), AllOf(HasSubstr("case.k:10:1"), HasSubstr("second order")));
    EXPECT_THAT(with("*ELEMENT_SOLID\n1,1\n1,2,3,4,5,6,1,2,3,4\n"), HasSubstr("ten nodes"));
    EXPECT_THAT(with("*ELEMENT_SOLID\n1,1,1,2,3,4,5,5,6,6\n"), HasSubstr("a wedge"));
    EXPECT_THAT(with("*ELEMENT_SOLID\n1,1,1,2,3,4,5,5,5,5\n"), HasSubstr("a pyramid"));
    EXPECT_THAT(with("*ELEMENT_SHELL\n1,1,1,2,9,9\n"), AllOf(HasSubstr("case.k:10:1"), HasSubstr("element 1 uses node 9")));
    EXPECT_THAT(with("*ELEMENT_SHELL\n1,1,1,2,&n,3\n"), HasSubstr("no parameter 'N'"));
    EXPECT_THAT(with("*ELEMENT_SHELL\n1,1,1,2\n"), HasSubstr("a node of an element is missing"));
    EXPECT_THAT(with("*INCLUDE_TRANSFORM\nfile.k\n"), AllOf(HasSubstr("case.k:10:1"), HasSubstr("no file 'file.k'")));
    EXPECT_THAT(with("*INCLUDE_NASTRAN\nfile.nas\n"), HasSubstr("*INCLUDE_NASTRAN is not read"));
    EXPECT_THAT(with("*NODE_MERGE_SET\n1\n"), HasSubstr("*NODE_MERGE_SET is not read"));
    EXPECT_THAT(with("*INCLUDE\nnone.k\n"), AllOf(HasSubstr("case.k:10:1"), HasSubstr("no file")));
    EXPECT_THAT(with("*SET_NODE_LIST\n1\n99\n*ELEMENT_SHELL\n1,1,1,2,3,4\n"), AllOf(HasSubstr("case.k:11:1"), HasSubstr("no node 99")));
    EXPECT_THAT(with("*SET_NODE_GENERAL\n1\nBOX,1\n"), HasSubstr("'BOX' in a general set"));
    EXPECT_THAT(with(""), HasSubstr("no shells"));
}

TEST(DeckMeshes, DamagedDecksAreReadOrRefusedButNeverMore)
{
    for (const std::string& whole : {abaqus_text(), assembled, dyna_text("standard"), solids}) {
        const bool abaqus = whole.find("KEYWORD") == std::string::npos;
        for (std::size_t at = 0; at < whole.size(); ++at) {
            std::string damaged = whole;
            damaged[at] = static_cast<char>("9,*x\n "[at % 6]);
            (void)(abaqus ? abaqus_refusal_of(damaged) : dyna_refusal_of(damaged));  // anything but InputError ends the test
            (void)(abaqus ? abaqus_refusal_of(whole.substr(0, at)) : dyna_refusal_of(whole.substr(0, at)));
        }
    }
    SUCCEED();
}

}  // namespace
}  // namespace corpuscle
