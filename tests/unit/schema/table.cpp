#include <array>

#include <gmock/gmock.h>

#include "schema/manual.hpp"
#include "schema/table_builder.hpp"

namespace corpuscle {
namespace {

enum class Colour { red, green };

struct Inner {
    double length = 0.25;
    std::optional<std::string> word;
};

struct Point {
    double x = 0, y = 0, z = 0;
};

struct Sample {
    double mass = 0;
    std::int64_t count = 3;
    bool flag = false;
    std::string text = "unchanged";
    Colour colour = Colour::green;
    Point point{1, 2, 3};
    std::optional<double> time;
    std::array<double, 2> pair{0, 1};
    std::vector<Inner> inner;
    Inner single;
    Places places;
};

Value number(double value, int line = 1)
{
    Value result = Value::of_number(value);
    result.place = {"sample", line, 5};
    return result;
}

Value text(const std::string& value, int line = 1)
{
    Value result = Value::of_text(value);
    result.place = {"sample", line, 5};
    return result;
}

}  // namespace

template <>
const std::vector<std::pair<std::string, Colour>>& words_of<Colour>()
{
    static const std::vector<std::pair<std::string, Colour>> words{{"red", Colour::red}, {"green", Colour::green}};
    return words;
}

template <>
const Table& table_of<Inner>()
{
    static const Table table = TableBuilder<Inner>("inner", "An inner table.")
                                   .row("length", &Inner::length, {"m", above(0), "A length.", "\"3 mm\""})
                                   .row("word", &Inner::word, {"", {}, "A word.", ""})
                                   .shorthand("length")
                                   .at_most_one_of({"length", "word"})
                                   .table();
    return table;
}

template <>
const Table& table_of<Sample>()
{
    static const Table table = TableBuilder<Sample>("sample", "A sample of every kind.")
                                   .need("mass", &Sample::mass, {"kg", above(0), "A mass.", "\"15 kg\""})
                                   .row("count", &Sample::count, {"", from_to(1, 10), "A count.", "5"})
                                   .row("flag", &Sample::flag, {"", {}, "A flag.", "true"})
                                   .row("text", &Sample::text, {"", {}, "A text.", "\"a\""})
                                   .row("colour", &Sample::colour, {"", {}, "A colour.", "\"red\""})
                                   .row("point", &Sample::point, {"m", {}, "A point.", "[0, 0, 1]"})
                                   .row("time", &Sample::time, {"s", at_least(0), "A time.", "\"3 ms\""})
                                   .row("pair", &Sample::pair, {"", {}, "Two numbers.", "[0, 1]"})
                                   .row("inner", &Sample::inner, {"", {}, "Many.", ""})
                                   .row("single", &Sample::single, {"", {}, "One.", ""})
                                   .table();
    return table;
}

namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

struct Reading {
    Sample sample;
    Problems problems;
    explicit Reading(const Value& value) { read_table(&sample, table_of<Sample>(), value, problems); }
    [[nodiscard]] std::string said() const
    {
        std::string all;
        for (const InputError& error : problems.found()) all += std::string(error.what()) + "\n";
        return all;
    }
};

Value with(const std::string& key, Value value)
{
    Value table;
    table.place = {"sample", 1, 1};
    table.put("mass", text("15 kg"));
    table.put(key, std::move(value), {"sample", 7, 1});
    return table;
}

TEST(Table, ReadsEveryKind)
{
    Value value = with("count", Value::of_integer(7));
    value.put("flag", Value::of_boolean(true));
    value.put("text", text("hello"));
    value.put("colour", text("red"));
    value.put("point", Value::of_array({number(0), text("5 mm"), Value::of_integer(2)}));
    value.put("time", text("3 ms"));
    value.put("pair", Value::of_array({number(4), number(5)}));
    value.put("inner", Value::of_array({text("20 mm"), Value{}}));
    const Reading read(value);
    EXPECT_THAT(read.problems.found(), IsEmpty()) << read.said();
    EXPECT_DOUBLE_EQ(read.sample.mass, 15);
    EXPECT_EQ(read.sample.count, 7);
    EXPECT_TRUE(read.sample.flag);
    EXPECT_EQ(read.sample.text, "hello");
    EXPECT_EQ(read.sample.colour, Colour::red);
    EXPECT_DOUBLE_EQ(read.sample.point.y, 0.005);
    EXPECT_DOUBLE_EQ(read.sample.point.z, 2);
    EXPECT_DOUBLE_EQ(read.sample.time.value(), 0.003);
    EXPECT_DOUBLE_EQ(read.sample.pair[1], 5);
    ASSERT_THAT(read.sample.inner, SizeIs(2));
    EXPECT_DOUBLE_EQ(read.sample.inner[0].length, 0.02);  // by its shorthand
    EXPECT_DOUBLE_EQ(read.sample.inner[1].length, 0.25);  // by default
}

TEST(Table, UnknownKeyNamesTheNearest)
{
    const Reading read(with("colur", text("red")));
    EXPECT_THAT(read.said(), HasSubstr("sample:7:1: unknown key 'colur' in 'sample'; did you mean 'colour'?"));
}

TEST(Table, UnknownKeyOfAnInnerTableNamesTheWay)
{
    const Reading read(with("length", number(1)));
    EXPECT_THAT(read.said(),
                HasSubstr("unknown key 'length' in 'sample'; did you mean inner = [{ length = ... }] or single = { length = ... }?"));
}

TEST(Table, MissingKeyIsNamedWithAnExample)
{
    Value value;
    value.place = {"sample", 4, 2};
    EXPECT_THAT(
        Reading(value).said(),
        HasSubstr("sample:4:2: 'sample' has no 'mass'; expected number > 0 in kg or with a unit (g, kg, t, lb), such as mass = \"15 kg\""));
}

TEST(Table, RangesAreKept)
{
    EXPECT_THAT(Reading(with("mass", number(-1))).said(), HasSubstr("mass = -1.0 is out of range; expected a number > 0 kg"));
    EXPECT_THAT(Reading(with("count", Value::of_integer(11))).said(), HasSubstr("expected a number 1 to 10"));
    EXPECT_THAT(Reading(with("mass", number(std::numeric_limits<double>::quiet_NaN()))).said(), HasSubstr("out of range"));
    EXPECT_THAT(Reading(with("time", number(std::numeric_limits<double>::infinity()))).said(), HasSubstr("out of range"));
}

TEST(Table, WrongKindsAreRefused)
{
    EXPECT_THAT(Reading(with("count", text("many"))).said(), HasSubstr("'count' is a text; expected integer 1 to 10"));
    EXPECT_THAT(Reading(with("count", number(1.5))).said(), HasSubstr("'count' is a number"));
    EXPECT_THAT(Reading(with("flag", Value::of_integer(1))).said(), HasSubstr("'flag' is an integer; expected true or false"));
    EXPECT_THAT(Reading(with("point", Value::of_array({number(1)}))).said(), HasSubstr("'point' has a list of 1 here; expected 3 of them"));
    EXPECT_THAT(Reading(with("single", Value::of_boolean(true))).said(), HasSubstr("'length' is true or false"));
    EXPECT_THAT(Reading(with("mass", Value::of_boolean(true))).said(), HasSubstr("'mass' is true or false"));
    EXPECT_THAT(Reading(with("colour", text("gren"))).said(), HasSubstr("did you mean 'green'?"));
}

TEST(Table, AWholeNumberIsAnInteger)
{
    EXPECT_EQ(Reading(with("count", number(4.0))).sample.count, 4);
}

TEST(Table, AlternativesExcludeEachOther)
{
    Value inner;
    inner.put("length", number(1));
    inner.put("word", text("x"));
    EXPECT_THAT(Reading(with("single", inner)).said(),
                HasSubstr("'inner' has length and word at once; expected at most one of length, word"));
}

TEST(Table, AllProblemsAreToldAtOnceInOrder)
{
    Value value = with("colour", text("blue", 9));
    value.put("count", text("x", 3));
    value.put("other", text("x", 5), {"sample", 5, 1});
    Reading read(value);
    ASSERT_THAT(read.problems.found(), SizeIs(3));
    try {
        read.problems.raise();
        FAIL() << "nothing was thrown";
    } catch (const InputProblems& problems) {
        ASSERT_THAT(problems.all(), SizeIs(3));
        EXPECT_EQ(problems.all()[0].place().line, 3);
        EXPECT_EQ(problems.all()[1].place().line, 5);
        EXPECT_EQ(problems.all()[2].place().line, 9);
    }
}

TEST(Table, PlacesAreKept)
{
    const Reading read(with("count", Value::of_integer(2)));
    EXPECT_EQ(read.sample.places.own.line, 1);
    EXPECT_EQ(read.sample.places.of("mass").column, 5);
    EXPECT_EQ(read.sample.places.of("time").line, 1);  // not given: the whole
}

TEST(Table, WritesWhatItReads)
{
    Value value = with("time", text("3 ms"));
    value.put("inner", Value::of_array({text("20 mm")}));
    const Reading first(value);
    const Value written = write_table(&first.sample, table_of<Sample>());
    const Reading second(written);
    EXPECT_THAT(second.problems.found(), IsEmpty()) << second.said();
    EXPECT_EQ(toml_document(written), toml_document(write_table(&second.sample, table_of<Sample>())));
    EXPECT_THAT(toml_document(written), HasSubstr("mass = \"15 kg\""));
    EXPECT_THAT(toml_document(written), HasSubstr("colour = \"green\""));
    EXPECT_THAT(toml_document(written), HasSubstr("time = \"0.003 s\""));
}

TEST(Manual, DefaultsComeFromTheMembers)
{
    const Table& table = table_of<Sample>();
    EXPECT_EQ(default_text(table, *table.find("count")), "3");
    EXPECT_EQ(default_text(table, *table.find("colour")), "\"green\"");
    EXPECT_EQ(default_text(table, *table.find("mass")), "");
    EXPECT_EQ(default_text(table, *table.find("time")), "");
}

TEST(Manual, ExplainsByFullNameAndByLastWord)
{
    EXPECT_THAT(explain(table_of<Sample>(), "inner.length"), HasSubstr("A length."));
    const std::string both = explain(table_of<Sample>(), "length");
    EXPECT_THAT(both, HasSubstr("inner.length"));
    EXPECT_THAT(both, HasSubstr("single.length"));
    EXPECT_THAT(explain(table_of<Sample>(), "colour"), HasSubstr("red, green"));
    try {
        static_cast<void>(explain(table_of<Sample>(), "lenght"));
        FAIL() << "nothing was thrown";
    } catch (const InputError& error) {
        EXPECT_THAT(error.remedy(), HasSubstr("'length'"));
    }
}

TEST(Manual, PageHasEveryParameter)
{
    const std::string page = reference_page(table_of<Sample>());
    for (const NamedParameter& named : all_parameters(table_of<Sample>()))
        EXPECT_THAT(page, HasSubstr("| `" + named.parameter->key + "` |")) << named.path;
}

}  // namespace
}  // namespace corpuscle
