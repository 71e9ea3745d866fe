#include "gas/cells.hpp"

#include <gtest/gtest.h>

#include "gas_samples.hpp"
#include "math/random.hpp"

namespace corpuscle {
namespace {

using Keys = std::vector<std::uint64_t>;

/// The cut by its definition: halve a box until it holds few enough.
void halve(const Keys& keys, std::size_t begin, std::size_t end, int depth, std::size_t limit, std::vector<Cell>& cells)
{
    if (begin == end) return;
    if (end - begin <= limit || depth == CellCurve::depth_limit) {
        Cell cell;
        cell.first = static_cast<std::uint32_t>(begin);
        cell.count = static_cast<std::uint32_t>(end - begin) & 0xFFFFFFu;
        cell.depth = static_cast<std::uint32_t>(depth) & 0xFFu;
        cells.push_back(cell);
        return;
    }
    const std::uint64_t half = std::uint64_t{1} << (CellCurve::depth_limit - 1 - depth);
    std::size_t middle = begin;
    while (middle < end && !(keys[middle] & half)) ++middle;
    halve(keys, begin, middle, depth + 1, limit, cells);
    halve(keys, middle, end, depth + 1, limit, cells);
}

/// Sorted keys; the larger `crowding`, the more of them crowd where the curve begins, to many that are equal.
Keys random_keys(std::size_t count, std::uint32_t crowding)
{
    Keys keys(count);
    Random random(5, Purpose::fill, 0, crowding);
    for (std::uint64_t& key : keys) {
        const std::uint64_t high = random.word(), low = random.word();
        key = (high << 31 ^ low) >> random.below(crowding + 1);
    }
    std::sort(keys.begin(), keys.end());
    return keys;
}

void expect_cut_by_halving(const Keys& keys, std::uint32_t limit)
{
    std::vector<Cell> expected;
    halve(keys, 0, keys.size(), 0, limit, expected);
    for (const int threads : {1, 2, 3}) {
        const WithThreads with(threads);
        const std::vector<Cell> cells = cut(keys, limit);
        ASSERT_EQ(cells.size(), expected.size()) << threads << " threads, limit " << limit;
        for (std::size_t c = 0; c < cells.size(); ++c) {
            ASSERT_EQ(cells[c].first, expected[c].first) << "cell " << c;
            ASSERT_EQ(cells[c].count, expected[c].count) << "cell " << c;
            ASSERT_EQ(cells[c].depth, expected[c].depth) << "cell " << c;
        }
    }
}

TEST(Cut, is_the_halving_of_boxes_for_any_threads)
{
    for (const std::uint32_t limit : {1u, 8u, 16u, 64u, 1024u}) {
        for (const std::uint32_t crowding : {0u, 20u, 62u}) expect_cut_by_halving(random_keys(20000, crowding), limit);
    }
}

TEST(Cut, small_and_equal_sets)
{
    expect_cut_by_halving({}, 16);
    expect_cut_by_halving({7}, 16);
    expect_cut_by_halving(Keys(16, 123), 16);
    expect_cut_by_halving(Keys(17, 123), 16);
    expect_cut_by_halving(Keys(20000, std::uint64_t{1} << 62), 16);
    expect_cut_by_halving({0, 1, 2, 3, (std::uint64_t{1} << 63) - 1}, 2);
}

}  // namespace
}  // namespace corpuscle
