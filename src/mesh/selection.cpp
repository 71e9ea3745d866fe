#include "mesh/selection.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "base/error.hpp"
#include "mesh/measure.hpp"
#include "schema/nearest.hpp"
#include "schema/units.hpp"

namespace corpuscle {

namespace {

constexpr double plane_tolerance = 1e-6;  // of the mesh's diagonal

std::string trimmed(const std::string& text)
{
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// A plain number is in m; anything else must be a number with a unit of length.
double read_length(const std::string& text)
{
    double value = 0.0;
    const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(begin, end, value);
    const double length = error == std::errc{} && rest == end ? value : convert(text, "m");
    if (!std::isfinite(length)) throw InputError("'" + text + "' is not a finite length", "give a plane as in \"x=0\"");
    return length;
}

std::vector<std::uint32_t> sorted_unique(std::vector<std::uint32_t> nodes)
{
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

std::vector<std::uint32_t> nodes_on(const Mesh& mesh, const AxisPlane& plane, const std::string& where)
{
    const double tolerance = plane_tolerance * diagonal(mesh);
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t node = 0; node < mesh.nodes.size(); ++node)
        if (std::abs(mesh.nodes[node][plane.axis] - plane.position) <= tolerance) nodes.push_back(node);
    if (!nodes.empty()) return nodes;
    const Box box = bounds(mesh);
    throw InputError(fmt::format("no node lies on the plane '{}'", where),
                     mesh.nodes.empty() ? "the mesh has no nodes"
                                        : fmt::format("the mesh reaches from {} to {}", point_text(box.lower), point_text(box.upper)));
}

std::vector<std::uint32_t> nodes_of_elements(const Mesh& mesh, const std::vector<std::uint32_t>& elements)
{
    std::vector<std::uint32_t> nodes;
    for (const std::uint32_t element : elements)
        for (int i = 0; i < node_count(mesh.elements[element].shape); ++i) nodes.push_back(mesh.elements[element].node[i]);
    return nodes;
}

[[noreturn]] void refuse_unknown(const Mesh& mesh, const std::string& where)
{
    std::set<std::string> names{"all", "x=0", "y=0", "z=0"};
    for (const auto& [name, set] : mesh.node_sets) names.insert(name);
    for (const auto& [name, set] : mesh.element_sets) names.insert(name);
    throw InputError(fmt::format("the mesh has no set of nodes '{}'", where), suggestion(where, {names.begin(), names.end()}));
}

}  // namespace

std::optional<AxisPlane> parse_plane(const std::string& where)
{
    const std::string text = trimmed(where);
    const auto equals = text.find('=');
    if (equals == std::string::npos) return std::nullopt;
    const std::string axis = trimmed(text.substr(0, equals));
    if (axis.size() != 1 || axis[0] < 'x' || axis[0] > 'z') return std::nullopt;
    return AxisPlane{axis[0] - 'x', read_length(trimmed(text.substr(equals + 1)))};
}

std::vector<std::uint32_t> select_nodes(const Mesh& mesh, const std::string& where)
{
    if (const auto set = mesh.node_sets.find(where); set != mesh.node_sets.end()) return sorted_unique(set->second);
    if (where == "all") {
        std::vector<std::uint32_t> nodes(mesh.nodes.size());
        std::iota(nodes.begin(), nodes.end(), 0u);
        return nodes;
    }
    if (const auto set = mesh.element_sets.find(where); set != mesh.element_sets.end())
        return sorted_unique(nodes_of_elements(mesh, set->second));
    if (const auto plane = parse_plane(where)) return nodes_on(mesh, *plane, where);
    refuse_unknown(mesh, where);
}

std::uint32_t nearest_node(const Mesh& mesh, const Vector3d& point)
{
    if (mesh.nodes.empty()) throw InputError("a mesh without nodes has none near " + point_text(point), "give the part a mesh");
    const auto nearer = [&](const Vector3d& a, const Vector3d& b) { return norm_squared(a - point) < norm_squared(b - point); };
    return static_cast<std::uint32_t>(std::min_element(mesh.nodes.begin(), mesh.nodes.end(), nearer) - mesh.nodes.begin());
}

}  // namespace corpuscle
