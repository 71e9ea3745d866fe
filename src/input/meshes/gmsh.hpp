#pragma once

#include "input/meshes/scanner.hpp"
#include "mesh/mesh.hpp"

namespace corpuscle {

/// Reads a gmsh file, version 2.2 or 4.1, text or binary (format: gmsh reference manual, "MSH file format"). Lengths as in the file.
[[nodiscard]] Mesh read_gmsh(Scanner scanner);

}  // namespace corpuscle
