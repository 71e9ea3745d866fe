#pragma once

#include "input/meshes/scanner.hpp"
#include "mesh/mesh.hpp"

namespace corpuscle {

/// Reads the mesh of an LS-DYNA deck: nodes, shells of 3 and 4 nodes, solids of 8 (tetrahedra as those whose nodes come again), parts, sets
/// of nodes, parts, shells, solids and segments, parameters, included files, also transformed ones; standard, long (+), ten-column (%) and
/// comma-separated fields. A part is the element set "part_7" by its number and its title; a set is "node_set_7", "part_set_7",
/// "shell_set_7", "solid_set_7" or "segment_set_7" and its title. Beams, springs and masses are counted and kept as sets of nodes. Other
/// keywords are passed over. The mesh's remarks name all that is left out.
/// Errors: InputError with file and line for elements of other kinds, and for what moves or joins nodes in ways that are not read.
/// Format: LS-DYNA Keyword User's Manual, volume I.
[[nodiscard]] Mesh read_dyna_mesh(Scanner scanner);

}  // namespace corpuscle
