#include "structure/builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "mesh/measure.hpp"
#include "mesh/quality.hpp"
#include "parallel/loops.hpp"

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

void check_shapes(const PartDescription& d)
{
    for (std::size_t e = 0; e < d.mesh.elements.size(); ++e) {
        const ElementShape shape = d.mesh.elements[e].shape;
        if (shape == ElementShape::quadrilateral) continue;
        const std::string place = element_place(d.mesh, e);
        if (shape != ElementShape::triangle)
            refuse(d, place + " is a solid", "shells and rigid parts are made of surface elements: mesh the surface");
        if (d.element == ElementKind::shell)
            refuse(d, place + " is a triangle, and deforming shells must be quadrilaterals",
                   "mesh with quadrilaterals only (gmsh: Recombine Surface)");
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
    if (d.points < 2 || d.points > 10)
        refuse(d, fmt::format("{} points through the thickness", d.points),
               "give 3 to 10 points (2 is enough for elastic bending with Gauss points)");
    if (!(d.shear_factor > 0 && d.shear_factor <= 1))
        refuse(d, fmt::format("shear factor {}", d.shear_factor), "give a shear factor above 0 and at most 1 (5/6)");
    check_thickness(d);
    try {
        check(d.material);
    } catch (const InputError& e) {
        refuse(d, e.problem(), e.remedy());
    }
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

void check_rigid(const PartDescription& d, const Freedom& freedom)
{
    const Vector3d still{};
    for (const MeshElement& element : d.mesh.elements)
        for (int c = 0; c < node_count(element.shape); ++c)
            if (!(freedom.translation[element.node[c]] == still))
                refuse(d,
                       fmt::format("a rigid part that can move is not supported, and its node at {} is free",
                                   point_text(d.mesh.nodes[element.node[c]])),
                       "hold the whole part: fix = [{ where = \"all\", dof = \"all\" }], or make it of shells");
}

/// The mesh's elements with the structure's node numbers.
std::vector<MeshElement> renumbered(const PartDescription& d, std::uint32_t first_node)
{
    std::vector<MeshElement> elements = d.mesh.elements;
    for (MeshElement& element : elements)
        for (int c = 0; c < node_count(element.shape); ++c) element.node[c] += first_node;
    return elements;
}

QuadrilateralShells make_shells(const PartDescription& d, const std::vector<MeshElement>& elements, const Nodes& nodes)
{
    ShellInput input;
    for (const MeshElement& e : elements) input.corners.push_back({e.node[0], e.node[1], e.node[2], e.node[3]});
    input.thickness = d.thicknesses.empty() ? std::vector<double>(elements.size(), d.thickness) : d.thicknesses;
    input.points = d.rule == PointRule::gauss ? gauss_rule(d.points) : lobatto_rule(d.points);
    input.shear_factor = d.shear_factor;
    input.hourglass = d.hourglass;
    return QuadrilateralShells(std::move(input), d.material, nodes);
}

/// Frees the part's nodes where they have mass and are not held, and sets them moving.
void release(Nodes& nodes, const Part& part, const Freedom& freedom, const Vector3d& velocity)
{
    for (std::uint32_t i = 0; i < part.node_count; ++i) {
        const std::uint32_t node = part.first_node + i;
        if (nodes.mass[node] > 0) nodes.inverse_mass[node] = freedom.translation[i] / nodes.mass[node];
        if (nodes.inertia[node] > 0) nodes.inverse_inertia[node] = freedom.rotation[i] / nodes.inertia[node];
        if (nodes.mass[node] > 0) nodes.velocity[node] = scaled(freedom.translation[i], velocity);
    }
}

/// Shows an element to the gas: a triangle, or a quadrilateral cut along its shorter diagonal.
void add_facets(Structure& structure, const MeshElement& element, std::uint32_t number, std::uint32_t part)
{
    const std::vector<Vector3d>& at = structure.nodes.reference;
    const auto [a, b, c, d] = std::array{element.node[0], element.node[1], element.node[2], element.node[3]};
    std::vector<Facet>& facets = structure.surface.facets;
    if (element.shape == ElementShape::triangle) {
        facets.push_back({{a, b, c}, number, part});
    } else if (norm_squared(at[c] - at[a]) <= norm_squared(at[d] - at[b])) {
        facets.push_back({{a, b, c}, number, part});
        facets.push_back({{a, c, d}, number, part});
    } else {
        facets.push_back({{a, b, d}, number, part});
        facets.push_back({{b, c, d}, number, part});
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

}  // namespace

Part& add_part(Structure& structure, const PartDescription& d)
{
    const bool rigid = d.element == ElementKind::rigid;
    for (const Part& part : structure.parts)
        if (part.name == d.name) refuse(d, "there is already a part of this name", "give each part a name of its own");
    check_mesh(d);
    check_shapes(d);
    check_holds(d);
    const Freedom freedom = freedom_of(d);
    if (rigid)
        check_rigid(d, freedom);
    else
        check_shell(d);

    Part part;
    part.name = d.name;
    part.material = d.material;
    part.first_element = static_cast<std::uint32_t>(structure.element_count());
    part.first_corner = static_cast<std::uint32_t>(structure.corner_loads.size());
    part.first_node = structure.nodes.add(d.mesh.nodes);
    part.node_count = static_cast<std::uint32_t>(d.mesh.nodes.size());
    const std::vector<MeshElement> elements = renumbered(d, part.first_node);
    if (rigid)
        part.elements = RigidFacets(elements);
    else
        part.elements = make_shells(d, elements, structure.nodes);
    std::visit(
        [&](const auto& e) {
            e.add_masses(structure.nodes);
            structure.corner_loads.resize(structure.corner_loads.size() + e.size() * e.corner_count());
        },
        part.elements);
    release(structure.nodes, part, freedom, d.velocity);
    for (std::uint32_t e = 0; e < elements.size(); ++e)
        add_facets(structure, elements[e], part.first_element + e, static_cast<std::uint32_t>(structure.parts.size()));
    structure.parts.push_back(std::move(part));
    connect(structure);
    return structure.parts.back();
}

}  // namespace corpuscle
