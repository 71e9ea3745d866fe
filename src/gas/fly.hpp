#pragma once

#include "base/clock.hpp"
#include "gas/gas.hpp"
#include "mesh/facet_tree.hpp"

namespace corpuscle {

/// Moves every particle to the end of the step, through the faces of the domain; lets ambient gas flow in. Particles that may
/// meet a facet in this step are not moved but listed in `gas.pending`, for the contact that knows the facets.
void fly(Gas& gas, const Clock& clock, const FacetTree& walls);

}  // namespace corpuscle
