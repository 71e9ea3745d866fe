#pragma once

#include <string>
#include <vector>

#include "input/case/case_description.hpp"
#include "structure/part_description.hpp"
#include "structure/structure.hpp"

namespace corpuscle {

/// Warns of what a part says without effect, and of values no one is likely to mean: a unit forgotten, a support left out, a limit that is
/// never or at once reached. `structure` holds the part as its last, built from `built`.
void warn_of_doubts(const PartInput& input, const PartDescription& built, const Structure& structure, std::vector<std::string>& warnings);

/// Warns of parts that lie wholly outside the box of the gas, which cannot meet it.
void warn_of_parts_outside(const CaseDescription& description, const Structure& structure, std::vector<std::string>& warnings);

}  // namespace corpuscle
