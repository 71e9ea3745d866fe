#include "input/doubts.hpp"

#include <gmock/gmock.h>

#include "input/build_structure.hpp"
#include "input/case/read_case.hpp"
#include "input/presets.hpp"

namespace corpuscle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The warnings about a part named "p" that is made of these lines, and further tables.
std::vector<std::string> warnings_of(const std::string& lines, const std::string& tables = "")
{
    CaseDescription description = read_case_text("end_time = 1\n[[part]]\nname = \"p\"\n" + lines + "\n" + tables, "case.toml");
    resolve_presets(description, {std::filesystem::path(CORPUSCLE_SOURCE_DIR) / "share"});
    StructureNotes notes;
    (void)build_structure(description, notes);
    return notes.warnings;
}

const std::string square = "mesh = { rectangle = { edge_1 = [0.2, 0, 0], edge_2 = [0, 0.2, 0], element_size = 0.1 } }\n";
const std::string shells = "element = { shell = { thickness = 0.005 } }\n", steel = "material = \"mild_steel\"\n";
const std::string wall = "element = \"rigid\"\nfix = [{ where = \"all\", dof = \"all\" }]\n";

/// A material of its own, of these elastic constants and strength.
std::string material(const std::string& density, const std::string& modulus, const std::string& strength)
{
    return "material = { density = " + density + ", young_modulus = " + modulus + ", poisson_ratio = 0.3, strength = { " + strength +
           " } }\n";
}

TEST(Doubts, HasNoneOfWhatIsUsual)
{
    EXPECT_THAT(warnings_of(square + shells + steel + "erosion = { plastic_strain = 0.3, step = 1e-8 }\n"), IsEmpty());
    EXPECT_THAT(warnings_of(square + wall), IsEmpty());
    EXPECT_THAT(warnings_of(square + "element = { rigid = { mass = 1 } }\nspin = [0, 0, 1]\nvelocity = [1, 0, 0]\n"), IsEmpty());
    EXPECT_THAT(warnings_of(square + "element = { membrane = { thickness = 0.001 } }\nmaterial = \"fabric_nylon\"\n"), IsEmpty());
    EXPECT_THAT(warnings_of(square + shells + material("1000", "1e6", "elastic = {}")), IsEmpty());  // rubber
}

TEST(Doubts, NamesWhatHasNoEffectOnRigidParts)
{
    EXPECT_THAT(warnings_of(square + "element = { rigid = { mass = 1 } }\nerosion = { plastic_strain = 0.2 }\n"),
                ElementsAre(HasSubstr("part 'p': it is rigid: its erosion has no effect")));
    EXPECT_THAT(warnings_of(square + wall + "velocity = [1, 0, 0]\n"), ElementsAre(HasSubstr("its velocity at the start has no effect")));
    EXPECT_THAT(warnings_of(square + wall + "spin = [1, 0, 0]\n"), ElementsAre(HasSubstr("its velocity at the start has no effect")));
    EXPECT_THAT(warnings_of(square + wall + "point_masses = [{ where = \"all\", mass = 1 }]\n"),
                ElementsAre(HasSubstr("its point masses have no effect")));
}

TEST(Doubts, SeesUnitsThatWereForgotten)
{
    const std::string plain = "elastic = {}";
    for (const auto& [density, modulus] : {std::pair{"7850", "210_000"}, {"7850", "210"}, {"7.85", "2.1e11"}, {"7.85e-9", "2.1e11"}})
        EXPECT_THAT(warnings_of(square + shells + material(density, modulus, plain)), ElementsAre(HasSubstr("let sound run at")))
            << density << " " << modulus;
    for (const std::string law : {"bilinear = { yield_stress = 355 }", "johnson_cook = { A = 2e10 }",
                                  "curve = { curves = [{ plastic_strain = [0, 0.1], stress = [300, 400] }] }"})
        EXPECT_THAT(warnings_of(square + shells + material("7850", "2.1e11", law)), ElementsAre(HasSubstr("a strain of"))) << law;
    EXPECT_THAT(warnings_of(square + "element = { shell = { thickness = 5 } }\n" + steel),
                ElementsAre(HasSubstr("its shells are 5 m thick, and it is only 0.2 m wide")));
}

TEST(Doubts, NamesLimitsAndExponentsWithoutEffect)
{
    EXPECT_THAT(warnings_of(square + shells + material("7850", "2.1e11", "bilinear = { yield_stress = 3e8, rate_p = 5 }")),
                ElementsAre(HasSubstr("rate_p but no rate_c")));
    EXPECT_THAT(warnings_of(square + shells + "material = \"elastic_steel\"\nerosion = { plastic_strain = 0.2 }\n"),
                ElementsAre(HasSubstr("its material does not yield")));
    EXPECT_THAT(warnings_of(square + shells + steel + "erosion = { step = \"1 ms\" }\n"),
                ElementsAre(HasSubstr("4 of its 4 elements have a stable step below that of its erosion (0.001 s)")));
}

TEST(Doubts, MissesTheSupportsOfAQuarter)
{
    const std::string disk =
        "mesh = { disk = { radius = 0.3, element_size = 0.1, quarter = true }, move = [0.1, 0, 0] }\n" + shells + steel;
    const std::string x = "{ where = \"x=0.1\", dof = \"symmetry\" }", y = "{ where = \"y=0\", dof = \"symmetry\" }";
    EXPECT_THAT(warnings_of(disk + "fix = [" + x + ", " + y + "]\n"), IsEmpty());
    EXPECT_THAT(warnings_of(disk + "fix = [" + y + "]\n"),
                ElementsAre(HasSubstr("its edge x=0.1 is not held: fix = [{ where = \"x=0.1\", dof = \"symmetry\" }]")));
    EXPECT_THAT(warnings_of(disk + "fix = [{ where = \"rim\", dof = \"all\" }]\n"),
                ElementsAre(HasSubstr("its edge x=0.1"), HasSubstr("its edge y=0")));
}

TEST(Doubts, MissesPartsInTheBoxOfTheGas)
{
    const std::string gas = "[gas]\nbox = [[0, 1], [0, 1], [0, 1]]\nparticles = 100\nfill = \"air\"\n";
    EXPECT_THAT(warnings_of(square + shells + steel, gas), IsEmpty());
    const std::string moved =
        "mesh = { rectangle = { edge_1 = [0.2, 0, 0], edge_2 = [0, 0.2, 0], element_size = 0.1 }, move = [5, 0, 0] }\n";
    EXPECT_THAT(warnings_of(moved + shells + steel, gas), ElementsAre(HasSubstr("part 'p': it lies outside the box of the gas")));
    const std::string grid = "[euler]\nbox = [[0, 1], [0, 1], [0, 1]]\ncell_size = 0.1\nfill = \"air\"\n";
    EXPECT_THAT(warnings_of(square + shells + steel, grid), IsEmpty());
    EXPECT_THAT(warnings_of(moved + shells + steel, grid), ElementsAre(HasSubstr("it lies outside the box of the gas")));
}

}  // namespace
}  // namespace corpuscle
