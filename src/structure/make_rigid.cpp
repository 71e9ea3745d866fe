#include "structure/make_rigid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "base/error.hpp"
#include "mesh/measure.hpp"

namespace corpuscle {

namespace {

/// Masses and their places. [kg], [m]
struct MassPoints {
    std::vector<Vector3d> places;
    std::vector<double> masses;

    void add(const Vector3d& place, double mass)
    {
        places.push_back(place);
        masses.push_back(mass);
    }
};

constexpr double gauss = std::numbers::inv_sqrt3;

/// Two Gauss points each way in a quadrilateral.
void add_quadrilateral(MassPoints& points, const std::array<Vector3d, 8>& c, double mass_per_area)
{
    for (const double xi : {-gauss, gauss}) {
        for (const double eta : {-gauss, gauss}) {
            const std::array<double, 4> n{(1 - xi) * (1 - eta) / 4, (1 + xi) * (1 - eta) / 4, (1 + xi) * (1 + eta) / 4,
                                          (1 - xi) * (1 + eta) / 4};
            const Vector3d place = n[0] * c[0] + n[1] * c[1] + n[2] * c[2] + n[3] * c[3];
            const Vector3d along = 0.25 * ((1 - eta) * (c[1] - c[0]) + (1 + eta) * (c[2] - c[3]));
            const Vector3d aside = 0.25 * ((1 - xi) * (c[3] - c[0]) + (1 + xi) * (c[2] - c[1]));
            points.add(place, mass_per_area * norm(cross(along, aside)));
        }
    }
}

/// The middles of a triangle's edges: exact for what is of second order in place.
void add_triangle(MassPoints& points, const std::array<Vector3d, 8>& c, double mass_per_area)
{
    const double third = mass_per_area * norm(cross(c[1] - c[0], c[2] - c[0])) / 6;
    for (int i = 0; i < 3; ++i) points.add(0.5 * (c[i] + c[(i + 1) % 3]), third);
}

/// Four points in a tetrahedron, exact to second order.
void add_tetrahedron(MassPoints& points, const std::array<Vector3d, 8>& c, double density)
{
    const double quarter = density * dot(cross(c[1] - c[0], c[2] - c[0]), c[3] - c[0]) / 24;
    const double near = (5 + 3 * std::sqrt(5.0)) / 20, far = (5 - std::sqrt(5.0)) / 20;
    const Vector3d sum = c[0] + c[1] + c[2] + c[3];
    for (int i = 0; i < 4; ++i) points.add(near * c[i] + far * (sum - c[i]), quarter);
}

/// Two Gauss points each way in a hexahedron.
void add_hexahedron(MassPoints& points, const std::array<Vector3d, 8>& c, double density)
{
    static constexpr std::array<std::array<int, 3>, 8> sign{
        {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
    for (const auto& at : sign) {
        Vector3d place;
        std::array<Vector3d, 3> tangent{};
        for (int i = 0; i < 8; ++i) {
            std::array<double, 3> f{};
            for (int a = 0; a < 3; ++a) f[a] = 0.5 * (1 + gauss * at[a] * sign[i][a]);
            place += f[0] * f[1] * f[2] * c[i];
            for (int a = 0; a < 3; ++a) tangent[a] += 0.5 * sign[i][a] * f[(a + 1) % 3] * f[(a + 2) % 3] * c[i];
        }
        points.add(place, density * dot(cross(tangent[0], tangent[1]), tangent[2]));
    }
}

/// Solids by their density, surfaces by density times thickness, or by 1 kg/m2 where only the mass is known.
MassPoints element_masses(const PartDescription& d)
{
    const double per_area = d.thickness > 0 && d.material.density > 0 ? d.material.density * d.thickness : 1.0;
    const double per_volume = d.material.density > 0 ? d.material.density : 1.0;
    MassPoints points;
    for (const MeshElement& e : d.mesh.elements) {
        std::array<Vector3d, 8> c{};
        for (int i = 0; i < node_count(e.shape); ++i) c[i] = d.mesh.nodes[e.node[i]];
        switch (e.shape) {
            case ElementShape::triangle: add_triangle(points, c, per_area); break;
            case ElementShape::quadrilateral: add_quadrilateral(points, c, per_area); break;
            case ElementShape::tetrahedron: add_tetrahedron(points, c, per_volume); break;
            case ElementShape::hexahedron: add_hexahedron(points, c, per_volume); break;
        }
    }
    return points;
}

[[noreturn]] void refuse_body(const PartDescription& d, const std::string& problem, const std::string& remedy)
{
    throw InputError(fmt::format("part '{}': {}", d.name, problem), remedy, d.place);
}

/// Which nodes of a part are held along (or about) each axis.
std::array<std::vector<bool>, 3> held_nodes(const PartDescription& d, Directions Hold::* kind)
{
    std::array<std::vector<bool>, 3> held;
    for (std::vector<bool>& nodes : held) nodes.resize(d.mesh.nodes.size());
    for (const Hold& hold : d.holds) {
        const Directions& directions = hold.*kind;
        const std::array<bool, 3> by_axis{directions.x, directions.y, directions.z};
        for (int a = 0; a < 3; ++a)
            for (const std::uint32_t node : hold.nodes)
                if (by_axis[a]) held[a][node] = true;
    }
    return held;
}

/// How a body may move, and where the planes of symmetry lie that cut it along each axis [m].
struct BodyFreedom {
    Vector3d free{1, 1, 1}, free_turn{1, 1, 1};
    std::array<std::optional<double>, 3> plane;
};

/// Where the plane normal to an axis is in which all the marked nodes lie, with all others on one side of it.
std::optional<double> plane_through(const std::vector<Vector3d>& nodes, const std::vector<bool>& marked, int axis)
{
    double low = 1e300, high = -1e300, lowest = 1e300, highest = -1e300;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        lowest = std::min(lowest, nodes[i][axis]);
        highest = std::max(highest, nodes[i][axis]);
        if (marked[i]) low = std::min(low, nodes[i][axis]), high = std::max(high, nodes[i][axis]);
    }
    const double rounding = 1e-9 * std::max({highest - lowest, std::abs(lowest), std::abs(highest)});
    const bool flat = high - low <= rounding, outermost = low - lowest <= rounding || highest - high <= rounding;
    return flat && outermost ? std::optional(low) : std::nullopt;
}

/// Holds of all nodes take a direction from the body. Some nodes held along an axis and about both others are a plane of symmetry through
/// the body's middle, which it can neither leave nor turn out of. All else would be a hinge.
BodyFreedom body_freedom(const PartDescription& d)
{
    const auto held = held_nodes(d, &Hold::translation), held_turn = held_nodes(d, &Hold::rotation);
    const auto count = [](const std::vector<bool>& nodes) {
        return static_cast<std::size_t>(std::count(nodes.begin(), nodes.end(), true));
    };
    const std::size_t all = d.mesh.nodes.size();
    BodyFreedom f;
    for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        if (count(held[a]) > 0) f.free[a] = 0;
        if (count(held_turn[a]) == all) f.free_turn[a] = 0;
        if (count(held[a]) == 0 || count(held[a]) == all) continue;
        bool in_plane = true;
        for (std::size_t i = 0; i < all; ++i) in_plane = in_plane && (!held[a][i] || (held_turn[b][i] && held_turn[c][i]));
        f.plane[a] = in_plane ? plane_through(d.mesh.nodes, held[a], a) : std::nullopt;
        if (!f.plane[a])
            refuse_body(
                d, fmt::format("a rigid part that moves has {} of its {} nodes held along {}", count(held[a]), all, "xyz"[a]),
                "hold all of a rigid part's nodes in a direction, or none: where = \"all\"; or those in a plane of symmetry that cuts the "
                "body: dof = \"symmetry\"");
    }
    for (int a = 0; a < 3; ++a) {
        const bool by_plane = f.plane[(a + 1) % 3] || f.plane[(a + 2) % 3];
        if (by_plane) f.free_turn[a] = 0;
        if (!by_plane && f.free_turn[a] != 0 && count(held_turn[a]) > 0)
            refuse_body(d, fmt::format("a rigid part that moves has {} of its {} nodes held about {}", count(held_turn[a]), all, "xyz"[a]),
                        "hold all of a rigid part's nodes about an axis, or none: where = \"all\"");
    }
    return f;
}

/// Puts the center of a body that is the half of a symmetric one into the plane of symmetry, where that of the whole is.
void center_in_planes(RigidBody& body, const BodyFreedom& freedom)
{
    const Vector3d before = body.center;
    for (int a = 0; a < 3; ++a) body.center[a] = freedom.plane[a].value_or(before[a]);
    body.center_at_start = body.center;
    body.inertia_at_start.add_mass(body.mass, body.center - before);
}

}  // namespace

bool has_weight(const PartDescription& d)
{
    if (d.rigid.mass) return true;
    if (!(d.material.density > 0)) return false;
    const ElementShape shape = d.mesh.elements.front().shape;
    return d.thickness > 0 || shape == ElementShape::tetrahedron || shape == ElementShape::hexahedron;
}

RigidBody make_rigid_body(const PartDescription& d)
{
    if (!has_weight(d))
        refuse_body(d, "a rigid part that can move has no mass",
                    "give it a mass, or a material and (unless it is solid) a thickness; or hold the whole part: "
                    "fix = [{ where = \"all\", dof = \"all\" }]");
    MassPoints points = element_masses(d);
    if (d.rigid.mass) {
        double sum = 0;
        for (const double mass : points.masses) sum += mass;
        for (double& mass : points.masses) mass *= *d.rigid.mass / sum;
    }
    for (const PointMass& extra : d.point_masses)
        for (const std::uint32_t node : extra.nodes) points.add(d.mesh.nodes[node], extra.mass / static_cast<double>(extra.nodes.size()));
    RigidBody body = rigid_body_of(points.places, points.masses);
    const BodyFreedom freedom = body_freedom(d);
    center_in_planes(body, freedom);
    if (d.rigid.center)
        for (int a = 0; a < 3; ++a) body.center[a] = body.center_at_start[a] = freedom.plane[a].value_or((*d.rigid.center)[a]);
    if (d.rigid.inertia) body.inertia_at_start = {d.rigid.inertia->x, d.rigid.inertia->y, d.rigid.inertia->z, 0, 0, 0};
    body.free = freedom.free;
    body.free_turn = freedom.free_turn;
    body.velocity = scaled(d.velocity, body.free);
    body.spin_momentum = scaled(body.inertia_at_start * d.spin, body.free_turn);
    return body;
}

}  // namespace corpuscle
