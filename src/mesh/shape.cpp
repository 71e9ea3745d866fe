#include "mesh/shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/error.hpp"
#include "mesh/closed_surface.hpp"
#include "mesh/revolved.hpp"

namespace corpuscle {

namespace {

constexpr double pi = std::numbers::pi;

void require_finite(const Vector3d& point, const char* what)
{
    if (!std::isfinite(norm_squared(point))) throw InputError(fmt::format("{} is not finite", what), "give three numbers");
}

void require_length(double value, const char* what)
{
    if (!(value > 0.0) || !std::isfinite(value)) throw InputError(fmt::format("{} is {:.6g} m", what, value), "give a length above 0");
}

Vector3d require_axis(const Vector3d& axis, const char* what)
{
    require_finite(axis, what);
    if (!(norm(axis) > 0.0)) throw InputError(fmt::format("{} has no direction", what), "give a direction such as [0, 0, 1]");
    return normalized(axis);
}

/// One face of the variant for each kind of shape; found by overload.
bool contains_point(const Box& box, const Vector3d& point)
{
    return box.contains(point);
}

bool contains_point(const Ellipsoid& e, const Vector3d& point)
{
    const Vector3d arm = point - e.center;
    return norm_squared(Vector3d{arm.x / e.semi_axes.x, arm.y / e.semi_axes.y, arm.z / e.semi_axes.z}) <= 1.0;
}

bool contains_point(const Hemisphere& h, const Vector3d& point)
{
    const Vector3d arm = point - h.center;
    return dot(arm, h.axis) >= 0.0 && norm_squared(arm) <= h.radius * h.radius;
}

bool contains_point(const Cylinder& c, const Vector3d& point)
{
    const Vector3d arm = point - c.center;
    const double along = dot(arm, c.axis);
    return std::abs(along) <= 0.5 * c.length && norm_squared(arm - along * c.axis) <= c.radius * c.radius;
}

bool contains_point(const std::shared_ptr<const ClosedSurface>& surface, const Vector3d& point)
{
    return surface->contains(point);
}

Box bounds_of(const Box& box)
{
    return box;
}

Box bounds_of(const Ellipsoid& e)
{
    return {e.center - e.semi_axes, e.center + e.semi_axes};
}

/// How far a disk with the given normal and radius reaches along a coordinate axis.
double disk_reach(double radius, double normal_component)
{
    return radius * std::sqrt(std::max(0.0, 1.0 - normal_component * normal_component));
}

Box bounds_of(const Hemisphere& h)
{
    Box box{h.center, h.center};
    for (int a = 0; a < 3; ++a) {
        const double reach = disk_reach(h.radius, h.axis[a]);
        box.upper[a] += h.axis[a] > 0.0 ? h.radius : reach;
        box.lower[a] -= h.axis[a] < 0.0 ? h.radius : reach;
    }
    return box;
}

Box bounds_of(const Cylinder& c)
{
    Box box{c.center, c.center};
    for (int a = 0; a < 3; ++a) {
        const double reach = 0.5 * c.length * std::abs(c.axis[a]) + disk_reach(c.radius, c.axis[a]);
        box.upper[a] += reach;
        box.lower[a] -= reach;
    }
    return box;
}

Box bounds_of(const std::shared_ptr<const ClosedSurface>& surface)
{
    return surface->bounds();
}

double volume_of(const Box& box)
{
    return box.volume();
}

double volume_of(const Ellipsoid& e)
{
    return 4.0 / 3.0 * pi * e.semi_axes.x * e.semi_axes.y * e.semi_axes.z;
}

double volume_of(const Hemisphere& h)
{
    return 2.0 / 3.0 * pi * h.radius * h.radius * h.radius;
}

double volume_of(const Cylinder& c)
{
    return pi * c.radius * c.radius * c.length;
}

double volume_of(const std::shared_ptr<const ClosedSurface>& surface)
{
    return surface->volume();
}

/// Both boxes' common part; its size has a negative component if there is none.
Box common(const Box& a, const Box& b)
{
    Box box;
    for (int i = 0; i < 3; ++i) {
        box.lower[i] = std::max(a.lower[i], b.lower[i]);
        box.upper[i] = std::min(a.upper[i], b.upper[i]);
    }
    return box;
}

double cut_volume(const Box& shape, const Box& box)
{
    const Box shared = common(shape, box);
    return shared.volume();
}

/// Stretched to the unit ball, box and all.
double cut_volume(const Ellipsoid& e, const Box& box)
{
    const auto stretched = [&](const Vector3d& point) {
        const Vector3d arm = point - e.center;
        return Vector3d{arm.x / e.semi_axes.x, arm.y / e.semi_axes.y, arm.z / e.semi_axes.z};
    };
    const Revolved ball{{}, {0.0, 0.0, 1.0}, -1.0, 1.0, [](double s) { return std::sqrt(std::max(0.0, 1.0 - s * s)); }};
    return volume_within({stretched(box.lower), stretched(box.upper)}, ball) * e.semi_axes.x * e.semi_axes.y * e.semi_axes.z;
}

double cut_volume(const Hemisphere& h, const Box& box)
{
    const double radius = h.radius;
    return volume_within(
        box, Revolved{h.center, h.axis, 0.0, radius, [radius](double s) { return std::sqrt(std::max(0.0, radius * radius - s * s)); }});
}

double cut_volume(const Cylinder& c, const Box& box)
{
    const double radius = c.radius;
    return volume_within(box, Revolved{c.center, c.axis, -0.5 * c.length, 0.5 * c.length, [radius](double) { return radius; }});
}

double cut_volume(const std::shared_ptr<const ClosedSurface>& surface, const Box& box)
{
    return surface->volume_within(box);
}

}  // namespace

Shape Shape::box(const Box& box)
{
    require_finite(box.lower, "the lower corner of a box");
    require_finite(box.upper, "the upper corner of a box");
    for (int a = 0; a < 3; ++a) require_length(box.size()[a], "a side of a box");
    return Shape(box);
}

Shape Shape::sphere(const Vector3d& center, double radius)
{
    require_finite(center, "the center of a sphere");
    require_length(radius, "the radius of a sphere");
    return Shape(Ellipsoid{center, {radius, radius, radius}});
}

Shape Shape::hemisphere(const Vector3d& center, double radius, const Vector3d& axis)
{
    require_finite(center, "the center of a hemisphere");
    require_length(radius, "the radius of a hemisphere");
    return Shape(Hemisphere{center, radius, require_axis(axis, "the axis of a hemisphere")});
}

Shape Shape::cylinder(const Vector3d& center, double radius, double length, const Vector3d& axis)
{
    require_finite(center, "the center of a cylinder");
    require_length(radius, "the radius of a cylinder");
    require_length(length, "the length of a cylinder");
    return Shape(Cylinder{center, radius, length, require_axis(axis, "the axis of a cylinder")});
}

Shape Shape::ellipsoid(const Vector3d& center, const Vector3d& semi_axes)
{
    require_finite(center, "the center of an ellipsoid");
    for (int a = 0; a < 3; ++a) require_length(semi_axes[a], "a semi-axis of an ellipsoid");
    return Shape(Ellipsoid{center, semi_axes});
}

Shape Shape::surface(const Mesh& mesh, const std::string& name)
{
    return Shape(std::make_shared<const ClosedSurface>(mesh, name));
}

bool Shape::contains(const Vector3d& point) const
{
    return std::visit([&](const auto& shape) { return contains_point(shape, point); }, kind_);
}

Box Shape::bounds() const
{
    return std::visit([](const auto& shape) { return bounds_of(shape); }, kind_);
}

double Shape::volume() const
{
    return std::visit([](const auto& shape) { return volume_of(shape); }, kind_);
}

double Shape::volume_within(const Box& box) const
{
    const Box own = bounds(), shared = common(own, box);
    const Vector3d size = shared.size();
    if (!(size.x > 0.0 && size.y > 0.0 && size.z > 0.0)) return 0.0;
    if (shared.lower == own.lower && shared.upper == own.upper) return volume();
    return std::min(volume(), std::visit([&](const auto& shape) { return cut_volume(shape, shared); }, kind_));
}

bool Shape::overlaps(const Box& box) const
{
    return volume_within(box) > 1e-9 * volume();
}

}  // namespace corpuscle
