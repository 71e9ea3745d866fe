#include "structure/builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "mesh/measure.hpp"
#include "mesh/quality.hpp"
#include "mesh/solid_faces.hpp"
#include "parallel/loops.hpp"
#include "structure/make_rigid.hpp"

namespace corpuscle {

namespace {

[[noreturn]] void refuse(const PartDescription& d, const std::string& problem, const std::string& remedy)
{
    throw InputError(fmt::format("part '{}': {}", d.name, problem), remedy, d.place);
}

void check_mesh(const PartDescription& d)
{
    if (d.mesh.elements.empty()) refuse(d, "its mesh has no elements, so the part has no mass", "give a mesh with quadrilaterals");
    try {
        validate(d.mesh, d.name);
    } catch (const InputError& e) {
        throw InputError(e.problem(), e.remedy(), e.place().known() ? e.place() : d.place);
    }
}

bool is_solid(ElementShape shape)
{
    return shape == ElementShape::tetrahedron || shape == ElementShape::hexahedron;
}

void check_shapes(const PartDescription& d)
{
    const ElementShape first = d.mesh.elements.front().shape;
    for (std::size_t e = 0; e < d.mesh.elements.size(); ++e) {
        const ElementShape shape = d.mesh.elements[e].shape;
        const std::string place = element_place(d.mesh, e);
        if (d.element == ElementKind::solid) {
            if (!is_solid(shape))
                refuse(d, place + " is a surface element, and the part is solid",
                       "mesh the volume with hexahedra or tetrahedra, or make the part of shells");
            if (shape != first)
                refuse(d, place + " is of another shape than those before it",
                       "mesh the part with hexahedra alone or with tetrahedra alone (two parts would not hold together)");
            continue;
        }
        if (is_solid(shape) && d.element != ElementKind::rigid)
            refuse(d, place + " is a solid", "shells are made of surface elements: mesh the surface, or make the part solid");
        if (is_solid(shape) != is_solid(first))
            refuse(d, place + " is of another kind than those before it",
                   "make one part of the solids and one of the surface elements (two parts do not hold together)");
    }
}

void check_holds(const PartDescription& d)
{
    for (const Hold& hold : d.holds)
        for (const std::uint32_t node : hold.nodes)
            if (node >= d.mesh.nodes.size())
                refuse(d, fmt::format("held node {} does not exist, its mesh has {} nodes", node, d.mesh.nodes.size()),
                       "hold nodes of the mesh");
}

void check_thickness(const PartDescription& d)
{
    if (!d.thicknesses.empty() && d.thicknesses.size() != d.mesh.elements.size())
        refuse(d, fmt::format("{} thicknesses for {} elements", d.thicknesses.size(), d.mesh.elements.size()),
               "give one thickness an element, or one for all");
    for (std::size_t e = 0; e < d.mesh.elements.size(); ++e) {
        const double thickness = d.thicknesses.empty() ? d.thickness : d.thicknesses[e];
        if (thickness > 0 && std::isfinite(thickness)) continue;
        refuse(d, fmt::format("{} has thickness {} m, so it has no mass", element_place(d.mesh, e), thickness), "give a thickness above 0");
    }
}

void check_shell(const PartDescription& d)
{
    if (d.element == ElementKind::shell && (d.points < 2 || d.points > 10))
        refuse(d, fmt::format("{} points through the thickness", d.points),
               "give 3 to 10 points (2 is enough for elastic bending with Gauss points)");
    if (!(d.shear_factor > 0 && d.shear_factor <= 1))
        refuse(d, fmt::format("shear factor {}", d.shear_factor), "give a shear factor above 0 and at most 1 (5/6)");
    check_thickness(d);
}

/// Refuses impossible values, and laws that the part's elements do not have.
void check_material(const PartDescription& d)
{
    try {
        check(d.material);
    } catch (const InputError& e) {
        throw InputError(fmt::format("part '{}': {}", d.name, e.problem()), e.remedy(),
                         d.material_place.known() ? d.material_place : d.place);
    }
    if (std::holds_alternative<Fabric>(d.material.strength) && d.element != ElementKind::membrane)
        refuse(d, fmt::format("material '{}' is a fabric, which does not bend", d.material.name), "make the part a membrane");
    const bool fits =
        std::visit([&]<class Law>(const Law&) { return d.element == ElementKind::solid ? for_solids<Law>() : for_shells<Law>(); },
                   d.material.strength);
    if (!fits)
        refuse(
            d,
            fmt::format("the law of material '{}' is not for {}", d.material.name, d.element == ElementKind::solid ? "solids" : "shells"),
            d.element == ElementKind::solid ? "give a law of metals, or make the part of shells"
                                            : "make the part solid, or give another law");
}

void check_solid(const PartDescription& d)
{
    if (!(d.brick_hourglass >= 0 && d.brick_hourglass <= 0.5))
        refuse(d, fmt::format("hourglass stiffness {}", d.brick_hourglass), "give a value from 0 to 0.5 (0.02 is usual)");
}

/// 1 where the directions are free, 0 where held.
Vector3d free_part(const Directions& held)
{
    return {held.x ? 0.0 : 1.0, held.y ? 0.0 : 1.0, held.z ? 0.0 : 1.0};
}

/// Nodes' freedom after all holds: 1 free, 0 held.
struct Freedom {
    std::vector<Vector3d> translation, rotation;
};

Freedom freedom_of(const PartDescription& d)
{
    const Vector3d free{1.0, 1.0, 1.0};
    Freedom f{std::vector<Vector3d>(d.mesh.nodes.size(), free), std::vector<Vector3d>(d.mesh.nodes.size(), free)};
    for (const Hold& hold : d.holds) {
        for (const std::uint32_t node : hold.nodes) {
            f.translation[node] = scaled(f.translation[node], free_part(hold.translation));
            f.rotation[node] = scaled(f.rotation[node], free_part(hold.rotation));
        }
    }
    return f;
}

/// Whether every node that an element has is held in place: then a rigid part is a wall.
bool is_wall(const PartDescription& d, const Freedom& freedom)
{
    const Vector3d still{};
    for (const MeshElement& element : d.mesh.elements)
        for (int c = 0; c < node_count(element.shape); ++c)
            if (!(freedom.translation[element.node[c]] == still)) return false;
    return true;
}

void check_point_masses(const PartDescription& d)
{
    for (const PointMass& extra : d.point_masses) {
        if (!(extra.mass > 0) || !std::isfinite(extra.mass))
            refuse(d, fmt::format("a point mass is {} kg", extra.mass), "give a mass above 0");
        if (extra.nodes.empty()) refuse(d, "a point mass is on no node", "name nodes of the part");
    }
}

/// The mesh's elements with the structure's node numbers.
std::vector<MeshElement> renumbered(const PartDescription& d, std::uint32_t first_node)
{
    std::vector<MeshElement> elements = d.mesh.elements;
    for (MeshElement& element : elements)
        for (int c = 0; c < node_count(element.shape); ++c) element.node[c] += first_node;
    return elements;
}

/// What shells of a part's elements need; `elements` may be fewer or more than the mesh's, so thicknesses come with them.
template <std::size_t N>
ShellInput<N> shell_input(const PartDescription& d, const std::vector<MeshElement>& elements)
{
    const bool membrane = d.element == ElementKind::membrane;
    ShellInput<N> input;
    for (const MeshElement& e : elements) std::copy_n(e.node.begin(), N, input.corners.emplace_back().begin());
    input.thickness = d.thicknesses.empty() ? std::vector<double>(elements.size(), d.thickness) : d.thicknesses;
    input.points = membrane ? gauss_rule(1) : d.rule == PointRule::gauss ? gauss_rule(d.points) : lobatto_rule(d.points);
    input.shear_factor = membrane ? 0.0 : d.shear_factor;
    input.hourglass = d.hourglass;
    return input;
}

Elements make_shells(const PartDescription& d, const std::vector<MeshElement>& elements, const Nodes& nodes)
{
    if (elements.front().shape == ElementShape::triangle) return TriangleShells(shell_input<3>(d, elements), d.material, nodes);
    return QuadrilateralShells(shell_input<4>(d, elements), d.material, nodes);
}

bool has_triangle(const Mesh& mesh)
{
    return std::any_of(mesh.elements.begin(), mesh.elements.end(), [](const MeshElement& e) { return e.shape == ElementShape::triangle; });
}

bool has_quadrilateral(const Mesh& mesh)
{
    return std::any_of(mesh.elements.begin(), mesh.elements.end(),
                       [](const MeshElement& e) { return e.shape == ElementShape::quadrilateral; });
}

/// The description with every quadrilateral cut into two triangles along its shorter diagonal.
PartDescription cut_into_triangles(PartDescription d)
{
    std::vector<MeshElement> elements;
    std::vector<double> thicknesses;
    for (std::size_t e = 0; e < d.mesh.elements.size(); ++e) {
        const auto& n = d.mesh.elements[e].node;
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            elements.push_back({ElementShape::triangle, {a, b, c, 0, 0, 0, 0, 0}, d.mesh.elements[e].number});
            if (!d.thicknesses.empty()) thicknesses.push_back(d.thicknesses[e]);
        };
        const auto length = [&](int i, int j) { return norm_squared(d.mesh.nodes[n[i]] - d.mesh.nodes[n[j]]); };
        if (d.mesh.elements[e].shape == ElementShape::triangle) {
            add(n[0], n[1], n[2]);
        } else if (length(0, 2) <= length(1, 3)) {
            add(n[0], n[1], n[2]);
            add(n[0], n[2], n[3]);
        } else {
            add(n[0], n[1], n[3]);
            add(n[1], n[2], n[3]);
        }
    }
    d.mesh.elements = std::move(elements);
    d.mesh.element_sets.clear();
    d.thicknesses = std::move(thicknesses);
    return d;
}

template <std::size_t N>
SolidInput<N> solid_input(const PartDescription& d, const std::vector<MeshElement>& elements)
{
    SolidInput<N> input;
    for (const MeshElement& e : elements) std::copy_n(e.node.begin(), N, input.corners.emplace_back().begin());
    input.viscosity = d.viscosity;
    input.hourglass_stiffness = d.brick_hourglass;
    return input;
}

Elements make_solids(const PartDescription& d, const std::vector<MeshElement>& elements, const Nodes& nodes)
{
    if (elements.front().shape == ElementShape::tetrahedron) return Tetrahedra(solid_input<4>(d, elements), d.material, nodes);
    if (d.full_integration) return FullBricks(solid_input<8>(d, elements), d.material, nodes);
    return Bricks(solid_input<8>(d, elements), d.material, nodes);
}

Elements make_elements(const PartDescription& d, const std::vector<MeshElement>& elements, const Nodes& nodes)
{
    switch (d.element) {
        case ElementKind::shell:
        case ElementKind::membrane: return make_shells(d, elements, nodes);
        case ElementKind::solid: return make_solids(d, elements, nodes);
        case ElementKind::rigid: break;
    }
    return RigidFacets(elements);
}

/// Gives each element's mass to its corners.
void add_masses(Nodes& nodes, const Elements& elements)
{
    std::visit(
        [&](const auto& kind) {
            for (std::size_t e = 0; e < kind.size(); ++e) {
                const CornerMass share = kind.corner_mass(e);
                for (int c = 0; c < kind.corner_count(); ++c) {
                    nodes.mass[kind.node(e, c)] += share.mass;
                    nodes.inertia[kind.node(e, c)] += share.inertia;
                }
            }
        },
        elements);
}

/// The center of mass of the part's nodes. [m]
Vector3d center_of_mass(const Nodes& nodes, const Part& part)
{
    Vector3d moment;
    double mass = 0;
    for (std::uint32_t node = part.first_node; node < part.first_node + part.node_count; ++node) {
        moment += nodes.mass[node] * nodes.reference[node];
        mass += nodes.mass[node];
    }
    return mass > 0 ? moment / mass : moment;
}

/// Frees the part's nodes where they have mass and are not held, and sets them moving and turning about the center of mass.
void release(Nodes& nodes, const Part& part, const Freedom& freedom, const PartDescription& d)
{
    const Vector3d center = center_of_mass(nodes, part);
    for (std::uint32_t i = 0; i < part.node_count; ++i) {
        const std::uint32_t node = part.first_node + i;
        if (nodes.mass[node] > 0) {
            nodes.inverse_mass[node] = freedom.translation[i] / nodes.mass[node];
            nodes.velocity[node] = scaled(freedom.translation[i], d.velocity + cross(d.spin, nodes.reference[node] - center));
        }
        if (nodes.inertia[node] > 0) {
            nodes.inverse_inertia[node] = freedom.rotation[i] / nodes.inertia[node];
            nodes.angular_velocity[node] = scaled(freedom.rotation[i], d.spin);
        }
    }
}

/// Sets nodes moving that start otherwise than their part.
void set_starts(Nodes& nodes, const Part& part, const Freedom& freedom, const std::vector<StartVelocity>& starts)
{
    for (const StartVelocity& start : starts)
        for (const std::uint32_t node : start.nodes)
            nodes.velocity[part.first_node + node] = scaled(freedom.translation[node], start.velocity);
}

/// Takes the driven directions out of the nodes' freedom; refuses nodes that are held or driven there already.
void take_driven(const PartDescription& d, Freedom& freedom)
{
    for (const Drive& drive : d.drives) {
        for (const std::uint32_t node : drive.nodes) {
            if (freedom.translation[node][drive.axis] == 0)
                refuse(d,
                       fmt::format("the node at {} is driven along {}, where it is held or driven already", point_text(d.mesh.nodes[node]),
                                   "xyz"[drive.axis]),
                       "hold or drive a node once in each direction");
            freedom.translation[node][drive.axis] = 0;
        }
        if (d.element == ElementKind::rigid && drive.nodes.size() != d.mesh.nodes.size())
            refuse(d, fmt::format("{} of {} nodes of a rigid part are driven", drive.nodes.size(), d.mesh.nodes.size()),
                   "drive the whole of a rigid part: where = \"all\"");
    }
}

/// Drives nodes of the part, or the body that carries them.
void add_drives(Structure& structure, const Part& part, const std::vector<Drive>& drives)
{
    Nodes& nodes = structure.nodes;
    for (Drive drive : drives) {
        if (nodes.body_of(part.first_node) != nullptr) {
            drive.body = nodes.body[part.first_node];
            drive.nodes.clear();
            RigidBody& body = nodes.bodies.back();
            body.free[drive.axis] = 0;
            body.velocity[drive.axis] = drive.start();
        }
        for (std::uint32_t& node : drive.nodes) {
            node += part.first_node;
            nodes.velocity[node][drive.axis] = drive.start();
        }
        structure.drives.push_back(std::move(drive));
    }
}

/// Lets a body carry the part's nodes.
void add_body(Nodes& nodes, const Part& part, RigidBody body)
{
    nodes.body.resize(nodes.size(), -1);
    body.first_node = part.first_node;
    body.node_count = part.node_count;
    for (std::uint32_t node = part.first_node; node < part.first_node + part.node_count; ++node) {
        nodes.body[node] = static_cast<std::int32_t>(nodes.bodies.size());
        nodes.velocity[node] = body.velocity_at(nodes.reference[node]);
    }
    nodes.bodies.push_back(body);
}

/// Shows a triangle, or a quadrilateral cut along its shorter diagonal, as facets like `facet`.
void add_facets(Structure& structure, const std::uint32_t* corners, bool triangle, const Facet& facet)
{
    const std::vector<Vector3d>& at = structure.nodes.reference;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        structure.surface.facets.push_back(facet);
        structure.surface.facets.back().node = {a, b, c};
    };
    const std::uint32_t a = corners[0], b = corners[1], c = corners[2];
    if (triangle) return add(a, b, c);
    const std::uint32_t d = corners[3];
    if (norm_squared(at[c] - at[a]) <= norm_squared(at[d] - at[b])) {
        add(a, b, c);
        add(a, c, d);
    } else {
        add(a, b, d);
        add(b, c, d);
    }
}

