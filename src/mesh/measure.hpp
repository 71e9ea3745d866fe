#pragma once

#include <string>

#include "math/box.hpp"
#include "mesh/mesh.hpp"

namespace corpuscle {

/// Smallest axis-parallel box around the nodes; empty for a mesh without nodes. [m]
[[nodiscard]] Box bounds(const Mesh& mesh);

/// Diagonal of the mesh's bounds, the length that tolerances are measured by; 0 without nodes. [m]
[[nodiscard]] double diagonal(const Mesh& mesh);

/// Mean of the element's corners. [m]
[[nodiscard]] Vector3d center(const Mesh& mesh, const MeshElement& element);

/// Half the cross product of the diagonals (or of two edges of a triangle): along the normal, as long as the area is large. [m2]
/// Zero for solid elements.
[[nodiscard]] Vector3d area_vector(const Mesh& mesh, const MeshElement& element);

/// Sum of the areas of triangles and quadrilaterals. [m2]
[[nodiscard]] double total_area(const Mesh& mesh);

/// "element 17 near (0.1, 0, 0.2) m": how errors name a place in a mesh; by the element's number in its file, else counted from 1.
[[nodiscard]] std::string element_place(const Mesh& mesh, std::size_t element);

/// "(0.1, 0, 0.2) m": how errors name a point.
[[nodiscard]] std::string point_text(const Vector3d& point);

}  // namespace corpuscle
