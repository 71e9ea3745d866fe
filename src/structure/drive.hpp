#pragma once

#include <cstdint>
#include <vector>

#include "base/clock.hpp"
#include "fields/transfer.hpp"
#include "laws/load/time_curve.hpp"
#include "structure/nodes.hpp"

namespace corpuscle {

/// What a curve of a prescribed motion gives.
enum class DriveKind { displacement, velocity, acceleration };

/// Nodes, or a rigid body, whose motion along an axis is prescribed.
struct Drive {
    std::vector<std::uint32_t> nodes;  ///< of the structure; none if a body is driven
    std::int32_t body = -1;
    int axis = 0;
    DriveKind kind = DriveKind::velocity;
    TimeCurve curve;            ///< [m], [m/s] or [m/s2]
    double start_velocity = 0;  ///< where the acceleration is given [m/s]

    /// How fast it goes at the start. [m/s]
    [[nodiscard]] double start() const;

    /// How far it goes between two times, exactly as the curve says. [m]
    [[nodiscard]] double way(double from, double to) const;
};

/// What driving has done in a step.
struct Driven {
    Transfer given{"prescribed motion", "structure", 0, {}, 0};
    Vector3d reaction;      ///< what of forces and impulses the drives answered, so not the supports [N s]
    double force_work = 0;  ///< what nodal forces did while the velocity changed, beyond what they do at its end [J]
};

/// Sets the velocities of driven nodes and bodies for the step, so that they go exactly where their curves say. The driving impulse is what
/// the change of momentum needs beyond internal forces (over `force_time` [s]) and impulses, its work what the change of kinetic energy
/// needs beyond theirs: the books close to round-off.
[[nodiscard]] Driven drive(Nodes& nodes, const std::vector<Drive>& drives, double force_time, const Clock& clock);

}  // namespace corpuscle