/// Shows a part to gas and loads: surface elements with both sides, solids with their outer faces. The inner faces of solids that can
/// erode are listed, too, hidden while there is an element on either side.
void show(Structure& structure, const Part& part, const std::vector<MeshElement>& elements)
{
    const auto number = static_cast<std::uint32_t>(structure.parts.size());
    if (!is_solid(elements.front().shape)) {
        for (std::uint32_t e = 0; e < elements.size(); ++e)
            add_facets(structure, elements[e].node.data(), elements[e].shape == ElementShape::triangle,
                       {{}, part.first_element + e, number, Facet::no_element, false});
        return;
    }
    for (const SolidFace& face : solid_faces(elements)) {
        if (!face.is_outer() && !part.erodes) continue;
        const std::uint32_t other = face.is_outer() ? Facet::no_element : part.first_element + face.other;
        add_facets(structure, face.node.data(), face.corners == 3, {{}, part.first_element + face.element, number, other, true});
    }
}

/// Lists for each node the corner loads it gathers, in the order of elements.
void connect(Structure& structure)
{
    std::vector<std::uint32_t> node_of(structure.corner_loads.size());
    for (const Part& part : structure.parts) {
        std::visit(
            [&](const auto& elements) {
                const int corners = elements.corner_count();
                for (std::size_t e = 0; e < elements.size(); ++e)
                    for (int c = 0; c < corners; ++c) node_of[part.first_corner + e * corners + c] = elements.node(e, c);
            },
            part.elements);
    }
    structure.corner_begin.assign(structure.nodes.size() + 1, 0);
    for (const std::uint32_t node : node_of) ++structure.corner_begin[node];
    exclusive_scan(structure.corner_begin);
    structure.corners.resize(node_of.size());
    std::vector<std::uint32_t> next = structure.corner_begin;
    for (std::uint32_t corner = 0; corner < node_of.size(); ++corner) structure.corners[next[node_of[corner]]++] = corner;
}

