#pragma once

#include <string>
#include <vector>

#include "input/case/case_description.hpp"
#include "structure/structure.hpp"

namespace corpuscle {

/// The mesh of a part, in its place. A ring whose inner radius is a disk's in the same case is made flush with it.
[[nodiscard]] Mesh make_mesh(const PartInput& part, const CaseDescription& description);

/// Builds all parts. Remarks on doubtful meshes are added to `warnings`. Errors: InputError at the part's place.
[[nodiscard]] Structure build_structure(const CaseDescription& description, std::vector<std::string>& warnings);

}  // namespace corpuscle
