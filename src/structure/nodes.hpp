#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/vector3.hpp"
#include "mesh/surface.hpp"
#include "structure/rigid_body.hpp"

namespace corpuscle {

/// The nodes of a structure: where they are, how they move, what pushes them. All vectors have one entry a node.
struct Nodes {
    std::vector<Vector3d> reference;         ///< as meshed [m]
    std::vector<Vector3d> previous;          ///< at the start of the step [m]
    std::vector<Vector3d> position;          ///< at its end [m]
    std::vector<Vector3d> velocity;          ///< carried previous to position [m/s]
    std::vector<Vector3d> angular_velocity;  ///< [rad/s]
    std::vector<Vector3d> force;             ///< internal, at `position`, written by resist [N]
    std::vector<Vector3d> moment;            ///< internal, at `position`, written by resist [N m]
    std::vector<Vector3d> impulse;           ///< from contacts and loads since the last accelerate [N s]
    std::vector<double> mass;                ///< [kg]
    std::vector<double> inertia;             ///< the same about every axis [kg m2]
    std::vector<Vector3d> inverse_mass;      ///< per direction, 0 where held [1/kg]
    std::vector<Vector3d> inverse_inertia;   ///< per direction, 0 where held [1/(kg m2)]

    std::vector<RigidBody> bodies;   ///< that carry some of the nodes with them; those nodes have no mass of their own
    std::vector<std::int32_t> body;  ///< of each node, -1: none; empty where there are no bodies

    [[nodiscard]] std::size_t size() const { return position.size(); }

    std::vector<Vector3d> path_start;  ///< at the ends of the gas's step, where those are not the ends of the structure's: else empty [m]
    std::vector<Vector3d> path_end;    ///< [m]

    /// Where the nodes are at both ends of the gas's step.
    [[nodiscard]] NodePath path() const { return {path_start.empty() ? previous : path_start, path_end.empty() ? position : path_end}; }

    /// Velocity a contact meets: with the impulses that wait for the next accelerate. [m/s]
    [[nodiscard]] Vector3d contact_velocity(std::uint32_t node) const
    {
        if (const RigidBody* carrier = body_of(node)) return carrier->velocity_at(position[node]);
        return velocity[node] + scaled(impulse[node], inverse_mass[node]);
    }

    /// The body that carries a node, if one does.
    [[nodiscard]] const RigidBody* body_of(std::uint32_t node) const
    {
        return bodies.empty() || body[node] < 0 ? nullptr : &bodies[static_cast<std::size_t>(body[node])];
    }

    /// A contact's or load's impulse, which waits for the next accelerate. [N s]
    void push(std::uint32_t node, const Vector3d& given)
    {
        if (bodies.empty() || body[node] < 0)
            impulse[node] += given;
        else
            bodies[static_cast<std::size_t>(body[node])].push(position[node], given);
    }

    /// Adds nodes at rest at `places` [m], without mass and held by nothing; returns the index of the first.
    std::uint32_t add(const std::vector<Vector3d>& places);
};

}  // namespace corpuscle
