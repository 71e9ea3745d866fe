#pragma once

#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace corpuscle {

/// How good the elements of a mesh are; of an empty mesh all zero.
struct MeshQuality {
    std::size_t elements = 0;
    double min_edge = 0;              ///< shortest edge [m]
    double max_edge = 0;              ///< longest edge [m]
    double worst_aspect = 0;          ///< longest over shortest edge of an element
    std::size_t longest_element = 0;  ///< index of the element of that aspect
    double worst_warp = 0;            ///< angle between the two triangles of a four-cornered face [rad]
    std::size_t warped_element = 0;   ///< index of an element of that warp
    double min_scaled_jacobian = 0;   ///< 1: square, equilateral or regular; 0: flat; below 0: tangled
    std::size_t worst_element = 0;    ///< index of the element of the smallest scaled Jacobian
};

/// Measures all elements. Scaled Jacobian after Knupp 2000: the smallest, over the corners, of the determinant of the edges there over the
/// product of their lengths (of the longest such product for triangles and tetrahedra), 1 for the regular element.
[[nodiscard]] MeshQuality check(const Mesh& mesh);

/// How people know an element: by its number in the file, else counted from 1.
[[nodiscard]] std::int64_t element_number(const Mesh& mesh, std::size_t element);

/// Scaled Jacobian of one element.
[[nodiscard]] double scaled_jacobian(const Mesh& mesh, const MeshElement& element);

/// Refuses (InputError naming mesh, element and place) a mesh that has no elements, positions that are not numbers, nodes or sets out of
/// range, collapsed, flat, tangled or duplicate elements. Returns warnings: unused nodes; poor, warped or slender elements, by their
/// numbers.
std::vector<std::string> validate(const Mesh& mesh, const std::string& name);

}  // namespace corpuscle
