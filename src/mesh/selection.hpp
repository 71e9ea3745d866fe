#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace corpuscle {

/// A plane normal to an axis, as `where = "x=0.5"` names it.
struct AxisPlane {
    int axis = 0;         ///< 0, 1, 2 for x, y, z
    double position = 0;  ///< [m]
};

/// Reads "x=0", "z = -0.0015" (in m), "y = -1.5 mm"; nothing if the text does not begin with an axis and "=".
/// Refuses (InputError) an axis followed by what is not a length.
[[nodiscard]] std::optional<AxisPlane> parse_plane(const std::string& where);

/// The nodes that `where` names, ascending: "all", a node set, an element set (the nodes of its elements), or a plane such as "x=0".
/// On a plane is what lies within 1e-6 of the mesh's diagonal. Refuses (InputError) unknown names, with the nearest known ones,
/// and planes without a node.
[[nodiscard]] std::vector<std::uint32_t> select_nodes(const Mesh& mesh, const std::string& where);

/// The node nearest to a point, the first of equals; refuses an empty mesh.
[[nodiscard]] std::uint32_t nearest_node(const Mesh& mesh, const Vector3d& point);

}  // namespace corpuscle
