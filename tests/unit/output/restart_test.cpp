#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/error.hpp"
#include "output/replace_file.hpp"
#include "output/restart/restart_file.hpp"
#include "output/restart/restart_folder.hpp"
#include "output/restart/seal.hpp"
#include "unit/scratch_folder.hpp"

namespace corpuscle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// A body with one array of every type a field can have.
struct Body {
    std::vector<float> f;
    std::vector<double> d;
    std::vector<std::uint8_t> b;
    std::vector<std::int32_t> i;
    std::vector<std::uint32_t> u;
    std::vector<std::uint64_t> l;
    std::vector<Vector3f> vf;
    std::vector<Vector3d> vd;

    friend bool operator==(const Body&, const Body&) = default;

    FieldSet state()
    {
        return {
            "gas/one",
            {stored_field("f", "1", "", f), stored_field("d", "1", "", d), stored_field("b", "1", "", b), stored_field("i", "1", "", i),
             stored_field("u", "1", "", u), stored_field("l", "1", "", l), stored_field("vf", "m", "", vf), stored_field("vd", "m", "", vd),
             derived_field<double>("derived", "1", "", 3, [](std::size_t n) { return static_cast<double>(n); })}};
    }
};

Body full_body()
{
    return {{0.1F, 2}, {1.0 / 3}, {255}, {-7, 7}, {4294967295U}, {18446744073709551615U, 1}, {{1, 2, 3}}, {{0.1, 0.2, 0.3}, {4, 5, 6}}};
}

RestartContent content_of(Body& body, double time = 0.25)
{
    return {
        {{"time", time}, {"step", std::uint64_t{12345678901234567U}}, {"title", std::string("a \"plate\"\nμ")}, {"empty", std::string()}},
        {body.state()}};
}

/// What the Error of `act` says; an empty text (and a failure) if there is none.
template <class Act>
std::string refusal(Act act)
{
    try {
        act();
    } catch (const Error& error) {
        return error.what();
    }
    ADD_FAILURE() << "nothing was refused";
    return {};
}

void flip_byte(const std::filesystem::path& path, std::uintmax_t position)
{
    std::fstream stream(path, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(position));
    const int byte = stream.get();
    stream.seekp(static_cast<std::streamoff>(position));
    stream.put(static_cast<char>(byte ^ 1));
}

TEST(RestartFile, ReturnsEverythingBitForBit)
{
    const ScratchFolder folder;
    Body saved = full_body();
    write_restart(folder / "a.hdf", content_of(saved));

    const RestartFile file(folder / "a.hdf");
    EXPECT_EQ(file.number("time"), 0.25);
    EXPECT_EQ(file.count("step"), 12345678901234567U);
    EXPECT_EQ(file.text("title"), "a \"plate\"\nμ");
    EXPECT_EQ(file.text("empty"), "");
    Body loaded;
    file.restore({loaded.state()});
    EXPECT_EQ(loaded, saved);
}

TEST(RestartFile, ReturnsAnEmptyBody)
{
    const ScratchFolder folder;
    Body saved;
    write_restart(folder / "a.hdf", content_of(saved));
    Body loaded = full_body();
    RestartFile(folder / "a.hdf").restore({loaded.state()});
    EXPECT_EQ(loaded, Body{});
}

TEST(RestartFile, NamesWhatIsMissing)
{
    const ScratchFolder folder;
    Body body = full_body();
    write_restart(folder / "a.hdf", content_of(body));
    const RestartFile file(folder / "a.hdf");
    EXPECT_THAT(refusal([&] { (void)file.number("mass"); }), HasSubstr("no value 'mass'"));
    EXPECT_THAT(refusal([&] { (void)file.number("step"); }), HasSubstr("'step' is not a number"));
    EXPECT_THAT(refusal([&] { (void)file.count("time"); }), HasSubstr("'time' is not a count"));
    EXPECT_THAT(refusal([&] { (void)file.text("time"); }), HasSubstr("'time' is not a text"));
}

TEST(RestartFile, RefusesAnotherCaseAndChangesNothing)
{
    const ScratchFolder folder;
    Body saved = full_body();
    write_restart(folder / "a.hdf", content_of(saved));
    const RestartFile file(folder / "a.hdf");
    Body body;
    std::vector<float> more;

    FieldSet extra = body.state();
    extra.fields.push_back(stored_field("temperature", "K", "", more));
    EXPECT_THAT(refusal([&] { file.restore({extra}); }), HasSubstr("'gas/one' has no field 'temperature'"));

    FieldSet fewer = body.state();
    fewer.fields.erase(fewer.fields.begin());
    EXPECT_THAT(refusal([&] { file.restore({fewer}); }), HasSubstr("has no field 'f'"));

    FieldSet retyped = body.state();
    retyped.fields[1] = stored_field("d", "1", "", more);
    EXPECT_THAT(refusal([&] { file.restore({retyped}); }), HasSubstr("field 'd' of 'gas/one' is of another type"));

    EXPECT_THAT(refusal([&] { file.restore({body.state(), {"grains", {}}}); }), HasSubstr("no 'grains'"));
    EXPECT_THAT(refusal([&] { file.restore({}); }), HasSubstr("the case has no 'gas|one'"));
    EXPECT_EQ(body, Body{});
}

