#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "input/meshes/scanner.hpp"
#include "mesh/mesh.hpp"

namespace corpuscle {

/// What gmsh calls an element type.
struct GmshType {
    int dimension = 0;
    int nodes = 0;
    ElementShape shape = ElementShape::triangle;  ///< for dimensions 2 and 3
};

/// The type of a number in a gmsh file; refuses, by name, those of higher order and other shapes.
[[nodiscard]] GmshType gmsh_type(const Scanner& scanner, std::int64_t number);

/// What the sections of a gmsh file add to, of either version: nodes and elements by the numbers the file gives them.
class GmshContent {
public:
    using Group = std::pair<int, std::int64_t>;  ///< dimension and number of a physical group

    void name_group(const Group& group, std::string name) { names_[group] = std::move(name); }
    void add_node(const Scanner& scanner, std::int64_t tag, const Vector3d& position);
    /// `number` is the file's of the element, `tags` of its nodes; an element that comes again for a further group is kept once.
    void add_element(const Scanner& scanner, const GmshType& type, std::int64_t number, const std::vector<std::int64_t>& groups,
                     const std::array<std::int64_t, 8>& tags);
    [[nodiscard]] bool has_nodes() const { return !nodes_.empty(); }

    /// The mesh of the elements of the highest dimension; physical groups as sets.
    [[nodiscard]] Mesh mesh(const Scanner& scanner) const;

private:
    struct Element {
        GmshType type;
        std::array<std::uint32_t, 8> node{};
        std::vector<std::int64_t> groups;
        std::int64_t number = 0;
    };

    [[nodiscard]] std::string name_of(const Group& group) const;

    std::vector<Vector3d> nodes_;
    std::unordered_map<std::int64_t, std::uint32_t> index_of_;
    std::vector<Element> elements_;
    std::map<std::array<std::uint32_t, 8>, std::size_t> grouped_;  ///< elements that came with a group, by type and nodes
    std::map<Group, std::string> names_;
};

/// The sections $Nodes and $Elements of version 2.2, and $Entities, $Nodes, $Elements of 4.1, text or binary.
void read_gmsh_2(Scanner& scanner, bool binary, GmshContent& content);
void read_gmsh_4(Scanner& scanner, bool binary, GmshContent& content);

/// Reads `$PhysicalNames`, whose heading has been read; text in every flavour.
void read_physical_names(Scanner& scanner, GmshContent& content);

/// The name of the next section, after its "$"; empty at the end of the file.
[[nodiscard]] std::string next_section(Scanner& scanner);

}  // namespace corpuscle
