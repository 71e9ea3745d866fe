#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "math/philox.hpp"
#include "math/vector3.hpp"

namespace corpuscle {

/// What a random stream is drawn for; keeps streams of the same step and index apart.
enum class Purpose : std::uint32_t { fill = 1, collide = 2, inflow = 3, contact = 4, packing = 5 };

/// Uniform in (0, 1) from 32 random bits: odd multiples of 2^-24, so that neither end is ever reached, not even by rounding.
[[nodiscard]] inline float unit_float(std::uint32_t word)
{
    return (static_cast<float>(word >> 9) + 0.5f) * 0x1p-23f;
}

/// Uniform in (0, 1) from 64 random bits: odd multiples of 2^-53.
[[nodiscard]] inline double unit_double(std::uint32_t high, std::uint32_t low)
{
    const std::uint64_t bits = (static_cast<std::uint64_t>(high) << 20) ^ (low >> 12);
    return (static_cast<double>(bits) + 0.5) * 0x1p-52;
}

/// Key of the streams of a purpose.
[[nodiscard]] inline std::array<std::uint32_t, 2> stream_key(std::uint64_t seed, Purpose purpose)
{
    return {static_cast<std::uint32_t>(seed) ^ (static_cast<std::uint32_t>(purpose) << 24),
            static_cast<std::uint32_t>(seed >> 32) + static_cast<std::uint32_t>(purpose) * 0x9E3779B9u};
}

/// First counter of the stream of (step, index); the first word counts on.
[[nodiscard]] inline std::array<std::uint32_t, 4> stream_counter(std::uint64_t step, std::uint64_t index)
{
    return {0, static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(step),
            static_cast<std::uint32_t>(index >> 32) ^ static_cast<std::uint32_t>(step >> 32) << 16};
}

/// A stream of random numbers that belongs to (seed, purpose, step, index) and to nothing else: the same on any thread.
class Random {
public:
    Random(std::uint64_t seed, Purpose purpose, std::uint64_t step, std::uint64_t index)
        : key_(stream_key(seed, purpose)), counter_(stream_counter(step, index))
    {
    }

    /// 32 random bits.
    std::uint32_t word()
    {
        if (used_ == 4) {
            words_ = philox(counter_, key_);
            ++counter_[0];
            used_ = 0;
        }
        return words_[used_++];
    }

    /// Uniform in (0, 1), 23 bits: never 0, never 1.
    float uniform() { return unit_float(word()); }

    /// Uniform in (0, 1), 52 bits: never 0, never 1.
    double uniform_double()
    {
        const std::uint32_t high = word(), low = word();
        return unit_double(high, low);
    }

    /// Uniform integer in [0, n).
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>((static_cast<std::uint64_t>(word()) * n) >> 32); }

    /// Normal variate of mean 0 and variance 1 (Box and Muller 1958).
    double normal()
    {
        const double radius = std::sqrt(-2.0 * std::log(uniform_double()));
        return radius * std::cos(2.0 * std::numbers::pi * uniform_double());
    }

    /// Gamma variate of the given shape (> 0) and scale 1 (Marsaglia and Tsang 2000).
    double gamma(double shape)
    {
        if (shape < 1.0) return gamma(shape + 1.0) * std::pow(uniform_double(), 1.0 / shape);
        const double d = shape - 1.0 / 3.0, c = 1.0 / std::sqrt(9.0 * d);
        while (true) {
            const double x = normal();
            const double v = std::pow(1.0 + c * x, 3);
            if (v > 0.0 && std::log(uniform_double()) < 0.5 * x * x + d - d * v + d * std::log(v)) return d * v;
        }
    }

    /// A direction uniform on the unit sphere.
    Vector3f direction()
    {
        const float cosine = 2.0f * uniform() - 1.0f;
        const float angle = 2.0f * std::numbers::pi_v<float> * uniform();
        const float sine = std::sqrt(1.0f - cosine * cosine);
        return {sine * std::cos(angle), sine * std::sin(angle), cosine};
    }

private:
    std::array<std::uint32_t, 2> key_;
    std::array<std::uint32_t, 4> counter_;
    std::array<std::uint32_t, 4> words_{};
    int used_ = 4;
};

}  // namespace corpuscle
