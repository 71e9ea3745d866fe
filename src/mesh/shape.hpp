#pragma once

#include <memory>
#include <string>
#include <variant>

#include "math/box.hpp"
#include "mesh/mesh.hpp"

namespace corpuscle {

class ClosedSurface;

/// Axis-parallel ellipsoid; a sphere has three equal semi-axes.
struct Ellipsoid {
    Vector3d center;     ///< [m]
    Vector3d semi_axes;  ///< [m]
};

/// The half of a ball on the side of its center to which `axis` points.
struct Hemisphere {
    Vector3d center;    ///< of the whole ball [m]
    double radius = 0;  ///< [m]
    Vector3d axis;      ///< unit vector from the flat face into the dome
};

/// Circular cylinder with flat ends.
struct Cylinder {
    Vector3d center;    ///< middle of its axis [m]
    double radius = 0;  ///< [m]
    double length = 0;  ///< along the axis [m]
    Vector3d axis;      ///< unit vector
};

/// A region of space, for charges and fills: a value, cheap to copy. Its boundary belongs to it (up to round-off).
/// Makers refuse sizes that are not above 0, zero axes and surfaces with holes by InputError.
class Shape {
public:
    static Shape box(const Box& box);
    static Shape sphere(const Vector3d& center, double radius);
    /// The half of the ball to which `axis` (any length) points.
    static Shape hemisphere(const Vector3d& center, double radius, const Vector3d& axis);
    /// `center` is the middle, `axis` may have any length.
    static Shape cylinder(const Vector3d& center, double radius, double length, const Vector3d& axis);
    static Shape ellipsoid(const Vector3d& center, const Vector3d& semi_axes);
    /// Inside of a closed surface of triangles and quadrilaterals, whose orientation is repaired; `name` is used in errors.
    static Shape surface(const Mesh& mesh, const std::string& name);

    [[nodiscard]] bool contains(const Vector3d& point) const;
    [[nodiscard]] Box bounds() const;     ///< smallest axis-parallel box around it [m]
    [[nodiscard]] double volume() const;  ///< of the whole shape, exact [m3]
    /// Volume of the part within `box` [m3]: round-off for boxes, surfaces and cuts through the center, else better than 1e-8 of the whole.
    [[nodiscard]] double volume_within(const Box& box) const;
    /// Whether more than 1e-9 of the shape lies within the box.
    [[nodiscard]] bool overlaps(const Box& box) const;

private:
    using SurfacePointer = std::shared_ptr<const ClosedSurface>;
    using Kind = std::variant<Box, Ellipsoid, Hemisphere, Cylinder, SurfacePointer>;
    explicit Shape(Kind kind) : kind_(std::move(kind)) {}

    Kind kind_;
};

}  // namespace corpuscle
