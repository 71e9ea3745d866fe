#pragma once

#include "structure/part_description.hpp"
#include "structure/structure.hpp"

namespace corpuscle {

/// Adds a part: nodes, elements, masses, holds, surface facets. Nodes of the mesh keep their order, so node i of the mesh is node
/// `part.first_node + i` of the structure. Throws InputError (naming part, element and remedy) for a mesh without elements, with
/// wrong indices, tangled or without area, elements of a shape the part cannot have, impossible thickness, points or material,
/// held nodes that do not exist, a second part of the same name, a rigid part that is not fully held.
/// The reference returned is good until the next part is added.
Part& add_part(Structure& structure, const PartDescription& description);

}  // namespace corpuscle
