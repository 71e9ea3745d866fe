#pragma once

#include <functional>

#include "math/box.hpp"

namespace corpuscle {

/// A body of revolution: circles of radius(s) around the points center + s * axis.
struct Revolved {
    Vector3d center;                       ///< [m]
    Vector3d axis;                         ///< unit vector
    double lower = 0, upper = 0;           ///< range of s [m]
    std::function<double(double)> radius;  ///< of the circle at s [m]
};

/// Volume of the part of a body of revolution within a box [m3]: the exact areas of circle and box in planes normal to the axis, summed by
/// adaptive Gauss-Kronrod quadrature to 1e-10 of the volume of the body's bounding cylinder.
[[nodiscard]] double volume_within(const Box& box, const Revolved& body);

/// Area of the part of a convex polygon within the circle of the given radius about the origin, positive for corners in
/// counter-clockwise order; z is not used. [m2]
[[nodiscard]] double circle_polygon_area(const Vector3d* corners, int count, double radius);

}  // namespace corpuscle
