#include <gmock/gmock.h>

#include "input/survey.hpp"
#include "unit/input/euler_case.hpp"

using namespace corpuscle;
using ::testing::HasSubstr;

namespace {

std::string refused_start(const CaseDescription& description)
{
    try {
        static_cast<void>(survey_case(description));
    } catch (const InputError& error) {
        EXPECT_TRUE(error.place().known()) << error.what();
        return error.what();
    }
    return "";
}

}  // namespace

TEST(GridStart, RefusesWhereItDoesNotApply)
{
    const std::string start = "euler.start=spherical";
    EXPECT_THAT(refused_start(grid_case(octant_grid, "", {start, "charge.0.shape=cylinder"})), HasSubstr("no sphere"));
    EXPECT_THAT(refused_start(grid_case(octant_grid, "", {start, "end_time=1 us"})), HasSubstr("meets nothing before end_time"));
    EXPECT_THAT(
        refused_start(grid_case(octant_grid, "", {start, "charge.0.center=[0.1, 0, 0]", "charge.0.detonation=[{ point = [0.11, 0, 0] }]"})),
        HasSubstr("not lit at its center"));
    EXPECT_THAT(refused_start(grid_case(octant_grid, "", {start, "charge.0.center=[0.06, 0, 0]"})),
                HasSubstr("m from the charge's center"));
}
