#pragma once

#include "structure/part_description.hpp"
#include "structure/rigid_body.hpp"

namespace corpuscle {

/// Whether a rigid part has anything that makes it heavy: a mass, or a density and, of surfaces, a thickness.
[[nodiscard]] bool has_weight(const PartDescription& d);

/// The body of a rigid part: mass, center and inertia of its elements (each read at points that are exact for straight-edged ones) and of
/// its point masses, or as given. Which directions are free follows from the holds: of all nodes, or of those in a plane of symmetry,
/// beyond which lies the body's other half (mass and inertia are then those of the half that is there, about the center of the whole).
/// Throws InputError for a part without mass, or with some nodes held and others not.
[[nodiscard]] RigidBody make_rigid_body(const PartDescription& d);

}  // namespace corpuscle
