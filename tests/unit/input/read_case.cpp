#include "input/case/read_case.hpp"

#include <gmock/gmock.h>

#include "input/presets.hpp"
#include "schema/problems.hpp"

using namespace corpuscle;
using ::testing::HasSubstr;
using ::testing::SizeIs;

namespace {

const std::filesystem::path source = CORPUSCLE_SOURCE_DIR;

const std::string plate = R"(title = "plate"
end_time = "3 ms"

[[charge]]
explosive = "tnt"
shape = "sphere"
mass = "15 kg"
center = [0, 0, "700 mm"]

[gas]
box = [[0, "1200 mm"], [0, "1200 mm"], ["-200 mm", "1400 mm"]]
edges = { x = ["rigid", "ambient"], y = ["rigid", "ambient"] }
particles = 200_000
fill = "air"

[[part]]
name = "plate"
mesh = { disk = { radius = "500 mm", element_size = "20 mm", quarter = true } }
element = { shell = { thickness = "20 mm" } }
material = "rha_steel"
fix = [{ where = "rim", dof = "all" }]
)";

std::string refusal(const std::string& text, const std::vector<std::string>& settings = {})
{
    try {
        static_cast<void>(read_case_text(text, "case.toml", settings));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

}  // namespace

TEST(ReadCase, ReadsThePlate)
{
    const CaseDescription d = read_case_text(plate, "case.toml");
    EXPECT_DOUBLE_EQ(d.end_time, 3e-3);
    ASSERT_THAT(d.charges, SizeIs(1));
    EXPECT_EQ(d.charges[0].explosive.name, "tnt");
    EXPECT_EQ(d.charges[0].shape.form, ChargeForm::sphere);
    EXPECT_DOUBLE_EQ(*d.charges[0].mass, 15);
    EXPECT_DOUBLE_EQ(d.charges[0].center->z, 0.7);
    ASSERT_TRUE(d.gas.has_value());
    EXPECT_DOUBLE_EQ(d.gas->box[2][0], -0.2);
    EXPECT_EQ(d.gas->edges.x[0], Edge::rigid);
    EXPECT_EQ(d.gas->edges.z[1], Edge::ambient);  // by default
    EXPECT_EQ(*d.gas->particles.total, 200'000u);
    EXPECT_DOUBLE_EQ(d.gas->cfl, GasSettings{}.cfl);
    ASSERT_THAT(d.parts, SizeIs(1));
    EXPECT_DOUBLE_EQ(d.parts[0].element.shell->thickness, 0.02);
    EXPECT_EQ(d.parts[0].element.shell->points, 5);
    EXPECT_EQ(d.parts[0].fix[0].dof, Held::all);
    EXPECT_EQ(d.charges[0].places.of("mass").line, 7);
    EXPECT_EQ(d.charges[0].places.of("mass").column, 8);
}

TEST(ReadCase, SettingsChangeValues)
{
    const CaseDescription d =
        read_case_text(plate, "case.toml",
                       {"charge.0.mass=20 kg", "end_time=\"1 ms\"", "charge.0.explosive=c4", "gas.particles={ products = 10, air = 20 }",
                        "output.fields_every=10 us", "gas.edges.z=[\"open\", \"open\"]"});
    EXPECT_DOUBLE_EQ(*d.charges[0].mass, 20);
    EXPECT_DOUBLE_EQ(d.end_time, 1e-3);
    EXPECT_EQ(d.charges[0].explosive.name, "c4");
    EXPECT_FALSE(d.gas->particles.total.has_value());
    EXPECT_EQ(*d.gas->particles.air, 20u);
    EXPECT_DOUBLE_EQ(*d.output.fields_every, 1e-5);
    EXPECT_EQ(d.gas->edges.z[0], Edge::open);
}

TEST(ReadCase, WrongSettingsNameThemselves)
{
    EXPECT_THAT(refusal(plate, {"charge.0.mass=20 m"}), HasSubstr("--set charge.0.mass: mass: \"20 m\" is a length; expected a mass"));
    EXPECT_THAT(refusal(plate, {"charge.0.mas=20 kg"}),
                HasSubstr("--set charge.0.mas: unknown key 'mas' in 'charge'; did you mean 'mass'?"));
    EXPECT_THAT(refusal(plate, {"charge.7.mass=20 kg"}), HasSubstr("there is no entry 7: the list has 1"));
    EXPECT_THAT(refusal(plate, {"charge.first.mass=20 kg"}), HasSubstr("'first' is no index"));
    EXPECT_THAT(refusal(plate, {"end_time"}), HasSubstr("has no key and value"));
    EXPECT_THAT(refusal(plate, {"end_time=0"}), HasSubstr("--set end_time: end_time = 0 is out of range"));
}

TEST(ReadCase, MistakesAreNamedWithTheirPlace)
{
    EXPECT_THAT(refusal(replaced(plate, "mass =", "masss =")),
                HasSubstr("case.toml:7:1: unknown key 'masss' in 'charge'; did you mean 'mass'?"));
    EXPECT_THAT(refusal(replaced(plate, "\"15 kg\"", "\"15 mm\"")),
                HasSubstr("case.toml:7:8: mass: \"15 mm\" is a length; expected a mass"));
    EXPECT_THAT(refusal(replaced(plate, "\"15 kg\"", "true")), HasSubstr("case.toml:7:8: 'mass' is true or false; expected number > 0"));
    EXPECT_THAT(refusal(replaced(plate, "\"15 kg\"", "-15")),
                HasSubstr("case.toml:7:8: mass = -15 is out of range; expected a number > 0 kg"));
    EXPECT_THAT(refusal(replaced(plate, "end_time = \"3 ms\"", "end_time = 0")),
                HasSubstr("case.toml:2:12: end_time = 0 is out of range; expected a number > 0 s"));
    EXPECT_THAT(refusal(replaced(plate, "particles = 200_000", "particles = 0")), HasSubstr("case.toml:13:13: total = 0 is out of range"));
    EXPECT_THAT(refusal(replaced(plate, "end_time = \"3 ms\"", "")), HasSubstr("the case has no 'end_time'"));
    EXPECT_THAT(refusal(replaced(plate, "{ disk =", "{ disc =")), HasSubstr("did you mean 'disk'?"));
}

TEST(ReadCase, WhatIsNoTomlIsRefusedAtItsPlace)
{
    EXPECT_THAT(refusal(replaced(plate, "mass = \"15 kg\"", "mass = 15 kg")), HasSubstr("case.toml:7:"));
    EXPECT_THAT(refusal(replaced(plate, "title = \"plate\"", "title = \"plate\"\ntitle = \"again\"")), HasSubstr("case.toml:2:"));
    EXPECT_THAT(refusal("*KEYWORD\n*END\n"), HasSubstr("LS-DYNA"));
    EXPECT_THAT(refusal(""), HasSubstr("the case has no 'end_time'"));
}

TEST(ReadCase, AllUnknownKeysAtOnce)
{
    const std::string two = replaced(replaced(plate, "title =", "titel ="), "particles =", "particels =");
    try {
        static_cast<void>(read_case_text(two, "case.toml"));
        FAIL() << "nothing was thrown";
    } catch (const InputProblems& problems) {
        ASSERT_THAT(problems.all(), SizeIs(3));  // two unknown keys, and [gas] without its particles
        EXPECT_EQ(problems.all()[0].place().line, 1);
    }
}

TEST(ReadCase, TheResolvedCaseReadsBackTheSame)
{
    CaseDescription first = read_case(source / "examples/01_plate/case.toml");
    resolve_presets(first, {source / "share"});
    const std::string resolved = resolved_case(first);
    const CaseDescription second = read_case_text(resolved, "resolved");
    EXPECT_EQ(resolved, resolved_case(second));
    EXPECT_THAT(resolved, HasSubstr("cfl = "));
    EXPECT_DOUBLE_EQ(second.charges[0].explosive.values->density, 1630);
}

TEST(Presets, UnknownNamesGetTheNearestAndTheList)
{
    CaseDescription d = read_case_text(replaced(plate, "\"tnt\"", "\"tmt\""), "case.toml");
    try {
        resolve_presets(d, {source / "share"});
        FAIL() << "nothing was thrown";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("case.toml:5:13: unknown explosive 'tmt'; did you mean 'tnt'"));
        EXPECT_THAT(error.what(), HasSubstr("c4"));
    }
}

TEST(Presets, EveryPresetOfTheProgramIsRead)
{
    const std::vector<std::filesystem::path> folders{source / "share"};
    for (const PresetEntry& entry : list_presets(PresetKind::explosives, folders)) {
        CaseDescription d = read_case_text(replaced(plate, "\"tnt\"", "\"" + entry.name + "\""), "case.toml");
        EXPECT_NO_THROW(resolve_presets(d, folders)) << entry.name;
        EXPECT_FALSE(d.charges[0].explosive.values->source.empty()) << entry.name;
    }
    for (const PresetEntry& entry : list_presets(PresetKind::materials, folders)) {
        CaseDescription d = read_case_text(replaced(plate, "\"rha_steel\"", "\"" + entry.name + "\""), "case.toml");
        EXPECT_NO_THROW(resolve_presets(d, folders)) << entry.name;
        EXPECT_FALSE(d.parts[0].material->values->source.empty()) << entry.name;
    }
    for (const PresetEntry& entry : list_presets(PresetKind::gases, folders)) {
        CaseDescription d = read_case_text(replaced(plate, "\"air\"", "\"" + entry.name + "\""), "case.toml");
        EXPECT_NO_THROW(resolve_presets(d, folders)) << entry.name;
        EXPECT_FALSE(d.gas->fill->values->source.empty()) << entry.name;
    }
    EXPECT_GE(list_presets(PresetKind::explosives, folders).size(), 3u);
}

TEST(Presets, EarlierFoldersComeFirst)
{
    const std::filesystem::path own = std::filesystem::temp_directory_path() / "corpuscle_test_presets";
    std::filesystem::create_directories(own / "explosives");
    std::filesystem::copy_file(source / "share/explosives/c4.toml", own / "explosives/tnt.toml",
                               std::filesystem::copy_options::overwrite_existing);
    CaseDescription d = read_case_text(plate, "case.toml");
    resolve_presets(d, {own, source / "share"});
    EXPECT_DOUBLE_EQ(d.charges[0].explosive.values->density, 1601);
    std::filesystem::remove_all(own);
}

TEST(Presets, ValuesInPlaceNeedNoPreset)
{
    CaseDescription d =
        read_case_text(replaced(plate, "fill = \"air\"", "fill = { gamma = 1.3, density = 1.0, pressure = 1e5 }"), "case.toml");
    resolve_presets(d, {source / "share"});
    EXPECT_DOUBLE_EQ(*d.gas->fill->values->gamma, 1.3);
}
