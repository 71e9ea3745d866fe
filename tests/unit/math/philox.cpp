#include "math/philox.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace corpuscle {
namespace {

using Counter = std::array<std::uint32_t, 4>;
using Key = std::array<std::uint32_t, 2>;

// The three known answers that the authors of Random123 publish for philox4x32 with 10 rounds (their kat_vectors).
TEST(Philox, GivesThePublishedAnswers)
{
    EXPECT_EQ(philox(Counter{0, 0, 0, 0}, Key{0, 0}), (Counter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    constexpr std::uint32_t ones = 0xffffffff;
    EXPECT_EQ(philox(Counter{ones, ones, ones, ones}, Key{ones, ones}), (Counter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
    EXPECT_EQ(philox(Counter{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, Key{0xa4093822, 0x299f31d0}),
              (Counter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

int differing_bits(const Counter& a, const Counter& b)
{
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += std::popcount(a[i] ^ b[i]);
    return count;
}

// Each of the 192 input bits changes about half of the 128 output bits: the mean over them is 64 with deviation sqrt(32 / 192).
TEST(Philox, EveryInputBitChangesHalfTheOutput)
{
    const Counter counter{1, 2, 3, 4};
    const Key key{5, 6};
    const Counter base = philox(counter, key);
    double total = 0;
    for (int bit = 0; bit < 192; ++bit) {
        Counter c = counter;
        Key k = key;
        (bit < 128 ? c[bit / 32] : k[(bit - 128) / 32]) ^= 1u << (bit % 32);
        const int changed = differing_bits(base, philox(c, k));
        EXPECT_GT(changed, 30) << "input bit " << bit;  // 6 deviations below 64
        total += changed;
    }
    EXPECT_NEAR(total / 192, 64.0, 4.0 * std::sqrt(32.0 / 192.0));
}

}  // namespace
}  // namespace corpuscle
