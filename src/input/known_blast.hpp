#pragma once

#include <optional>

#include "input/case/case_description.hpp"
#include "model/records.hpp"

namespace corpuscle {

/// The case's charge as the curves of Kingery and Bulmash know it; nothing where they do not: more than one charge, a charge that is
/// neither a ball nor a hemisphere lying flat on a rigid face of the box, or gas around it that is not at the pressure of the open air
/// (101325 Pa, within 5 %). Another explosive counts as the TNT that releases as much energy (4.29 MJ/kg).
[[nodiscard]] std::optional<KnownBlast> known_blast(const CaseDescription& description);

}  // namespace corpuscle
