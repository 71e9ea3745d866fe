#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "gas/curve.hpp"
#include "gas/domain.hpp"
#include "math/box.hpp"

namespace corpuscle {

/// Where gas is disturbed from, and how far from there the disturbance may have come.
struct Disturbance {
    Box box;           ///< [m]
    double reach = 0;  ///< [m]
};

/// A box of the curve whose gas sleeps.
struct SleepingZone {
    std::uint32_t number = 0;  ///< among the boxes of its depth, along the curve
    std::uint32_t particles = 0;
};

/// How the gas in a box of the curve is.
namespace zone_state {
inline constexpr std::uint8_t awake = 0;
inline constexpr std::uint8_t asleep = 1;
inline constexpr std::uint8_t asleep_near_facet = 2;  ///< one is in the box or close by
}  // namespace zone_state

/// Gas that cannot yet know of any event: it stays as it was filled and costs nothing until a disturbance may have come near. To the gas
/// beside it, a zone asleep is a plane of symmetry. Its particles are the first of the gas's, zone after zone.
struct SleepingGas {
    std::vector<Disturbance> disturbances;  ///< none: no gas sleeps
    std::optional<Box> movable;             ///< about all of the structure that can move [m]
    bool movable_woken = false;             ///< it is among the disturbances
    std::vector<double> found;              ///< how far each disturbance was seen in the last step [m]

    int depth = 0;                          ///< of the zones
    std::vector<SleepingZone> zones;        ///< in the order of their particles
    std::vector<std::uint8_t> state;        ///< by the zone's number: see zone_state
    std::uint32_t particles = 0;            ///< in all zones
    Passage held;                           ///< by them
    std::array<double, face_count> area{};  ///< of each face of the domain that they touch [m2]
    Passage turned;                         ///< impulse on them, of awake gas and of the domain's rigid faces, since the start

    [[nodiscard]] bool any() const { return particles > 0; }
    [[nodiscard]] std::uint32_t zone_of(std::uint64_t key) const
    {
        return static_cast<std::uint32_t>(key >> (CellCurve::depth_limit - depth));
    }
    /// Whether gas sleeps at a place of this key.
    [[nodiscard]] bool holds(std::uint64_t key) const { return any() && state[zone_of(key)] != zone_state::awake; }
};

/// Distance from a point to a box, 0 inside [m].
[[nodiscard]] inline double distance(const Box& box, const Vector3d& point)
{
    Vector3d outside;
    for (int a = 0; a < 3; ++a) outside[a] = std::max({box.lower[a] - point[a], point[a] - box.upper[a], 0.0});
    return norm(outside);
}

/// Distance between two boxes, 0 if they touch [m].
[[nodiscard]] inline double distance(const Box& a, const Box& b)
{
    Vector3d between;
    for (int k = 0; k < 3; ++k) between[k] = std::max({a.lower[k] - b.upper[k], b.lower[k] - a.upper[k], 0.0});
    return norm(between);
}

}  // namespace corpuscle
