#pragma once

#include <array>
#include <cstdint>

#include "structure/nodes.hpp"

namespace corpuscle {

/// Gives a node the impulse of a load [N s] over a step of `duration` [s]; returns the work it does [J]. Central difference has velocities
/// half a step before the forces: the load acts on the velocity in the middle, after half a step of the inner force.
inline double push_node(Nodes& nodes, std::uint32_t node, const Vector3d& impulse, double duration)
{
    const Vector3d before = nodes.contact_velocity(node);
    nodes.push(node, impulse);
    const Vector3d after = nodes.contact_velocity(node);
    const double inner = nodes.mass[node] > 0 ? 0.5 * duration * dot(nodes.force[node], after - before) : 0.0;
    return 0.5 * dot(impulse, before + after) + inner;
}

/// Area times normal of a triangle as it stands half way through the step [m2].
inline Vector3d middle_area(const Nodes& nodes, const std::array<std::uint32_t, 3>& node)
{
    const auto middle = [&](std::uint32_t n) { return 0.5 * (nodes.previous[n] + nodes.position[n]); };
    const Vector3d a = middle(node[0]);
    return 0.5 * cross(middle(node[1]) - a, middle(node[2]) - a);
}

}  // namespace corpuscle
