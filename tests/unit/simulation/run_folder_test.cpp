#include "simulation/run_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "base/error.hpp"
#include "sample_run.hpp"
#include "unit/scratch_folder.hpp"

namespace corpuscle {
namespace {

using testing::HasSubstr;

void touch(const std::filesystem::path& path)
{
    std::ofstream(path) << "x";
}

TEST(RunFolder, ChecksWithoutTouching)
{
    const ScratchFolder folder;
    const RunFolder run(folder / "a/b/c");
    run.check(Existing::refuse);
    EXPECT_FALSE(std::filesystem::exists(folder / "a"));
    run.create(Existing::refuse);
    EXPECT_TRUE(std::filesystem::is_directory(run.fields()));
    EXPECT_TRUE(std::filesystem::is_directory(run.restart()));
    EXPECT_FALSE(run.has_results());
}

TEST(RunFolder, RefusesResultsInTheWay)
{
    const ScratchFolder folder;
    const RunFolder run(folder.path());
    touch(folder / "case.toml");
    run.check(Existing::refuse);  // other files are not in the way
    write_sample_run(folder.path());
    try {
        run.create(Existing::refuse);
        FAIL() << "results were overwritten";
    } catch (const InputError& error) {
        EXPECT_THAT(error.remedy(), HasSubstr("--force"));
    }
    EXPECT_TRUE(std::filesystem::exists(run.summary()));
}

TEST(RunFolder, ReplacesResultsAndNothingElse)
{
    const ScratchFolder folder;
    const RunFolder run(folder.path());
    run.create(Existing::refuse);
    write_sample_run(folder.path());
    touch(run.fields() / "gas_000000.hdf");
    touch(run.fields() / "gas.hdf.series");
    touch(run.restart() / "state_000001.hdf");
    touch(folder / "case.toml");
    touch(run.fields() / "my_notes.txt");
    run.create(Existing::replace);
    EXPECT_FALSE(std::filesystem::exists(run.summary()));
    EXPECT_FALSE(std::filesystem::exists(run.fields() / "gas_000000.hdf"));
    EXPECT_FALSE(std::filesystem::exists(run.restart() / "state_000001.hdf"));
    EXPECT_TRUE(std::filesystem::exists(folder / "case.toml"));
    EXPECT_TRUE(std::filesystem::exists(run.fields() / "my_notes.txt"));
}

TEST(RunFolder, RefusesAFileInItsPlace)
{
    const ScratchFolder folder;
    touch(folder / "results");
    EXPECT_THROW(RunFolder(folder / "results").check(Existing::replace), InputError);
    EXPECT_THROW(RunFolder(folder / "results/below").check(Existing::refuse), InputError);
    EXPECT_THROW(RunFolder("").check(Existing::refuse), InputError);
}

TEST(RunFolder, RefusesAFolderItMayNotWrite)
{
    // Nobody, not even root, may write into /proc.
    if (!std::filesystem::is_directory("/proc/self")) GTEST_SKIP() << "this system has no /proc";
    EXPECT_THROW(RunFolder("/proc/results").create(Existing::refuse), InputError);
}

TEST(RunFolder, TakesRequestsOnce)
{
    const ScratchFolder folder;
    const RunFolder run(folder.path());
    EXPECT_EQ(run.take_request(), FolderRequest::none);
    touch(folder / "save");
    EXPECT_EQ(run.take_request(), FolderRequest::save);
    touch(folder / "stop");
    EXPECT_EQ(run.take_request(), FolderRequest::stop);
    EXPECT_EQ(run.take_request(), FolderRequest::none);
}

}  // namespace
}  // namespace corpuscle
