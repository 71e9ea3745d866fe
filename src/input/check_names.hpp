#pragma once

#include "input/case/case_description.hpp"

namespace corpuscle {

/// What the parts of a case mean together, as far as words go: names used twice, loads and gauges on parts there are none of, charges
/// without gas, nothing to simulate. Throws InputError or InputProblems with all of it.
void check_names(const CaseDescription& description);

}  // namespace corpuscle
