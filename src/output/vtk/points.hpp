#pragma once

#include <filesystem>

#include "fields/field.hpp"
#include "output/vtk/vtk_file.hpp"

namespace corpuscle {

/// Writes a cloud of points (particles, grains) as one VTKHDF file: `positions` [m] is a field of 3 components, float32 or float64;
/// `fields` are on the same points (one named like `positions` is not written twice). An empty cloud is legal. Throws Error.
void write_points(const std::filesystem::path& path, const Field& positions, const FieldSet& fields, const VtkOptions& options = {});

}  // namespace corpuscle
