#pragma once

#include <string>

#include "fields/field.hpp"
#include "output/hdf5.hpp"

namespace corpuscle {

/// Choices of a file for ParaView.
struct VtkOptions {
    int gzip = 0;  ///< 0 as it is (fast), 1..9 compressed
};

/// Starts a VTKHDF 1.0 file ("UnstructuredGrid" or "ImageData"): what ParaView 5.11 and every newer one reads.
[[nodiscard]] Hdf5File begin_vtk_file(const std::filesystem::path& path, const std::string& type);

/// A name that ParaView and HDF5 both take: '/' and '.' have a meaning there and become '_'.
[[nodiscard]] std::string vtk_name(const std::string& name);

/// Writes every field of the set into /VTKHDF/<group> ("PointData" or "CellData"), each with the leading extents of `extents` (the
/// product is the number of things). Throws Error if a field counts another number of things.
void write_fields(Hdf5File& file, const std::string& group, const FieldSet& set, const std::vector<std::uint64_t>& extents, int gzip);

}  // namespace corpuscle
