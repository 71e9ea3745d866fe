#include "output/vtk/vtk_file.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace corpuscle {

Hdf5File begin_vtk_file(const std::filesystem::path& path, const std::string& type)
{
    Hdf5File file = Hdf5File::create(path);
    file.add_group("/VTKHDF");
    file.set_attribute("/VTKHDF", "Version", std::vector<std::int64_t>{1, 0});
    file.set_attribute("/VTKHDF", "Type", type);
    file.add_group("/VTKHDF/PointData");
    file.add_group("/VTKHDF/CellData");
    return file;
}

std::string vtk_name(const std::string& name)
{
    std::string clean = name;
    for (char& letter : clean) {
        if (letter == '/' || letter == '.') letter = '_';
    }
    return clean;
}

void write_fields(Hdf5File& file, const std::string& group, const FieldSet& set, const std::vector<std::uint64_t>& extents, int gzip)
{
    const std::uint64_t count = Hdf5Shape{Hdf5Type::uint8, extents}.value_count();
    for (const Field& field : set.fields) {
        if (field.count != count) {
            throw Error(fmt::format("field '{}' of '{}' has {} values for {} things", field.name, set.name, field.count, count));
        }
        Hdf5Shape shape{hdf5_type(field.scalar), extents};
        if (field.components > 1) shape.extents.push_back(static_cast<std::uint64_t>(field.components));
        file.write("/VTKHDF/" + group + "/" + vtk_name(field.name), field, shape, gzip);
    }
}

}  // namespace corpuscle
