#include "structure/drive.hpp"

namespace corpuscle {

namespace {

/// Sets a node's velocity along an axis.
void drive_node(Nodes& nodes, std::uint32_t node, int axis, double velocity, double force_time, Driven& driven)
{
    const double mass = nodes.mass[node], before = nodes.velocity[node][axis];
    const double push = force_time * nodes.force[node][axis], impulse = nodes.impulse[node][axis];
    driven.given.momentum[axis] += mass * (velocity - before) - push - impulse;
    driven.given.energy += 0.5 * mass * (velocity - before) * (velocity + before) - 0.5 * push * (before + velocity) - impulse * before;
    driven.reaction[axis] += push + impulse;
    driven.force_work -= 0.5 * push * (velocity - before);
    nodes.velocity[node][axis] = velocity;
}

/// Sets the velocity of a body's center along an axis.
void drive_body(RigidBody& body, int axis, double velocity, Driven& driven)
{
    const double before = body.velocity[axis], impulse = body.impulse[axis];
    driven.given.momentum[axis] += body.mass * (velocity - before) - impulse;
    driven.given.energy += 0.5 * body.mass * (velocity - before) * (velocity + before) - impulse * before;
    driven.reaction[axis] += impulse;
    body.velocity[axis] = velocity;
}

}  // namespace

double Drive::start() const
{
    switch (kind) {
        case DriveKind::displacement: return 0.0;
        case DriveKind::velocity: return curve.value(0);
        case DriveKind::acceleration: break;
    }
    return start_velocity;
}

double Drive::way(double from, double to) const
{
    switch (kind) {
        case DriveKind::displacement: return curve.value(to) - curve.value(from);
        case DriveKind::velocity: return curve.integral(from, to);
        case DriveKind::acceleration: break;
    }
    return start_velocity * (to - from) + curve.way(to) - curve.way(from);
}

Driven drive(Nodes& nodes, const std::vector<Drive>& drives, double force_time, const Clock& clock)
{
    Driven driven;
    if (!(clock.duration() > 0)) return driven;
    for (const Drive& drive : drives) {
        const double velocity = drive.way(clock.time(), clock.end()) / clock.duration();
        if (drive.body >= 0) drive_body(nodes.bodies[static_cast<std::size_t>(drive.body)], drive.axis, velocity, driven);
        for (const std::uint32_t node : drive.nodes) drive_node(nodes, node, drive.axis, velocity, force_time, driven);
    }
    return driven;
}

}  // namespace corpuscle
