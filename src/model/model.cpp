#include "model/model.hpp"

#include "model/grid_books.hpp"
#include "parallel/loops.hpp"
#include "structure/energy.hpp"

namespace corpuscle {

namespace {

/// Impulses of this step into held and driven directions, which supports and drives will answer in the next; and the work that they did
/// where driven, which a drive will then take back. Without mass. [N s], [J]
Holding waiting_for_supports(const Nodes& nodes)
{
    Holding waiting;
    for (const RigidBody& body : nodes.bodies) {
        const Vector3d held = body.impulse - scaled(body.impulse, body.free);
        waiting += {0, held, dot(held, body.velocity)};
    }
    waiting += sum<Holding>(nodes.size(), [&](std::size_t i) {
        Vector3d held;
        for (int a = 0; a < 3; ++a) held[a] = nodes.inverse_mass[i][a] == 0 ? nodes.impulse[i][a] : 0.0;
        return Holding{0, held, dot(held, nodes.velocity[i])};
    });
    return waiting;
}

/// Kinetic energy is known half a step before the strain energy: what the forces do in between. [J]
double half_step_work(const Nodes& nodes, double duration)
{
    return sum<double>(nodes.size(), [&](std::size_t i) {
        const auto node = static_cast<std::uint32_t>(i);
        if (!(nodes.mass[i] > 0)) return 0.0;
        return 0.5 * duration * (dot(nodes.force[i], nodes.contact_velocity(node)) + dot(nodes.moment[i], nodes.angular_velocity[i]));
    });
}

/// About the faces of each part of solids: gas presses on them from one side alone, so it must be awake.
std::vector<Box> solid_boxes(const Structure& structure)
{
    std::vector<Box> boxes(structure.parts.size());
    for (const Facet& facet : structure.surface.facets) {
        if (!facet.solid) continue;
        for (const std::uint32_t node : facet.node) boxes[facet.part].include(structure.nodes.position[node]);
    }
    std::erase_if(boxes, [](const Box& box) { return !(box.lower.x <= box.upper.x); });
    return boxes;
}

}  // namespace

Model::Model(Gas gas_, Structure structure_)
    : gas(std::move(gas_)), structure(std::move(structure_)), gas_structure(gas, structure), grid_walls(euler, structure)
{
}

Holding Model::held(double duration) const
{
    const GasContents inside = contents(gas);
    Holding total = inside.gas;
    total += inside.explosive;
    total += corpuscle::held(euler);
    const StructureEnergy solid = energy(structure);
    total += waiting_for_supports(structure.nodes);
    total += {-structure.eroded.mass, momentum(structure),
              solid.kinetic + solid.internal + solid.hourglass + half_step_work(structure.nodes, duration)};
    return total;
}

void let_sleep_beside_structure(Model& model)
{
    SleepingGas& sleeping = model.gas.sleeping;
    const Nodes& nodes = model.structure.nodes;
    if (sleeping.disturbances.empty()) return;
    for (const Box& box : solid_boxes(model.structure)) sleeping.disturbances.push_back({box, 0});
    bool moves = !model.loads.empty() || !model.structure.drives.empty();
    Box movable;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        moves = moves || norm_squared(nodes.velocity[n]) + norm_squared(nodes.angular_velocity[n]) > 0;
        if (norm_squared(nodes.inverse_mass[n]) > 0) movable.include(nodes.position[n]);
    }
    for (const Drive& drive : model.structure.drives)
        for (const std::uint32_t n : drive.nodes) movable.include(nodes.position[n]);
    for (const RigidBody& body : model.structure.nodes.bodies) {
        moves = moves || norm_squared(body.velocity) + norm_squared(body.spin_momentum) > 0;
        for (std::uint32_t n = 0; n < body.node_count; ++n) movable.include(nodes.position[body.first_node + n]);
    }
    if (!(movable.lower.x <= movable.upper.x)) return;
    sleeping.movable = movable;
    if (moves) sleeping.disturbances.push_back({movable, 0});
    sleeping.movable_woken = moves;
}

void add_conwep(Model& model, std::uint32_t part, const ConwepCharge& charge)
{
    model.loads.push_back(std::make_unique<ConwepLoad>(model.structure, part, charge));
}

}  // namespace corpuscle
