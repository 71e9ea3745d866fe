#include "input/build_structure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "input/curves.hpp"
#include "input/doubts.hpp"
#include "input/make_material.hpp"
#include "input/mesh_files.hpp"
#include "input/placed.hpp"
#include "input/shapes.hpp"
#include "mesh/boundary.hpp"
#include "mesh/extrude.hpp"
#include "mesh/generators.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"
#include "mesh/transform.hpp"
#include "schema/nearest.hpp"
#include "structure/builder.hpp"

namespace corpuscle {

namespace {

/// Rim divisions of the disk that a ring surrounds, 0 if there is none.
int flush_divisions(const PartInput& ring, const CaseDescription& description)
{
    for (const PartInput& part : description.parts) {
        if (!part.mesh.disk) continue;
        const DiskInput& disk = *part.mesh.disk;
        const bool same_radius = std::abs(disk.radius - ring.mesh.ring->inner_radius) <= 1e-9 * disk.radius;
        if (same_radius && disk.quarter == ring.mesh.ring->quarter && part.mesh.move == ring.mesh.move)
            return rim_divisions(disk.radius, disk.element_size, disk.quarter);
    }
    return 0;
}

/// The elements of a set of the mesh; refuses a name it does not have, with the nearest it has.
const std::vector<std::uint32_t>& elements_of(const Mesh& mesh, const std::string& set, const Place& place)
{
    const auto found = mesh.element_sets.find(set);
    if (found != mesh.element_sets.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [name, elements] : mesh.element_sets) names.push_back(name);
    throw InputError(fmt::format("the mesh has no group '{}'", set),
                     names.empty() ? "the mesh has no groups of elements" : suggestion(set, names), place);
}

constexpr std::uint32_t no_element = 0xFFFFFFFFu;

/// The elements of one set of a mesh, their nodes, and what of the other sets is among them.
Mesh only_group(const Mesh& mesh, const std::string& group, const Place& place)
{
    const std::vector<std::uint32_t>& chosen = elements_of(mesh, group, place);
    Mesh part;
    part.nodes = mesh.nodes;
    part.node_sets = mesh.node_sets;
    part.remarks = mesh.remarks;
    std::vector<std::uint32_t> kept_as(mesh.elements.size(), no_element);
    for (const std::uint32_t element : chosen) {
        kept_as[element] = static_cast<std::uint32_t>(part.elements.size());
        part.elements.push_back(mesh.elements[element]);
    }
    for (const auto& [name, elements] : mesh.element_sets)
        for (const std::uint32_t element : elements)
            if (kept_as[element] != no_element) part.element_sets[name].push_back(kept_as[element]);
    remove_unused_nodes(part);
    return part;
}

Mesh generated_surface(const PartInput& part, const CaseDescription& description)
{
    const MeshInput& mesh = part.mesh;
    if (mesh.disk) return disk_mesh(mesh.disk->radius, mesh.disk->element_size, mesh.disk->quarter);
    if (mesh.ring)
        return ring_mesh(mesh.ring->inner_radius, mesh.ring->outer_radius, mesh.ring->element_size, mesh.ring->quarter,
                         flush_divisions(part, description));
    if (mesh.rectangle)
        return rectangle_mesh(mesh.rectangle->origin, mesh.rectangle->edge_1, mesh.rectangle->edge_2, mesh.rectangle->element_size);
    return box_mesh(box_of(mesh.box->box), mesh.box->element_size);
}

/// The way a part's surface is swept: along the normal of a rectangle, else along z. [m]
Vector3d sweep_of(const MeshInput& mesh)
{
    if (!mesh.rectangle) return {0.0, 0.0, mesh.extrude->height};
    return mesh.extrude->height * normalized(cross(mesh.rectangle->edge_1, mesh.rectangle->edge_2));
}

/// What a support holds, as masks on its nodes.
Hold make_hold(const Mesh& mesh, const FixInput& fix)
{
    std::vector<std::uint32_t> nodes = at_place(fix.places.of("where"), [&] { return select_nodes(mesh, fix.where); });
    Hold hold;
    switch (fix.dof) {
        case Held::all: return clamp(std::move(nodes));
        case Held::translation: return pin(std::move(nodes));
        case Held::rotation: hold.rotation = {true, true, true}; break;
        case Held::x: hold.translation.x = true; break;
        case Held::y: hold.translation.y = true; break;
        case Held::z: hold.translation.z = true; break;
        case Held::symmetry: {
            const auto plane = parse_plane(fix.where);
            if (!plane)
                throw InputError(fmt::format("dof = \"symmetry\" needs a plane, '{}' is none", fix.where),
                                 "expected where = \"x=0\" or another plane across an axis", fix.places.of("where"));
            return symmetry(std::move(nodes), plane->axis);
        }
    }
    hold.nodes = std::move(nodes);
    return hold;
}

/// A motion that nodes follow; a displacement begins where the mesh is.
Drive make_drive(const Mesh& mesh, const PartInput& part, const DriveInput& input, const CaseDescription& description)
{
    Drive drive;
    drive.nodes = at_place(input.places.of("where"), [&] { return select_nodes(mesh, input.where); });
    drive.axis = static_cast<int>(input.dof);
    drive.start_velocity = part.velocity[drive.axis];
    if (input.displacement) {
        drive.kind = DriveKind::displacement;
        drive.curve = make_curve(*input.displacement, "m", description);
        if (drive.curve.value(0) != 0)
            throw InputError(fmt::format("the displacement is {:.6g} m at time 0", drive.curve.value(0)),
                             "expected a curve that begins at 0 at time 0", input.places.of("displacement"));
    } else if (input.velocity) {
        drive.kind = DriveKind::velocity;
        drive.curve = make_curve(*input.velocity, "m/s", description);
    } else {
        drive.kind = DriveKind::acceleration;
        drive.curve = make_curve(*input.acceleration, "m/s2", description);
    }
    return drive;
}

/// The thickness of each shell, where sets of them have their own; else nothing. [m]
std::vector<double> thicknesses_of(const Mesh& mesh, const ShellInputSection& shell)
{
    if (shell.sets.empty()) return {};
    std::vector<double> thicknesses(mesh.elements.size(), shell.thickness);
    for (const ThicknessInput& own : shell.sets)
        for (const std::uint32_t element : elements_of(mesh, own.set, own.places.of("set"))) thicknesses[element] = own.thickness;
    return thicknesses;
}

/// What the part's elements are and what they need besides a material.
void set_section(PartDescription& built, const ElementInput& element)
{
    if (element.shell) {
        built.element = ElementKind::shell;
        built.thickness = element.shell->thickness;
        built.thicknesses = thicknesses_of(built.mesh, *element.shell);
        built.points = element.shell->points;
    } else if (element.membrane) {
        built.element = ElementKind::membrane;
        built.thickness = element.membrane->thickness;
    } else if (element.is_solid()) {
        const SolidSection section = element.solid.value_or(SolidSection{});
        built.element = ElementKind::solid;
        built.full_integration = section.bricks == BrickRule::full;
        built.brick_hourglass = section.hourglass;
    } else {
        const RigidSection section = element.rigid.value_or(RigidSection{});
        built.element = ElementKind::rigid;
        built.rigid = {section.mass, section.inertia, section.center};
        built.thickness = section.thickness.value_or(0.0);
    }
}

Erosion make_erosion(const ErosionInput& input)
{
    Erosion limits;
    if (input.plastic_strain) limits.plastic_strain = *input.plastic_strain;
    if (input.principal_stress) limits.principal_stress = *input.principal_stress;
    if (input.tension) limits.tension = *input.tension;
    if (input.step) limits.step = *input.step;
    return limits;
}

/// Triangles among a shell part's quadrilaterals make triangles of all: worth knowing, as they are stiffer and as many again.
void warn_of_triangles(const PartDescription& built, std::vector<std::string>& warnings)
{
    const auto count = [&](ElementShape shape) {
        return std::count_if(built.mesh.elements.begin(), built.mesh.elements.end(),
                             [shape](const MeshElement& e) { return e.shape == shape; });
    };
    const auto triangles = count(ElementShape::triangle), others = count(ElementShape::quadrilateral);
    if (built.element == ElementKind::shell && triangles > 0 && others > 0)
        warnings.push_back(
            fmt::format("part '{}' has {} triangles among {} quadrilaterals: all are computed as triangles, which are stiffer in "
                        "bending; a mesh of quadrilaterals alone is better",
                        built.name, triangles, others));
}

/// The mesh of a part, of a file that may have been read for another.
Mesh mesh_of(const PartInput& part, const CaseDescription& description, MeshFiles& files)
{
    const Place& place = part.places.of("mesh");
    const auto chosen = [&](const Mesh& whole) {
        return part.mesh.group.empty() ? whole : only_group(whole, part.mesh.group, part.mesh.places.of("group"));
    };
    Mesh mesh = part.mesh.file ? chosen(files.read(*part.mesh.file, part.mesh.unit, place))
                               : chosen(at_place(place, [&] { return generated_surface(part, description); }));
    if (part.mesh.extrude) mesh = at_place(place, [&] { return extruded(mesh, sweep_of(part.mesh), part.mesh.extrude->layers); });
    translate(mesh, part.mesh.move);
    return mesh;
}

PartDescription describe(const PartInput& part, const CaseDescription& description, MeshFiles& files, std::vector<std::string>& warnings)
{
    PartDescription built;
    built.name = part.name;
    built.place = part.places.own;
    built.material_place = part.places.of("material");
    built.mesh = mesh_of(part, description, files);
    at_place(part.places.of("mesh"), [&] {
        for (const std::string& remark : built.mesh.remarks)
            if (std::find(warnings.begin(), warnings.end(), remark) == warnings.end()) warnings.push_back(remark);
        for (const std::string& warning : validate(built.mesh, part.name)) warnings.push_back(warning);
        if (part.mesh.closed) require_closed(built.mesh, part.name);
    });
    set_section(built, part.element);
    if (part.element.is_rigid()) {
        if (part.material && part.element.rigid) built.material = make_material(*part.material->values);
        if (part.material && !part.element.rigid)
            warnings.push_back(fmt::format("part '{}' is rigid: its material has no effect", part.name));
    } else {
        if (!part.material)
            throw InputError(fmt::format("part '{}' has no material, so it has no mass", part.name),
                             "expected material = \"rha_steel\" or another (`corpuscle list materials`)", part.places.own);
        built.material = make_material(*part.material->values);
        if (part.erosion) built.erosion = make_erosion(*part.erosion);
    }
    warn_of_triangles(built, warnings);
    for (const FixInput& fix : part.fix) built.holds.push_back(make_hold(built.mesh, fix));
    for (const PointMassInput& extra : part.point_masses)
        built.point_masses.push_back(
            {at_place(extra.places.of("where"), [&] { return select_nodes(built.mesh, extra.where); }), extra.mass});
    for (const DriveInput& drive : part.drive) built.drives.push_back(make_drive(built.mesh, part, drive, description));
    for (const StartInput& start : part.start)
        built.starts.push_back({at_place(start.places.of("where"), [&] { return select_nodes(built.mesh, start.where); }), start.velocity});
    built.velocity = part.velocity;
    built.spin = part.spin;
    return built;
}

/// The stable steps of a part's elements: the least, the one in the middle, and whose the least is.
void find_steps(const Part& part, PartReport& report)
{
    constexpr double safety = 0.9;  // as in stable_step of a structure
    std::vector<double> steps;
    std::visit(
        [&](const auto& elements) {
            for (std::size_t e = 0; e < elements.size(); ++e) steps.push_back(safety * elements.transit(e));
        },
        part.elements);
    const auto least = std::min_element(steps.begin(), steps.end());
    report.step = *least;
    report.slowest = part.number_of(static_cast<std::size_t>(least - steps.begin()));
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    report.usual_step = *middle;
}

/// The report on the part that has just been built of a mesh.
PartReport report_of(const Mesh& mesh, const Structure& structure)
{
    const Part& part = structure.parts.back();
    PartReport report;
    report.name = part.name;
    report.kind = std::visit([](const auto& e) { return e.kind(); }, part.elements);
    report.elements = part.element_count();
    report.nodes = part.node_count;
    for (std::uint32_t n = part.first_node; n < part.first_node + part.node_count; ++n) report.mass += structure.nodes.mass[n];
    if (const RigidBody* body = structure.nodes.body_of(part.first_node)) report.mass = body->mass;
    report.quality = check(mesh);
    report.slender = element_number(mesh, report.quality.longest_element);
    report.warped = element_number(mesh, report.quality.warped_element);
    report.badly_shaped = element_number(mesh, report.quality.worst_element);
    find_steps(part, report);
    return report;
}

/// A few small elements make the whole run as slow as they are.
void warn_of_small_step(const PartReport& part, std::vector<std::string>& warnings)
{
    constexpr double much_less = 0.3;
    if (std::isfinite(part.step) && part.step < much_less * part.usual_step)
        warnings.push_back(
            fmt::format("part '{}': element {} allows a step of {:.3g} s only, most of its elements {:.3g} s: a mesh without "
                        "such small elements would run {:.0f} times as fast",
                        part.name, part.slowest, part.step, part.usual_step, part.usual_step / part.step));
}

/// Finds the nodes of the loads on the part that has just been built, and reads their curves.
void plan_loads(const CaseDescription& description, const Mesh& mesh, const Structure& structure, std::vector<PlannedLoad>& loads)
{
    const Part& part = structure.parts.back();
    for (std::size_t i = 0; i < description.loads.size(); ++i) {
        const LoadInput& load = description.loads[i];
        if (load.part != part.name || load.conwep) continue;
        LoadedNodes& where = loads[i].where;
        where.part = static_cast<std::uint32_t>(structure.parts.size() - 1);
        where.nodes = at_place(load.places.of("where"), [&] { return select_nodes(mesh, load.where); });
        for (std::uint32_t& node : where.nodes) node += part.first_node;
        where.name = fmt::format("{} on {} of {}", load.pressure ? "pressure" : "force", load.where, part.name);
        loads[i].curve = load.pressure ? make_curve(*load.pressure, "Pa", description) : make_curve(*load.force, "N", description);
    }
}

}  // namespace

Mesh make_mesh(const PartInput& part, const CaseDescription& description)
{
    MeshFiles files(description);
    return mesh_of(part, description, files);
}

Structure build_structure(const CaseDescription& description, StructureNotes& notes)
{
    Structure structure;
    notes.loads.resize(description.loads.size());
    MeshFiles files(description);
    for (const PartInput& part : description.parts) {
        const PartDescription described = describe(part, description, files, notes.warnings);
        at_place(part.places.own, [&] { add_part(structure, described); });
        notes.parts.push_back(report_of(described.mesh, structure));
        warn_of_small_step(notes.parts.back(), notes.warnings);
        warn_of_doubts(part, described, structure, notes.warnings);
        plan_loads(description, described.mesh, structure, notes.loads);
    }
    warn_of_parts_outside(description, structure, notes.warnings);
    return structure;
}

std::string PartReport::text() const
{
    const std::string mesh = fmt::format(
        "part '{}': {} {} elements, {} nodes, edges {:.4g} to {:.4g} m, worst aspect {:.3g} (element {}), warp {:.3g} degrees (element "
        "{}), "
        "scaled Jacobian {:.3g} (element {})",
        name, elements, kind, nodes, quality.min_edge, quality.max_edge, quality.worst_aspect, slender,
        quality.worst_warp * 180 / std::numbers::pi, warped, quality.min_scaled_jacobian, badly_shaped);
    return std::isfinite(step) ? mesh + fmt::format(", stable step {:.4g} s (element {})", step, slowest) : mesh;
}

}  // namespace corpuscle
