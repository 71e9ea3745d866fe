#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "math/vector3.hpp"

namespace corpuscle {

/// The value a number takes when it is stored as a float (to nearest, ties to even), still as a double; numbers below the smallest
/// normal float keep its relative precision. Not written as a cast to float and back: GCC 12 drops that pair of casts where it
/// vectorises (it compares the precision of vector types, which is that of their length).
[[nodiscard]] inline double single(double x)
{
    if (!(std::abs(x) <= static_cast<double>(std::numeric_limits<float>::max()))) return x;
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    return std::bit_cast<double>((bits + 0x0FFFFFFFu + (bits >> 29 & 1u)) & ~std::uint64_t{0x1FFFFFFF});
}

/// Component by component.
[[nodiscard]] inline Vector3d single(const Vector3d& v)
{
    return {single(v.x), single(v.y), single(v.z)};
}

}  // namespace corpuscle
