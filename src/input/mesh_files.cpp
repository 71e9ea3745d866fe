#include "input/mesh_files.hpp"

#include "input/shapes.hpp"

namespace corpuscle {

const Mesh& MeshFiles::read(const std::string& file, const std::string& unit, const Place& place)
{
    const std::pair<std::string, std::string> key{file, unit};
    const auto known = read_.find(key);
    if (known != read_.end()) return known->second;
    return read_.emplace(key, mesh_from_file(file, unit, description_, place)).first->second;
}

}  // namespace corpuscle
