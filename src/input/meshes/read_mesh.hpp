#pragma once

#include <string>

#include "mesh/mesh.hpp"

namespace corpuscle {

/// Reads a mesh file: gmsh .msh (2.2 and 4.1, text and binary), Abaqus .inp, LS-DYNA .k or STL (text and binary), told apart by content.
/// `unit_in_metre` is the length of the file's unit [m]; the mesh is in m.
/// Of gmsh's elements only those of the highest dimension are kept; physical groups of every dimension become node sets, those of the
/// kept elements element sets as well; a group without a name is "surface_3" (or point, curve, volume) by its number.
/// Nodes without an element are dropped; STL corners that coincide become one node.
/// Errors: InputError naming file and line, or the byte in a binary file.
[[nodiscard]] Mesh read_mesh(const std::string& file, double unit_in_metre = 1.0);

}  // namespace corpuscle
