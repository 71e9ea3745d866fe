#include "input/spherical_start.hpp"

#include <gmock/gmock.h>

#include "input/survey.hpp"
#include "spherical_plate.hpp"

using namespace corpuscle;
using ::testing::HasSubstr;

namespace {

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
    EXPECT_THAT(refusal(spherical_plate({"charge.0.detonation.0.point=[0, 0, 0.75]"})), HasSubstr("not lit at its center"));
    EXPECT_THAT(refusal(spherical_plate({"charge.0.shape=\"cylinder\""})), HasSubstr("no sphere"));
    EXPECT_THAT(refusal(spherical_plate({"charge.0.center=[0, 0, 0.15]", "charge.0.detonation.0.point=[0, 0, 0.15]"})),
                HasSubstr("m from the charge's center"));
    EXPECT_THAT(refusal(spherical_plate({"end_time=\"1 us\""})), HasSubstr("meets nothing before end_time"));
    CaseDescription twice = spherical_plate();
    twice.charges.push_back(twice.charges[0]);
    EXPECT_THAT(refusal(twice), HasSubstr("with 2 charges"));
    CaseDescription vacuum = spherical_plate();
    vacuum.gas->fill.reset();
    EXPECT_THAT(refusal(vacuum), HasSubstr("without a gas all around"));
    // A plane through the charge that is not rigid is no plane of symmetry, but an obstacle at no distance.
    EXPECT_NE(refusal(spherical_plate({"gas.edges.x=[\"open\", \"ambient\"]"})), "");
}
