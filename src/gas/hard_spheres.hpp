#pragma once

#include "base/clock.hpp"
#include "gas/gas.hpp"
#include "mesh/facet_tree.hpp"

namespace corpuscle {

/// Radius of a species' particles as hard spheres [m]. A Noble-Abel gas gets the packing at which spheres have its pressure at its
/// reference density; a gas without co-volume gets `packing` (share of the volume) at `density` [kg/m3].
/// Refuses by InputError what spheres cannot be: JWL, and co-volumes beyond `largest_packing`.
[[nodiscard]] double sphere_radius(const Species& species, double packing, double density);

/// Virial pressure of a species as the gas's rule of collision makes it [Pa], at its partial density [kg/m3] and kinetic pressure [Pa]:
/// that of its law, or of Carnahan and Starling for the packing of its spheres (held at freezing).
[[nodiscard]] double virial_pressure(const Gas& gas, std::size_t species, double density, double kinetic_pressure);

/// Lets the particles collide as hard spheres: pairs that touch in the step, found by a search of neighbours, bounce along their
/// line of centres, one after the other in the order of time, and share energy with their internal freedoms. A bounce within the
/// step leaves its particles where they would have had to start to come from it at its time.
/// Needs sorted particles with radii. Pairs with a facet or a face of the domain between them do not meet. Leaves moves that may
/// meet a facet in `gas.displaced`, and the stable step in `gas.step_limit`.
void collide_hard_spheres(Gas& gas, const Clock& clock, const FacetTree& walls);

/// Finds the stable step of sorted spheres without letting them collide.
void survey_hard_spheres(Gas& gas);

}  // namespace corpuscle
