#include "parallel/sort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "math/random.hpp"

namespace corpuscle {
namespace {

class CountingSort : public testing::TestWithParam<int> {
protected:
    CountingSort() { set_thread_count(GetParam()); }
    ~CountingSort() override { set_thread_count(before_); }

private:
    int before_ = thread_count();
};
INSTANTIATE_TEST_SUITE_P(Threads, CountingSort, testing::Values(1, 2, 3, 7));

std::vector<std::uint32_t> random_keys(std::size_t count, std::uint32_t keys)
{
    std::vector<std::uint32_t> key(count);
    Random random(4, Purpose::fill, 0, 0);
    for (std::uint32_t& k : key) k = random.below(keys);
    return key;
}

/// Checks the sort of these keys against std::stable_sort.
void expect_sorted_stably(const std::vector<std::uint32_t>& key, std::uint32_t keys)
{
    std::vector<std::uint32_t> expected(key.size()), sorted(key.size(), 0xffffffff);
    std::iota(expected.begin(), expected.end(), 0u);
    std::stable_sort(expected.begin(), expected.end(), [&](std::uint32_t a, std::uint32_t b) { return key[a] < key[b]; });
    const auto place = [&](std::size_t i, std::uint32_t position) { sorted[position] = static_cast<std::uint32_t>(i); };
    const std::vector<std::uint32_t> start = stable_counting_sort(key.size(), keys, [&](std::size_t i) { return key[i]; }, place);
    EXPECT_EQ(sorted, expected);
    ASSERT_EQ(start.size(), keys + 1u);
    for (std::uint32_t k = 0; k <= keys; ++k) {
        const auto before = std::count_if(key.begin(), key.end(), [k](std::uint32_t own) { return own < k; });
        ASSERT_EQ(start[k], static_cast<std::uint32_t>(before)) << "key " << k;
    }
}

TEST_P(CountingSort, IsTheStableSort)
{
    expect_sorted_stably(random_keys(100'003, 300), 300);
    expect_sorted_stably(random_keys(8'191, 2), 2);
    expect_sorted_stably(random_keys(50'000, 1), 1);
}

TEST_P(CountingSort, LeavesKeysThatNobodyHasEmpty)
{
    std::vector<std::uint32_t> key(30'000, 5);
    key[12'345] = 7;
    expect_sorted_stably(key, 9);
}

TEST_P(CountingSort, SortsNothing)
{
    expect_sorted_stably({}, 4);
}

}  // namespace
}  // namespace corpuscle
