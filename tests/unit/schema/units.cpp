#include "schema/units.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"

using namespace corpuscle;
using ::testing::HasSubstr;

namespace {

/// The refusal of a conversion, in full.
std::string refusal(const std::string& text, const std::string& unit)
{
    try {
        static_cast<void>(convert(text, unit));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(Units, ConvertsWhatPeopleWrite)
{
    EXPECT_DOUBLE_EQ(convert("15 kg", "kg"), 15.0);
    EXPECT_DOUBLE_EQ(convert("700 mm", "m"), 0.7);
    EXPECT_DOUBLE_EQ(convert("4 ms", "s"), 0.004);
    EXPECT_DOUBLE_EQ(convert("10us", "s"), 1e-5);
    EXPECT_DOUBLE_EQ(convert("0.5 in", "m"), 0.0127);
    EXPECT_DOUBLE_EQ(convert("1630 kg/m3", "kg/m3"), 1630.0);
    EXPECT_DOUBLE_EQ(convert("1.63 g/cm3", "kg/m3"), 1630.0);
    EXPECT_DOUBLE_EQ(convert("371.2 GPa", "Pa"), 371.2e9);
    EXPECT_DOUBLE_EQ(convert("7.0 GJ/m3", "J/m3"), 7.0e9);
    EXPECT_DOUBLE_EQ(convert("28.96 g/mol", "kg/mol"), 0.02896);
    EXPECT_NEAR(convert("20 degC", "K"), 293.15, 1e-10);
    EXPECT_DOUBLE_EQ(convert("-200 mm", "m"), -0.2);
    EXPECT_DOUBLE_EQ(convert("+1e3 g", "kg"), 1.0);
    EXPECT_DOUBLE_EQ(convert("10 min", "s"), 600.0);
    EXPECT_DOUBLE_EQ(convert("5 percent", "1"), 0.05);
    EXPECT_NEAR(convert("1 psi", "Pa"), 6894.757, 1e-2);
    EXPECT_DOUBLE_EQ(convert("300 1/s", "1/s"), 300.0);
}

TEST(Units, WrongDimensionIsNamed)
{
    const std::string text = refusal("15 mm", "kg");
    EXPECT_THAT(text, HasSubstr("\"15 mm\" is a length"));
    EXPECT_THAT(text, HasSubstr("expected a mass"));
    EXPECT_THAT(text, HasSubstr("kg"));
}

TEST(Units, TimeAndRateAreNotTheSame)
{
    EXPECT_THAT(refusal("3 1/s", "s"), HasSubstr("is a rate"));
    EXPECT_THAT(refusal("3 s", "1/s"), HasSubstr("is a time"));
}

TEST(Units, UnknownUnitGetsTheNearest)
{
    const std::string text = refusal("15 kgg", "kg");
    EXPECT_THAT(text, HasSubstr("unknown unit 'kgg'"));
    EXPECT_THAT(text, HasSubstr("'kg'"));
    EXPECT_THAT(text, HasSubstr("expected a mass"));
}

TEST(Units, TextWithoutUnitOrNumberIsRefused)
{
    EXPECT_THAT(refusal("15", "kg"), HasSubstr("has no unit"));
    EXPECT_THAT(refusal("heavy", "kg"), HasSubstr("does not begin with a number"));
    EXPECT_THAT(refusal("", "kg"), HasSubstr("does not begin with a number"));
}

TEST(Units, WrittenNumbersReadBackToTheSameBits)
{
    for (const double value : {0.1, 1.0 / 3.0, 6.02214076e23, -0.2, 1e-5})
        for (const char* unit : {"m", "kg/m3", "Pa", "m/s"}) EXPECT_EQ(convert(with_unit(value, unit), unit), value) << unit;
}