TEST(RestartFile, RefusesTwins)
{
    const ScratchFolder folder;
    Body body;
    EXPECT_THROW(write_restart(folder / "a.hdf", {{}, {body.state(), body.state()}}), Error);
    FieldSet twice = body.state();
    twice.fields.push_back(twice.fields.front());
    EXPECT_THROW(write_restart(folder / "a.hdf", {{}, {twice}}), Error);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.hdf"));
}

TEST(RestartFile, RefusesAnotherFormatVersion)
{
    const ScratchFolder folder;
    Hdf5File file = Hdf5File::create(folder / "a.hdf");
    file.set_attribute("/", "corpuscle_restart", std::vector<std::int64_t>{99});
    file.close();
    seal_file(folder / "a.hdf");
    EXPECT_THAT(refusal([&] { const RestartFile back(folder / "a.hdf"); }), HasSubstr("version 99, this program reads version 1"));
}

TEST(RestartFile, SeesEveryKindOfDamage)
{
    const ScratchFolder folder;
    Body body = full_body();
    write_restart(folder / "good.hdf", content_of(body));
    const auto size = std::filesystem::file_size(folder / "good.hdf");
    const auto damaged = [&](const auto& damage) {
        std::filesystem::copy_file(folder / "good.hdf", folder / "bad.hdf", std::filesystem::copy_options::overwrite_existing);
        damage(folder / "bad.hdf");
        return refusal([&] { const RestartFile file(folder / "bad.hdf"); });
    };
    for (std::uintmax_t position = 0; position < size; position += 499) {
        EXPECT_THAT(damaged([&](const auto& path) { flip_byte(path, position); }), HasSubstr("not whole")) << "byte " << position;
    }
    for (const std::uintmax_t length : {std::uintmax_t{0}, std::uintmax_t{10}, size / 2, size - 1}) {
        EXPECT_THAT(damaged([&](const auto& path) { std::filesystem::resize_file(path, length); }), HasSubstr("not whole"))
            << length << " bytes";
    }
    EXPECT_THAT(damaged([](const auto& path) { std::ofstream(path, std::ios::app) << "more"; }), HasSubstr("not whole"));
}

TEST(RestartFolder, KeepsTheLastTwo)
{
    const ScratchFolder folder;
    const RestartFolder restart(folder / "restart");
    Body body = full_body();
    for (int i = 0; i < 4; ++i) restart.save(content_of(body, i));
    ASSERT_THAT(restart.files(), SizeIs(2));
    std::vector<std::string> remarks;
    EXPECT_EQ(restart.open_newest(remarks).number("time"), 3);
    EXPECT_THAT(remarks, IsEmpty());
    EXPECT_EQ(RestartFile(restart.files().front()).number("time"), 2);
}

TEST(RestartFolder, TakesTheOlderStateWhenTheNewestIsTorn)
{
    const ScratchFolder folder;
    const RestartFolder restart(folder / "restart");
    Body body = full_body();
    restart.save(content_of(body, 1));
    const auto newest = restart.save(content_of(body, 2));
    std::filesystem::resize_file(newest, std::filesystem::file_size(newest) / 2);
    std::vector<std::string> remarks;
    EXPECT_EQ(restart.open_newest(remarks).number("time"), 1);
    EXPECT_THAT(remarks, ElementsAre(HasSubstr("state_000002.hdf")));
}

TEST(RestartFolder, IgnoresAStateThatWasNeverFinished)
{
    const ScratchFolder folder;
    const RestartFolder restart(folder / "restart");
    Body body = full_body();
    restart.save(content_of(body, 1));
    std::ofstream(folder / "restart/state_000002.hdf.part") << "killed here";
    std::vector<std::string> remarks;
    EXPECT_EQ(restart.open_newest(remarks).number("time"), 1);
    EXPECT_THAT(remarks, IsEmpty());
    EXPECT_EQ(restart.save(content_of(body, 2)).filename(), "state_000002.hdf");
}

TEST(RestartFolder, SaysWhyThereIsNothingToResume)
{
    const ScratchFolder folder;
    std::vector<std::string> remarks;
    EXPECT_THROW((void)RestartFolder(folder / "absent").open_newest(remarks), InputError);
    std::ofstream(folder / "state_000001.hdf") << "torn";
    EXPECT_THAT(refusal([&] { (void)RestartFolder(folder.path()).open_newest(remarks); }), HasSubstr("state_000001.hdf"));
}

}  // namespace
}  // namespace corpuscle
