#pragma once

#include <string>

#include "gas/domain.hpp"
#include "input/case/gas_input.hpp"
#include "mesh/shape.hpp"

// What the gas of particles and the gases on a grid ask of a charge and a box.

namespace corpuscle {

/// Refuses ranges of a box that do not ascend, at its place.
void check_ascends(double lower, double upper, const std::string& axis, const Place& place);

/// Refuses a charge that is not in the box, or that an edge other than a rigid one cuts. `owner` of the box: "[gas]".
void check_within(const Shape& shape, const Domain& domain, const ChargeInput& charge, const std::string& owner);

}  // namespace corpuscle
