#pragma once

#include <vector>

#include "fields/field.hpp"
#include "mesh/mesh.hpp"
#include "structure/structure.hpp"

namespace corpuscle {

/// Shown at nodes: displacement, velocity, angular_velocity, force. The structure must outlive the set.
[[nodiscard]] FieldSet node_fields(Structure& structure);

/// Shown on elements, in their order over all parts: stresses, plastic strain, thickness, energies, part.
[[nodiscard]] FieldSet element_fields(Structure& structure);

/// All that a restart needs on a structure built from the same input. Fields differ in their counts.
[[nodiscard]] FieldSet state(Structure& structure);

/// The elements over all parts as a mesh's, with the structure's node numbers: what a writer draws.
[[nodiscard]] std::vector<MeshElement> cells(const Structure& structure);

}  // namespace corpuscle
