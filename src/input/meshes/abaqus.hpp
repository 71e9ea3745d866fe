#pragma once

#include "input/meshes/scanner.hpp"
#include "mesh/mesh.hpp"

namespace corpuscle {

/// Reads the mesh of an Abaqus input file: nodes, shells, membranes and rigid surfaces of 3 and 4 nodes, C3D4 and C3D8, what *NGEN, *NFILL,
/// *NCOPY, *ELGEN and *ELCOPY make of them, sets, surfaces as sets of nodes, parts and their instances put in place, included files.
/// Other keywords are passed over, and named in the mesh's remarks; beams, springs and point masses are counted there and kept as sets of
/// nodes. Sets of instances are also "instance.set". Names in the file may be in any case.
/// Errors: InputError with file and line for elements of other kinds and for what makes or moves nodes in other ways.
/// Format: Abaqus Keywords Reference Guide.
[[nodiscard]] Mesh read_abaqus(Scanner scanner);

}  // namespace corpuscle
