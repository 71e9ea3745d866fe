#pragma once

#include <vector>

#include "../mesh/facet_tree_surfaces.hpp"
#include "contact/gas_structure.hpp"

namespace corpuscle {

/// Gas without particles in a domain of rigid faces, one species of the given particle mass [kg].
inline Gas empty_gas(const Box& box, double particle_mass, EquationOfState law = IdealGas{1.4})
{
    Gas gas;
    gas.domain.box = box;
    gas.species.push_back({"gas", law, particle_mass, internal_freedoms(heat_capacity_ratio(law))});
    return gas;
}

/// A particle of the first species [m, m/s].
inline Particle particle_at(const Vector3f& position, const Vector3f& velocity)
{
    return {position, 0, velocity, particle_tag::make(0)};
}

/// A structure of bare facets: nodes of the given mass [kg], at rest, free (held if the mass is 0).
inline Structure bare_structure(const Surface& surface, const std::vector<Vector3d>& places, double node_mass)
{
    Structure structure;
    structure.nodes.add(places);
    structure.surface = surface;
    for (std::size_t n = 0; n < places.size(); ++n) {
        structure.nodes.mass[n] = node_mass;
        if (node_mass > 0) structure.nodes.inverse_mass[n] = Vector3d{1, 1, 1} / node_mass;
    }
    return structure;
}

/// Moves bare nodes through a step of `duration` [s] by their velocities, which first take up the impulses.
inline void move_freely(Nodes& nodes, double duration)
{
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        nodes.velocity[n] += scaled(nodes.impulse[n], nodes.inverse_mass[n]);
        nodes.impulse[n] = {};
        nodes.previous[n] = nodes.position[n];
        nodes.position[n] += duration * nodes.velocity[n];
    }
}

/// Kinetic energy of bare nodes with the impulses that wait [J].
inline double kinetic_energy(const Nodes& nodes)
{
    double energy = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n)
        energy += 0.5 * nodes.mass[n] * norm_squared(nodes.contact_velocity(static_cast<std::uint32_t>(n)));
    return energy;
}

/// Momentum of bare nodes with the impulses that wait [kg m/s].
inline Vector3d momentum_of(const Nodes& nodes)
{
    Vector3d momentum;
    for (std::size_t n = 0; n < nodes.size(); ++n) momentum += nodes.mass[n] * nodes.contact_velocity(static_cast<std::uint32_t>(n));
    return momentum;
}

}  // namespace corpuscle
