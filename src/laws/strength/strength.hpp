#pragma once

#include <variant>

#include "laws/strength/bilinear_plastic.hpp"
#include "laws/strength/curve_plastic.hpp"
#include "laws/strength/elastic.hpp"
#include "laws/strength/fabric.hpp"
#include "laws/strength/hydro_plastic.hpp"
#include "laws/strength/johnson_cook.hpp"

namespace corpuscle {

/// The list of strength laws: picked once per part, outside the loop over its elements.
using Strength = std::variant<Elastic, BilinearPlastic, CurvePlastic, JohnsonCook, HydroPlastic, Fabric>;

}  // namespace corpuscle
