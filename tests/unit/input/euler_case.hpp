#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "input/case/read_case.hpp"
#include "input/presets.hpp"

namespace corpuscle {

/// A kilogram of TNT at the corner of a box, or at the foot of an axis, or in the center, with changes.
inline CaseDescription grid_case(const std::string& grid, const std::string& more = "", const std::vector<std::string>& settings = {})
{
    const std::string text = R"(title = "a charge in a grid"
end_time = "0.1 ms"
[[charge]]
explosive = "tnt"
shape = "sphere"
mass = "1 kg"
center = [0, 0, 0]
[euler]
fill = "air"
)" + grid + more;
    CaseDescription description = read_case_text(text, "grid.toml", settings);
    resolve_presets(description, {std::filesystem::path(CORPUSCLE_SOURCE_DIR) / "share"});
    return description;
}

inline const std::string octant_grid = R"(box = [[0, 0.4], [0, 0.4], [0, 0.4]]
cell_size = "20 mm"
edges = { x = ["rigid", "open"], y = ["rigid", "open"], z = ["rigid", "open"] }
)";
inline const std::string ring_grid = R"(symmetry = "axisymmetric"
box = [[0, 0.4], [0, 0.5]]
cell_size = "10 mm"
edges = { x = ["rigid", "open"], z = ["rigid", "open"] }
)";
inline const std::string shell_grid = R"(symmetry = "spherical"
box = [[0, 0.4]]
cells = [100]
)";

}  // namespace corpuscle
