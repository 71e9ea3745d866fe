#pragma once

#include <array>
#include <cstdint>

#include "structure/nodes.hpp"

namespace corpuscle {

/// Gives a node an impulse [N s]; returns the work it does, impulse times the mean of the velocities before and after [J].
inline double push_node(Nodes& nodes, std::uint32_t node, const Vector3d& impulse)
{
    const Vector3d before = nodes.contact_velocity(node);
    nodes.push(node, impulse);
    return 0.5 * dot(impulse, before + nodes.contact_velocity(node));
}

/// Area times normal of a triangle as it stands half way through the step [m2].
inline Vector3d middle_area(const Nodes& nodes, const std::array<std::uint32_t, 3>& node)
{
    const auto middle = [&](std::uint32_t n) { return 0.5 * (nodes.previous[n] + nodes.position[n]); };
    const Vector3d a = middle(node[0]);
    return 0.5 * cross(middle(node[1]) - a, middle(node[2]) - a);
}

}  // namespace corpuscle
