#include "mesh/quality.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include <fmt/format.h>

#include "base/error.hpp"
#include "mesh/measure.hpp"

namespace corpuscle {

namespace {

constexpr double flat = 1e-9;                             // scaled Jacobian below which an element has no area or volume
constexpr double poor = 0.2;                              // below which it deserves a warning
constexpr double warped = 20.0 * std::numbers::pi / 180;  // [rad] beyond which a face deserves a warning
constexpr double slender = 10.0;                          // aspect beyond which an element deserves a warning
constexpr std::size_t shown_elements = 5;                 // that a warning names

using Edge = std::array<int, 2>;
using Corners = std::array<int, 4>;

std::span<const Edge> edges_of(ElementShape shape)
{
    static constexpr std::array<Edge, 3> triangle{{{0, 1}, {1, 2}, {2, 0}}};
    static constexpr std::array<Edge, 4> quadrilateral{{{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
    static constexpr std::array<Edge, 6> tetrahedron{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
    static constexpr std::array<Edge, 12> hexahedron{
        {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
    switch (shape) {
        case ElementShape::triangle: return triangle;
        case ElementShape::quadrilateral: return quadrilateral;
        case ElementShape::tetrahedron: return tetrahedron;
        case ElementShape::hexahedron: break;
    }
    return hexahedron;
}

std::span<const Corners> four_cornered_faces_of(ElementShape shape)
{
    static constexpr std::array<Corners, 1> quadrilateral{{{0, 1, 2, 3}}};
    static constexpr std::array<Corners, 6> hexahedron{
        {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
    if (shape == ElementShape::quadrilateral) return quadrilateral;
    if (shape == ElementShape::hexahedron) return hexahedron;
    return {};
}

/// Corner and its three neighbours, right-handed, of a hexahedron.
constexpr std::array<Corners, 8> hexahedron_corners{
    {{0, 1, 3, 4}, {1, 2, 0, 5}, {2, 3, 1, 6}, {3, 0, 2, 7}, {4, 7, 5, 0}, {5, 4, 6, 1}, {6, 5, 7, 2}, {7, 6, 4, 3}}};

/// Corner positions of one element.
struct Corner {
    const Mesh& mesh;
    const MeshElement& element;
    Vector3d operator()(int i) const { return mesh.nodes[element.node[i]]; }
};

double ratio(double value, double scale)
{
    return scale > 0.0 ? value / scale : 0.0;
}

double triangle_jacobian(const Corner& at)
{
    const Vector3d a = at(1) - at(0), b = at(2) - at(1), c = at(0) - at(2);
    const double la = norm(a), lb = norm(b), lc = norm(c);
    return ratio(2.0 / std::numbers::sqrt3 * norm(cross(a, b)), std::max({la * lb, lb * lc, lc * la}));
}

double quadrilateral_jacobian(const Corner& at)
{
    const Vector3d normal = cross(at(2) - at(0), at(3) - at(1));
    double smallest = 1.0;
    for (int i = 0; i < 4; ++i) {
        const Vector3d next = at((i + 1) % 4) - at(i), last = at((i + 3) % 4) - at(i);
        smallest = std::min(smallest, ratio(dot(cross(next, last), normal), norm(next) * norm(last) * norm(normal)));
    }
    return smallest;
}

double tetrahedron_jacobian(const Corner& at)
{
    double largest = 0.0;
    for (int i = 0; i < 4; ++i) {
        double product = 1.0;
        for (int j = 0; j < 4; ++j)
            if (j != i) product *= norm(at(j) - at(i));
        largest = std::max(largest, product);
    }
    return ratio(std::numbers::sqrt2 * dot(cross(at(1) - at(0), at(2) - at(0)), at(3) - at(0)), largest);
}

double hexahedron_jacobian(const Corner& at)
{
    double smallest = 1.0;
    for (const Corners& c : hexahedron_corners) {
        const Vector3d a = at(c[1]) - at(c[0]), b = at(c[2]) - at(c[0]), d = at(c[3]) - at(c[0]);
        smallest = std::min(smallest, ratio(dot(cross(a, b), d), norm(a) * norm(b) * norm(d)));
    }
    return smallest;
}

/// Angle between the normals of the two triangles of a face, for the diagonal that bends it more. [rad]
double warp(const Corner& at, const Corners& face)
{
    const auto bend = [&](int first) {
        const Vector3d a = at(face[first]), b = at(face[first + 1]), c = at(face[(first + 2) % 4]), d = at(face[(first + 3) % 4]);
        const Vector3d one = cross(b - a, c - a), two = cross(c - a, d - a);
        return std::atan2(norm(cross(one, two)), dot(one, two));
    };
    return std::max(bend(0), bend(1));
}

[[noreturn]] void refuse(const Mesh& mesh, const std::string& name, std::size_t element, const std::string& problem, const char* remedy)
{
    throw InputError(fmt::format("mesh '{}': {} {}", name, element_place(mesh, element), problem), remedy);
}

/// The largest warp of an element's faces of four corners; 0 without any. [rad]
double worst_warp(const Corner& at, ElementShape shape)
{
    double worst = 0;
    for (const Corners& face : four_cornered_faces_of(shape)) worst = std::max(worst, warp(at, face));
    return worst;
}

/// Shortest and longest edge of an element. [m]
struct EdgeRange {
    double shortest = 1e300, longest = 0;
};

EdgeRange edge_range(const Corner& at)
{
    EdgeRange range;
    for (const auto& [a, b] : edges_of(at.element.shape)) {
        const double length = norm(at(b) - at(a));
        range.shortest = std::min(range.shortest, length);
        range.longest = std::max(range.longest, length);
    }
    return range;
}

/// Refuses positions, indices and sets that point nowhere.
void require_sound(const Mesh& mesh, const std::string& name)
{
    if (mesh.elements.empty())
        throw InputError(fmt::format("mesh '{}' has no elements", name), "export the elements of the part, not only its geometry");
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
        if (!std::isfinite(norm_squared(mesh.nodes[i])))
            throw InputError(fmt::format("mesh '{}': the position of node {} is not a finite number", name, i + 1), "write the mesh anew");
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        for (int i = 0; i < node_count(mesh.elements[e].shape); ++i)
            if (mesh.elements[e].node[i] >= mesh.nodes.size())
                throw InputError(fmt::format("mesh '{}': element {} uses node {} of {}", name, element_number(mesh, e),
                                             mesh.elements[e].node[i] + 1ull, mesh.nodes.size()),
                                 "write the mesh anew");
    const auto require_range = [&](const auto& sets, std::size_t count, const char* kind) {
        for (const auto& [set, members] : sets)
            for (const std::uint32_t member : members)
                if (member >= count)
                    throw InputError(fmt::format("mesh '{}': set '{}' holds {} {} of {}", name, set, kind, member + 1ull, count),
                                     "write the mesh anew");
    };
    require_range(mesh.node_sets, mesh.nodes.size(), "node");
    require_range(mesh.element_sets, mesh.elements.size(), "element");
}

/// The element's nodes in ascending order, the rest filled up: equal for elements on the same nodes.
std::array<std::uint32_t, 8> sorted_nodes(const MeshElement& element)
{
    std::array<std::uint32_t, 8> nodes;
    nodes.fill(0xFFFFFFFFu);
    const int count = node_count(element.shape);
    std::copy_n(element.node.begin(), count, nodes.begin());
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

void require_no_collapse(const Mesh& mesh, const std::string& name)
{
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const auto nodes = sorted_nodes(mesh.elements[e]);
        const auto end = nodes.begin() + node_count(mesh.elements[e].shape);
        if (std::adjacent_find(nodes.begin(), end) != end)
            refuse(mesh, name, e, "uses a node twice", "make collapsed quadrilaterals triangles, and remove elements without area");
    }
}

void require_no_duplicates(const Mesh& mesh, const std::string& name)
{
    std::vector<std::pair<std::array<std::uint32_t, 8>, std::size_t>> keys;
    keys.reserve(mesh.elements.size());
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) keys.emplace_back(sorted_nodes(mesh.elements[e]), e);
    std::sort(keys.begin(), keys.end());
    const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
    const auto twin = std::adjacent_find(keys.begin(), keys.end(), same);
    if (twin != keys.end())
        refuse(mesh, name, twin[1].second, fmt::format("lies on the same nodes as element {}", element_number(mesh, twin->second)),
               "remove one of the two");
}

void require_shapely(const Mesh& mesh, const std::string& name)
{
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const double jacobian = scaled_jacobian(mesh, mesh.elements[e]);
        if (jacobian > flat) continue;
        const bool solid = mesh.elements[e].shape == ElementShape::tetrahedron || mesh.elements[e].shape == ElementShape::hexahedron;
        if (jacobian >= -flat)
            refuse(mesh, name, e, solid ? "has a corner without volume" : "has a corner without area", "move its nodes apart or remove it");
        refuse(mesh, name, e, fmt::format("is tangled or concave (scaled Jacobian {:.2g})", jacobian),
               solid ? "order its nodes as gmsh does: the first face seen from inside runs clockwise"
                     : "order its nodes around the element and keep it convex");
    }
}

std::size_t unused_nodes(const Mesh& mesh)
{
    std::vector<bool> used(mesh.nodes.size(), false);
    for (const MeshElement& element : mesh.elements)
        for (int i = 0; i < node_count(element.shape); ++i) used[element.node[i]] = true;
    return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

/// Indices of the elements of which `is` says so.
template <class Is>
std::vector<std::size_t> elements_where(const Mesh& mesh, const Is& is)
{
    std::vector<std::size_t> found;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        if (is(Corner{mesh, mesh.elements[e]})) found.push_back(e);
    return found;
}

/// "element 17", "elements 17, 18, 20, ...": the first of a list, by their numbers.
std::string numbers_text(const Mesh& mesh, const std::vector<std::size_t>& elements)
{
    std::string text = elements.size() == 1 ? "element" : "elements";
    for (std::size_t i = 0; i < std::min(elements.size(), shown_elements); ++i)
        text += fmt::format("{} {}", i == 0 ? "" : ",", element_number(mesh, elements[i]));
    return elements.size() > shown_elements ? text + ", ..." : text;
}

std::vector<std::string> warnings_of(const Mesh& mesh, const std::string& name)
{
    std::vector<std::string> warnings;
    if (const std::size_t unused = unused_nodes(mesh); unused > 0)
        warnings.push_back(fmt::format("mesh '{}': {} nodes are used by no element", name, unused));
    const auto warn = [&](const std::vector<std::size_t>& elements, const std::string& what) {
        if (elements.empty()) return;
        warnings.push_back(fmt::format("mesh '{}': {} {} {} ({}), the first near {}", name, elements.size(),
                                       elements.size() == 1 ? "element is" : "elements are", what, numbers_text(mesh, elements),
                                       point_text(center(mesh, mesh.elements[elements.front()]))));
    };
    warn(elements_where(mesh, [](const Corner& at) { return scaled_jacobian(at.mesh, at.element) < poor; }),
         fmt::format("badly shaped: scaled Jacobian below {}", poor));
    warn(elements_where(mesh, [](const Corner& at) { return worst_warp(at, at.element.shape) > warped; }),
         "warped by more than 20 degrees");
    warn(elements_where(mesh, [](const Corner& at) { return edge_range(at).longest > slender * edge_range(at).shortest; }),
         fmt::format("slender: longest over shortest edge above {}", slender));
    return warnings;
}

}  // namespace

std::int64_t element_number(const Mesh& mesh, std::size_t element)
{
    const std::int64_t number = mesh.elements[element].number;
    return number != 0 ? number : static_cast<std::int64_t>(element) + 1;
}

double scaled_jacobian(const Mesh& mesh, const MeshElement& element)
{
    const Corner at{mesh, element};
    switch (element.shape) {
        case ElementShape::triangle: return triangle_jacobian(at);
        case ElementShape::quadrilateral: return quadrilateral_jacobian(at);
        case ElementShape::tetrahedron: return tetrahedron_jacobian(at);
        case ElementShape::hexahedron: break;
    }
    return hexahedron_jacobian(at);
}

MeshQuality check(const Mesh& mesh)
{
    if (mesh.elements.empty()) return {};
    MeshQuality quality{.elements = mesh.elements.size(), .min_edge = 1e300, .min_scaled_jacobian = 2.0};
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const MeshElement& element = mesh.elements[e];
        const Corner at{mesh, element};
        const auto [shortest, longest] = edge_range(at);
        quality.min_edge = std::min(quality.min_edge, shortest);
        quality.max_edge = std::max(quality.max_edge, longest);
        if (longest > quality.worst_aspect * shortest) {
            quality.worst_aspect = longest / shortest;
            quality.longest_element = e;
        }
        if (const double own = worst_warp(at, element.shape); own > quality.worst_warp) {
            quality.worst_warp = own;
            quality.warped_element = e;
        }
        const double jacobian = scaled_jacobian(mesh, element);
        if (jacobian < quality.min_scaled_jacobian) quality.worst_element = e;
        quality.min_scaled_jacobian = std::min(quality.min_scaled_jacobian, jacobian);
    }
    return quality;
}

std::vector<std::string> validate(const Mesh& mesh, const std::string& name)
{
    require_sound(mesh, name);
    require_no_collapse(mesh, name);
    require_no_duplicates(mesh, name);
    require_shapely(mesh, name);
    return warnings_of(mesh, name);
}

}  // namespace corpuscle
