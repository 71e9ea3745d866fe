#pragma once

#include "input/meshes/scanner.hpp"
#include "mesh/mesh.hpp"

namespace corpuscle {

/// Whether the bytes are an STL file, text or binary.
[[nodiscard]] bool looks_like_stl(const Scanner& scanner);

/// Reads an STL file, text or binary. Corners closer than 1e-7 of the body become one node; triangles that lose their area so are dropped.
/// The solids of a text file become element sets. Lengths as in the file.
[[nodiscard]] Mesh read_stl(Scanner scanner);

}  // namespace corpuscle
