#pragma once

#include "base/clock.hpp"
#include "gas/gas.hpp"

namespace corpuscle {

/// Lets the explosive burn that the detonation has reached at the step's start: its particles, at rest until then, move on with
/// the velocity and internal energy that the fill gave them. Returns what the explosive gave to the gas.
Passage burn(Gas& gas, const Clock& clock);

}  // namespace corpuscle
