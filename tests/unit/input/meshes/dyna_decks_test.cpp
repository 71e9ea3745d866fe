#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <fmt/format.h>

#include "input/meshes/dyna_mesh.hpp"
#include "input/meshes/read_mesh.hpp"
#include "mesh/measure.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"
#include "unit/input/meshes/refusal.hpp"

namespace corpuscle {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

Mesh deck(const std::string& text)
{
    return read_dyna_mesh(Scanner("deck.k", text));
}

std::string deck_refusal(const std::string& text)
{
    return refusal_of([&] { return deck(text); });
}

/// Files of a deck in a folder of their own, which goes with this.
class DeckFolder {
public:
    DeckFolder() : folder_(std::filesystem::temp_directory_path() / fmt::format("corpuscle_deck_folder_{}", ::getpid()))
    {
        std::filesystem::create_directories(folder_ / "inner");
    }
    DeckFolder(const DeckFolder&) = delete;
    DeckFolder& operator=(const DeckFolder&) = delete;
    ~DeckFolder() { std::filesystem::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
    [[nodiscard]] Mesh read(const std::string& name) const { return read_mesh((folder_ / name).string()); }
    [[nodiscard]] std::string refusal(const std::string& name) const
    {
        try {
            (void)read(name);
        } catch (const InputError& error) {
            return error.what();
        }
        return "accepted";
    }

private:
    std::filesystem::path folder_;
};

/// A strip of two squares on six nodes (0..2, 0..1, 0), its part titled and its two nodes at x = 0 a set.
const std::string strip_nodes = "*NODE\n1,0,0,0\n2,1,0,0\n3,2,0,0\n4,0,1,0\n5,1,1,0\n6,2,1,0\n*ELEMENT_SHELL\n11,7,1,2,5,4\n12,7,2,3,6,5\n";
const std::string strip_sets = "*PART\nhull\n7,1,1\n*SET_NODE_LIST_TITLE\nedge\n3\n1,4\n";

void expect_strip(const Mesh& mesh, const std::string& what)
{
    ASSERT_EQ(mesh.nodes.size(), 6u) << what;
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(mesh.nodes[i], (Vector3d{static_cast<double>(i % 3), i < 3 ? 0.0 : 1.0, 0})) << what << " " << i;
    ASSERT_EQ(mesh.elements.size(), 2u) << what;
    EXPECT_EQ(mesh.elements[0].node, (std::array<std::uint32_t, 8>{0, 1, 4, 3})) << what;
    EXPECT_EQ(mesh.elements[1].node, (std::array<std::uint32_t, 8>{1, 2, 5, 4})) << what;
    EXPECT_EQ(mesh.elements[1].number, 12) << what;
    EXPECT_THAT(mesh.element_sets.at("hull"), ElementsAre(0, 1)) << what;
    EXPECT_THAT(mesh.element_sets.at("part_7"), ElementsAre(0, 1)) << what;
    EXPECT_THAT(select_nodes(mesh, "edge"), ElementsAre(0, 3)) << what;
    EXPECT_THAT(select_nodes(mesh, "node_set_3"), ElementsAre(0, 3)) << what;
}

/// Nodes and elements of the strip in fixed columns of these widths.
std::string strip_in_columns(int number, int place, const std::string& mark)
{
    std::string text = "*NODE" + mark + "\n";
    for (int i = 0; i < 6; ++i) text += fmt::format("{:{}}{:{}}{:{}}{:{}}\n", i + 1, number, i % 3, place, i / 3, place, 0, place);
    text += "*ELEMENT_SHELL" + mark + "\n";
    for (const auto& numbers : {std::array{11, 7, 1, 2, 5, 4}, std::array{12, 7, 2, 3, 6, 5}}) {
        for (const int value : numbers) text += fmt::format("{:{}}", value, number);
        text += "\n";
    }
    return text;
}

TEST(DynaDecks, FieldsOfEveryWidthAreTheSameMesh)
{
    expect_strip(deck("*KEYWORD\n" + strip_nodes + strip_sets), "commas");
    expect_strip(deck("*KEYWORD\n" + strip_in_columns(8, 16, "") + strip_sets), "standard");
    expect_strip(deck("*KEYWORD I10=Y\n" + strip_in_columns(10, 16, "") + strip_sets), "ten columns");
    expect_strip(deck("*KEYWORD\n" + strip_in_columns(10, 16, "%") + strip_sets), "keywords with %");
    expect_strip(deck("*KEYWORD\n" + strip_in_columns(10, 16, " %") + strip_sets), "keywords with % behind a blank");
    expect_strip(deck("*KEYWORD LONG=Y\n" + strip_in_columns(20, 20, "") + strip_sets), "long");
    expect_strip(deck("*KEYWORD\n" + strip_in_columns(20, 20, " +") + strip_sets), "keywords with +");
    expect_strip(deck("*KEYWORD LONG=Y\n" + strip_in_columns(8, 16, "-") + strip_sets), "keywords with -");
    expect_strip(deck("*keyword\n$ a comment\n" + strip_in_columns(8, 16, "") + "$\n\n" + strip_sets + "*end\nnothing"), "small letters");
}

TEST(DynaDecks, FieldsWithoutBlanksBetweenThemAreTaken)
{
    const std::string text =
        "*KEYWORD\n*NODE\n10000001-1.00000000E+000-2.00000000E+000-3.00000000E+000\n10000002              1.              0.              "
        "0.\n"
        "10000003              0.              1.              0.\n*ELEMENT_SHELL\n2000000130000001100000011000000210000003\n";
    const Mesh mesh = deck(text);
    EXPECT_EQ(mesh.nodes[0], (Vector3d{-1, -2, -3}));
    EXPECT_EQ(mesh.elements[0].number, 20000001);
    EXPECT_THAT(mesh.element_sets.at("part_30000001"), ElementsAre(0));
}

TEST(DynaDecks, LinesWithTabsHaveNoColumns)
{
    std::string text = "*KEYWORD\n" + strip_nodes + strip_sets;
    for (char& c : text)
        if (c == ',') c = '\t';
    expect_strip(deck(text), "tabs");
    EXPECT_THAT(deck_refusal("*KEYWORD\n*NODE\n1 0. 0. 0.\n"), AllOf(HasSubstr("deck.k:3:1"), HasSubstr("put commas between the fields")));
}

TEST(DynaDecks, BlankTitlesOfPartsAreTitles)
{
    const std::string text =
        "*KEYWORD\n" + strip_nodes +
        "*PART\n$# title\n\n$#     pid     secid\n         9         1\nhull\n         7         1\n\n*SET_NODE_LIST_TITLE\n\n3\n1,4\n";
    const Mesh mesh = deck(text);
    EXPECT_THAT(mesh.element_sets.at("hull"), ElementsAre(0, 1));
    EXPECT_THAT(select_nodes(mesh, "node_set_3"), ElementsAre(0, 3));
    EXPECT_THAT(deck("*KEYWORD\n" + strip_nodes + "*PART\nother\n9,1\n\nhull\n7,1\n").element_sets.at("hull"), ElementsAre(0, 1));
}

TEST(DynaDecks, ParametersStandForNumbersAndNames)
{
    const std::string parameters =
        "*PARAMETER\nR     one,1.,I n5, 5,R h,1.D0\nRminus    -1.\nCname     hull\n"
        "*PARAMETER_EXPRESSION\nR two     2*one+(&h-1.0)\nI n6      nint(max(5.6, 3.2)) + 7/8\nR zero    sqrt(one)\n            -h\n";
    const std::string mesh =
        "*NODE\n1,&zero,&zero,0\n2,&one,0,0\n3,&two,0,0\n4,0,-&minus,0\n&n5,&ONE,1,0\n       6            &two           &h               "
        "0\n"
        "*ELEMENT_SHELL\n11,7,1,2,&n5,4\n12,7,2,3,&n6,<n5>\n";
    expect_strip(deck("*KEYWORD\n" + parameters + mesh + strip_sets), "parameters");
    const auto with = [&](const std::string& text) { return deck_refusal("*KEYWORD\n" + text + strip_nodes); };
    EXPECT_THAT(with("*NODE\n9,&x,0,0\n"), AllOf(HasSubstr("deck.k:3:1"), HasSubstr("no parameter 'X'"), HasSubstr("*PARAMETER")));
    EXPECT_THAT(with("*PARAMETER\nx,1\n"), AllOf(HasSubstr("deck.k:3:1"), HasSubstr("R (real)")));
    EXPECT_THAT(with("*PARAMETER\nR x,one\n"), HasSubstr("'one' is not a number"));
    EXPECT_THAT(with("*PARAMETER\nR x,1\nR x,2\n"), AllOf(HasSubstr("deck.k:4:1"), HasSubstr("second time")));
    EXPECT_EQ(with("*PARAMETER\nR x,1\nR x,1.0\n*PARAMETER_MUTABLE\nI n,1\nI n,2\n"), "accepted");
    EXPECT_THAT(with("*PARAMETER_EXPRESSION\nR x,1/(2-2.)\n"), HasSubstr("a quotient has no finite value"));
    EXPECT_THAT(with("*PARAMETER_EXPRESSION\nR x,2*(1+3\n"), HasSubstr("')' is missing"));
    EXPECT_THAT(with("*PARAMETER_EXPRESSION\nR x,2 3\n"), HasSubstr("'3' follows"));
    EXPECT_THAT(with("*PARAMETER_EXPRESSION\nR x,2*\n"), HasSubstr("it ends where a number was expected"));
    EXPECT_THAT(with("*PARAMETER_EXPRESSION\nR x," + std::string(5000, '(') + "1\n"), HasSubstr("too deep"));
    EXPECT_THAT(with("*PARAMETER\nC name,hull\n*NODE\n9,&name,0,0\n"), HasSubstr("'hull' is not a number"));
    EXPECT_THAT(with("*PARAMETER_TYPE\n"), HasSubstr("*PARAMETER_TYPE is not read"));
}

/// The x of a node that is given by an expression.
double value_of(const std::string& expression)
{
    const std::string nodes = "*NODE\n1,&x,0,0\n2,1000,0,0\n3,0,1000,0\n*ELEMENT_SHELL\n1,1,1,2,3\n";
    return deck("*KEYWORD\n*PARAMETER\nI i,7,R a,2.5\n*PARAMETER_EXPRESSION\nR x       " + expression + "\n" + nodes).nodes[0].x;
}

TEST(DynaDecks, ExpressionsAreComputedAsFortranDoes)
{
    EXPECT_EQ(value_of("1 + 2*3 - 4/2"), 5);
    EXPECT_EQ(value_of("2/5"), 0);
    EXPECT_EQ(value_of("2.0/5"), 0.4);
    EXPECT_EQ(value_of("i/2 + &a"), 5.5);
    EXPECT_EQ(value_of("-3**2"), 9);  // the sign binds closer, as in LS-DYNA
    EXPECT_EQ(value_of("2**3**2"), 512);
    EXPECT_EQ(value_of("2.**-1"), 0.5);
    EXPECT_EQ(value_of("-(a - 1.5d0)*1e1 + .5E+0"), -9.5);
    EXPECT_EQ(value_of("mod(i, 4) + sign(2, -1) + min(3, 1, 2) + abs(-a)"), 4.5);
    EXPECT_NEAR(value_of("4*atan(1.0) - acos(-1.) + atan2(0, 1)"), 0, 1e-15);
    EXPECT_EQ(value_of("log10(100.) + exp(0) + int(2.9) + nint(2.6) + floor(-0.5) + ceil(0.1)"), 8);
}

TEST(DynaDecks, LocalParametersEndWithTheirFile)
{
    const DeckFolder folder;
    folder.write("deck.k", "*KEYWORD\n*PARAMETER\nR x,1.\n*INCLUDE\ninner/nodes.k\n*NODE\n2,&x,0,0\n" + strip_sets + "*END\n");
    folder.write("inner/nodes.k",
                 "*KEYWORD\n*PARAMETER_LOCAL\nR x,2.\nR y,1.\n*NODE\n1,0,0,0\n3,&x,0,0\n4,0,&y,0\n5,1,1,0\n6,2,1,0\n"
                 "*ELEMENT_SHELL\n11,7,1,2,5,4\n12,7,2,3,6,5\n*END\n");
    const Mesh mesh = folder.read("deck.k");
    EXPECT_EQ(mesh.element_sets.at("hull").size(), 2u);
    EXPECT_THAT(mesh.nodes, AllOf(Contains(Vector3d{1, 0, 0}), Contains(Vector3d{2, 0, 0})));
    folder.write("deck.k", "*KEYWORD\n*INCLUDE\ninner/nodes.k\n*NODE\n2,&y,0,0\n");
    EXPECT_THAT(folder.refusal("deck.k"), AllOf(HasSubstr("deck.k:5:1"), HasSubstr("no parameter 'Y'")));
}

TEST(DynaDecks, EndOfAnIncludedFileIsNotTheEndOfTheDeck)
{
    const DeckFolder folder;
    folder.write("inner/a.k", "*KEYWORD\n" + strip_nodes + "*END\nnot read\n");
    folder.write("inner/b.k", strip_sets + "*END");
    folder.write("list.k", "*KEYWORD\n*INCLUDE\ninner/a.k\n$ and\ninner\\b.k\n*END\n");
    expect_strip(folder.read("list.k"), "list");
    folder.write("path.k", "*KEYWORD\n*INCLUDE_PATH_RELATIVE\ninner\n*PARAMETER\nCa        a.k\n*INCLUDE\n&a\n*INCLUDE\nb +\n  .k\n");
    expect_strip(folder.read("path.k"), "path");
    std::string many = "*KEYWORD\n*INCLUDE\ninner/a.k\n";  // more files than may include one another
    for (int i = 0; i < 30; ++i) {
        folder.write(fmt::format("inner/{}.k", i), "*TITLE\nnothing\n");
        many += fmt::format("inner/{}.k\n", i);
    }
    folder.write("many.k", many + "*INCLUDE\ninner/b.k\n");
    expect_strip(folder.read("many.k"), "many");
    folder.write("inner/a.k", "*INCLUDE\n../list.k\n");
    EXPECT_THAT(folder.refusal("list.k"), AllOf(HasSubstr("a.k:2:1"), HasSubstr("includes itself")));
}

/// The strip made of its left square, included twice: the second time moved, with other numbers.
TEST(DynaDecks, TransformedFilesArePutInPlace)
{
    const DeckFolder folder;
    folder.write("square.k",
                 "*KEYWORD\n*NODE\n1,0,0,0\n2,1,0,0\n5,1,1,0\n4,0,1,0\n*ELEMENT_SHELL\n11,7,1,2,5,4\n*SET_NODE_LIST\n3\n1,4\n*"
                 "PART\nhull\n7,1\n*END\n");
    const std::string define = "*DEFINE_TRANSFORMATION\n         5\n";
    const auto include = [](const std::string& factors, const std::string& transformation) {
        return "*INCLUDE_TRANSFORM\nsquare.k\n$ offsets\n       100       200         0         0        50         0         0\n\n" +
               factors + "\n" + transformation + "\n";
    };
    const auto moved = [&](const std::string& steps, const std::string& factors = "") {
        folder.write("deck.k", "*KEYWORD\n*INCLUDE\nsquare.k\n" + define + steps + include(factors, "         5"));
        return folder.read("deck.k");
    };
    const Mesh mesh = moved("TRANSL          1.0\n");
    ASSERT_EQ(mesh.nodes.size(), 8u);
    EXPECT_EQ(mesh.nodes[5], (Vector3d{2, 0, 0}));
    EXPECT_EQ(mesh.elements[1].node, (std::array<std::uint32_t, 8>{4, 5, 6, 7}));
    EXPECT_EQ(mesh.elements[1].number, 211);
    EXPECT_THAT(mesh.element_sets.at("hull"), ElementsAre(0, 1));
    EXPECT_THAT(mesh.node_sets.at("node_set_3"), ElementsAre(0, 3));
    EXPECT_THAT(mesh.node_sets.at("node_set_53"), ElementsAre(4, 7));
    EXPECT_EQ(moved("SCALE,2.,3.\nTRANSL,0,0,4\n").nodes[6], (Vector3d{2, 3, 4}));
    EXPECT_EQ(moved("TRANSL,0,0,4\nSCALE,2.,3.,.5\n").nodes[6], (Vector3d{2, 3, 2}));
    EXPECT_LT(norm(moved("ROTATE,0,0,2,1,0,0,90.\n").nodes[6] - Vector3d{0, 0, 0}), 1e-15);  // (1, 1) about (1, 0)
    EXPECT_LT(norm(moved("POINT,1,1.,0,0\nPOINT,2,1.,0,5.\nTRANSL,1.\nROTATE,1,2,90.\n").nodes[6] - Vector3d{1, 0, 0}), 1e-15);
    EXPECT_EQ(moved("MIRROR,1,0,0,3,0,0\n").nodes[4], (Vector3d{2, 0, 0}));
    EXPECT_EQ(moved("SCALE,2.,2.,2.\n", ",,0.5").nodes[6], (Vector3d{1, 1, 0}));
    folder.write("deck.k", "*KEYWORD\n*INCLUDE\nsquare.k\n" + define + "TRANSL,1.\n" + include(",,0.001", "5"));
    EXPECT_THAT(folder.refusal("deck.k"), AllOf(HasSubstr("deck.k:13:1"), HasSubstr("SCALE")));
    folder.write("deck.k", "*KEYWORD\n*INCLUDE\nsquare.k\n" + include("", "6"));
    EXPECT_THAT(folder.refusal("deck.k"), AllOf(HasSubstr("deck.k:10:1"), HasSubstr("no transformation 6")));
    folder.write("deck.k", "*KEYWORD\n*INCLUDE_TRANSFORM\nsquare.k\n -1\n");
    EXPECT_THAT(folder.refusal("deck.k"), AllOf(HasSubstr("square.k:3:1"), HasSubstr("1 becomes 0")));
    folder.write("deck.k", "*KEYWORD\n" + define + "POS6P,1\n");
    EXPECT_THAT(folder.refusal("deck.k"), AllOf(HasSubstr("deck.k:4:1"), HasSubstr("'POS6P' in a transformation")));
}

TEST(DynaDecks, IncludedFilesMayIncludeTransformedOnes)
{
    const DeckFolder folder;
    folder.write("deck.k",
                 "*KEYWORD\n*DEFINE_TRANSFORMATION\n1\nTRANSL,10.\n*DEFINE_TRANSFORMATION_TITLE\nup\n2\nSCALE,2.,2.,2.\n"
                 "*INCLUDE_TRANSFORM\ninner/pair.k\n1000\n\n\n1\n*END\n");
    folder.write("inner/pair.k", "*INCLUDE_TRANSFORM\nstrip.k\n10\n\n\n2\n*END\n");
    folder.write("inner/strip.k", "*KEYWORD\n" + strip_nodes + strip_sets + "*END\n");
    const Mesh mesh = folder.read("deck.k");
    EXPECT_EQ(mesh.nodes[5], (Vector3d{14, 2, 0}));  // (2, 1): first doubled, then moved by 10
    EXPECT_THAT(select_nodes(mesh, "edge"), ElementsAre(0, 3));
}

TEST(DynaDecks, SolidsInAMirrorKeepTheirVolume)
{
    const DeckFolder folder;
    folder.write("solids.k",
                 "*KEYWORD\n*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n9,.5,.5,2\n"
                 "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n2,2,5,6,7,9,9,9,9,9\n*END\n");
    folder.write("deck.k", "*KEYWORD\n*DEFINE_TRANSFORMATION\n1\nMIRROR,0,0,0,0,0,1\n*INCLUDE_TRANSFORM\nsolids.k\n\n\n\n1\n*END\n");
    const Mesh mesh = folder.read("deck.k");
    for (const MeshElement& element : mesh.elements) EXPECT_GT(scaled_jacobian(mesh, element), 0.3);
    EXPECT_EQ(mesh.nodes[4].z, -1);
}

TEST(DynaDecks, NodesOfASetAreTransformed)
{
    const std::string text = "*KEYWORD\n*DEFINE_TRANSFORMATION\n4\nTRANSL,-1.\n*NODE_TRANSFORM\n4,3\n" + strip_nodes + strip_sets;
    EXPECT_EQ(deck(text).nodes[3], (Vector3d{-1, 1, 0}));
    EXPECT_EQ(deck(text).nodes[1], (Vector3d{1, 0, 0}));
    EXPECT_THAT(deck_refusal("*KEYWORD\n*DEFINE_TRANSFORMATION\n4\nTRANSL,-1.\n*NODE_TRANSFORM\n4,5\n" + strip_nodes),
                AllOf(HasSubstr("deck.k:6:1"), HasSubstr("no set 'node_set_5'")));
}

TEST(DynaDecks, SetsOfEveryForm)
{
    const auto set = [](const std::string& text, const std::string& name) {
        return select_nodes(deck("*KEYWORD\n*SET_PART_LIST_GENERATE\n8\n1,9\n" + text + strip_nodes + strip_sets), name);
    };
    EXPECT_THAT(set("*SET_NODE_LIST_GENERATE\n1\n1,2,5,6\n", "node_set_1"), ElementsAre(0, 1, 4, 5));
    EXPECT_THAT(set("*SET_NODE_LIST_GENERATE_INCREMENT_TITLE\nodd\n1\n1,6,2\n", "odd"), ElementsAre(0, 2, 4));
    EXPECT_THAT(set("*SET_NODE_COLUMN\n1\n2,0.5\n3,0.5\n", "node_set_1"), ElementsAre(1, 2));
    EXPECT_THAT(set("*SET_NODE_ADD\n1\n2,3\n*SET_NODE\n2\n6\n", "node_set_1"), ElementsAre(0, 3, 5));
    EXPECT_THAT(set("*SET_NODE_LIST_COLLECT\n1\n2\n*SET_NODE_LIST_COLLECT\n1\n3\n", "node_set_1"), ElementsAre(1, 2));
    EXPECT_THAT(set("*SET_NODE_GENERAL\n1\nSET_SHELL,2\nNODE,1\n*SET_SHELL_LIST\n2\n12\n", "node_set_1"), ElementsAre(0, 1, 2, 4, 5));
    EXPECT_THAT(set("*SET_SHELL_LIST_GENERATE\n2\n12,99\n", "shell_set_2"), ElementsAre(1, 2, 4, 5));
    EXPECT_THAT(set("", "part_set_8"), ElementsAre(0, 1, 2, 3, 4, 5));
    EXPECT_THAT(deck_refusal("*KEYWORD\n*SET_NODE_LIST_GENERATE\n1\n5,2\n"), AllOf(HasSubstr("deck.k:4:1"), HasSubstr("backwards")));
    const Mesh mesh = deck("*KEYWORD\n" + strip_nodes + strip_sets + "*SET_PART\n2\n7,55\n*SET_BEAM\n2\n1\n*SET_NODE_INTERSECT\n9\n1\n");
    EXPECT_THAT(mesh.element_sets.at("part_set_2"), ElementsAre(0, 1));
    EXPECT_THAT(mesh.remarks, Contains(HasSubstr("parts without shells or solids: 55")));
    EXPECT_THAT(mesh.remarks, Contains(AllOf(HasSubstr("*SET_BEAM"), HasSubstr("*SET_NODE_INTERSECT"))));
}

TEST(DynaDecks, BeamsSpringsAndMassesAreCountedAndLeftOut)
{
    const Mesh mesh = deck("*KEYWORD\n" + strip_nodes + strip_sets + "*ELEMENT_BEAM\n1,5,1,2,4\n2,5,2,3,4\n*ELEMENT_DISCRETE\n1,6,3,0\n" +
                           "*ELEMENT_MASS\n1,6,2.5\n*ELEMENT_BEAM_ORIENTATION\n3,5,1,2\n1.,0.,0.\n");
    EXPECT_EQ(mesh.elements.size(), 2u);
    EXPECT_THAT(mesh.remarks, Contains(HasSubstr("2 elements of *ELEMENT_BEAM are not computed")));
    EXPECT_THAT(mesh.remarks, Contains(AllOf(HasSubstr("*ELEMENT_MASS, 1"), HasSubstr("point_masses"))));
    EXPECT_THAT(mesh.remarks, Contains(HasSubstr("*ELEMENT_BEAM_ORIENTATION")));
    EXPECT_THAT(select_nodes(mesh, "part_5"), ElementsAre(0, 1, 2));
    EXPECT_THAT(select_nodes(mesh, "element_mass"), ElementsAre(5));
}

TEST(DynaDecks, ThicknessesAreTold)
{
    const std::string sections = "*SECTION_SHELL_TITLE\nlaminate\n4,2,,2,,,1\n3.,3.,3.,3.\n0.,90.\n\n1,16,,5\n       8.0       8.0\n";
    const Mesh mesh = deck("*KEYWORD\n" + strip_nodes + strip_sets + sections + "*SECTION_SHELL\n2,2\n5.\n3,2\n6.\n" +
                           "*SECTION_SHELL\n9,101\nits,own\n");
    EXPECT_THAT(mesh.remarks, ElementsAre(AllOf(HasSubstr("the case says them"), HasSubstr(": part_7 8"))));
    EXPECT_THAT(deck_refusal("*KEYWORD\n" + strip_nodes + "*SECTION_SHELL\n1\nthick\n"), HasSubstr("'thick' is not a number"));
}

TEST(DynaDecks, CutOrDamagedDecksAreReadOrRefusedButNeverMore)
{
    const std::string whole =
        "*KEYWORD\n*PARAMETER\nR     one,1.,I n5, 5\n*PARAMETER_EXPRESSION\nR two     2*one+min(&n5,1)**2\n*DEFINE_TRANSFORMATION\n4\n"
        "POINT,1,0,0,1\nROTATE,0,0,1,0,0,0,9.\nMIRROR,0,0,0,1,0,0\n*NODE_TRANSFORM\n4,3\n" +
        strip_nodes + strip_sets + "*SET_NODE_GENERAL\n1\nPART,7\n*SET_PART_LIST_GENERATE\n2\n1,9\n*ELEMENT_BEAM\n1,5,1,2,4\n*NODE +\n";
    int refused = 0;
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>("9,*x\n &<(-"[at % 10]);
        refused += deck_refusal(damaged) != "accepted";  // anything but InputError ends the test
        refused += deck_refusal(whole.substr(0, at)) != "accepted";
    }
    EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace corpuscle
