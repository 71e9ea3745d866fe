#pragma once

#include <cstdint>
#include <cstring>

namespace corpuscle {

/// Sixteen words that are worked on at once: one register, two or four, as the machine has them. The same words on any machine.
inline constexpr int wide_lanes = 16;
using WideWord [[gnu::vector_size(64)]] = std::uint32_t;
using WideLong [[gnu::vector_size(64)]] = std::uint64_t;  ///< the same as eight words of twice the length

/// 0, 1, 2, ...
inline constexpr WideWord lane_numbers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/// Writes the lanes to memory.
inline void write_lanes(const WideWord& lanes, std::uint32_t* to)
{
    std::memcpy(to, &lanes, sizeof(lanes));
}

inline constexpr std::uint64_t low_word = 0xFFFFFFFF;

/// The high and the low words of a product, lane by lane.
inline void multiply(const WideWord& a, std::uint32_t factor, WideWord& high, WideWord& low)
{
    const WideLong words = reinterpret_cast<WideLong>(a), even = (words & low_word) * factor, odd = (words >> 32) * factor;
    high = reinterpret_cast<WideWord>((even >> 32) | (odd & ~low_word));
    low = reinterpret_cast<WideWord>((even & low_word) | (odd << 32));
}

}  // namespace corpuscle
