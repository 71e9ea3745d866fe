#pragma once

#include "input/case/case_description.hpp"
#include "mesh/shape.hpp"

namespace corpuscle {

/// The shape a case gives in full. Errors: InputError at the shape's place (only a form, a size not above 0, a surface with a hole).
[[nodiscard]] Shape make_shape(const ShapeInput& input, const CaseDescription& description);

/// Refuses a charge of which a form is given, with too little or too much to give its size and place. Errors: InputError at the charge.
void check_form(const ChargeInput& charge);

/// The charge's shape: in full, or from form, center, mass or radius and the explosive's density. Errors: InputError at the charge's place
/// where too much or too little is given.
[[nodiscard]] Shape make_charge_shape(const ChargeInput& charge, const CaseDescription& description);

/// A file that the case names: as it is if its path is full, else beside the case.
[[nodiscard]] std::string file_beside(const std::string& file, const CaseDescription& description);

/// Reads a mesh file in its unit, at `place` for messages.
[[nodiscard]] Mesh mesh_from_file(const std::string& file, const std::string& unit, const CaseDescription& description, const Place& place);

}  // namespace corpuscle
