#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "output/checksum.hpp"
#include "output/log.hpp"
#include "output/replace_file.hpp"
#include "unit/scratch_folder.hpp"

namespace corpuscle {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

std::uint64_t checksum(const std::string& text, std::size_t piece)
{
    Checksum sum;
    const auto bytes = std::as_bytes(std::span(text));
    for (std::size_t begin = 0; begin < bytes.size(); begin += piece) sum.add(bytes.subspan(begin, std::min(piece, bytes.size() - begin)));
    return sum.value();
}

TEST(Checksum, DoesNotDependOnThePieces)
{
    std::string text(1000, '\0');
    for (std::size_t i = 0; i < text.size(); ++i) text[i] = static_cast<char>(i * i);
    const std::uint64_t whole = checksum(text, text.size());
    for (const std::size_t piece : {1U, 7U, 31U, 32U, 33U, 999U}) EXPECT_EQ(checksum(text, piece), whole) << piece;
}

TEST(Checksum, SeesEveryBitAndEveryLength)
{
    const std::string text(100, 'x');
    std::set<std::uint64_t> seen{checksum(text, 100)};
    for (std::size_t i = 0; i < 8 * text.size(); ++i) {
        std::string changed = text;
        changed[i / 8] = static_cast<char>(changed[i / 8] ^ (1 << (i % 8)));
        EXPECT_TRUE(seen.insert(checksum(changed, 100)).second) << "bit " << i;
    }
    for (std::size_t length = 0; length < 100; ++length)
        EXPECT_TRUE(seen.insert(checksum(std::string(length, '\0'), 100)).second) << length;
}

TEST(ReplaceFile, ReplacesWholly)
{
    const ScratchFolder folder;
    replace_file(folder / "a", "a long first text");
    replace_file(folder / "a", std::string_view("short\0er", 8), Durability::disk);
    EXPECT_EQ(read_file(folder / "a"), std::string("short\0er", 8));
    EXPECT_FALSE(std::filesystem::exists(aside(folder / "a")));
}

TEST(ReplaceFile, NamesTheFileAndTheReason)
{
    const ScratchFolder folder;
    try {
        replace_file(folder / "no/such/file", "x");
        FAIL() << "written into a folder that does not exist";
    } catch (const Error& error) {
        EXPECT_THAT(error.problem(), HasSubstr("no/such/file"));
        EXPECT_THAT(error.problem(), HasSubstr("No such file or directory"));
    }
    EXPECT_THROW((void)read_file(folder / "absent"), Error);
    EXPECT_THROW((void)read_file(folder.path()), Error);
}

TEST(Log, AddsStampedLinesAtOnce)
{
    const ScratchFolder folder;
    Log log(folder / "run.log");
    log.line("step 1");
    log.warning("the mesh is coarse");
    const std::string text = read_file(folder / "run.log");  // while the log is still open
    EXPECT_THAT(text, ContainsRegex("\n +[0-9]+\\.[0-9]{3} s  step 1\n"));
    EXPECT_THAT(text, HasSubstr(" s  warning: the mesh is coarse\n"));
    Log again(folder / "run.log");
    again.line("resumed");
    EXPECT_THAT(read_file(folder / "run.log"), HasSubstr("step 1"));
    EXPECT_THAT(read_file(folder / "run.log"), HasSubstr("resumed"));
    EXPECT_THROW(Log(folder / "no/run.log"), Error);
}

}  // namespace
}  // namespace corpuscle
