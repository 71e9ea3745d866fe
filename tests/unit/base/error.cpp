#include "base/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corpuscle {
namespace {

TEST(Error, SaysTheProblemAloneWhenNothingElseIsKnown)
{
    EXPECT_STREQ(InputError("mass is negative").what(), "mass is negative");
}

TEST(Error, PutsThePlaceBeforeAndTheRemedyBehind)
{
    const InputError error("unknown key 'mas'", "did you mean 'mass'?", {"plate.toml", 4, 7});
    EXPECT_STREQ(error.what(), "plate.toml:4:7: unknown key 'mas'; did you mean 'mass'?");
}

TEST(Error, NamesAFileWithoutALine)
{
    EXPECT_STREQ(InputError("cannot be read", "", {"plate.toml", 0, 0}).what(), "plate.toml: cannot be read");
}

TEST(Error, KeepsItsPieces)
{
    const SafetyStop error("a velocity is not a number", "halve the time step", {"case.toml", 2, 3});
    EXPECT_EQ(error.problem(), "a velocity is not a number");
    EXPECT_EQ(error.remedy(), "halve the time step");
    EXPECT_EQ(error.place().file, "case.toml");
    EXPECT_EQ(error.place().line, 2);
    EXPECT_EQ(error.place().column, 3);
    EXPECT_TRUE(error.place().known());
    EXPECT_FALSE(Place{}.known());
}

TEST(Error, KindsAreToldApartAndCaughtAsOne)
{
    const auto throw_stop = [] { throw SafetyStop("lost a particle"); };
    EXPECT_THROW(throw_stop(), Error);
    EXPECT_THROW(throw_stop(), std::runtime_error);
    bool was_input = true;
    try {
        throw_stop();
    } catch (const InputError&) {
    } catch (const SafetyStop&) {
        was_input = false;
    }
    EXPECT_FALSE(was_input);
}

}  // namespace
}  // namespace corpuscle
