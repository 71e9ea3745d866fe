#include "input/meshes/gmsh_content.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "mesh/transform.hpp"

namespace corpuscle {

namespace {

constexpr const char* first_order =
    "mesh with first-order triangles, quadrilaterals, tetrahedra or hexahedra (in gmsh: gmsh -order 1, or Mesh.ElementOrder = 1)";

/// Names of gmsh's element types that are refused, by number.
const char* refused_type(std::int64_t number)
{
    switch (number) {
        case 6: return "6-node prism";
        case 7: return "5-node pyramid";
        case 8: return "3-node line (second order)";
        case 9: return "6-node triangle (second order)";
        case 10: return "9-node quadrilateral (second order)";
        case 11: return "10-node tetrahedron (second order)";
        case 12: return "27-node hexahedron (second order)";
        case 13: return "18-node prism (second order)";
        case 14: return "14-node pyramid (second order)";
        case 16: return "8-node quadrilateral (second order)";
        case 17: return "20-node hexahedron (second order)";
        case 18: return "15-node prism (second order)";
        case 19: return "13-node pyramid (second order)";
        case 20: return "9-node triangle (third order)";
        case 21: return "10-node triangle (third order)";
        case 26: return "4-node line (third order)";
        case 29: return "20-node tetrahedron (third order)";
        case 36: return "16-node quadrilateral (third order)";
        default: return number > 0 && number < 140 ? "type of high order or unusual shape" : "type that gmsh does not have";
    }
}

void add_unique_sorted(std::vector<std::int64_t>& groups, const std::vector<std::int64_t>& more)
{
    groups.insert(groups.end(), more.begin(), more.end());
    std::sort(groups.begin(), groups.end());
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
}

}  // namespace

GmshType gmsh_type(const Scanner& scanner, std::int64_t number)
{
    switch (number) {
        case 1: return {1, 2};
        case 2: return {2, 3, ElementShape::triangle};
        case 3: return {2, 4, ElementShape::quadrilateral};
        case 4: return {3, 4, ElementShape::tetrahedron};
        case 5: return {3, 8, ElementShape::hexahedron};
        case 15: return {0, 1};
        default: scanner.fail(fmt::format("element type {}: {} is not supported", number, refused_type(number)), first_order);
    }
}

void GmshContent::add_node(const Scanner& scanner, std::int64_t tag, const Vector3d& position)
{
    if (!std::isfinite(norm_squared(position)))
        scanner.fail(fmt::format("the position of node {} is not finite", tag), "save the whole mesh again");
    if (!index_of_.emplace(tag, static_cast<std::uint32_t>(nodes_.size())).second)
        scanner.fail(fmt::format("node {} is given twice", tag), "number the nodes anew (in gmsh: Mesh > Renumber) and save again");
    nodes_.push_back(position);
}

void GmshContent::add_element(const Scanner& scanner, const GmshType& type, std::int64_t number, const std::vector<std::int64_t>& groups,
                              const std::array<std::int64_t, 8>& tags)
{
    Element element{type, {}, {}, number};
    add_unique_sorted(element.groups, groups);
    for (int i = 0; i < type.nodes; ++i) {
        const auto found = index_of_.find(tags[i]);
        if (found == index_of_.end())
            scanner.fail(fmt::format("an element uses node {}, which the file does not have", tags[i]), "save the whole mesh again");
        element.node[i] = found->second;
    }
    if (!element.groups.empty()) {
        std::array<std::uint32_t, 8> key;
        key.fill(std::numeric_limits<std::uint32_t>::max());
        std::copy_n(element.node.begin(), type.nodes, key.begin());
        if (type.dimension == 3 && type.nodes == 4) key[7] = 3;  // a tetrahedron is not the quadrilateral on its nodes
        const auto [known, fresh] = grouped_.emplace(key, elements_.size());
        auto& before = fresh ? element.groups : elements_[known->second].groups;
        if (!fresh && !std::includes(before.begin(), before.end(), element.groups.begin(), element.groups.end()))
            return add_unique_sorted(before, element.groups);
    }
    elements_.push_back(std::move(element));
}

std::string GmshContent::name_of(const Group& group) const
{
    const auto named = names_.find(group);
    if (named != names_.end()) return named->second;
    static constexpr std::array<const char*, 4> kinds{"point", "curve", "surface", "volume"};
    return fmt::format("{}_{}", kinds[std::clamp(group.first, 0, 3)], group.second);
}

Mesh GmshContent::mesh(const Scanner& scanner) const
{
    int highest = 0;
    for (const Element& element : elements_) highest = std::max(highest, element.type.dimension);
    if (highest < 2)
        scanner.fail("the mesh has no triangles, quadrilaterals, tetrahedra or hexahedra",
                     "mesh surfaces or volumes, and put them into a physical group or save all (in gmsh: Mesh.SaveAll = 1)");
    Mesh mesh;
    mesh.nodes = nodes_;
    for (const Element& element : elements_) {
        const bool kept = element.type.dimension == highest;
        for (const std::int64_t group : element.groups) {
            const std::string name = name_of({element.type.dimension, group});
            auto& set = mesh.node_sets[name];
            set.insert(set.end(), element.node.begin(), element.node.begin() + element.type.nodes);
            if (kept) mesh.element_sets[name].push_back(static_cast<std::uint32_t>(mesh.elements.size()));
        }
        if (kept) mesh.elements.push_back({element.type.shape, element.node, element.number});
    }
    remove_unused_nodes(mesh);
    return mesh;
}

void read_physical_names(Scanner& scanner, GmshContent& content)
{
    const std::size_t count = scanner.count(scanner.integer("the number of physical names"), 6, "physical names");
    for (std::size_t i = 0; i < count; ++i) {
        const auto dimension = static_cast<int>(scanner.integer("the dimension of a physical group"));
        const std::int64_t tag = scanner.integer("the number of a physical group");
        const std::string_view quoted = scanner.line();
        const std::size_t first = quoted.find('"'), last = quoted.rfind('"');
        if (first == std::string_view::npos || last == first)
            scanner.fail("the name of a physical group is not in quotes", "save the file again");
        content.name_group({dimension, tag}, std::string(quoted.substr(first + 1, last - first - 1)));
    }
}

std::string next_section(Scanner& scanner)
{
    while (!scanner.at_end()) {
        const std::string_view line = scanner.line();
        if (line.starts_with('$') && !line.starts_with("$End")) return std::string(line.substr(1, line.find_last_not_of(" \t")));
        scanner.fail("a section such as $Nodes was expected", "the file may be damaged: save it again");
    }
    return "";
}

}  // namespace corpuscle
