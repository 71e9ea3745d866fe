#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <fmt/format.h>

#include "input/meshes/abaqus.hpp"
#include "input/meshes/read_mesh.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"
#include "unit/input/meshes/refusal.hpp"

namespace corpuscle {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

Mesh abaqus_deck(const std::string& text)
{
    return read_abaqus(Scanner("deck.inp", text));
}

std::string abaqus_deck_refusal(const std::string& text)
{
    return refusal_of([&] { return abaqus_deck(text); });
}

const std::string six_nodes = "1,0,0,0\n2,1,0,0\n3,2,0,0\n4,0,1,0\n5,1,1,0\n6,2,1,0\n";
const std::string two_squares = "11,1,2,5,4\n12,2,3,6,5\n";

/// Two squares on six nodes (0..2, 0..1, 0), numbered 11 and 12 and in the set HULL.
void expect_squares(const Mesh& mesh, const std::string& what)
{
    ASSERT_EQ(mesh.nodes.size(), 6u) << what;
    ASSERT_EQ(mesh.elements.size(), 2u) << what;
    for (int e = 0; e < 2; ++e) {
        EXPECT_EQ(mesh.elements[e].number, 11 + e) << what;
        const std::array<Vector3d, 4> corners{Vector3d{0.0 + e, 0, 0}, {1.0 + e, 0, 0}, {1.0 + e, 1, 0}, {0.0 + e, 1, 0}};
        for (int k = 0; k < 4; ++k) EXPECT_LT(norm(mesh.nodes[mesh.elements[e].node[k]] - corners[k]), 1e-15) << what << " " << e << k;
    }
    EXPECT_THAT(mesh.element_sets.at("HULL"), ElementsAre(0, 1)) << what;
}

TEST(AbaqusDecks, TheSameMeshHoweverItIsMade)
{
    const std::string written = "*ELEMENT, TYPE=S4R, ELSET=HULL\n" + two_squares;
    expect_squares(abaqus_deck("*NODE\n" + six_nodes + written), "written");
    expect_squares(abaqus_deck("*NODE\n1,0,0,0\n3,2,0,0\n4,0,1,0\n6,2,1,0\n*NGEN\n1,3\n6,4,1\n" + written), "*NGEN");
    expect_squares(
        abaqus_deck("*NODE, NSET=LOW\n1,0,0\n2,1,0\n3,2,0\n*NODE, NSET=HIGH\n7,0,2\n8,1,2\n9,2,2\n*NFILL\nLOW,HIGH,2,3\n" + written),
        "*NFILL");
    expect_squares(abaqus_deck("*NODE, NSET=LOW\n1,0,0\n2,1,0\n3,2,0\n*NCOPY, CHANGE NUMBER=3, OLD SET=LOW, SHIFT\n0,1,0\n\n" + written),
                   "*NCOPY, SHIFT");
    expect_squares(abaqus_deck("*NODE, NSET=LOW\n1,0,0\n2,0,-1\n3,0,-2\n*NODE\n40,0,0\n*NCOPY, CHANGE NUMBER=3, OLD SET=LOW, SHIFT\n1,0,0\n"
                               "0,0,0,0,0,1,90\n*NCOPY, CHANGE NUMBER=100, OLD SET=LOW, SHIFT\n0,0,0\n0,0,0,0,0,1,90\n"
                               "*ELEMENT, TYPE=S4R, ELSET=HULL\n11,101,102,5,4\n12,102,103,6,5\n"),
                   "*NCOPY, SHIFT with a turn");
    expect_squares(abaqus_deck("*NODE, NSET=LOW\n1,0,0\n2,1,0\n3,2,0\n*NCOPY, CHANGE NUMBER=3, OLD SET=LOW, REFLECT=MIRROR\n"
                               "0,.5,0,1,.5,0\n0,.5,1\n" +
                               written),
                   "*NCOPY, REFLECT=MIRROR");
    expect_squares(
        abaqus_deck("*NODE, NSET=LOW\n1,0,0\n2,1,0\n3,2,0\n*NCOPY, CHANGE NUMBER=3, OLD SET=LOW, REFLECT=LINE\n0,.5,0,1,.5,0\n" + written),
        "*NCOPY, REFLECT=LINE");
    expect_squares(abaqus_deck("*NODE, NSET=LOW\n1,0,0\n2,1,0\n3,2,0\n*NCOPY, CHANGE NUMBER=3, OLD SET=LOW, REFLECT=POINT\n1,.5,0\n"
                               "*ELEMENT, TYPE=S4R, ELSET=HULL\n11,1,2,5,6\n12,2,3,4,5\n"),
                   "*NCOPY, REFLECT=POINT");
    const std::string master = "*ELEMENT, TYPE=S4R\n11,1,2,5,4\n";
    expect_squares(abaqus_deck("*NODE\n" + six_nodes + master + "*ELGEN, ELSET=HULL\n11, 2\n"), "*ELGEN");
    expect_squares(abaqus_deck("*NODE\n" + six_nodes + master + "*ELGEN, ELSET=HULL\n11, 1,,, 2, 1, 1\n"), "*ELGEN in rows");
    expect_squares(abaqus_deck("*NODE\n" + six_nodes + "*ELEMENT, TYPE=S4R, ELSET=HULL\n11,1,2,5,4\n" +
                               "*ELCOPY, ELEMENT SHIFT=1, OLD SET=HULL, SHIFT NODES=1, NEW SET=HULL\n"),
                   "*ELCOPY");
}

TEST(AbaqusDecks, NodesInOtherSystems)
{
    const std::string squares = "*ELEMENT, TYPE=S4R, ELSET=HULL\n" + two_squares;
    expect_squares(
        abaqus_deck("*SYSTEM\n2,0,0,2,1,0\n1,0,0\n*NODE\n1,0,2\n2,0,1\n3,0,0\n*SYSTEM\n0,0,0\n*NODE\n4,0,1\n5,1,1\n6,2,1\n" + squares),
        "x along y, y against x");
    expect_squares(abaqus_deck("*SYSTEM\n0,1,0\n*NODE\n4,0,0\n5,1,0\n6,2,0\n*SYSTEM\n*NODE\n1,0,0\n2,1,0\n3,2,0\n" + squares), "moved");
    expect_squares(abaqus_deck("*NODE, SYSTEM=C\n1,0,0\n2,1,0\n3,2,360.\n4,1,90,0\n*NODE, SYSTEM=R\n5,1,1\n6,2,1\n" + squares),
                   "cylindrical");
    EXPECT_THAT(abaqus_deck_refusal("*NODE, SYSTEM=S\n"), HasSubstr("'S' are not read"));
    EXPECT_THAT(abaqus_deck_refusal("*SYSTEM\n0,0,0,1,0,0\n2,0,0\n"), AllOf(HasSubstr("deck.inp:3:1"), HasSubstr("on a line")));
}

TEST(AbaqusDecks, LinesGoOnBehindCommentsAndCommas)
{
    const std::string text = "** a comment\n*Heading\n*NODE,\n** between the lines of a keyword\n NSET=all\n" + six_nodes +
                             "*Element, type=S4R,\nelset=\"HULL\"\n11, 1, 2,\n** between the nodes\n\n 5, 4\n12,2,3,6,5\n*nset , "
                             "nset=edge\n1,\n** a comment\n4,\n";
    const Mesh mesh = abaqus_deck(text);
    expect_squares(mesh, "commas");
    EXPECT_THAT(select_nodes(mesh, "edge"), ElementsAre(0, 3));
    EXPECT_THAT(select_nodes(mesh, "all"), ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(AbaqusDecks, DataMayComeFromOtherFiles)
{
    const auto folder = std::filesystem::temp_directory_path() / fmt::format("corpuscle_abaqus_decks_{}", ::getpid());
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "nodes.txt") << six_nodes;
    std::ofstream(folder / "squares.txt") << two_squares;
    std::ofstream(folder / "input.inp") << "\xEF\xBB\xBF*NODE, INPUT=nodes.txt\n*ELEMENT, TYPE=S4, ELSET=HULL, INPUT=squares.txt\n";
    std::ofstream(folder / "include.inp")
        << "*NODE\n*INCLUDE, INPUT=nodes.txt\n*ELEMENT, TYPE=S4, ELSET=HULL\n*INCLUDE, INPUT=squares.txt\n";
    std::ofstream(folder / "none.inp") << "*NODE, INPUT=none.txt\n";
    expect_squares(read_mesh((folder / "input.inp").string()), "INPUT=");
    expect_squares(read_mesh((folder / "include.inp").string()), "*INCLUDE within data");
    EXPECT_THROW((void)read_mesh((folder / "none.inp").string()), InputError);
    std::filesystem::remove_all(folder);
}

/// Two cubes beside each other along x, as *ELGEN makes them, and a shell on the floor of the first.
const std::string two_cubes =
    "*NODE\n1,0,0,0\n2,1,0,0\n3,2,0,0\n11,0,1,0\n12,1,1,0\n13,2,1,0\n101,0,0,1\n102,1,0,1\n103,2,0,1\n111,0,1,1\n112,1,1,1\n113,2,1,1\n"
    "*ELEMENT, TYPE=C3D8R\n1,1,2,12,11,101,102,112,111\n*ELGEN, ELSET=cubes\n1,2,1,1\n*ELEMENT, TYPE=S4, ELSET=floor\n7,1,2,12,11\n";

TEST(AbaqusDecks, SurfacesAreSetsOfNodes)
{
    const auto nodes_of = [](const std::string& surface) { return select_nodes(abaqus_deck(two_cubes + surface), "top"); };
    EXPECT_THAT(nodes_of("*SURFACE, NAME=top\ncubes, S2\n"), ElementsAre(6, 7, 8, 9, 10, 11));
    EXPECT_THAT(nodes_of("*SURFACE, NAME=top, TYPE=ELEMENT\n1, S2\n"), ElementsAre(6, 7, 9, 10));
    EXPECT_THAT(nodes_of("*SURFACE, NAME=top\n2, S1\n"), ElementsAre(1, 2, 4, 5));
    EXPECT_THAT(nodes_of("*SURFACE, NAME=top\n2, S3\n"), ElementsAre(1, 2, 7, 8));
    EXPECT_THAT(nodes_of("*SURFACE, NAME=top\n2, S4\n"), ElementsAre(2, 5, 8, 11));
    EXPECT_THAT(nodes_of("*SURFACE, NAME=top\n2, S5\n"), ElementsAre(4, 5, 10, 11));
    EXPECT_THAT(nodes_of("*SURFACE, NAME=top\n2, S6\n"), ElementsAre(1, 4, 7, 10));
    EXPECT_THAT(nodes_of("*SURFACE, NAME=top\nfloor, SNEG\n"), ElementsAre(0, 1, 3, 4));
    EXPECT_THAT(nodes_of("*SURFACE, NAME=top, TYPE=NODE\n113\nlow\n*NSET, NSET=low\n1\n"), ElementsAre(0, 11));
    EXPECT_EQ(nodes_of("*SURFACE, NAME=top\ncubes,\n").size(), 12u);
    EXPECT_THAT(abaqus_deck_refusal(two_cubes + "*SURFACE, NAME=top\nfloor, S2\n"), HasSubstr("no side S2"));
    EXPECT_THAT(abaqus_deck_refusal(two_cubes + "*SURFACE, NAME=top\nroof, S2\n"), HasSubstr("no set of elements 'ROOF'"));
    const Mesh mesh = abaqus_deck(two_cubes + "*NSET, NSET=top\n1\n*SURFACE, NAME=top\nfloor, SPOS\n");
    EXPECT_THAT(mesh.node_sets.at("top"), ElementsAre(0));
    EXPECT_THAT(mesh.node_sets.at("surface top"), ElementsAre(0, 1, 3, 4));
}

/// A block of 3 x 3 x 3 cubes: of its free faces all nodes but the inner eight are.
TEST(AbaqusDecks, SurfacesWithoutSidesAreTheFreeFaces)
{
    const std::string block =
        "*NODE, NSET=a\n1,0,0,0\n*NODE, NSET=b\n4,3,0,0\n*NFILL, NSET=line\na,b,3,1\n*NCOPY, CHANGE NUMBER=30, OLD SET=line, SHIFT, NEW "
        "SET=far\n"
        "0,3,0\n*NFILL, NSET=floor\nline,far,3,10\n*NCOPY, CHANGE NUMBER=300, OLD SET=floor, SHIFT, NEW "
        "SET=roof\n0,0,3\n*NFILL\nfloor,roof,3,100\n"
        "*ELEMENT, TYPE=C3D8R\n1,1,2,12,11,101,102,112,111\n*ELGEN, ELSET=block\n1,3,1,1,3,10,10,3,100,100\n*SURFACE, NAME=skin\nblock\n"
        "*SURFACE, NAME=part of it\n1\n223\n";
    const Mesh mesh = abaqus_deck(block);
    EXPECT_EQ(mesh.nodes.size(), 64u);
    EXPECT_EQ(mesh.elements.size(), 27u);
    for (const MeshElement& element : mesh.elements) EXPECT_NEAR(scaled_jacobian(mesh, element), 1, 1e-12);
    EXPECT_EQ(select_nodes(mesh, "skin").size(), 56u);
    EXPECT_EQ(select_nodes(mesh, "part of it").size(), 14u);  // of the corner cubes all but the one that lies within
}

TEST(AbaqusDecks, SurfacesOfInstances)
{
    const std::string part =
        "*PART, NAME=Box\n" + two_cubes +
        "*SURFACE, NAME=up\ncubes, S2\n*END PART\n*ASSEMBLY, NAME=A\n"
        "*INSTANCE, NAME=one, PART=Box\n*END INSTANCE\n*INSTANCE, NAME=two, PART=Box\n0,0,5\n*END INSTANCE\n"
        "*ELSET, ELSET=_s, INTERNAL, INSTANCE=two\n1\n*SURFACE, TYPE=ELEMENT, NAME=s\n_s, S2\none.cubes, S1\n*END ASSEMBLY\n";
    const Mesh mesh = abaqus_deck(part);
    EXPECT_EQ(select_nodes(mesh, "up").size(), 12u);
    EXPECT_THAT(select_nodes(mesh, "two.up"), ElementsAre(18, 19, 20, 21, 22, 23));
    EXPECT_THAT(select_nodes(mesh, "s"), ElementsAre(0, 1, 2, 3, 4, 5, 18, 19, 21, 22));
}

TEST(AbaqusDecks, LinesAndPointsAreCountedAndLeftOut)
{
    const Mesh mesh = abaqus_deck("*NODE\n" + six_nodes + "*ELEMENT, TYPE=S4R\n" + two_squares +
                                  "*ELEMENT, TYPE=B31, ELSET=ribs\n21,1,2\n22,2,3\n*ELEMENT, TYPE=CONN3D2, ELSET=joint\n23,,6\n"
                                  "*ELEMENT, TYPE=MASS, ELSET=load\n24,5\n");
    EXPECT_EQ(mesh.elements.size(), 2u);
    EXPECT_THAT(mesh.remarks, Contains(HasSubstr("2 elements of type B31 are not computed")));
    EXPECT_THAT(mesh.remarks, Contains(HasSubstr("1 elements of type CONN3D2")));
    EXPECT_THAT(mesh.remarks, Contains(HasSubstr("point_masses")));
    EXPECT_THAT(select_nodes(mesh, "ribs"), ElementsAre(0, 1, 2));
    EXPECT_THAT(select_nodes(mesh, "joint"), ElementsAre(5));
}

TEST(AbaqusDecks, MakersRefuseByLine)
{
    const auto with = [](const std::string& more) {
        return abaqus_deck_refusal("*NODE, NSET=a\n" + six_nodes + "*ELEMENT, TYPE=S4R, ELSET=HULL\n" + two_squares + more);
    };
    EXPECT_THAT(with("*NGEN\n1,9\n"), AllOf(HasSubstr("deck.inp:12:1"), HasSubstr("no node 9")));
    EXPECT_THAT(with("*NGEN\n1,4,2\n"), HasSubstr("no multiple of 2"));
    EXPECT_THAT(with("*NGEN\n1\n"), HasSubstr("needs 2 numbers"));
    EXPECT_THAT(with("*NGEN, LINE=C\n1,4,1,3\n"), AllOf(HasSubstr("deck.inp:11:1"), HasSubstr("*NGEN with LINE is not read")));
    EXPECT_THAT(with("*NFILL\na,b,2,1\n"), AllOf(HasSubstr("deck.inp:12:1"), HasSubstr("no set of nodes 'B' before")));
    EXPECT_THAT(with("*NFILL\na,a,0,1\n"), HasSubstr("0 steps of 1"));
    EXPECT_THAT(with("*ELGEN\n99,2\n"), HasSubstr("no element 99"));
    EXPECT_THAT(with("*ELGEN\n11,99999999,1,1,99999\n"), HasSubstr("too many elements"));
    EXPECT_THAT(with("*ELGEN\n11,3,9,9\n"), HasSubstr("element 20 uses node 10"));
    EXPECT_THAT(with("*ELGEN\n11,2,-1,-20\n"), HasSubstr("number -9 is made"));
    EXPECT_THAT(with("*NCOPY, OLD SET=a, SHIFT\n1,0,0\n"), AllOf(HasSubstr("deck.inp:11:1"), HasSubstr("needs CHANGE NUMBER")));
    EXPECT_THAT(with("*NCOPY, CHANGE NUMBER=9, OLD SET=a\n"), HasSubstr("neither SHIFT nor"));
    EXPECT_THAT(with("*NCOPY, CHANGE NUMBER=9, OLD SET=a, REFLECT=MIRROR\n0,0,0,1,0,0\n"), HasSubstr("9 coordinates"));
    EXPECT_THAT(with("*ELCOPY, OLD SET=HULL, SHIFT NODES=1, ELEMENT SHIFT=0\n"), HasSubstr("ELEMENT SHIFT is 0"));
    EXPECT_THAT(with("*PARAMETER\nx=1\n"), AllOf(HasSubstr("deck.inp:11:1"), HasSubstr("*PARAMETER is not read")));
    EXPECT_THAT(with("*ELEMENT, TYPE=SC8R\n"), HasSubstr("thick shells"));
}

TEST(AbaqusDecks, CutOrDamagedDecksAreReadOrRefusedButNeverMore)
{
    const std::string whole =
        two_cubes +
        "*NSET, NSET=a\n1,2,3\n*NCOPY, CHANGE NUMBER=1000, OLD SET=a, SHIFT\n0,9,0\n0,0,0,0,0,1,90\n*NFILL\na,a,2,20\n"
        "*SURFACE, NAME=top\ncubes\n*SYSTEM\n0,1,0,1,1,0\n*NGEN, NSET=b\n1,3\n*ELEMENT, TYPE=B31\n9,1,2\n";
    int refused = 0;
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>("9,*x\n -.S"[at % 9]);
        refused += abaqus_deck_refusal(damaged) != "accepted";  // anything but InputError ends the test
        refused += abaqus_deck_refusal(whole.substr(0, at)) != "accepted";
    }
    EXPECT_GT(refused, 200);
}

}  // namespace
}  // namespace corpuscle
