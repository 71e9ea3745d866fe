#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace corpuscle {

/// An edge of a surface mesh, its lower node first, and one use of it.
struct SurfaceEdge {
    std::uint32_t low = 0, high = 0;  ///< nodes
    std::uint32_t element = 0;        ///< that uses it
    bool forward = true;              ///< the element runs from low to high
};

/// Every edge of every triangle and quadrilateral, sorted by (low, high, element): uses of one edge stand together. Solids have none.
[[nodiscard]] std::vector<SurfaceEdge> surface_edges(const Mesh& mesh);

/// The open edges (used by one element only) of a surface, chained: each inner vector is the nodes along one loop, the first not repeated.
/// Empty for a surface without holes.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> boundary_loops(const Mesh& mesh);

/// Refuses (InputError naming the mesh and a place) a surface with holes, with an edge that more than two elements share, or of solids.
void require_closed(const Mesh& mesh, const std::string& name);

/// Makes the normals of a closed surface consistent: outward, and into the hollow for surfaces inside others. Returns how many elements
/// were turned. Refuses what require_closed refuses, and surfaces with one side only. Separate surfaces must not cut each other.
std::size_t orient_closed(Mesh& mesh, const std::string& name);

}  // namespace corpuscle
