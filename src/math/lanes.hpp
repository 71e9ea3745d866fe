#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <experimental/simd>

namespace corpuscle {

/// Numbers in a `Lanes`: the same on every machine, so that stored blocks look alike everywhere.
inline constexpr int lane_count = 4;

/// Numbers of several things, computed side by side. Kernels written for a type `Real` take `double` or `Lanes`.
using Lanes = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, lane_count>>;
using LaneMask = Lanes::mask_type;

/// Reads the lanes from `lane_count` numbers.
inline Lanes load_lanes(const double* values)
{
    return Lanes(values, std::experimental::element_aligned);
}

/// Writes the lanes to `lane_count` numbers.
inline void store_lanes(const Lanes& lanes, double* values)
{
    lanes.copy_to(values, std::experimental::element_aligned);
}

/// Asks memory for so many bytes that will be read and written soon.
inline void prefetch(const void* first, std::size_t bytes)
{
    constexpr std::size_t line = 64;
    for (std::size_t at = 0; at < bytes; at += line) __builtin_prefetch(static_cast<const char*>(first) + at, 1);
}

/// Lane by lane: `yes` where the mask is set, else `no`.
inline Lanes select(const LaneMask& mask, const Lanes& yes, const Lanes& no)
{
    Lanes result = no;
    std::experimental::where(mask, result) = yes;
    return result;
}
inline double select(bool mask, double yes, double no)
{
    return mask ? yes : no;
}

/// True if the condition holds in any lane.
inline bool any(const LaneMask& mask)
{
    return std::experimental::any_of(mask);
}
inline bool any(bool mask)
{
    return mask;
}

inline Lanes square_root(const Lanes& a)
{
    return std::experimental::sqrt(a);
}
inline double square_root(double a)
{
    return std::sqrt(a);
}

inline Lanes larger(const Lanes& a, const Lanes& b)
{
    return select(a > b, a, b);
}
inline double larger(double a, double b)
{
    return std::max(a, b);
}

inline Lanes magnitude(const Lanes& a)
{
    return select(a < 0.0, -a, a);
}
inline double magnitude(double a)
{
    return std::abs(a);
}

/// base^exponent for base >= 0.
inline Lanes power(const Lanes& base, double exponent)
{
    return Lanes([&](auto lane) { return std::pow(base[lane], exponent); });
}
inline double power(double base, double exponent)
{
    return std::pow(base, exponent);
}

/// base^exponent by repeated multiplication.
template <class Real>
Real integer_power(const Real& base, int exponent)
{
    Real result = 1.0;
    for (int i = 0; i < exponent; ++i) result = result * base;
    return result;
}

}  // namespace corpuscle
