#pragma once

#include "input/case/preset_values.hpp"
#include "laws/strength/material.hpp"

namespace corpuscle {

/// The material of preset values. Errors: InputError at the values' place.
[[nodiscard]] Material make_material(const MaterialValues& values);

}  // namespace corpuscle