void check_section(const PartDescription& d)
{
    check_point_masses(d);
    switch (d.element) {
        case ElementKind::shell:
        case ElementKind::membrane: check_shell(d); break;
        case ElementKind::solid: check_solid(d); break;
        case ElementKind::rigid: return;
    }
    check_material(d);
}

bool can_fail(const Material& material)
{
    return std::visit([]<class Law>(const Law&) { return damages<Law>(); }, material.strength);
}

}  // namespace

Part& add_part(Structure& structure, const PartDescription& d)
{
    const bool mixed = d.element == ElementKind::shell && has_triangle(d.mesh) && has_quadrilateral(d.mesh);
    if (mixed || (d.element == ElementKind::membrane && has_quadrilateral(d.mesh))) return add_part(structure, cut_into_triangles(d));
    for (const Part& part : structure.parts)
        if (part.name == d.name) refuse(d, "there is already a part of this name", "give each part a name of its own");
    check_mesh(d);
    check_shapes(d);
    check_holds(d);
    Freedom freedom = freedom_of(d);
    const bool wall = d.element == ElementKind::rigid && is_wall(d, freedom);
    take_driven(d, freedom);
    check_section(d);

    Part part;
    part.name = d.name;
    part.material = d.material;
    part.erosion = d.erosion;
    part.erodes = d.element != ElementKind::rigid && (d.erosion.any() || can_fail(d.material));
    part.first_element = static_cast<std::uint32_t>(structure.element_count());
    part.first_corner = static_cast<std::uint32_t>(structure.corner_loads.size());
    part.first_node = structure.nodes.add(d.mesh.nodes);
    part.node_count = static_cast<std::uint32_t>(d.mesh.nodes.size());
    const std::vector<MeshElement> elements = renumbered(d, part.first_node);
    if (elements.front().number != 0)
        for (const MeshElement& element : elements) part.element_numbers.push_back(element.number);
    part.elements = make_elements(d, elements, structure.nodes);
    add_masses(structure.nodes, part.elements);
    std::visit([&](const auto& e) { structure.corner_loads.resize(structure.corner_loads.size() + e.size() * e.corner_count()); },
               part.elements);
    if (d.element == ElementKind::rigid && !wall) {
        if (!d.starts.empty()) refuse(d, "nodes of a rigid part have no velocities of their own", "give the part a velocity and a spin");
        add_body(structure.nodes, part, make_rigid_body(d));
    } else {
        for (const PointMass& extra : d.point_masses)
            for (const std::uint32_t node : extra.nodes)
                structure.nodes.mass[part.first_node + node] += extra.mass / static_cast<double>(extra.nodes.size());
        release(structure.nodes, part, freedom, d);
        set_starts(structure.nodes, part, freedom, d.starts);
    }
    add_drives(structure, part, d.drives);
    show(structure, part, elements);
    structure.parts.push_back(std::move(part));
    connect(structure);
    hide_facets(structure);
    return structure.parts.back();
}

}  // namespace corpuscle
