#include "output/hdf5.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <numeric>

#include "base/error.hpp"
#include "unit/scratch_folder.hpp"

namespace corpuscle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Writes `values` as a field and reads them back, bit for bit.
template <class T>
void expect_round_trip(std::vector<T> values, int gzip)
{
    const ScratchFolder folder;
    const Field field = stored_field("x", "m/s", "speed of a thing", values);
    Hdf5File file = Hdf5File::create(folder / "a.hdf");
    file.write("/x", field, shape_of(field), gzip);
    file.close();

    const Hdf5File back = Hdf5File::open(folder / "a.hdf");
    EXPECT_EQ(back.shape("/x"), shape_of(field));
    std::vector<T> read(values.size());
    back.read("/x", hdf5_type(field.scalar), read.data());
    EXPECT_EQ(read, values);
    EXPECT_EQ(back.text_attribute("/x", "unit"), "m/s");
    EXPECT_EQ(back.text_attribute("/x", "meaning"), "speed of a thing");
}

TEST(Hdf5, ReturnsEveryTypeOfField)
{
    for (const int gzip : {0, 1}) {
        expect_round_trip<float>({0.1F, -3e38F, 1e-38F}, gzip);
        expect_round_trip<double>({0.1, -1e308, 5e-324}, gzip);
        expect_round_trip<std::uint8_t>({0, 127, 255}, gzip);
        expect_round_trip<std::int32_t>({-2147483647 - 1, 0, 2147483647}, gzip);
        expect_round_trip<std::uint32_t>({0, 4294967295U}, gzip);
        expect_round_trip<std::uint64_t>({0, 18446744073709551615U}, gzip);
        expect_round_trip<Vector3f>({{1, 2, 3}, {4, 5, 6}}, gzip);
        expect_round_trip<Vector3d>({{1, 2, 3}, {4, 5, 6.5}}, gzip);
        expect_round_trip<double>({}, gzip);
        expect_round_trip<Vector3f>({}, gzip);
    }
}

TEST(Hdf5, WritesManyChunks)
{
    std::vector<Vector3d> values(200'000);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = {0.5 * static_cast<double>(i), 1, -static_cast<double>(i)};
    expect_round_trip(values, 0);
    expect_round_trip(values, 1);
}

TEST(Hdf5, CompressesWhenAsked)
{
    const ScratchFolder folder;
    const std::vector<double> values(100'000, 1.5);
    for (const int gzip : {0, 1}) {
        Hdf5File file = Hdf5File::create(folder / std::to_string(gzip));
        file.write("/x", values, gzip);
        file.close();
    }
    EXPECT_GT(std::filesystem::file_size(folder / "0"), 800'000U);
    EXPECT_LT(std::filesystem::file_size(folder / "1"), 80'000U);
}

TEST(Hdf5, ListsGroupsAndAttributes)
{
    const ScratchFolder folder;
    Hdf5File file = Hdf5File::create(folder / "a.hdf");
    file.add_group("/one/two");
    file.write("/one/numbers", std::vector<double>{1.5});
    file.set_attribute("/one", "extent", std::vector<std::int64_t>{0, 7});
    file.set_attribute("/one", "spacing", std::vector<double>{0.25});
    file.set_attribute("/one", "empty", std::string());
    file.close();

    const Hdf5File back = Hdf5File::open(folder / "a.hdf");
    EXPECT_THAT(back.members("/one"), ElementsAre("numbers", "two"));
    EXPECT_TRUE(back.has("/one/two"));
    EXPECT_FALSE(back.has("/one/three"));
    EXPECT_FALSE(back.has("/none/two"));
    EXPECT_THAT(back.integer_attribute("/one", "extent"), ElementsAre(0, 7));
    EXPECT_THAT(back.number_attribute("/one", "spacing"), ElementsAre(0.25));
    EXPECT_EQ(back.text_attribute("/one", "empty"), "");
    EXPECT_THROW((void)back.text_attribute("/one", "absent"), Error);
    EXPECT_THROW((void)back.shape("/one/absent"), Error);
}

TEST(Hdf5, NamesTheFileItCannotUse)
{
    const ScratchFolder folder;
    std::ofstream(folder / "text.hdf") << "this is no HDF5 file";
    testing::internal::CaptureStderr();
    for (const char* name : {"text.hdf", "absent.hdf"}) {
        try {
            (void)Hdf5File::open(folder / name);
            FAIL() << name << " was opened";
        } catch (const Error& error) {
            EXPECT_THAT(error.problem(), HasSubstr(name));
            EXPECT_FALSE(error.remedy().empty());
        }
    }
    EXPECT_THROW((void)Hdf5File::create(folder / "no/such/folder.hdf"), Error);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Hdf5, ReportsAFullDisk)
{
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
    EXPECT_THROW(
        {
            Hdf5File file = Hdf5File::create("/dev/full");
            file.write("/x", std::vector<double>(1000, 1.0));
            file.close();
        },
        Error);
}

}  // namespace
}  // namespace corpuscle
