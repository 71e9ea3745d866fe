#include "schema/nearest.hpp"

#include <gmock/gmock.h>

using namespace corpuscle;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Nearest, EditDistanceCountsLetters)
{
    EXPECT_EQ(edit_distance("", ""), 0u);
    EXPECT_EQ(edit_distance("mass", "mass"), 0u);
    EXPECT_EQ(edit_distance("mass", "mas"), 1u);
    EXPECT_EQ(edit_distance("raduis", "radius"), 1u);  // neighbours swapped
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
    EXPECT_EQ(edit_distance("abc", ""), 3u);
}

TEST(Nearest, BestFirstAndNothingFarOff)
{
    const std::vector<std::string> names{"explosive", "mass", "shape", "center", "axis"};
    EXPECT_THAT(nearest_names("centre", names), ElementsAre("center"));
    EXPECT_THAT(nearest_names("Mass", names), ElementsAre("mass"));
    EXPECT_THAT(nearest_names("temperature", names), IsEmpty());
}

TEST(Nearest, SuggestionFallsBackOnAllNames)
{
    EXPECT_EQ(suggestion("raduis", {"radius", "length"}), "did you mean 'radius'?");
    EXPECT_EQ(suggestion("zzzzzz", {"radius", "length"}), "known: radius, length");
}

TEST(Nearest, ListedStopsAtMost)
{
    EXPECT_EQ(listed({"a", "b", "c"}, 3), "a, b, c");
    EXPECT_EQ(listed({"a", "b", "c"}, 2), "a, b and 1 more");
}
