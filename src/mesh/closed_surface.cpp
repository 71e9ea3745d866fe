#include "mesh/closed_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "mesh/boundary.hpp"
#include "mesh/measure.hpp"

namespace corpuscle {

namespace {

/// Twice the signed area, in the y-z plane, of edge a -> b and the point; computed from the lower node, so that it only changes sign
/// when the edge is read backwards. Where it is zero, the point counts as shifted by a little in y and by far less in z: one shift
/// for all edges, so that a line through a node crosses exactly one of the triangles around it (Edelsbrunner and Muecke 1990).
struct EdgeSide {
    double value;
    bool left;
};

EdgeSide side_of(std::span<const Vector3d> nodes, std::uint32_t a, std::uint32_t b, const Vector3d& point)
{
    const bool swapped = a > b;
    const Vector3d& low = nodes[swapped ? b : a];
    const Vector3d& high = nodes[swapped ? a : b];
    const double value = (low.y - point.y) * (high.z - point.z) - (low.z - point.z) * (high.y - point.y);
    const double shifted = value != 0.0 ? value : low.z != high.z ? low.z - high.z : high.y - low.y;
    return {swapped ? -value : value, (shifted > 0.0) != swapped};
}

/// The x at which the line along x through `point` crosses the triangle, and +1 where it leaves the body, -1 where it enters, 0 if it
/// misses.
struct Crossing {
    int sign = 0;
    double x = 0;
};

Crossing cross_triangle(std::span<const Vector3d> nodes, const Triangle& t, const Vector3d& point)
{
    const EdgeSide a = side_of(nodes, t[1], t[2], point), b = side_of(nodes, t[2], t[0], point), c = side_of(nodes, t[0], t[1], point);
    if (a.left != b.left || b.left != c.left) return {};
    const double sum = a.value + b.value + c.value;
    if (sum == 0.0) return {};
    return {a.left ? 1 : -1, (a.value * nodes[t[0]].x + b.value * nodes[t[1]].x + c.value * nodes[t[2]].x) / sum};
}

Mesh oriented(Mesh mesh, const std::string& name)
{
    orient_closed(mesh, name);
    return mesh;
}

/// A convex polygon in space of up to 3 + 4 + 2 corners.
struct Polygon {
    std::array<Vector3d, 10> corner;
    int count = 0;

