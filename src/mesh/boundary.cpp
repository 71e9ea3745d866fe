#include "mesh/boundary.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "base/error.hpp"
#include "mesh/measure.hpp"
#include "mesh/triangles.hpp"

namespace corpuscle {

namespace {

bool is_surface(ElementShape shape)
{
    return shape == ElementShape::triangle || shape == ElementShape::quadrilateral;
}

bool same_edge(const SurfaceEdge& a, const SurfaceEdge& b)
{
    return a.low == b.low && a.high == b.high;
}

/// Calls `visit(first, last)` for the uses of each edge.
template <class Visit>
void for_each_edge(const std::vector<SurfaceEdge>& edges, Visit&& visit)
{
    for (auto first = edges.begin(); first != edges.end();) {
        const auto last = std::find_if(first, edges.end(), [&](const SurfaceEdge& edge) { return !same_edge(edge, *first); });
        visit(first, last);
        first = last;
    }
}

void turn(MeshElement& element)
{
    std::reverse(element.node.begin() + 1, element.node.begin() + node_count(element.shape));
}

/// Elements joined by edges, each with whether it must be turned against the first of its surface.
class Orientation {
public:
    Orientation(const Mesh& mesh, const std::string& name) : mesh_(mesh), name_(name), neighbours_(mesh.elements.size())
    {
        const auto edges = surface_edges(mesh);
        for_each_edge(edges, [&](auto first, auto last) {
            if (last - first != 2) return;
            const bool opposed = first[0].forward == first[1].forward;
            neighbours_[first[0].element].push_back({first[1].element, opposed});
            neighbours_[first[1].element].push_back({first[0].element, opposed});
        });
        turned_.assign(mesh.elements.size(), unseen);
        component_.assign(mesh.elements.size(), 0);
        for (std::uint32_t e = 0; e < mesh.elements.size(); ++e)
            if (turned_[e] == unseen) spread_from(e);
    }

    [[nodiscard]] bool turned(std::size_t element) const { return turned_[element] == 1; }
    [[nodiscard]] std::uint32_t component(std::size_t element) const { return component_[element]; }
    [[nodiscard]] std::uint32_t components() const { return components_; }

private:
    struct Neighbour {
        std::uint32_t element;
        bool opposed;
    };
    static constexpr signed char unseen = -1;

    void spread_from(std::uint32_t start)
    {
        std::vector<std::uint32_t> front{start};
        turned_[start] = 0;
        while (!front.empty()) {
            const std::uint32_t element = front.back();
            front.pop_back();
            component_[element] = components_;
            for (const Neighbour& next : neighbours_[element]) {
                const auto wanted = static_cast<signed char>(next.opposed ? 1 - turned_[element] : turned_[element]);
                if (turned_[next.element] == unseen) front.push_back(next.element), turned_[next.element] = wanted;
                if (turned_[next.element] != wanted)
                    throw InputError(
                        fmt::format("mesh '{}': the surface has one side only ({})", name_, element_place(mesh_, next.element)),
                        "repair the surface: inside and outside cannot be told apart");
            }
        }
        ++components_;
    }

    const Mesh& mesh_;
    const std::string& name_;
    std::vector<std::vector<Neighbour>> neighbours_;
    std::vector<signed char> turned_;
    std::vector<std::uint32_t> component_;
    std::uint32_t components_ = 0;
};

/// One connected surface of a mesh.
struct Shell {
    std::vector<Triangle> triangles;
    Box box;
};

std::vector<Shell> shells_of(const Mesh& mesh, const Orientation& orientation)
{
    std::vector<Shell> shells(orientation.components());
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        Shell& shell = shells[orientation.component(e)];
        append_triangles(mesh.elements[e], shell.triangles);
        for (int i = 0; i < node_count(mesh.elements[e].shape); ++i) shell.box.include(mesh.nodes[mesh.elements[e].node[i]]);
    }
    return shells;
}

/// Whether the outward side of a shell must face inward because an odd number of other shells encloses it.
bool is_hollow(const Mesh& mesh, const std::vector<Shell>& shells, std::size_t index)
{
    const Vector3d point = mesh.nodes[shells[index].triangles.front()[0]];
    int enclosing = 0;
    for (std::size_t other = 0; other < shells.size(); ++other)
        if (other != index && shells[other].box.contains(point) &&
            std::abs(winding_number(mesh.nodes, shells[other].triangles, point)) > 0.5)
            ++enclosing;
    return enclosing % 2 == 1;
}

}  // namespace

