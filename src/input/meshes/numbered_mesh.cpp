#include "input/meshes/numbered_mesh.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "mesh/transform.hpp"

namespace corpuscle {

namespace {

using Numbers = std::unordered_map<std::int64_t, std::uint32_t>;
using Sets = std::map<std::string, NumberedMesh::Set>;
using Indices = std::vector<std::uint32_t>;

constexpr const char* write_again = "correct the file, or export the mesh again";

void make_unique(Indices& indices)
{
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

/// Turns numbers and sets of a file into indices.
class Resolver {
public:
    Resolver(const DeckLines& lines, const std::function<std::int64_t(std::int64_t)>& shown, const Sets& node_sets,
             const Sets& element_sets)
        : lines_(lines), shown_(shown), node_sets_(node_sets), element_sets_(element_sets)
    {
    }

    void number_nodes(const std::vector<NumberedMesh::Node>& nodes)
    {
        for (const NumberedMesh::Node& node : nodes) enter(node_at_, node.number, node.place, "node");
    }

    void number_elements(const std::vector<NumberedMesh::Element>& elements)
    {
        for (const NumberedMesh::Element& element : elements) enter(element_at_, element.number, element.place, "element");
        nodes_of_.reserve(elements.size());
        for (const NumberedMesh::Element& element : elements) nodes_of_.push_back(nodes_of(element));
    }

    [[nodiscard]] const std::array<std::uint32_t, 8>& nodes_of(std::size_t element) const { return nodes_of_[element]; }

    [[nodiscard]] Indices nodes_in(const std::string& key, const DeckPlace& place)
    {
        return resolve(node_sets_, key, place, node_at_, "node", [this](const SetMember& member) {
            return member.elements ? nodes_of_elements(elements_in(member.set, member.place)) : nodes_in(member.set, member.place);
        });
    }

    [[nodiscard]] Indices elements_in(const std::string& key, const DeckPlace& place)
    {
        return resolve(element_sets_, key, place, element_at_, "element",
                       [this](const SetMember& member) { return elements_in(member.set, member.place); });
    }

    [[nodiscard]] Indices nodes_of_elements(const Indices& elements) const
    {
        Indices nodes;
        for (const std::uint32_t e : elements)
            for (const std::uint32_t node : nodes_of_[e])
                if (node != none) nodes.push_back(node);
        make_unique(nodes);
        return nodes;
    }

private:
    static constexpr std::uint32_t none = 0xFFFFFFFFu;

    void enter(Numbers& at, std::int64_t number, const DeckPlace& place, const char* what) const
    {
        if (!at.emplace(number, static_cast<std::uint32_t>(at.size())).second)
            lines_.fail_at(place, fmt::format("{} {} is given twice", what, shown_(number)), "number them anew, or include the file once");
    }

    [[nodiscard]] std::array<std::uint32_t, 8> nodes_of(const NumberedMesh::Element& element) const
    {
        std::array<std::uint32_t, 8> nodes;
        nodes.fill(none);
        for (int i = 0; i < element.corners; ++i) {
            const auto found = node_at_.find(element.node[i]);
            if (found == node_at_.end())
                lines_.fail_at(
                    element.place,
                    fmt::format("element {} uses node {}, which the file does not have", shown_(element.number), shown_(element.node[i])),
                    write_again);
            nodes[i] = found->second;
        }
        return nodes;
    }

    /// Adds what of a range of numbers there is; of a single number, that it is there.
    void add_range(const SetMember& member, const Numbers& at, const char* what, Indices& indices) const
    {
        const bool single = member.first == member.last;
        const auto add = [&](std::int64_t number) {
            const auto found = at.find(number);
            if (found != at.end()) return indices.push_back(found->second);
            if (single) lines_.fail_at(member.place, fmt::format("there is no {} {} to put into a set", what, shown_(number)), write_again);
        };
        if (member.last < member.first || member.step < 1)
            lines_.fail_at(member.place, "the range of a set runs backwards", "give first, last and a step of at least 1");
        if (static_cast<std::uint64_t>(member.last - member.first) / static_cast<std::uint64_t>(member.step) < 2 * at.size() + 2) {
            for (std::int64_t number = member.first; number <= member.last; number += member.step) add(number);
            return;
        }
        for (const auto& [number, index] : at)
            if (number >= member.first && number <= member.last && (number - member.first) % member.step == 0) indices.push_back(index);
    }

    template <class Other>
    Indices resolve(const Sets& sets, const std::string& key, const DeckPlace& place, const Numbers& at, const char* what,
                    const Other& other)
    {
        const auto found = sets.find(key);
        if (found == sets.end())
            lines_.fail_at(place, fmt::format("there is no set of {}s '{}'", what, key), "name a set of the file, or correct its spelling");
        if (!visiting_.insert(what + key).second) lines_.fail_at(place, fmt::format("the set '{}' holds itself", key), "take the line out");
        Indices indices;
        for (const SetMember& member : found->second.members) {
            if (member.set.empty()) {
                add_range(member, at, what, indices);
            } else {
                const Indices more = other(member);
                indices.insert(indices.end(), more.begin(), more.end());
            }
        }
        visiting_.erase(what + key);
        make_unique(indices);
        return indices;
    }

    const DeckLines& lines_;
    const std::function<std::int64_t(std::int64_t)>& shown_;
    const Sets &node_sets_, &element_sets_;
    Numbers node_at_, element_at_;
    std::vector<std::array<std::uint32_t, 8>> nodes_of_;
    std::set<std::string> visiting_;
};

/// Moves what the members of sets mean by a shift of all numbers and a prefix of all names.
std::vector<SetMember> shifted(std::vector<SetMember> members, std::int64_t shift, const std::string& prefix)
{
    for (SetMember& member : members) {
        member.first += shift;
        member.last += shift;
        if (!member.set.empty()) member.set = prefix + "." + member.set;
    }
    return members;
}

/// The corners without those that come again, in the order of their first coming.
std::vector<std::int64_t> different(std::span<const std::int64_t> corners)
{
    std::vector<std::int64_t> kept;
    for (const std::int64_t corner : corners)
        if (std::find(kept.begin(), kept.end(), corner) == kept.end()) kept.push_back(corner);
    return kept;
}

NumberedMesh::Element element_of(const DeckLines& lines, std::int64_t number, ElementShape shape, std::span<const std::int64_t> corners)
{
    NumberedMesh::Element element{number, shape, static_cast<int>(corners.size()), {}, lines.place()};
    std::copy(corners.begin(), corners.end(), element.node.begin());
    return element;
}

}  // namespace

NumberedMesh::Set& NumberedMesh::node_set(const std::string& key, const std::string& name)
{
    return node_sets_.try_emplace(key, Set{name, {}}).first->second;
}

NumberedMesh::Set& NumberedMesh::element_set(const std::string& key, const std::string& name)
{
    return element_sets_.try_emplace(key, Set{name, {}}).first->second;
}

void NumberedMesh::add(const NumberedMesh& other, std::int64_t shift, const std::string& prefix,
                       const std::function<Vector3d(const Vector3d&)>& placed)
{
    const std::string key = in_capitals(prefix);
    for (Node node : other.nodes_) {
        node.number += shift;
        node.position = placed(node.position);
        nodes_.push_back(node);
    }
    for (Element element : other.elements_) {
        element.number += shift;
        for (int i = 0; i < element.corners; ++i) element.node[i] += shift;
        elements_.push_back(element);
    }
    for (const bool of_nodes : {true, false}) {
        Sets& sets = of_nodes ? node_sets_ : element_sets_;
        for (const auto& [name, set] : of_nodes ? other.node_sets_ : other.element_sets_) {
            sets[key + "." + name] = {prefix + "." + set.name, shifted(set.members, shift, key)};
            Set& all = sets.try_emplace(name, Set{set.name, {}}).first->second;
            all.members.push_back({0, 0, 1, key + "." + name, false, {}});
        }
        sets[key] = {prefix, {{shift, shift + numbers - 1, 1, "", false, {}}}};
    }
}

Mesh NumberedMesh::mesh(const DeckLines& lines, const std::function<std::int64_t(std::int64_t)>& shown) const
{
    Resolver resolver(lines, shown, node_sets_, element_sets_);
    resolver.number_nodes(nodes_);
    resolver.number_elements(elements_);
    Mesh mesh;
    for (const Node& node : nodes_) mesh.nodes.push_back(node.position);
    std::vector<std::int64_t> kept(elements_.size(), -1);
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        if (!elements_[e].shape) continue;
        kept[e] = static_cast<std::int64_t>(mesh.elements.size());
        MeshElement& element = mesh.elements.emplace_back(*elements_[e].shape);
        element.number = shown(elements_[e].number);
        std::copy_n(resolver.nodes_of(e).begin(), node_count(element.shape), element.node.begin());
    }
    for (const auto& [key, set] : element_sets_) {
        const Indices members = resolver.elements_in(key, {});
        mesh.node_sets[set.name] = resolver.nodes_of_elements(members);
        for (const std::uint32_t member : members)
            if (kept[member] >= 0) mesh.element_sets[set.name].push_back(static_cast<std::uint32_t>(kept[member]));
    }
    for (const auto& [key, set] : node_sets_) mesh.node_sets[set.name] = resolver.nodes_in(key, {});
    if (mesh.elements.empty())
        lines.fail_at({}, "the file has no shells, tetrahedra or hexahedra", "export a mesh with elements, not of nodes or geometry alone");
    remove_unused_nodes(mesh);
    return mesh;
}

NumberedMesh::Element surface_element(const DeckLines& lines, std::int64_t number, std::array<std::int64_t, 4> corners)
{
    if (corners[3] == 0) corners[3] = corners[2];
    const std::vector<std::int64_t> kept = different(corners);
    if (kept.size() < 3) lines.fail(fmt::format("element {} has {} different nodes", number, kept.size()), "remove elements without area");
    return element_of(lines, number, kept.size() == 3 ? ElementShape::triangle : ElementShape::quadrilateral, kept);
}

NumberedMesh::Element solid_element(const DeckLines& lines, std::int64_t number, const std::array<std::int64_t, 8>& corners)
{
    std::vector<std::int64_t> kept = different(corners);
    std::erase(kept, 0);
    switch (kept.size()) {
        case 4: return element_of(lines, number, ElementShape::tetrahedron, kept);
        case 8: return element_of(lines, number, ElementShape::hexahedron, kept);
        default: break;
    }
    const char* kind = kept.size() == 6 ? "a wedge" : kept.size() == 5 ? "a pyramid" : "no solid";
    lines.fail(fmt::format("element {} has {} different nodes: {}", number, kept.size(), kind),
               "mesh the volume with hexahedra or tetrahedra alone");
}

}  // namespace corpuscle
