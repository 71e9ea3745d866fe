#pragma once

#include "input/meshes/scanner.hpp"
#include "mesh/mesh.hpp"

namespace corpuscle {

/// Reads the mesh of an LS-DYNA deck: nodes, shells of 3 and 4 nodes, solids of 8 (tetrahedra as those whose nodes come again), parts, sets
/// of nodes, parts, shells, solids and segments, included files; standard, long (+) and comma-separated fields. A part is the element set
/// "part_7" by its number and its title; sets without a title are "node_set_7", "part_set_7", "shell_set_7", "solid_set_7",
/// "segment_set_7". Other keywords are passed over, and named in the mesh's remarks.
/// Errors: InputError with file and line for elements of other kinds, parameters, transformed includes.
/// Format: LS-DYNA Keyword User's Manual, volume I.
[[nodiscard]] Mesh read_dyna_mesh(Scanner scanner);

}  // namespace corpuscle
