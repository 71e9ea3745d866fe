#pragma once

#include <array>
#include <cstdint>
#include <filesystem>

#include "fields/field.hpp"
#include "math/vector3.hpp"
#include "output/vtk/vtk_file.hpp"

namespace corpuscle {

/// Points in rows along the axes.
struct ImageGrid {
    std::array<std::int64_t, 3> points{1, 1, 1};  ///< along x, y, z, each at least 1
    Vector3d origin;                              ///< lowest point [m]
    Vector3d spacing{1, 1, 1};                    ///< between neighbours [m]
};

/// The centres of a grid of nx * ny * nz box cells, to write cell averages: ParaView 5.11 misreads cell data of an image (it asks for as
/// many values as there are points), and values at centres can be contoured and interpolated as they are.
[[nodiscard]] ImageGrid cell_centers(const std::array<std::int64_t, 3>& cells, const Vector3d& lowest_corner, const Vector3d& cell_size);

/// Writes fields on the points of a regular grid as one VTKHDF file; values run with x fastest, then y, then z. Throws Error if a field's
/// count is not nx * ny * nz or the grid is empty.
void write_image(const std::filesystem::path& path, const ImageGrid& grid, const FieldSet& fields, const VtkOptions& options = {});

}  // namespace corpuscle
