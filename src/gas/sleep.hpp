#pragma once

#include "base/clock.hpp"
#include "gas/gas.hpp"
#include "mesh/facet_tree.hpp"

namespace corpuscle {

/// Puts the ambient gas that `gas.sleeping.disturbances` do not reach to sleep; for the start of a run, before the first sort. Gas of hard
/// spheres, and gas without surroundings, stays awake.
void lay_to_sleep(Gas& gas, const FacetTree& walls);

/// Lets each disturbance spread to where it was seen and a margin beyond, and at least by what the weakest that would be seen travels in
/// the step; wakes what it reaches, and lets what sleeps on press on the domain's faces. Before the sort.
void wake(Gas& gas, const Clock& clock);

/// Where a disturbance in the gas was seen: `energy` is the kinetic energy density there, motion of the whole included [J/m3]. Raises
/// `found`, an entry for each disturbance, for the nearest.
void note_disturbance(const Gas& gas, const Vector3d& place, double energy, std::vector<double>& found);

/// Turns a particle that has come into a zone asleep back as a plane of symmetry would. Returns the impulse on the zone's face [N s].
Vector3d turn_back(const Gas& gas, Particle& particle);

/// Adds what a restart needs to know of the gas asleep, behind the fields of the particles.
void add_sleep_state(FieldSet& set, Gas& gas);

}  // namespace corpuscle
