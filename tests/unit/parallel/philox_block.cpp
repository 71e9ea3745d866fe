#include "parallel/philox_block.hpp"

#include "math/philox.hpp"

#include <gtest/gtest.h>

namespace corpuscle {
namespace {

TEST(PhiloxBlock, is_philox_of_sixteen_counters)
{
    const std::array<std::uint32_t, 2> key{0xa4093822, 0x299f31d0};
    for (const std::uint32_t start : {0u, 0x243f6a88u, 0xFFFFFFFFu}) {
        const std::array<std::uint32_t, 4> counter{start, 0x85a308d3, 0x13198a2e, 0x03707344};
        WordBlock words;
        philox_block(counter, key, words);
        for (std::uint32_t c = 0; c < 16; ++c) {
            const auto alone = philox({start + c, counter[1], counter[2], counter[3]}, key);
            for (std::uint32_t w = 0; w < 4; ++w) EXPECT_EQ(words[w * 16 + c], alone[w]);
        }
    }
}

}  // namespace
}  // namespace corpuscle
