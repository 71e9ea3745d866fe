#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace corpuscle {

using Triangle = std::array<std::uint32_t, 3>;

/// Adds the element's triangles (a quadrilateral has two, cut from its first to its third corner); solids add none.
void append_triangles(const MeshElement& element, std::vector<Triangle>& triangles);

/// All triangles of a surface mesh, in the order of its elements.
[[nodiscard]] std::vector<Triangle> triangles_of(const Mesh& mesh);

/// Volume that closed triangles enclose, positive for outward normals. [m3]
[[nodiscard]] double signed_volume(std::span<const Vector3d> nodes, std::span<const Triangle> triangles);

/// How often closed triangles wind around a point: the sum of their solid angles over 4 pi (angle after Van Oosterom and Strackee 1983).
/// 1 inside outward triangles, 0 outside; cost grows with the number of triangles.
[[nodiscard]] double winding_number(std::span<const Vector3d> nodes, std::span<const Triangle> triangles, const Vector3d& point);

}  // namespace corpuscle
