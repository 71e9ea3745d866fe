#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "laws/collision/larsen_borgnakke.hpp"
#include "math/fast.hpp"
#include "math/random.hpp"
#include "parallel/philox_block.hpp"

namespace corpuscle {

/// The random numbers of collisions, made many at a time in loops that vectorise: words, directions, internal shares of energy.
/// What is drawn depends on (seed, step, index) and on the order of the draws, not on threads.
class Dice {
public:
    Dice(std::uint64_t seed, std::uint64_t step, std::uint64_t index, std::span<const LarsenBorgnakke> exchanges)
        : key_(stream_key(seed, Purpose::collide)), counter_(stream_counter(step, index)), exchanges_(exchanges), shares_(exchanges.size())
    {
    }

    /// 32 random bits.
    std::uint32_t word()
    {
        if (words_used_ == block_words) {
            refill(words_);
            words_used_ = 0;
        }
        return words_[words_used_++];
    }

    /// A direction uniform on the unit sphere.
    Vector3f direction()
    {
        if (directions_used_ == block_words) throw_directions();
        const std::size_t i = directions_used_++;
        return {x_[i], y_[i], z_[i]};
    }

    /// Internal share of the energy that a particle of a species has in common with the relative motion of its pair.
    float internal_share(std::uint32_t species)
    {
        Shares& shares = shares_[species];
        if (shares.used == block_words) throw_shares(shares, exchanges_[species]);
        return shares.values[shares.used++];
    }

private:
    struct Shares {
        std::array<float, block_words> values;
        std::size_t used = block_words;
    };

    void refill(WordBlock& words)
    {
        philox_block(counter_, key_, words);
        counter_[0] += block_words / 4;
    }

    void throw_directions()
    {
        WordBlock first, second;
        refill(first);
        refill(second);
        for (std::size_t i = 0; i < block_words; ++i) {
            const float cosine = 2 * unit_float(first[i]) - 1, sine = std::sqrt(1 - cosine * cosine);
            const Turn turn = fast_turn(unit_float(second[i]));
            // Directions too short in the mean would cool the gas: a step of Newton's in double, rounded up or down at random, with the
            // bits that are left of the words.
            const double x = sine * turn.cosine, y = sine * turn.sine, z = cosine;
            const double scale = 1.5 - 0.5 * (x * x + y * y + z * z);
            x_[i] = round_at_random(x * scale, first[i]);
            y_[i] = round_at_random(y * scale, second[i]);
            z_[i] = round_at_random(z * scale, first[i] ^ second[i]);
        }
        directions_used_ = 0;
    }

    void throw_shares(Shares& shares, const LarsenBorgnakke& law)
    {
        WordBlock first, second;
        refill(first);
        refill(second);
        for (std::size_t i = 0; i < block_words; ++i) shares.values[i] = law.internal_share(unit_float(first[i]), unit_float(second[i]));
        shares.used = 0;
    }

    std::array<std::uint32_t, 2> key_;
    std::array<std::uint32_t, 4> counter_;
    std::span<const LarsenBorgnakke> exchanges_;
    WordBlock words_;
    std::array<float, block_words> x_, y_, z_;
    std::size_t words_used_ = block_words, directions_used_ = block_words;
    std::vector<Shares> shares_;
};

}  // namespace corpuscle
