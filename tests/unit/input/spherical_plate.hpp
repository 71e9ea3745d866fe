#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "input/case/read_case.hpp"
#include "input/presets.hpp"

namespace corpuscle {

/// The example of the plate with a spherical start, and changes.
inline CaseDescription spherical_plate(std::vector<std::string> settings = {})
{
    const std::filesystem::path source = CORPUSCLE_SOURCE_DIR;
    settings.insert(settings.begin(), {"gas.particles=20_000", "gas.start=\"spherical\""});
    CaseDescription description = read_case(source / "examples/01_plate/case.toml", settings);
    resolve_presets(description, {source / "share"});
    return description;
}

}  // namespace corpuscle
