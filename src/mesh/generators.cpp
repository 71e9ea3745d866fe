#include "mesh/generators.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/error.hpp"
#include "mesh/transform.hpp"

namespace corpuscle {

namespace {

constexpr double max_elements = 2e7;

void require_size(double value, const char* what)
{
    if (!(value > 0.0) || !std::isfinite(value))
        throw InputError(fmt::format("{} of a mesh is {:.6g} m", what, value), "give a length above 0");
}

void require_affordable(double elements)
{
    if (elements > max_elements)
        throw InputError(fmt::format("a mesh of about {:.2g} elements was asked for", elements), "give a larger element_size");
}

/// Number of pieces of about `size` that `length` is cut into, at least 1.
int divisions(double length, double size)
{
    require_affordable(length / size);
    return std::max(1, static_cast<int>(std::lround(length / size)));
}

/// Point `index` of 4 * `per_quarter` on a circle in z = 0; exact on the axes, mirrored exactly at the diagonals, so that whoever
/// asks for the same point of the same circle gets the same bits.
Vector3d circle_point(double radius, int index, int per_quarter)
{
    const int quadrant = index / per_quarter % 4, i = index % per_quarter;
    const bool mirrored = 2 * i > per_quarter;
    const double angle = 0.5 * std::numbers::pi * (mirrored ? per_quarter - i : i) / per_quarter;
    Vector3d point{radius * std::cos(angle), i == 0 ? 0.0 : radius * std::sin(angle), 0.0};
    if (2 * i == per_quarter) point.x = point.y = radius * std::sqrt(0.5);
    if (mirrored) std::swap(point.x, point.y);
    for (int turn = 0; turn < quadrant; ++turn) point = {0.0 - point.y, point.x, 0.0};
    return point;
}

/// The quarter disk as a core of `core` x `core` quadrilaterals within `layers` rings of 2 `core` quadrilaterals.
/// The core's outer sides are parabolas from the axis to its corner on the diagonal; its inside is their transfinite interpolation.
/// The lengths `side` and `corner` were found by search: they hold the smallest scaled Jacobian near 0.82 and edges within 0.70..1.15
/// of the rim's edge for all but the coarsest disks.
class QuarterDisk {
public:
    QuarterDisk(double radius, int core) : radius_(radius), core_(core), layers_(std::max(1, static_cast<int>(std::lround(0.4 * core))))
    {
        const double thickness = static_cast<double>(layers_) / core_;
        side_ = (0.707 - 0.167 * thickness) * radius;
        corner_ = (0.92 - 0.35 * thickness) * radius * std::sqrt(0.5);
    }

    [[nodiscard]] Mesh mesh() const
    {
        Mesh mesh;
        for (int j = 0; j <= core_; ++j)
            for (int i = 0; i <= core_; ++i) mesh.nodes.push_back(core_point(i, j));
        for (int layer = 1; layer <= layers_; ++layer)
            for (int k = 0; k <= 2 * core_; ++k) mesh.nodes.push_back(ring_point(layer, k));
        for (int j = 0; j < core_; ++j)
            for (int i = 0; i < core_; ++i) add(mesh, core_node(i, j), core_node(i + 1, j), core_node(i + 1, j + 1), core_node(i, j + 1));
        for (int layer = 0; layer < layers_; ++layer)
            for (int k = 0; k < 2 * core_; ++k)
                add(mesh, ring_node(layer, k), ring_node(layer + 1, k), ring_node(layer + 1, k + 1), ring_node(layer, k + 1));
        for (int k = 0; k <= 2 * core_; ++k) mesh.node_sets["rim"].push_back(ring_node(layers_, k));
        return mesh;
    }

