#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "math/vector3.hpp"

namespace corpuscle {

/// Distance of a point from a straight line between two others [m].
[[nodiscard]] inline double distance_to_segment(const Vector3d& point, const Vector3d& a, const Vector3d& b)
{
    const Vector3d along = b - a;
    const double length_squared = norm_squared(along);
    const double share = length_squared > 0 ? std::clamp(dot(point - a, along) / length_squared, 0.0, 1.0) : 0.0;
    return norm(point - a - share * along);
}

/// Distance of a point from a triangle [m]: from its plane where the foot of the perpendicular lies within, else from its nearest edge.
[[nodiscard]] inline double distance_to_triangle(const Vector3d& point, const std::array<Vector3d, 3>& corner)
{
    const Vector3d normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    bool within = norm_squared(normal) > 0;
    double nearest = norm(point - corner[0]);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector3d &a = corner[i], &b = corner[(i + 1) % 3];
        within = within && dot(cross(b - a, point - a), normal) >= 0;
        nearest = std::min(nearest, distance_to_segment(point, a, b));
    }
    return within ? std::abs(dot(point - corner[0], normal)) / norm(normal) : nearest;
}

}  // namespace corpuscle
