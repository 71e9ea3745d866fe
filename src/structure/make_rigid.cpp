#include "structure/make_rigid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

/// How many holds' nodes are held in each direction; all nodes or none must be.
Vector3d freedom(const PartDescription& d, Directions Hold::* kind)
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
    Vector3d free;
    for (int a = 0; a < 3; ++a) {
        const auto count = static_cast<std::size_t>(std::count(held[a].begin(), held[a].end(), true));
        if (count != 0 && count != d.mesh.nodes.size())
            refuse_body(d,
                        fmt::format("a rigid part that moves has {} of its {} nodes held along {}", count, d.mesh.nodes.size(), "xyz"[a]),
                        "hold all of a rigid part's nodes in a direction, or none: where = \"all\"");
        free[a] = count == 0 ? 1.0 : 0.0;
    }
    return free;
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
    if (d.rigid.center) body.center = body.center_at_start = *d.rigid.center;
    if (d.rigid.inertia) body.inertia_at_start = {d.rigid.inertia->x, d.rigid.inertia->y, d.rigid.inertia->z, 0, 0, 0};
    body.free = freedom(d, &Hold::translation);
    body.free_turn = freedom(d, &Hold::rotation);
    body.velocity = scaled(d.velocity, body.free);
    body.spin_momentum = scaled(body.inertia_at_start * d.spin, body.free_turn);
    return body;
}

}  // namespace corpuscle
