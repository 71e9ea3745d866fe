#pragma once

#include <cstdint>

#include "math/vector3.hpp"

namespace corpuscle {

/// A lump of molecules that moves and collides as one hard molecule (Maxwell 1860; Olovsson; Teng and Wang): 32 bytes.
struct alignas(32) Particle {
    Vector3f position;      ///< [m]
    float energy = 0;       ///< internal ("spin") energy [J]
    Vector3f velocity;      ///< [m/s]
    std::uint32_t tag = 0;  ///< species, charge and state: see the functions below
};
static_assert(sizeof(Particle) == 32);

namespace particle_tag {

inline constexpr std::uint32_t unburnt = 1u << 16;  ///< explosive the detonation has not reached: at rest, not hit
inline constexpr std::uint32_t gone = 1u << 17;     ///< has left the domain; dropped at the next sort

constexpr std::uint32_t make(std::uint32_t species, std::uint32_t charge = 0, std::uint32_t state = 0)
{
    return species | charge << 8 | state;
}
constexpr std::uint32_t species(std::uint32_t tag)
{
    return tag & 0xFFu;
}
constexpr std::uint32_t charge(std::uint32_t tag)
{
    return tag >> 8 & 0xFFu;
}

}  // namespace particle_tag

}  // namespace corpuscle