    [[nodiscard]] double element_count() const { return 1.0 * core_ * core_ + 2.0 * core_ * layers_; }

private:
    static void add(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
    {
        mesh.elements.push_back({ElementShape::quadrilateral, {a, b, c, d}});
    }

    [[nodiscard]] std::uint32_t core_node(int i, int j) const { return static_cast<std::uint32_t>(j * (core_ + 1) + i); }

    /// Node `k` of ring `layer`; ring 0 is the core's outside.
    [[nodiscard]] std::uint32_t ring_node(int layer, int k) const
    {
        if (layer == 0) return k <= core_ ? core_node(core_, k) : core_node(2 * core_ - k, core_);
        return static_cast<std::uint32_t>((core_ + 1) * (core_ + 1) + (layer - 1) * (2 * core_ + 1) + k);
    }

    /// The core's right side, from the axis (t = 0) to the corner (t = 1).
    [[nodiscard]] Vector3d right_side(double t) const { return {side_ + (corner_ - side_) * t * t, corner_ * t, 0.0}; }

    [[nodiscard]] Vector3d core_point(int i, int j) const
    {
        const double u = static_cast<double>(i) / core_, v = static_cast<double>(j) / core_;
        const Vector3d right = right_side(v), mirrored = right_side(u);
        const Vector3d top{mirrored.y, mirrored.x, 0.0};
        Vector3d point{(1.0 - v) * side_ * u + v * top.x + u * right.x - u * v * corner_ - u * (1.0 - v) * side_,
                       (1.0 - u) * side_ * v + u * right.y + v * top.y - u * v * corner_ - (1.0 - u) * v * side_, 0.0};
        if (i == 0) point.x = 0.0;
        if (j == 0) point.y = 0.0;
        return point;
    }

    [[nodiscard]] Vector3d ring_point(int layer, int k) const
    {
        const Vector3d rim = circle_point(radius_, k, 2 * core_);
        if (layer == layers_) return rim;
        const Vector3d inside = k <= core_ ? core_point(core_, k) : core_point(2 * core_ - k, core_);
        return inside + (static_cast<double>(layer) / layers_) * (rim - inside);
    }

    double radius_;
    int core_;
    int layers_;
    double side_ = 0;    ///< half side of the core on the axes [m]
    double corner_ = 0;  ///< x and y of the core's corner on the diagonal [m]
};

/// Turns a point by a number of right angles about z, exactly.
Vector3d quarter_turned(Vector3d point, int turns)
{
    for (int turn = 0; turn < turns; ++turn) point = {0.0 - point.y, point.x, point.z};
    return point;
}

/// A grid of rows x columns nodes made into quadrilaterals; `closed` joins the last column to the first.
void add_grid_elements(Mesh& mesh, int rows, int columns, bool closed)
{
    const auto node = [&](int row, int column) { return static_cast<std::uint32_t>(row * columns + column % columns); };
    for (int row = 0; row + 1 < rows; ++row)
        for (int column = 0; column + (closed ? 0 : 1) < columns; ++column)
            mesh.elements.push_back({ElementShape::quadrilateral,
                                     {node(row, column), node(row + 1, column), node(row + 1, column + 1), node(row, column + 1)}});
}

}  // namespace

int rim_divisions(double radius, double element_size, bool quarter)
{
    require_size(radius, "the radius");
    require_size(element_size, "element_size");
    return 2 * divisions(0.25 * std::numbers::pi * radius, element_size) * (quarter ? 1 : 4);
}

Mesh disk_mesh(double radius, double element_size, bool quarter)
{
    const int per_quarter = rim_divisions(radius, element_size, true);
    const QuarterDisk disk(radius, per_quarter / 2);
    require_affordable(disk.element_count() * (quarter ? 1 : 4));
    Mesh mesh = disk.mesh();
    if (quarter) return mesh;
    const Mesh first = mesh;
    for (int turns = 1; turns < 4; ++turns) {
        Mesh next = first;
        for (Vector3d& node : next.nodes) node = quarter_turned(node, turns);
        append(mesh, next);
    }
    merge_nodes(mesh, 1e-3 * radius / per_quarter);
    return mesh;
}

Mesh ring_mesh(double inner_radius, double outer_radius, double element_size, bool quarter, int inner_divisions)
{
    require_size(inner_radius, "the inner radius");
    require_size(element_size, "element_size");
    if (!(outer_radius > inner_radius) || !std::isfinite(outer_radius))
        throw InputError(fmt::format("a ring from radius {:.6g} m to {:.6g} m has no width", inner_radius, outer_radius),
                         "give an outer_radius larger than inner_radius");
    const int quarters = quarter ? 1 : 4;
    const int around = inner_divisions > 0 ? inner_divisions : rim_divisions(0.5 * (inner_radius + outer_radius), element_size, quarter);
    if (around % quarters != 0) throw InputError("a whole ring needs inner divisions in a multiple of 4", "use rim_divisions");
    const int rows = divisions(outer_radius - inner_radius, element_size) + 1, columns = around + (quarter ? 1 : 0);
    require_affordable(1.0 * around * rows);
    Mesh mesh;
    for (int row = 0; row < rows; ++row) {
        const double radius = row + 1 == rows ? outer_radius : inner_radius + (outer_radius - inner_radius) * row / (rows - 1);
        for (int column = 0; column < columns; ++column) mesh.nodes.push_back(circle_point(radius, column, around / quarters));
    }
    add_grid_elements(mesh, rows, columns, !quarter);
    for (int column = 0; column < columns; ++column) {
        mesh.node_sets["inner"].push_back(static_cast<std::uint32_t>(column));
        mesh.node_sets["outer"].push_back(static_cast<std::uint32_t>((rows - 1) * columns + column));
    }
    return mesh;
}

Mesh rectangle_mesh(const Vector3d& origin, const Vector3d& edge_1, const Vector3d& edge_2, double element_size)
{
    require_size(element_size, "element_size");
    require_size(norm(edge_1), "an edge");
    require_size(norm(edge_2), "an edge");
    if (!(norm(cross(edge_1, edge_2)) > 1e-9 * norm(edge_1) * norm(edge_2)))
        throw InputError("the edges of a rectangle are parallel", "give two edge vectors in different directions");
    const int n1 = divisions(norm(edge_1), element_size), n2 = divisions(norm(edge_2), element_size);
    require_affordable(1.0 * n1 * n2);
    Mesh mesh;
    for (int i = 0; i <= n1; ++i)
        for (int j = 0; j <= n2; ++j) {
            const auto node = static_cast<std::uint32_t>(mesh.nodes.size());
            mesh.nodes.push_back(origin + (static_cast<double>(i) / n1) * edge_1 + (static_cast<double>(j) / n2) * edge_2);
            if (i == 0) mesh.node_sets["start_1"].push_back(node);
            if (i == n1) mesh.node_sets["end_1"].push_back(node);
            if (j == 0) mesh.node_sets["start_2"].push_back(node);
            if (j == n2) mesh.node_sets["end_2"].push_back(node);
            if (i == 0 || i == n1 || j == 0 || j == n2) mesh.node_sets["rim"].push_back(node);
        }
    add_grid_elements(mesh, n1 + 1, n2 + 1, false);
    return mesh;
}

Mesh box_mesh(const Box& box, double element_size)
{
    static constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};
    const Vector3d size = box.size();
    for (int a = 0; a < 3; ++a) require_size(size[a], "a side of a box");
    Mesh mesh;
    for (int a = 0; a < 3; ++a)
        for (const bool upper : {false, true}) {
            Vector3d origin = box.lower, edge_1, edge_2;
            origin[a] = upper ? box.upper[a] : box.lower[a];
            edge_1[(a + 1) % 3] = size[(a + 1) % 3];
            edge_2[(a + 2) % 3] = size[(a + 2) % 3];
            if (!upper) std::swap(edge_1, edge_2);  // the normal then points down the axis
            Mesh face = rectangle_mesh(origin, edge_1, edge_2, element_size);
            face.node_sets.clear();
            auto& set = face.element_sets[fmt::format("{}_{}", axis_names[a], upper ? "max" : "min")];
            for (std::uint32_t element = 0; element < face.elements.size(); ++element) set.push_back(element);
            append(mesh, face);
        }
    merge_nodes(mesh, 1e-3 * std::min({size.x, size.y, size.z, element_size}));
    return mesh;
}

}  // namespace corpuscle
