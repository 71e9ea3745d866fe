#pragma once

#include "base/clock.hpp"
#include "gas/gas.hpp"
#include "mesh/facet_tree.hpp"

namespace corpuscle {

/// Lets gas collide with gas: pairs within a cell, chosen without a time counter, scattered isotropically, exchanging internal
/// energy, and displaced so that the virial pressure of their law arises. Pairs with a facet between them do not meet.
/// Needs sorted particles. Leaves displacements that may meet a facet in `gas.displaced`, and the stable step in `gas.step_limit`.
void collide(Gas& gas, const Clock& clock, const FacetTree& walls);

/// Finds the stable step of the sorted gas without letting it collide; for the start of a run.
void survey(Gas& gas);

/// Largest stable step at the given time [s]: of what was last surveyed, and of explosive that may burn in it.
[[nodiscard]] double stable_step(const Gas& gas, double time);

}  // namespace corpuscle
