#include "input/unlike_masses.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "gas/fill.hpp"

namespace corpuscle {

namespace {

/// "tnt 12000, air 3000": as many particles as there are, shared by mass.
std::string even_counts(const std::vector<Species>& species, const std::vector<double>& masses)
{
    double total = 0;
    for (std::size_t s = 0; s < species.size(); ++s) total += masses[s] / species[s].particle_mass;
    const std::vector<std::size_t> counts = share_particles(masses, static_cast<std::size_t>(std::llround(total)));
    std::string text;
    for (std::size_t s = 0; s < species.size(); ++s) text += fmt::format("{}{} {}", s ? ", " : "", species[s].name, counts[s]);
    return text;
}

}  // namespace

void warn_of_unlike_masses(const std::vector<Species>& species, const std::vector<double>& masses, std::vector<std::string>& warnings)
{
    if (species.empty()) return;
    const auto [light, heavy] = std::minmax_element(species.begin(), species.end(),
                                                    [](const Species& a, const Species& b) { return a.particle_mass < b.particle_mass; });
    const double ratio = heavy->particle_mass / light->particle_mass;
    if (!(ratio > harmless_mass_ratio)) return;
    warnings.push_back(fmt::format(
        "a particle of '{}' weighs {:.3g} times one of '{}': beyond {:g} fronts smear and the gases mix too deep; for equal masses "
        "give one total, or {}",
        heavy->name, ratio, light->name, harmless_mass_ratio, even_counts(species, masses)));
}

}  // namespace corpuscle
