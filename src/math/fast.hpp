#pragma once

#include <bit>
#include <cstdint>

namespace corpuscle {

/// Base-2 logarithm of a normal float x > 0, error below 1e-7 besides rounding: the mantissa's part by the series of atanh about
/// sqrt(1/2)..sqrt 2. No branch, no table: compilers vectorise loops over it.
[[nodiscard]] inline float fast_log2(float x)
{
    const std::int32_t bits = std::bit_cast<std::int32_t>(x);
    const std::int32_t exponent = (bits - 0x3F3504F3) >> 23;  // 0x3F3504F3: sqrt(1/2)
    const float mantissa = std::bit_cast<float>(bits - exponent * (1 << 23));
    const float t = (mantissa - 1) / (mantissa + 1), s = t * t;
    const float series = 2.885390082f + s * (0.961796694f + s * (0.577078016f + s * (0.412198583f + s * 0.320598898f)));
    return static_cast<float>(exponent) + t * series;
}

/// 2^x for -126 < x < 127 (less counts as -126), relative error below 3e-7.
[[nodiscard]] inline float fast_exp2(float x)
{
    const float bounded = x > -126.0f ? x : -126.0f;
    const float rounded = bounded + 12582912.0f;  // 1.5 * 2^23: the nearest whole number is in the last bits
    const float fraction = bounded - (rounded - 12582912.0f);
    const float series =
        1 + fraction * (0.693147181f +
                        fraction * (0.240226507f +
                                    fraction * (0.0555041087f +
                                                fraction * (0.00961812911f + fraction * (0.00133335581f + fraction * 0.000154035304f)))));
    const std::int32_t whole = std::bit_cast<std::int32_t>(rounded) - 0x4B400000;
    return std::bit_cast<float>(std::bit_cast<std::int32_t>(series) + whole * (1 << 23));
}

/// e^x for -708 < x < 709 (less counts as -708), relative error below 4e-16: Taylor's series about the nearest whole power of two.
[[nodiscard]] inline double fast_exp(double x)
{
    constexpr double shift = 6755399441055744.0;  // 1.5 * 2^52: the nearest whole number is in the last bits
    const double bounded = x > -708.0 ? x : -708.0;
    const double rounded = bounded * 1.4426950408889634 + shift, whole = rounded - shift;
    const double r = (bounded - whole * 6.93147180369123816490e-01) - whole * 1.90821492927058770002e-10;
    double series = 1.0 / 479001600;
    series = series * r + 1.0 / 39916800;
    series = series * r + 1.0 / 3628800;
    series = series * r + 1.0 / 362880;
    series = series * r + 1.0 / 40320;
    series = series * r + 1.0 / 5040;
    series = series * r + 1.0 / 720;
    series = series * r + 1.0 / 120;
    series = series * r + 1.0 / 24;
    series = series * r + 1.0 / 6;
    series = series * r + 0.5;
    series = (series * r + 1.0) * r + 1.0;
    const std::int64_t power = std::bit_cast<std::int64_t>(rounded) - std::bit_cast<std::int64_t>(shift);
    return std::bit_cast<double>(std::bit_cast<std::int64_t>(series) + power * (std::int64_t(1) << 52));
}

/// One of the two floats next to a number, each as often as makes the mean right; by the lowest 8 of some random bits.
[[nodiscard]] inline float round_at_random(double exact, std::uint32_t random)
{
    constexpr int lost = 29;  // bits of a double's fraction that a float does not have
    const std::uint64_t added = (std::uint64_t{random & 0xFFu} << (lost - 8)) + (std::uint64_t{1} << (lost - 9));
    const std::uint64_t bits = (std::bit_cast<std::uint64_t>(exact) + added) >> lost << lost;
    return static_cast<float>(std::bit_cast<double>(bits));
}

/// Cosine and sine of a turn.
struct Turn {
    float cosine, sine;
};

/// Cosine and sine of 2 pi u for 0 <= u <= 1, error below 5e-7: Taylor's series of half the angle, doubled.
[[nodiscard]] inline Turn fast_turn(float u)
{
    const float a = 3.14159265f * (u - 0.5f), s = a * a;
    const float sine =
        a * (1 + s * (-1.66666667e-1f + s * (8.33333333e-3f + s * (-1.98412698e-4f + s * (2.75573192e-6f + s * -2.50521084e-8f)))));
    const float cosine =
        1 + s * (-0.5f + s * (4.16666667e-2f + s * (-1.38888889e-3f + s * (2.48015873e-5f + s * (-2.75573192e-7f + s * 2.08767570e-9f)))));
    return {sine * sine - cosine * cosine, -2 * sine * cosine};  // turned on by half a turn, as u - 1/2 was taken
}

}  // namespace corpuscle
