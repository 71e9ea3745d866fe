#include "input/meshes/affine_map.hpp"

#include <cmath>

namespace corpuscle {

namespace {

/// The linear map of these columns, about a point that stays where it is.
AffineMap about(const Vector3d& point, AffineMap map)
{
    map.shift = point - map.turned(point);
    return map;
}

}  // namespace

AffineMap moved_by(const Vector3d& shift)
{
    AffineMap map;
    map.shift = shift;
    return map;
}

AffineMap stretched_by(const Vector3d& factors)
{
    return {{factors.x, 0, 0}, {0, factors.y, 0}, {0, 0, factors.z}, {}};
}

AffineMap turned_about(const Vector3d& point, const Vector3d& axis, double angle)
{
    const Vector3d n = normalized(axis);
    const auto image = [&](const Vector3d& e) {
        return std::cos(angle) * e + std::sin(angle) * cross(n, e) + (1 - std::cos(angle)) * dot(n, e) * n;
    };
    return about(point, {image({1, 0, 0}), image({0, 1, 0}), image({0, 0, 1}), {}});
}

AffineMap mirrored_in(const Vector3d& point, const Vector3d& normal)
{
    const Vector3d n = normalized(normal);
    const auto image = [&](const Vector3d& e) { return e - 2 * dot(n, e) * n; };
    return about(point, {image({1, 0, 0}), image({0, 1, 0}), image({0, 0, 1}), {}});
}

}  // namespace corpuscle
