#include "output/checksum.hpp"

#include <algorithm>
#include <cstring>

namespace corpuscle {

namespace {

/// One word taken into a lane: xor, an odd factor (2^64 over the golden ratio) and a shift are all invertible.
constexpr std::uint64_t mixed(std::uint64_t lane, std::uint64_t word)
{
    lane = (lane ^ word) * 0x9E3779B97F4A7C15U;
    return lane ^ (lane >> 29U);
}

}  // namespace

void Checksum::add(std::span<const std::byte> bytes)
{
    length_ += bytes.size();
    if (rest_size_ > 0) {
        const std::size_t taken = std::min(block_size - rest_size_, bytes.size());
        std::copy_n(bytes.begin(), taken, rest_.begin() + static_cast<std::ptrdiff_t>(rest_size_));
        rest_size_ += taken;
        bytes = bytes.subspan(taken);
        if (rest_size_ < block_size) return;
        add_block(rest_.data());
    }
    for (; bytes.size() >= block_size; bytes = bytes.subspan(block_size)) add_block(bytes.data());
    std::copy(bytes.begin(), bytes.end(), rest_.begin());
    rest_size_ = bytes.size();
}

void Checksum::add_block(const std::byte* block)
{
    std::array<std::uint64_t, 4> words{};
    std::memcpy(words.data(), block, block_size);
    for (std::size_t lane = 0; lane < 4; ++lane) lanes_[lane] = mixed(lanes_[lane], words[lane]);
}

std::uint64_t Checksum::value() const
{
    Checksum closed = *this;
    if (rest_size_ > 0) {
        std::fill(closed.rest_.begin() + static_cast<std::ptrdiff_t>(rest_size_), closed.rest_.end(), std::byte{0});
        closed.add_block(closed.rest_.data());
    }
    std::uint64_t sum = length_;
    for (const std::uint64_t lane : closed.lanes_) sum = mixed(sum, lane);
    return sum;
}

}  // namespace corpuscle
