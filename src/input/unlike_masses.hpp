#pragma once

#include <string>
#include <vector>

#include "gas/gas.hpp"

namespace corpuscle {

/// Masses of particles further apart than this hurt: fronts smear, the heavy particles fly deep into the light gas (measured in
/// docs/validation.md, "Unlike particles").
inline constexpr double harmless_mass_ratio = 10;

/// Warns of gases whose particles weigh too unlike, with counts of the same total that would make them equal. `masses`: of each gas [kg].
void warn_of_unlike_masses(const std::vector<Species>& species, const std::vector<double>& masses, std::vector<std::string>& warnings);

}  // namespace corpuscle
