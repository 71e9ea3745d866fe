#pragma once

namespace corpuscle {

/// What the radial coordinate is: distance from a plane, an axis or a point.
enum class Symmetry { planar, cylindrical, spherical };

/// Area of the surface at a radius [m], for one unit of what lies around: a square metre of a plane, a radian and a metre of a
/// cylinder, a steradian of a sphere.
[[nodiscard]] constexpr double area(Symmetry symmetry, double radius)
{
    if (symmetry == Symmetry::planar) return 1;
    return symmetry == Symmetry::cylindrical ? radius : radius * radius;
}

/// Mean area over the way from one radius to another: times the way it is the volume swept, exactly.
[[nodiscard]] constexpr double swept_area(Symmetry symmetry, double from, double to)
{
    if (symmetry == Symmetry::planar) return 1;
    return symmetry == Symmetry::cylindrical ? 0.5 * (from + to) : (from * from + from * to + to * to) / 3;
}

/// Volume between two radii [m3], for one unit of what lies around.
[[nodiscard]] constexpr double volume_between(Symmetry symmetry, double inner, double outer)
{
    return (outer - inner) * swept_area(symmetry, inner, outer);
}

/// Units of what lies around in the whole: 1 m2, 2 pi for a metre of a cylinder, 4 pi for a sphere.
[[nodiscard]] constexpr double whole(Symmetry symmetry)
{
    constexpr double pi = 3.14159265358979323846;
    if (symmetry == Symmetry::planar) return 1;
    return symmetry == Symmetry::cylindrical ? 2 * pi : 4 * pi;
}

}  // namespace corpuscle
