#include "mesh/transform.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "base/error.hpp"

namespace corpuscle {

namespace {

constexpr std::uint32_t gone = std::numeric_limits<std::uint32_t>::max();

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
    std::size_t operator()(const Cell& cell) const
    {
        std::uint64_t hash = 0x9E3779B97F4A7C15u;
        for (const std::int64_t index : cell) hash = (hash ^ static_cast<std::uint64_t>(index)) * 0xD6E8FEB86659FD93u;
        return hash ^ (hash >> 32);
    }
};

Cell cell_of(const Vector3d& point, double side)
{
    Cell cell{};
    for (int a = 0; a < 3; ++a) cell[a] = std::llround(point[a] / side);
    return cell;
}

/// Nodes kept so far, found by the cell they lie in; a cell's side is four tolerances, so that most nodes need one cell only.
class KeptNodes {
public:
    KeptNodes(const std::vector<Vector3d>& nodes, double tolerance) : nodes_(nodes), tolerance_(tolerance), side_(4.0 * tolerance) {}

    /// The first kept node within the tolerance of `point`, or `gone`.
    std::uint32_t near(const Vector3d& point) const
    {
        const Vector3d reach{tolerance_, tolerance_, tolerance_};
        const Cell low = cell_of(point - reach, side_), high = cell_of(point + reach, side_);
        std::uint32_t first = gone;
        for (auto i = low[0]; i <= high[0]; ++i)
            for (auto j = low[1]; j <= high[1]; ++j)
                for (auto k = low[2]; k <= high[2]; ++k) first = std::min(first, near_in({i, j, k}, point));
        return first;
    }

    void keep(std::uint32_t node) { cells_[cell_of(nodes_[node], side_)].push_back(node); }

private:
    std::uint32_t near_in(const Cell& cell, const Vector3d& point) const
    {
        const auto found = cells_.find(cell);
        if (found == cells_.end()) return gone;
        for (const std::uint32_t node : found->second)
            if (norm_squared(nodes_[node] - point) <= tolerance_ * tolerance_) return node;
        return gone;
    }

    const std::vector<Vector3d>& nodes_;
    double tolerance_;
    double side_;
    std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells_;
};

/// A distance below which positions are the same but for round-off; not 0, because cells of no size cannot be numbered. [m]
double smallest_tolerance(const Mesh& mesh)
{
    double largest = 1e-290;
    for (const Vector3d& node : mesh.nodes) largest = std::max({largest, std::abs(node.x), std::abs(node.y), std::abs(node.z)});
    return 1e-15 * largest;
}

/// Gives each node the index `renumbered` says; drops those that are `gone` from the sets.
void renumber(Mesh& mesh, const std::vector<std::uint32_t>& renumbered)
{
    for (MeshElement& element : mesh.elements)
        for (int i = 0; i < node_count(element.shape); ++i) element.node[i] = renumbered[element.node[i]];
    for (auto& [name, set] : mesh.node_sets) {
        for (std::uint32_t& node : set) node = renumbered[node];
        std::sort(set.begin(), set.end());
        set.erase(std::unique(set.begin(), set.end()), set.end());
        if (!set.empty() && set.back() == gone) set.pop_back();
    }
}

}  // namespace

void translate(Mesh& mesh, const Vector3d& shift)
{
    for (Vector3d& node : mesh.nodes) node += shift;
}

void rotate(Mesh& mesh, const Vector3d& axis, double angle, const Vector3d& center)
{
    if (!(norm(axis) > 0.0)) throw InputError("the axis of a rotation has no length", "give a direction such as [0, 0, 1]");
    const Vector3d n = normalized(axis);
    const double cosine = std::cos(angle), sine = std::sin(angle);
    for (Vector3d& node : mesh.nodes) {
        const Vector3d arm = node - center;
        node = center + cosine * arm + sine * cross(n, arm) + (1.0 - cosine) * dot(n, arm) * n;
    }
}

void scale(Mesh& mesh, double factor)
{
    if (!(factor > 0.0)) throw InputError("a mesh cannot be scaled by a factor that is not above 0", "give a factor such as 0.001");
    for (Vector3d& node : mesh.nodes) node *= factor;
}

void append(Mesh& mesh, const Mesh& other)
{
    const auto nodes_before = static_cast<std::uint32_t>(mesh.nodes.size());
    const auto elements_before = static_cast<std::uint32_t>(mesh.elements.size());
    mesh.nodes.insert(mesh.nodes.end(), other.nodes.begin(), other.nodes.end());
    for (MeshElement element : other.elements) {
        for (int i = 0; i < node_count(element.shape); ++i) element.node[i] += nodes_before;
        mesh.elements.push_back(element);
    }
    for (const auto& [name, set] : other.node_sets)
        for (const std::uint32_t node : set) mesh.node_sets[name].push_back(node + nodes_before);
    for (const auto& [name, set] : other.element_sets)
        for (const std::uint32_t element : set) mesh.element_sets[name].push_back(element + elements_before);
}

std::size_t merge_nodes(Mesh& mesh, double tolerance)
{
    KeptNodes kept_nodes(mesh.nodes, std::max(tolerance, smallest_tolerance(mesh)));
    std::vector<std::uint32_t> kept, renumbered(mesh.nodes.size());
    for (std::uint32_t node = 0; node < mesh.nodes.size(); ++node) {
        const std::uint32_t twin = kept_nodes.near(mesh.nodes[node]);
        if (twin != gone) {
            renumbered[node] = renumbered[twin];
            continue;
        }
        renumbered[node] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(node);
        kept_nodes.keep(node);
    }
    renumber(mesh, renumbered);
    for (std::size_t i = 0; i < kept.size(); ++i) mesh.nodes[i] = mesh.nodes[kept[i]];
    const std::size_t merged = mesh.nodes.size() - kept.size();
    mesh.nodes.resize(kept.size());
    return merged;
}

std::size_t remove_unused_nodes(Mesh& mesh)
{
    std::vector<std::uint32_t> renumbered(mesh.nodes.size(), gone);
    for (const MeshElement& element : mesh.elements)
        for (int i = 0; i < node_count(element.shape); ++i) renumbered[element.node[i]] = 0;
    std::uint32_t used = 0;
    for (std::uint32_t node = 0; node < mesh.nodes.size(); ++node) {
        if (renumbered[node] == gone) continue;
        mesh.nodes[used] = mesh.nodes[node];
        renumbered[node] = used++;
    }
    const std::size_t removed = mesh.nodes.size() - used;
    mesh.nodes.resize(used);
    renumber(mesh, renumbered);
    std::erase_if(mesh.node_sets, [](const auto& named) { return named.second.empty(); });
    return removed;
}

}  // namespace corpuscle
