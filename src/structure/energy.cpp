#include "structure/energy.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

/// Kinetic energy of a node; 0 for one without mass. [J]
double kinetic_energy(const Nodes& nodes, std::size_t i)
{
    if (!(nodes.mass[i] > 0)) return 0.0;
    const Vector3d velocity = nodes.contact_velocity(static_cast<std::uint32_t>(i));
    return 0.5 * (nodes.mass[i] * norm_squared(velocity) + nodes.inertia[i] * norm_squared(nodes.angular_velocity[i]));
}

double kinetic_energy(const Nodes& nodes, std::size_t first, std::size_t count)
{
    return sum<double>(count, [&](std::size_t i) { return kinetic_energy(nodes, first + i); });
}

ElementEnergy element_energy(const Part& part)
{
    return std::visit(
        [](const auto& elements) { return sum<ElementEnergy>(elements.size(), [&](std::size_t e) { return elements.energy(e); }); },
        part.elements);
}

}  // namespace

StructureEnergy part_energy(const Structure& structure, const Part& part)
{
    const ElementEnergy held = element_energy(part);
    double kinetic = kinetic_energy(structure.nodes, part.first_node, part.node_count);
    if (part.node_count > 0)
        if (const RigidBody* body = structure.nodes.body_of(part.first_node)) kinetic += body->kinetic_energy();
    return {kinetic, held.internal, held.plastic, held.hourglass, 0.0};
}

StructureEnergy energy(const Structure& structure)
{
    StructureEnergy all;
    for (const Part& part : structure.parts) {
        const StructureEnergy own = part_energy(structure, part);
        all.kinetic += own.kinetic;
        all.internal += own.internal;
        all.plastic += own.plastic;
        all.hourglass += own.hourglass;
    }
    all.integration = -structure.force_work - all.internal - all.hourglass - structure.eroded.internal;
    return all;
}

double max_plastic_strain(const Part& part)
{
    return std::visit(
        [](const auto& elements) {
            double most = 0;
            for (std::size_t e = 0; e < elements.size(); ++e) most = std::max(most, elements.values(e).plastic_strain);
            return most;
        },
        part.elements);
}

Vector3d momentum(const Structure& structure)
{
    Vector3d total = sum<Vector3d>(structure.nodes.size(), [&](std::size_t i) {
        const double mass = structure.nodes.mass[i];
        return mass > 0 ? mass * structure.nodes.contact_velocity(static_cast<std::uint32_t>(i)) : Vector3d{};
    });
    for (const RigidBody& body : structure.nodes.bodies) total += body.momentum();
    return total;
}

std::string fastest_element(const Structure& structure)
{
    double fastest = 0;
    std::string words;
    for (const Part& part : structure.parts) {
        const auto look = [&](const auto& elements) {
            for (std::size_t e = 0; e < elements.size(); ++e) {
                const std::uint32_t node = elements.node(e, 0);
                const double speed = norm(structure.nodes.velocity[node]);
                if (!(speed > fastest)) continue;
                const Vector3d& at = structure.nodes.reference[node];
                fastest = speed;
                words = fmt::format("element {} of part '{}' (as meshed near ({:.4g}, {:.4g}, {:.4g}) m) moves fastest, at {:.4g} m/s",
                                    part.number_of(e), part.name, at.x, at.y, at.z, speed);
            }
        };
        std::visit(look, part.elements);
    }
    return words;
}

}  // namespace corpuscle
