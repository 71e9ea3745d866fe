#pragma once

#include "gas/gas.hpp"

namespace corpuscle {

/// Mass, momentum and energy of a particle in flight.
[[nodiscard]] inline Passage carried(const Gas& gas, const Particle& particle)
{
    const double mass = gas.species[particle_tag::species(particle.tag)].particle_mass;
    const Vector3d velocity(particle.velocity);
    return {mass, mass * velocity, 0.5 * mass * norm_squared(velocity) + static_cast<double>(particle.energy)};
}

/// Meets the face of the domain that it has come to: a rigid face turns its velocity (impulse to the face), any other lets the
/// particle go. Adds what passed to `passages`; says whether the particle stays. Its position is the caller's.
inline bool meet_face(const Gas& gas, Particle& particle, int face, FacePassages& passages)
{
    if (gas.domain.edges[face] != Edge::rigid) {
        passages.face[face] += carried(gas, particle);
        particle.tag |= particle_tag::gone;
        return false;
    }
    const int axis = face / 2;
    const double mass = gas.species[particle_tag::species(particle.tag)].particle_mass;
    Passage bounce;
    bounce.momentum[axis] = 2 * mass * static_cast<double>(particle.velocity[axis]);
    particle.velocity[axis] = -particle.velocity[axis];
    passages.face[face] += bounce;
    passages.squares[face] += bounce.momentum[axis] * bounce.momentum[axis];
    return true;
}

/// Turns a particle that has moved beyond rigid faces back into its mirror image; leaves it where it is beyond others.
inline void mirror_at_rigid_faces(const Gas& gas, Particle& particle, FacePassages& passages)
{
    const Box& box = gas.domain.box;
    for (int axis = 0; axis < 3; ++axis) {
        for (int bounce = 0; bounce < 4; ++bounce) {
            const double place = static_cast<double>(particle.position[axis]);
            const bool below = place < box.lower[axis];
            if (!below && !(place > box.upper[axis])) break;
            const int face = 2 * axis + (below ? 0 : 1);
            if (gas.domain.edges[face] != Edge::rigid) break;
            meet_face(gas, particle, face, passages);
            particle.position[axis] = static_cast<float>(2 * (below ? box.lower[axis] : box.upper[axis]) - place);
        }
    }
}

/// Brings a particle that has moved out of the domain back at the rigid faces it crossed, or lets it go at any other.
inline void keep_in_domain(const Gas& gas, Particle& particle, FacePassages& passages)
{
    const Vector3d place(particle.position);
    if (gas.domain.box.contains(place)) return;
    mirror_at_rigid_faces(gas, particle, passages);
    const Domain::Exit exit = gas.domain.first_exit(place, Vector3d(particle.position));
    if (exit.face >= 0) meet_face(gas, particle, exit.face, passages);
}

}  // namespace corpuscle