std::vector<SurfaceEdge> surface_edges(const Mesh& mesh)
{
    std::vector<SurfaceEdge> edges;
    edges.reserve(4 * mesh.elements.size());
    for (std::uint32_t e = 0; e < mesh.elements.size(); ++e) {
        const MeshElement& element = mesh.elements[e];
        if (!is_surface(element.shape)) continue;
        const int count = node_count(element.shape);
        for (int i = 0; i < count; ++i) {
            const std::uint32_t a = element.node[i], b = element.node[(i + 1) % count];
            edges.push_back({std::min(a, b), std::max(a, b), e, a < b});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const SurfaceEdge& a, const SurfaceEdge& b) {
        return std::tie(a.low, a.high, a.element) < std::tie(b.low, b.high, b.element);
    });
    return edges;
}

std::vector<std::vector<std::uint32_t>> boundary_loops(const Mesh& mesh)
{
    std::multimap<std::uint32_t, std::uint32_t> next;
    const auto edges = surface_edges(mesh);
    for_each_edge(edges, [&](auto first, auto last) {
        if (last - first != 1) return;
        if (first->forward)
            next.emplace(first->low, first->high);
        else
            next.emplace(first->high, first->low);
    });
    std::vector<std::vector<std::uint32_t>> loops;
    while (!next.empty()) {
        auto& loop = loops.emplace_back();
        for (auto step = next.begin(); step != next.end(); step = next.find(loop.back() == loop.front() ? ~0u : loop.back())) {
            if (loop.empty()) loop.push_back(step->first);
            loop.push_back(step->second);
            next.erase(step);
        }
        if (loop.back() == loop.front()) loop.pop_back();
    }
    return loops;
}

void require_closed(const Mesh& mesh, const std::string& name)
{
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        if (!is_surface(mesh.elements[e].shape))
            throw InputError(fmt::format("mesh '{}': {} is a solid element where a closed surface is needed", name, element_place(mesh, e)),
                             "give the triangles or quadrilaterals of the surface");
    if (mesh.elements.empty()) throw InputError(fmt::format("mesh '{}' has no elements", name), "give a closed surface");
    const auto edges = surface_edges(mesh);
    for_each_edge(edges, [&](auto first, auto last) {
        if (last - first <= 2) return;
        throw InputError(
            fmt::format("mesh '{}': {} elements share the edge near {}", name, last - first, point_text(mesh.nodes[first->low])),
            "a closed surface has two elements at every edge: remove inner walls and duplicates");
    });
    const auto loops = boundary_loops(mesh);
    if (loops.empty()) return;
    throw InputError(fmt::format("mesh '{}' has {} {}; one with {} edges passes {}", name, loops.size(),
                                 loops.size() == 1 ? "hole" : "holes", loops.front().size(), point_text(mesh.nodes[loops.front().front()])),
                     "close the surface, or merge its coincident nodes");
}

std::size_t orient_closed(Mesh& mesh, const std::string& name)
{
    require_closed(mesh, name);
    const Orientation orientation(mesh, name);
    const std::vector<MeshElement> before = mesh.elements;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        if (orientation.turned(e)) turn(mesh.elements[e]);
    const auto shells = shells_of(mesh, orientation);
    std::vector<bool> turn_shell(shells.size());
    for (std::size_t s = 0; s < shells.size(); ++s)
        turn_shell[s] = (signed_volume(mesh.nodes, shells[s].triangles) < 0.0) != is_hollow(mesh, shells, s);
    std::size_t turned = 0;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        if (turn_shell[orientation.component(e)]) turn(mesh.elements[e]);
        turned += mesh.elements[e].node != before[e].node ? 1 : 0;
    }
    return turned;
}

}  // namespace corpuscle
