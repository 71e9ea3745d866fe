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
    return true;
}

/// Brings a particle that has moved out of the domain back as its mirror image in the rigid faces it crossed, or lets it go.
inline void keep_in_domain(const Gas& gas, Particle& particle, FacePassages& passages)
{
    const Box& box = gas.domain.box;
    for (int axis = 0; axis < 3; ++axis) {
        for (int bounce = 0; bounce < 4; ++bounce) {
            const double place = static_cast<double>(particle.position[axis]);
            const bool below = place < box.lower[axis];
            if (!below && !(place > box.upper[axis])) break;
            if (!meet_face(gas, particle, 2 * axis + (below ? 0 : 1), passages)) return;
            particle.position[axis] = static_cast<float>(2 * (below ? box.lower[axis] : box.upper[axis]) - place);
        }
    }
}

}  // namespace corpuscle
