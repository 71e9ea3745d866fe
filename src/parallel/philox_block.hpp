#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "parallel/wide.hpp"

namespace corpuscle {

/// Words of a block of Philox4x32-10.
inline constexpr std::size_t block_words = 4 * wide_lanes;
using WordBlock = std::array<std::uint32_t, block_words>;

/// Sixteen counters at once, `counter[0]` and the fifteen that follow: word w of counter c stands at w * 16 + c. The same words as
/// `philox` (math/philox.hpp) gives one counter at a time.
inline void philox_block(const std::array<std::uint32_t, 4>& counter, std::array<std::uint32_t, 2> key, WordBlock& words)
{
    constexpr std::uint32_t multiplier_0 = 0xD2511F53, multiplier_1 = 0xCD9E8D57;
    constexpr std::uint32_t weyl_0 = 0x9E3779B9, weyl_1 = 0xBB67AE85;
    WideWord a = lane_numbers + counter[0], b = WideWord{} + counter[1], c = WideWord{} + counter[2], d = WideWord{} + counter[3];
    for (int round = 0; round < 10; ++round) {
        WideWord high_a, low_a, high_c, low_c;
        multiply(a, multiplier_0, high_a, low_a);
        multiply(c, multiplier_1, high_c, low_c);
        a = high_c ^ b ^ key[0];
        b = low_c;
        c = high_a ^ d ^ key[1];
        d = low_a;
        key[0] += weyl_0;
        key[1] += weyl_1;
    }
    write_lanes(a, words.data());
    write_lanes(b, words.data() + wide_lanes);
    write_lanes(c, words.data() + 2 * wide_lanes);
    write_lanes(d, words.data() + 3 * wide_lanes);
}

}  // namespace corpuscle
