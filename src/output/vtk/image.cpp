#include "output/vtk/image.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace corpuscle {

ImageGrid cell_centers(const std::array<std::int64_t, 3>& cells, const Vector3d& lowest_corner, const Vector3d& cell_size)
{
    return {cells, lowest_corner + 0.5 * cell_size, cell_size};
}

void write_image(const std::filesystem::path& path, const ImageGrid& grid, const FieldSet& fields, const VtkOptions& options)
{
    const auto& [nx, ny, nz] = grid.points;
    const Vector3d& spacing = grid.spacing;
    if (nx < 1 || ny < 1 || nz < 1 || !(spacing.x > 0) || !(spacing.y > 0) || !(spacing.z > 0)) {
        throw Error(fmt::format("a regular grid of {} x {} x {} points {}, {} and {} m apart cannot be written", nx, ny, nz, spacing.x,
                                spacing.y, spacing.z));
    }
    Hdf5File file = begin_vtk_file(path, "ImageData");
    file.set_attribute("/VTKHDF", "WholeExtent", std::vector<std::int64_t>{0, nx - 1, 0, ny - 1, 0, nz - 1});
    file.set_attribute("/VTKHDF", "Origin", std::vector<double>{grid.origin.x, grid.origin.y, grid.origin.z});
    file.set_attribute("/VTKHDF", "Spacing", std::vector<double>{spacing.x, spacing.y, spacing.z});
    file.set_attribute("/VTKHDF", "Direction", std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1});
    const std::vector<std::uint64_t> slowest_first{static_cast<std::uint64_t>(nz), static_cast<std::uint64_t>(ny),
                                                   static_cast<std::uint64_t>(nx)};
    write_fields(file, "PointData", fields, slowest_first, options.gzip);
    file.close();
}

}  // namespace corpuscle
