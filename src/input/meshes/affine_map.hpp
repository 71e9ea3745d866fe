#pragma once

#include "math/vector3.hpp"

namespace corpuscle {

/// Where a body is put: x to shift + x.x columns[0] + x.y columns[1] + x.z columns[2]. [m]
struct AffineMap {
    Vector3d column_x{1, 0, 0}, column_y{0, 1, 0}, column_z{0, 0, 1};
    Vector3d shift;

    /// What a direction becomes: the map without its shift.
    [[nodiscard]] Vector3d turned(const Vector3d& direction) const
    {
        return direction.x * column_x + direction.y * column_y + direction.z * column_z;
    }
    [[nodiscard]] Vector3d operator()(const Vector3d& place) const { return turned(place) + shift; }
    /// By what it multiplies volumes; negative if it makes left hands of right ones.
    [[nodiscard]] double determinant() const { return dot(column_x, cross(column_y, column_z)); }
    /// This map after another one.
    [[nodiscard]] AffineMap after(const AffineMap& first) const
    {
        return {turned(first.column_x), turned(first.column_y), turned(first.column_z), (*this)(first.shift)};
    }
};

/// Moves by a vector.
[[nodiscard]] AffineMap moved_by(const Vector3d& shift);
/// Stretches along the axes, from the origin.
[[nodiscard]] AffineMap stretched_by(const Vector3d& factors);
/// Turns by an angle [rad] about the line through a point along an axis (any length, not zero), by the right hand.
[[nodiscard]] AffineMap turned_about(const Vector3d& point, const Vector3d& axis, double angle);
/// Mirrors in the plane through a point across a normal (any length, not zero).
[[nodiscard]] AffineMap mirrored_in(const Vector3d& point, const Vector3d& normal);

}  // namespace corpuscle
