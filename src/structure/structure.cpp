#include "structure/structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/error.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

/// What one sweep over the nodes adds up.
struct NodeSums {
    Vector3d support;  ///< momentum given by what holds the nodes [kg m/s]
    double work = 0;   ///< of nodal forces and moments [J]

    NodeSums& operator+=(const NodeSums& b)
    {
        support += b.support;
        work += b.work;
        return *this;
    }
};

/// Where a direction is held, what would have pushed the node goes to the support.
Vector3d held_part(const Vector3d& push, const Vector3d& inverse_mass)
{
    return {inverse_mass.x == 0 ? push.x : 0.0, inverse_mass.y == 0 ? push.y : 0.0, inverse_mass.z == 0 ? push.z : 0.0};
}

/// Moves one node through the step. The impulse acts first, then the force; so each one's work is exact.
NodeSums move_node(Nodes& nodes, std::size_t i, double force_time, double duration)
{
    const Vector3d before = nodes.velocity[i] + scaled(nodes.impulse[i], nodes.inverse_mass[i]);
    const Vector3d push = force_time * nodes.force[i], twist = force_time * nodes.moment[i];
    const Vector3d after = before + scaled(push, nodes.inverse_mass[i]);
    const Vector3d spin_before = nodes.angular_velocity[i];
    const Vector3d spin_after = spin_before + scaled(twist, nodes.inverse_inertia[i]);
    const Vector3d support = -held_part(push + nodes.impulse[i], nodes.inverse_mass[i]);
    nodes.velocity[i] = after;
    nodes.angular_velocity[i] = spin_after;
    nodes.impulse[i] = {};
    nodes.previous[i] = nodes.position[i];
    nodes.position[i] += duration * after;
    return {support, 0.5 * (dot(push, before + after) + dot(twist, spin_before + spin_after))};
}

/// Adds up at each node what its elements' corners do, in a fixed order.
void gather_loads(Structure& structure)
{
    Nodes& nodes = structure.nodes;
    for_each(nodes.size(), [&](std::size_t i) {
        Vector3d force, moment;
        for (std::uint32_t k = structure.corner_begin[i]; k < structure.corner_begin[i + 1]; ++k) {
            const CornerLoad& load = structure.corner_loads[structure.corners[k]];
            force += load.force;
            moment += load.moment;
        }
        nodes.force[i] = force;
        nodes.moment[i] = moment;
    });
}

[[noreturn]] void stop_at(const Structure& structure, const Part& part, std::size_t element, double time)
{
    const std::uint32_t node = std::visit([&](const auto& e) { return e.node(element, 0); }, part.elements);
    const Vector3d& at = structure.nodes.reference[node];
    throw SafetyStop(
        fmt::format(
            "element {} of part '{}' (as meshed near ({:.4g}, {:.4g}, {:.4g}) m) came to nothing or is no longer finite at {:.6g} s",
            part.number_of(element), part.name, at.x, at.y, at.z, time),
        "the load is more than this mesh can follow: look at the last state written, then refine or coarsen the mesh there, or lower the "
        "step");
}

/// The first element that allows no step or whose energy is no longer a number, or their number.
std::size_t first_unsound(const Part& part)
{
    return std::visit(
        [](const auto& elements) {
            std::size_t e = 0;
            while (e < elements.size() && elements.transit(e) > 0 && std::isfinite(elements.energy(e).internal)) ++e;
            return e;
        },
        part.elements);
}

/// Moves the rigid bodies and the nodes they carry; returns what their supports gave. [kg m/s]
Vector3d move_bodies(Nodes& nodes, double duration)
{
    Vector3d support;
    for (RigidBody& body : nodes.bodies) {
        support += body.advance(duration);
        const Vector3d spin = body.spin();
        for_each(body.node_count, [&](std::size_t i) {
            const std::size_t node = body.first_node + i;
            nodes.position[node] = body.placed(nodes.reference[node]);
            if (duration > 0) nodes.velocity[node] = (nodes.position[node] - nodes.previous[node]) / duration;
            nodes.angular_velocity[node] = spin;
        });
    }
    return support;
}

}  // namespace

double stable_step(const Structure& structure)
{
    constexpr double safety = 0.9;
    double least = std::numeric_limits<double>::infinity();
    for (const Part& part : structure.parts)
        least = std::min(least, std::visit([](const auto& e) { return e.stable_step(); }, part.elements));
    return safety * least;
}

std::vector<Transfer> resist(Structure& structure, const Clock& clock)
{
    if (structure.parts.empty() || !(clock.duration() > 0)) return {};
    std::vector<Transfer> gone;
    for (Part& part : structure.parts) {
        std::size_t wrong = std::visit(
            [&](auto& elements) {
                const std::span<CornerLoad> loads(structure.corner_loads.data() + part.first_corner,
                                                  elements.size() * elements.corner_count());
                return elements.resist(structure.nodes, clock.duration(), loads);
            },
            part.elements);
        if (part.erodes) {
            const Transfer left = erode(structure, part, clock);
            if (left.mass > 0) gone.push_back(left);
            wrong = first_unsound(part);
        }
        if (wrong != part.element_count()) stop_at(structure, part, wrong, clock.end());
    }
    gather_loads(structure);
    return gone;
}

std::vector<Transfer> accelerate(Structure& structure, const Clock& clock)
{
    if (structure.parts.empty()) return {};
    const double force_time = 0.5 * (clock.previous_duration() + clock.duration());
    const Driven driven = drive(structure.nodes, structure.drives, force_time, clock);
    constexpr std::size_t piece = 512;  // nodes that a thread takes at a time
    const auto move_nodes = [&](std::size_t begin, std::size_t end) {
        NodeSums moved;
        for (std::size_t i = begin; i < end; ++i) moved += move_node(structure.nodes, i, force_time, clock.duration());
        return moved;
    };
    const NodeSums sums = sum_chunks<NodeSums>(structure.nodes.size(), move_nodes, piece);
    structure.force_work += sums.work + driven.force_work;
    const Vector3d support = sums.support + move_bodies(structure.nodes, clock.duration()) + driven.reaction;
    std::vector<Transfer> given{Transfer{"support", "structure", 0.0, support, 0.0}};
    if (!structure.drives.empty()) given.push_back(driven.given);
    return given;
}

}  // namespace corpuscle
