#include "input/spherical_start.hpp"

#include <gmock/gmock.h>

#include "input/case/read_case.hpp"
#include "input/presets.hpp"
#include "input/survey.hpp"

using namespace corpuscle;
using ::testing::HasSubstr;

namespace {

const std::filesystem::path source = CORPUSCLE_SOURCE_DIR;

/// The example of the plate with a spherical start, and changes.
CaseDescription plate(std::vector<std::string> settings = {})
{
    settings.insert(settings.begin(), {"gas.particles=20_000", "gas.start=\"spherical\""});
    CaseDescription description = read_case(source / "examples/01_plate/case.toml", settings);
    resolve_presets(description, {source / "share"});
    return description;
}

std::string refusal(const CaseDescription& description)
{
    try {
        static_cast<void>(survey_case(description));
    } catch (const InputError& error) {
        EXPECT_TRUE(error.place().known());
        return std::string(error.what());
    }
    return "";
}

}  // namespace

TEST(SphericalStart, RefusesWhereItDoesNotApply)
{
    EXPECT_THAT(refusal(plate({"charge.0.detonation.0.point=[0, 0, 0.75]"})), HasSubstr("not lit at its center"));
    EXPECT_THAT(refusal(plate({"charge.0.shape=\"cylinder\""})), HasSubstr("no sphere"));
    EXPECT_THAT(refusal(plate({"charge.0.center=[0, 0, 0.15]", "charge.0.detonation.0.point=[0, 0, 0.15]"})),
                HasSubstr("m from the charge's center"));
    EXPECT_THAT(refusal(plate({"end_time=\"1 us\""})), HasSubstr("meets nothing before end_time"));
    CaseDescription twice = plate();
    twice.charges.push_back(twice.charges[0]);
    EXPECT_THAT(refusal(twice), HasSubstr("with 2 charges"));
    CaseDescription vacuum = plate();
    vacuum.gas->fill.reset();
    EXPECT_THAT(refusal(vacuum), HasSubstr("without a gas all around"));
    // A plane through the charge that is not rigid is no plane of symmetry, but an obstacle at no distance.
    EXPECT_NE(refusal(plate({"gas.edges.x=[\"open\", \"ambient\"]"})), "");
}
