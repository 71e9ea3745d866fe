#pragma once

#include <variant>

#include "laws/strength/bilinear_plastic.hpp"
#include "laws/strength/elastic.hpp"

namespace corpuscle {

/// The list of strength laws: picked once per part, outside the loop over its elements.
using Strength = std::variant<Elastic, BilinearPlastic>;

}  // namespace corpuscle
