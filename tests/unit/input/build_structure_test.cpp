#include "input/build_structure.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "input/case/read_case.hpp"
#include "input/presets.hpp"

namespace corpuscle {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

/// A case of one part from the sheet of four quadrilaterals and eight triangles, with further words of the part and further tables.
CaseDescription sheet(const std::string& words, const std::string& tables = "")
{
    const std::string data = std::string(CORPUSCLE_SOURCE_DIR) + "/tests/data/meshes/";
    const std::string text = "end_time = 1\n[[part]]\nname = \"sheet\"\nmesh = { file = \"" + data +
                             "sheet_4.1_text.msh\", group = \"quads\" }\nelement = { shell = { thickness = 0.1 } }\n"
                             "material = \"elastic_steel\"\n" +
                             words + "\n" + tables;
    CaseDescription description = read_case_text(text, "case.toml");
    resolve_presets(description, {std::filesystem::path(CORPUSCLE_SOURCE_DIR) / "share"});
    return description;
}

TEST(BuildStructure, APartOfAFileKeepsWhatOfTheOtherSetsIsInIt)
{
    const CaseDescription description = sheet("");
    const Mesh mesh = make_mesh(description.parts[0], description);
    EXPECT_THAT(mesh.elements, SizeIs(4));
    EXPECT_THAT(mesh.element_sets.at("all of it"), SizeIs(4));
    EXPECT_THAT(mesh.node_sets.at("left edge"), SizeIs(3));
    EXPECT_FALSE(mesh.node_sets.contains("curve_9"));  // of the other half
    EXPECT_GT(mesh.elements[0].number, 0);
}

TEST(BuildStructure, TellsQualityAndStepByTheFilesNumbers)
{
    StructureNotes notes;
    const Structure structure = build_structure(sheet(""), notes);
    ASSERT_THAT(notes.parts, SizeIs(1));
    const PartReport& report = notes.parts[0];
    EXPECT_EQ(report.elements, 4u);
    EXPECT_NEAR(report.mass, structure.parts[0].material.density * 0.1, 1e-9);
    EXPECT_NEAR(report.quality.min_scaled_jacobian, 1, 1e-6);
    EXPECT_DOUBLE_EQ(report.step, stable_step(structure));
    EXPECT_NEAR(report.usual_step / report.step, 1, 1e-6);  // squares of one size, but for the digits of the file
    EXPECT_THAT(structure.parts[0].element_numbers, testing::Contains(report.slowest));
    EXPECT_THAT(report.text(), HasSubstr("part 'sheet': 4 shell elements, 9 nodes"));
}

TEST(BuildStructure, SetsOfShellsHaveThicknessesOfTheirOwn)
{
    CaseDescription description = sheet("");
    description.parts[0].mesh.group = "all of it";
    description.parts[0].element.shell->sets = {{"quads", 0.3, {}}};
    StructureNotes notes;
    const Structure structure = build_structure(description, notes);
    const double density = structure.parts[0].material.density;
    EXPECT_NEAR(notes.parts[0].mass, density * (0.3 + 0.1), 1e-6 * density);  // two squares of 1 m2
    description.parts[0].element.shell->sets[0].set = "quad";
    EXPECT_THROW((void)build_structure(description, notes), InputError);
}

TEST(BuildStructure, SetsNodesMovingAndDrivesThem)
{
    StructureNotes notes;
    const Structure structure = build_structure(sheet("velocity = [1, 2, 3]\nstart = [{ where = \"x=1\", velocity = [7, 0, 0] }]\n"
                                                      "drive = [{ where = \"left edge\", dof = \"z\", velocity = [[0, 4], [1, 6]] }]"),
                                                notes);
    const Nodes& nodes = structure.nodes;
    ASSERT_THAT(structure.drives, SizeIs(1));
    EXPECT_THAT(structure.drives[0].nodes, SizeIs(3));
    EXPECT_DOUBLE_EQ(structure.drives[0].way(0, 1), 5);
    for (std::uint32_t n = 0; n < nodes.size(); ++n) {
        const double x = nodes.reference[n].x;
        const bool left = std::abs(x) < 1e-6, right = std::abs(x - 1) < 1e-6;
        EXPECT_EQ(nodes.velocity[n], left ? (Vector3d{1, 2, 4}) : right ? (Vector3d{7, 0, 0}) : (Vector3d{1, 2, 3}));
        EXPECT_EQ(nodes.inverse_mass[n].z == 0, left);
    }
}

TEST(BuildStructure, FindsTheNodesOfLoads)
{
    StructureNotes notes;
    (void)build_structure(
        sheet("",
              "[[load]]\npart = \"sheet\"\nforce = [[0, 0], [\"2 ms\", \"3 kN\"]]\ndirection = [0, 0, 1]\nwhere = \"left edge\"\n"
              "[[load]]\npart = \"sheet\"\npressure = \"2 bar\"\n"),
        notes);
    ASSERT_THAT(notes.loads, SizeIs(2));
    EXPECT_THAT(notes.loads[0].where.nodes, SizeIs(3));
    EXPECT_DOUBLE_EQ(notes.loads[0].curve.value(1e-3), 1500);
    EXPECT_THAT(notes.loads[1].where.nodes, SizeIs(9));
    EXPECT_DOUBLE_EQ(notes.loads[1].curve.value(9), 2e5);
}

}  // namespace
}  // namespace corpuscle
