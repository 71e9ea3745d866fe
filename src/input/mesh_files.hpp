#pragma once

#include <map>
#include <string>
#include <utility>

#include "input/case/case_description.hpp"
#include "mesh/mesh.hpp"

namespace corpuscle {

/// The mesh files that a case names, each read once however many parts are made of it.
class MeshFiles {
public:
    explicit MeshFiles(const CaseDescription& description) : description_(description) {}

    /// The mesh of a file in its unit. Errors: InputError, at `place` where the file itself is not to blame.
    [[nodiscard]] const Mesh& read(const std::string& file, const std::string& unit, const Place& place);

private:
    const CaseDescription& description_;
    std::map<std::pair<std::string, std::string>, Mesh> read_;  ///< by name and unit
};

}  // namespace corpuscle
