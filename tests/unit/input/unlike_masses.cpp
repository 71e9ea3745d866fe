#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "input/unlike_masses.hpp"

namespace corpuscle {
namespace {

using testing::HasSubstr;

std::vector<std::string> warnings_of(double heavy, double light)
{
    const std::vector<Species> species{{"tnt", IdealGas{1.3}, heavy, 3.67}, {"air", IdealGas{1.4}, light, 2}};
    std::vector<std::string> warnings;
    warn_of_unlike_masses(species, {heavy * 1000, light * 3000}, warnings);
    return warnings;
}

TEST(UnlikeMasses, are_warned_of_beyond_ten)
{
    EXPECT_TRUE(warnings_of(10, 1).empty());
    EXPECT_TRUE(warnings_of(1, 10).empty());
    const std::vector<std::string> warnings = warnings_of(24, 1);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_THAT(warnings[0], HasSubstr("'tnt' weighs 24 times one of 'air'"));
    EXPECT_THAT(warnings_of(1, 30).at(0), HasSubstr("'air' weighs 30 times one of 'tnt'"));
}

/// 24000 kg and 3000 kg share 4000 particles by mass.
TEST(UnlikeMasses, say_the_counts_that_make_them_equal)
{
    EXPECT_THAT(warnings_of(24, 1).at(0), HasSubstr("tnt 3556, air 444"));
}

}  // namespace
}  // namespace corpuscle
