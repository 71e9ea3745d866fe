#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace corpuscle {

/// A 64-bit checksum of a stream of bytes, against torn and damaged files (not against forgers). Every step is invertible, so a change
/// within one 8-byte word is always seen, and any other with probability 1 - 2^-64 or so. Four independent lanes keep it at memory speed.
class Checksum {
public:
    void add(std::span<const std::byte> bytes);
    /// Of all bytes so far; their number is part of it.
    [[nodiscard]] std::uint64_t value() const;

private:
    void add_block(const std::byte* block);

    static constexpr std::size_t block_size = 32;
    std::array<std::uint64_t, 4> lanes_{0x243F6A8885A308D3U, 0x13198A2E03707344U, 0xA4093822299F31D0U,
                                        0x082EFA98EC4E6C89U};  // digits of pi
    std::array<std::byte, block_size> rest_{};
    std::size_t rest_size_ = 0;
    std::uint64_t length_ = 0;
};

}  // namespace corpuscle
