#pragma once

#include "base/clock.hpp"
#include "gas/gas.hpp"
#include "mesh/facet_tree.hpp"

namespace corpuscle {

/// Lets ambient gas in through the `ambient` faces: the flux n sigma/sqrt(2 pi) of a Maxwellian at rest (Bird 1994, chapter 4),
/// each particle entering at a random instant of the step. Newcomers stand behind the sorted particles until the next sort.
void flow_in(Gas& gas, const Clock& clock, const FacetTree* walls);

}  // namespace corpuscle