    void add(const Vector3d& point) { corner[count++] = point; }
};

/// The part of the polygon where sign * p[axis] <= sign * limit (Sutherland and Hodgman 1974).
Polygon clipped(const Polygon& polygon, int axis, double limit, double sign)
{
    Polygon kept;
    for (int i = 0; i < polygon.count; ++i) {
        const Vector3d& here = polygon.corner[i];
        const Vector3d& next = polygon.corner[(i + 1) % polygon.count];
        const double inside_here = sign * (limit - here[axis]), inside_next = sign * (limit - next[axis]);
        if (inside_here >= 0.0) kept.add(here);
        if ((inside_here > 0.0 && inside_next < 0.0) || (inside_here < 0.0 && inside_next > 0.0)) {
            Vector3d cut = here + (inside_here / (inside_here - inside_next)) * (next - here);
            cut[axis] = limit;
            kept.add(cut);
        }
    }
    return kept;
}

/// Integral over the polygon's shadow on z = 0 (positive where its normal has z > 0) of z - floor.
double column_volume(const Polygon& polygon, double floor)
{
    double volume = 0.0;
    for (int i = 1; i + 1 < polygon.count; ++i) {
        const Vector3d &a = polygon.corner[0], &b = polygon.corner[i], &c = polygon.corner[i + 1];
        const double area = 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
        volume += area * ((a.z + b.z + c.z) / 3.0 - floor);
    }
    return volume;
}

/// The part of the polygon above the ceiling, pressed down onto it; nothing for a polygon that only touches it.
Polygon pressed(const Polygon& polygon, double ceiling)
{
    Polygon above = clipped(polygon, 2, ceiling, -1.0);
    bool touches_only = true;
    for (int i = 0; i < above.count; ++i) {
        touches_only = touches_only && above.corner[i].z == ceiling;
        above.corner[i].z = ceiling;
    }
    return touches_only ? Polygon{} : above;
}

/// The same with z cut at the ceiling of the box, zero below its floor.
double clipped_column_volume(const std::array<Vector3d, 3>& triangle, const Box& box)
{
    Polygon polygon;
    for (const Vector3d& corner : triangle) polygon.add(corner);
    for (const int axis : {0, 1}) {
        polygon = clipped(polygon, axis, box.upper[axis], 1.0);
        polygon = clipped(polygon, axis, box.lower[axis], -1.0);
    }
    polygon = clipped(polygon, 2, box.lower.z, -1.0);
    return column_volume(clipped(polygon, 2, box.upper.z, 1.0), box.lower.z) + column_volume(pressed(polygon, box.upper.z), box.lower.z);
}

}  // namespace

ClosedSurface::ClosedSurface(Mesh mesh, const std::string& name) : ClosedSurface(oriented(std::move(mesh), name))
{
    for (const Triangle& triangle : triangles_)
        for (const std::uint32_t node : triangle) bounds_.include(nodes_[node]);
    if (!(volume_ > 1e-12 * std::pow(norm(bounds_.size()), 3)))
        throw InputError(fmt::format("mesh '{}' encloses no volume", name), "give the surface of a body, not of a sheet");
    make_columns();
}

ClosedSurface::ClosedSurface(const Mesh& mesh)
    : nodes_(mesh.nodes), triangles_(triangles_of(mesh)), volume_(signed_volume(nodes_, triangles_))
{
}

/// Which of `rows` slices of the bounds along an axis a value lies in.
int ClosedSurface::row(double value, int axis, int rows) const
{
    const double fraction = (value - bounds_.lower[axis]) / (bounds_.upper[axis] - bounds_.lower[axis]);
    return std::clamp(static_cast<int>(fraction * rows), 0, rows - 1);
}

/// Sorts the triangles into about as many columns as there are triangles.
void ClosedSurface::make_columns()
{
    const Vector3d size = bounds_.size();
    const double per_side = std::sqrt(static_cast<double>(triangles_.size()) / (size.y * size.z));
    const auto rows = [&](double length) { return static_cast<int>(std::clamp(std::ceil(per_side * length), 1.0, 4096.0)); };
    columns_.rows_y = rows(size.y);
    columns_.rows_z = rows(size.z);
    const auto for_each_column = [&](std::uint32_t t, auto&& visit) {
        Box box;
        for (const std::uint32_t node : triangles_[t]) box.include(nodes_[node]);
        for (int j = row(box.lower.y, 1, columns_.rows_y); j <= row(box.upper.y, 1, columns_.rows_y); ++j)
            for (int k = row(box.lower.z, 2, columns_.rows_z); k <= row(box.upper.z, 2, columns_.rows_z); ++k)
                visit(static_cast<std::size_t>(j) * columns_.rows_z + k);
    };
    columns_.first.assign(static_cast<std::size_t>(columns_.rows_y) * columns_.rows_z + 1, 0);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) for_each_column(t, [&](std::size_t column) { ++columns_.first[column + 1]; });
    for (std::size_t c = 1; c < columns_.first.size(); ++c) columns_.first[c] += columns_.first[c - 1];
    columns_.triangle.resize(columns_.first.back());
    std::vector<std::uint32_t> next(columns_.first.begin(), columns_.first.end() - 1);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
        for_each_column(t, [&](std::size_t column) { columns_.triangle[next[column]++] = t; });
}

bool ClosedSurface::contains(const Vector3d& point) const
{
    if (!bounds_.contains(point)) return false;
    const std::size_t column =
        static_cast<std::size_t>(row(point.y, 1, columns_.rows_y)) * columns_.rows_z + row(point.z, 2, columns_.rows_z);
    int beyond = 0, before = 0;
    for (std::uint32_t i = columns_.first[column]; i < columns_.first[column + 1]; ++i) {
        const Crossing crossing = cross_triangle(nodes_, triangles_[columns_.triangle[i]], point);
        (crossing.x >= point.x ? beyond : before) += crossing.sign;
    }
    if (beyond + before == 0 && (beyond == 0 || beyond == 1)) return beyond == 1;
    return winding_number(nodes_, triangles_, point) > 0.5;
}

double ClosedSurface::volume_within(const Box& box) const
{
    const Vector3d size = box.size();
    if (!box.overlaps(bounds_) || size.x <= 0.0 || size.y <= 0.0 || size.z <= 0.0) return 0.0;
    if (box.contains(bounds_.lower) && box.contains(bounds_.upper)) return volume_;
    double volume = 0.0;
    for (const Triangle& t : triangles_) volume += clipped_column_volume({nodes_[t[0]], nodes_[t[1]], nodes_[t[2]]}, box);
    return std::clamp(volume, 0.0, volume_);
}

}  // namespace corpuscle
