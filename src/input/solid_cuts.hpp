#pragma once

#include "input/build_gas.hpp"

namespace corpuscle {

/// Keeps gas out of where solid parts are: every fill is cut by each part's outer surface.
void cut_by_solids(GasPlan& plan, const CaseDescription& description);

}  // namespace corpuscle
