#include "parallel/loops.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <mutex>
#include <set>
#include <thread>

#include "math/random.hpp"
#include "math/vector3.hpp"

namespace corpuscle {
namespace {

/// Runs each test with 1, 2, 3 and 7 threads, and leaves the count as it was.
class Loops : public testing::TestWithParam<int> {
protected:
    Loops() { set_thread_count(GetParam()); }
    ~Loops() override { set_thread_count(before_); }

private:
    int before_ = thread_count();
};
INSTANTIATE_TEST_SUITE_P(Threads, Loops, testing::Values(1, 2, 3, 7));

/// Counts around the places where loops change their ways.
constexpr std::size_t counts[] = {0, 1, 2, 255, 256, 257, 4096, 4097, 10'007};

TEST_P(Loops, ForEachMeetsEveryItemOnce)
{
    for (const std::size_t count : counts) {
        std::vector<int> met(count);
        for_each(count, [&](std::size_t i) { ++met[i]; });
        for_each_dynamic(count, 16, [&](std::size_t i) { ++met[i]; });
        for_each_simd(count, [&, m = met.data()](std::size_t i) { ++m[i]; });
        EXPECT_EQ(met, std::vector<int>(count, 3));
    }
}

TEST_P(Loops, SharedPiecesAreDoneOnceByHoweverManyWorkers)
{
    for (const std::size_t pieces : {0, 1, 6, 7, 8, 1000}) {
        for (const std::size_t shares : {1, 3, 7}) {
            std::vector<int> met(pieces);
            WorkShares work(pieces, shares);
            for_each_part(shares, shares, [&](std::size_t worker, std::size_t, std::size_t) {
                if (worker % 2 == 0) work.work(worker, [&](std::size_t piece) { ++met[piece]; });  // the others never come
            });
            EXPECT_EQ(met, std::vector<int>(pieces, 1)) << shares << " shares";
        }
    }
}

TEST(WorkShares, WorkersBeginWithTheirOwnPieces)
{
    WorkShares work(10, 3);
    std::vector<std::size_t> order;
    work.work(1, [&](std::size_t piece) { order.push_back(piece); });
    EXPECT_EQ(order, (std::vector<std::size_t>{3, 4, 5, 6, 7, 8, 9, 0, 1, 2}));
}

TEST_P(Loops, PartsFollowOneAnotherWithoutGap)
{
    for (const std::size_t count : counts) {
        for (const std::size_t parts : {1, 2, 5, 16}) {
            std::vector<std::size_t> begins(parts), ends(parts);
            for_each_part(count, parts, [&](std::size_t part, std::size_t begin, std::size_t end) {
                begins[part] = begin;
                ends[part] = end;
            });
            EXPECT_EQ(begins.front(), 0u);
            EXPECT_EQ(ends.back(), count);
            for (std::size_t part = 1; part < parts; ++part) EXPECT_EQ(begins[part], ends[part - 1]);
        }
    }
}

TEST_P(Loops, UsesTheThreadsItWasGiven)
{
    EXPECT_EQ(thread_count(), GetParam());
    std::set<std::thread::id> threads;
    std::mutex guard;
    for_each(10'000, [&](std::size_t) {
        const std::lock_guard lock(guard);
        threads.insert(std::this_thread::get_id());
    });
    EXPECT_EQ(threads.size(), static_cast<std::size_t>(GetParam()));
}

TEST_P(Loops, PartCountIsBoundedByThreadsAndByWork)
{
    const auto threads = static_cast<std::size_t>(GetParam());
    EXPECT_EQ(part_count(0), 1u);
    EXPECT_EQ(part_count(1023), 1u);
    EXPECT_EQ(part_count(2048), std::min<std::size_t>(2, threads));
    EXPECT_EQ(part_count(1'000'000), threads);
}

/// Terms of very different size and sign: any other order of adding gives other bits.
double wild_term(std::size_t i)
{
    Random random(3, Purpose::fill, 0, i);
    return (random.uniform_double() - 0.5) * std::pow(10.0, 24.0 * random.uniform_double() - 12.0);
}

/// The sum as documented: chunk by chunk, each from its first item on.
double chunked_sum(const std::vector<double>& terms)
{
    double total = 0;
    for (std::size_t begin = 0; begin < terms.size(); begin += chunk_size) {
        double chunk = 0;
        for (std::size_t i = begin; i < std::min(terms.size(), begin + chunk_size); ++i) chunk += terms[i];
        total += chunk;
    }
    return total;
}

TEST_P(Loops, SumHasTheSameBitsForAnyThreads)
{
    std::vector<double> terms(100'003);
    for (std::size_t i = 0; i < terms.size(); ++i) terms[i] = wild_term(i);
    double backwards = 0;
    for (std::size_t i = terms.size(); i-- > 0;) backwards += terms[i];
    const double expected = chunked_sum(terms);
    ASSERT_NE(expected, backwards);  // else the order would not matter and this test would show nothing
    for (int repeat = 0; repeat < 20; ++repeat) EXPECT_EQ(sum<double>(terms.size(), [&](std::size_t i) { return terms[i]; }), expected);
}

TEST_P(Loops, SumsAnythingThatAdds)
{
    EXPECT_EQ(sum<int>(0, [](std::size_t) { return 1; }), 0);
    EXPECT_EQ(sum<std::uint64_t>(100'000, [](std::size_t i) { return std::uint64_t{i}; }), 4'999'950'000u);
    const Vector3d total = sum<Vector3d>(10'000, [](std::size_t i) { return Vector3d(1, static_cast<double>(i), -2); });
    EXPECT_EQ(total, Vector3d(10'000, 49'995'000, -20'000));
}

TEST_P(Loops, SumOfChunksSeesEachChunkWhole)
{
    const auto longest = sum_chunks<std::size_t>(10'000, [](std::size_t begin, std::size_t end) { return end - begin; });
    EXPECT_EQ(longest, 10'000u);
    const auto chunks = sum_chunks<std::size_t>(10'000, [](std::size_t, std::size_t) { return std::size_t{1}; });
    EXPECT_EQ(chunks, 3u);
}

TEST_P(Loops, MinimumFindsTheLeastOrTheStart)
{
    const auto valley = [](std::size_t i) { return std::abs(static_cast<double>(i) - 7'777.0) - 3.0; };
    EXPECT_EQ(minimum(10'000, 100.0, valley), -3.0);
    EXPECT_EQ(minimum(10'000, -5.0, valley), -5.0);
    EXPECT_EQ(minimum(0, 2.5, valley), 2.5);
}

TEST(ExclusiveScan, TurnsCountsIntoStarts)
{
    std::vector<int> values{3, 0, 4, 1};
    EXPECT_EQ(exclusive_scan(values), 8);
    EXPECT_EQ(values, (std::vector<int>{0, 3, 3, 7}));
    std::vector<int> none;
    EXPECT_EQ(exclusive_scan(none), 0);
}

TEST(LoopsWithRoom, each_thread_works_in_its_own)
{
    std::vector<std::vector<int>> rooms(3, std::vector<int>(1));
    std::vector<int> done(1000);
    for_each_with(rooms, done.size(), [&](std::vector<int>& room, std::size_t i) {
        ++room[0];
        ++done[i];
    });
    EXPECT_EQ(rooms[0][0] + rooms[1][0] + rooms[2][0], 1000);
    EXPECT_EQ(done, std::vector<int>(1000, 1));
    std::vector<double> squares(37);
    for_simd(squares.size(), [&](std::size_t i) { squares[i] = static_cast<double>(i * i); });
    for (std::size_t i = 0; i < squares.size(); ++i) EXPECT_EQ(squares[i], static_cast<double>(i * i));
}

}  // namespace
}  // namespace corpuscle
