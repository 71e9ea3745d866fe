#include "input/meshes/numbered_mesh.hpp"

#include <algorithm>
#include <set>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "mesh/transform.hpp"

namespace corpuscle {

namespace {

using Numbers = std::unordered_map<std::int64_t, std::uint32_t>;
using Sets = std::map<std::string, NumberedMesh::Set>;
using Indices = std::vector<std::uint32_t>;

constexpr const char* write_again = "correct the file, or export the mesh again";

/// Corners of the faces of a solid in the order in which Abaqus numbers them, as bits; none for shells.
/// Source: Abaqus Elements Reference Guide, three-dimensional solid elements.
std::span<const unsigned> solid_faces_of(std::optional<ElementShape> shape)
{
    static constexpr std::array<unsigned, 4> tetrahedron{0b0111, 0b1011, 0b1110, 0b1101};
    static constexpr std::array<unsigned, 6> hexahedron{0b00001111, 0b11110000, 0b00110011, 0b01100110, 0b11001100, 0b10011001};
    if (shape == ElementShape::tetrahedron) return tetrahedron;
    if (shape == ElementShape::hexahedron) return hexahedron;
    return {};
}

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
        shapes_.reserve(elements.size());
        for (const NumberedMesh::Element& element : elements) {
            nodes_of_.push_back(nodes_of(element));
            shapes_.push_back(element.shape);
        }
    }

    [[nodiscard]] const std::array<std::uint32_t, 8>& nodes_of(std::size_t element) const { return nodes_of_[element]; }

    [[nodiscard]] Indices nodes_in(const std::string& key, const DeckPlace& place) { return nodes_in(node_sets_, key, place); }

    [[nodiscard]] Indices nodes_in(const Sets& sets, const std::string& key, const DeckPlace& place)
    {
        return resolve(sets, key, place, node_at_, "node", [this](const SetMember& member) {
            return member.elements ? nodes_of_elements(elements_in(member), member) : nodes_in(member.set, member.place);
        });
    }

    [[nodiscard]] Indices elements_in(const std::string& key, const DeckPlace& place)
    {
        return resolve(element_sets_, key, place, element_at_, "element",
                       [this](const SetMember& member) { return elements_in(member.set, member.place); });
    }

    /// The nodes of elements, or of the faces of theirs that a member of a surface means.
    [[nodiscard]] Indices nodes_of_elements(const Indices& elements, const SetMember& member = {})
    {
        Indices nodes;
        for (const std::uint32_t e : elements) {
            const unsigned wanted = member.face == 0 ? ~0u : corners_of_face(e, member);
            for (std::size_t i = 0; i < nodes_of_[e].size(); ++i)
                if (nodes_of_[e][i] != none && (wanted >> i & 1u) != 0) nodes.push_back(nodes_of_[e][i]);
        }
        make_unique(nodes);
        return nodes;
    }

private:
    static constexpr std::uint32_t none = 0xFFFFFFFFu;

    /// Elements that a member of a set of nodes means.
    [[nodiscard]] Indices elements_in(const SetMember& member)
    {
        if (!member.set.empty()) return elements_in(member.set, member.place);
        Indices indices;
        add_range(member, element_at_, "element", indices);
        return indices;
    }

    /// Bits of the corners of a face of an element, or of its free ones; all corners of a shell.
    [[nodiscard]] unsigned corners_of_face(std::uint32_t element, const SetMember& member)
    {
        const auto faces = solid_faces_of(shapes_[element]);
        if (member.face == SetMember::free_faces) {
            unsigned corners = faces.empty() ? ~0u : 0u;
            for (const unsigned face : faces)
                if (is_free(face_key(element, face))) corners |= face;
            return corners;
        }
        if (member.face > static_cast<int>(faces.size()))
            lines_.fail_at(member.place, fmt::format("an element of the surface has no side S{}", member.face), write_again);
        return faces[member.face - 1];
    }

    /// The nodes of a face of a solid, sorted.
    [[nodiscard]] std::array<std::uint32_t, 4> face_key(std::size_t element, unsigned face) const
    {
        std::array<std::uint32_t, 4> key{none, none, none, none};
        std::size_t count = 0;
        for (std::size_t i = 0; i < nodes_of_[element].size(); ++i)
            if ((face >> i & 1u) != 0) key[count++] = nodes_of_[element][i];
        std::sort(key.begin(), key.end());
        return key;
    }

    /// Whether only one solid of the file has that face.
    [[nodiscard]] bool is_free(const std::array<std::uint32_t, 4>& key)
    {
        if (faces_.empty()) {
            for (std::size_t e = 0; e < nodes_of_.size(); ++e)
                for (const unsigned face : solid_faces_of(shapes_[e])) faces_.push_back(face_key(e, face));
            std::sort(faces_.begin(), faces_.end());
        }
        const auto [first, last] = std::equal_range(faces_.begin(), faces_.end(), key);
        return last - first == 1;
    }

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
        if (!visiting_.insert({&sets, key}).second)
            lines_.fail_at(place, fmt::format("the set '{}' holds itself", key), "take the line out");
        Indices indices;
        for (const SetMember& member : found->second.members) {
            if (member.set.empty() && !member.elements) {
                add_range(member, at, what, indices);
            } else {
                const Indices more = other(member);
                indices.insert(indices.end(), more.begin(), more.end());
            }
        }
        visiting_.erase({&sets, key});
        make_unique(indices);
        return indices;
    }

    const DeckLines& lines_;
    const std::function<std::int64_t(std::int64_t)>& shown_;
    const Sets &node_sets_, &element_sets_;
    Numbers node_at_, element_at_;
    std::vector<std::array<std::uint32_t, 8>> nodes_of_;
    std::vector<std::optional<ElementShape>> shapes_;
    std::vector<std::array<std::uint32_t, 4>> faces_;  ///< of all solids, sorted; filled when first asked for
    std::set<std::pair<const Sets*, std::string>> visiting_;
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

NumberedMesh::Set& NumberedMesh::surface(const std::string& key, const std::string& name)
{
    return surfaces_.try_emplace(key, Set{name, {}}).first->second;
}

const NumberedMesh::Node* NumberedMesh::find_node(std::int64_t number)
{
    for (; nodes_seen_ < nodes_.size(); ++nodes_seen_) node_at_.emplace(nodes_[nodes_seen_].number, nodes_seen_);
    const auto found = node_at_.find(number);
    return found == node_at_.end() ? nullptr : &nodes_[found->second];
}

const NumberedMesh::Element* NumberedMesh::find_element(std::int64_t number)
{
    for (; elements_seen_ < elements_.size(); ++elements_seen_) element_at_.emplace(elements_[elements_seen_].number, elements_seen_);
    const auto found = element_at_.find(number);
    return found == element_at_.end() ? nullptr : &elements_[found->second];
}

std::vector<std::int64_t> NumberedMesh::nodes_in_set(const DeckLines& lines, const std::string& key)
{
    return numbers_in_set(lines, true, key);
}

std::vector<std::int64_t> NumberedMesh::elements_in_set(const DeckLines& lines, const std::string& key)
{
    return numbers_in_set(lines, false, key);
}

std::vector<std::int64_t> NumberedMesh::numbers_in_set(const DeckLines& lines, bool of_nodes, const std::string& key)
{
    std::vector<std::int64_t> members;
    add_numbers(lines, of_nodes, key, 0, members);
    const Sets& sets = of_nodes ? node_sets_ : element_sets_;
    if (!sets.at(key).as_listed) std::sort(members.begin(), members.end());
    std::unordered_set<std::int64_t> seen;
    std::erase_if(members, [&](std::int64_t number) { return !seen.insert(number).second; });
    return members;
}

/// Adds the members in a set, and in those that it names.
void NumberedMesh::add_numbers(const DeckLines& lines, bool of_nodes, const std::string& key, int depth, std::vector<std::int64_t>& members)
{
    constexpr int deepest_sets = 20;
    const Sets& sets = of_nodes ? node_sets_ : element_sets_;
    const auto found = sets.find(key);
    if (found == sets.end())
        lines.fail(fmt::format("there is no set of {} '{}' before this line", of_nodes ? "nodes" : "elements", shown_field(key)),
                   "define the set first, or correct its spelling");
    if (depth > deepest_sets) lines.fail(fmt::format("sets name one another, deeper than {}", deepest_sets), "correct the sets");
    const auto exists = [&](std::int64_t number) { return of_nodes ? find_node(number) != nullptr : find_element(number) != nullptr; };
    for (const SetMember& member : found->second.members) {
        if (of_nodes && member.elements) {
            for (const std::int64_t number : elements_in_set(lines, member.set))
                if (const Element* element = find_element(number))
                    members.insert(members.end(), element->node.begin(), element->node.begin() + element->corners);
        } else if (!member.set.empty()) {
            add_numbers(lines, of_nodes, member.set, depth + 1, members);
        } else {
            constexpr std::int64_t most = 1'000'000'000;
            if (member.step < 1 || (member.last - member.first) / member.step > most)
                lines.fail(fmt::format("the set '{}' has a range that is too long", shown_field(key)), "correct the range");
            for (std::int64_t number = member.first; number <= member.last; number += member.step)
                if (exists(number)) members.push_back(number);
        }
    }
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
    const auto add_sets = [&](Sets& sets, const Sets& others) {
        for (const auto& [name, set] : others) {
            sets[key + "." + name] = {prefix + "." + set.name, shifted(set.members, shift, key)};
            Set& all = sets.try_emplace(name, Set{set.name, {}}).first->second;
            all.members.push_back({0, 0, 1, key + "." + name, false, {}, 0});
        }
    };
    add_sets(node_sets_, other.node_sets_);
    add_sets(element_sets_, other.element_sets_);
    for (const auto& [name, set] : other.surfaces_) {
        const std::vector<SetMember> members = shifted(set.members, shift, key);
        surfaces_[key + "." + name] = {prefix + "." + set.name, members};
        Set& all = surfaces_.try_emplace(name, Set{set.name, {}}).first->second;
        all.members.insert(all.members.end(), members.begin(), members.end());
    }
    for (Sets* sets : {&node_sets_, &element_sets_}) (*sets)[key] = {prefix, {{shift, shift + numbers - 1, 1, "", false, {}, 0}}};
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
    for (const auto& [key, set] : surfaces_) {
        const bool taken = mesh.node_sets.contains(set.name);
        mesh.node_sets[(taken ? "surface " : "") + set.name] = resolver.nodes_in(surfaces_, key, {});
    }
    if (mesh.elements.empty())
        lines.fail_at({}, "the file has no shells, tetrahedra or hexahedra", "export a mesh with elements, not of nodes or geometry alone");
    remove_unused_nodes(mesh);
    return mesh;
}

void mirror(NumberedMesh::Element& element)
{
    auto& node = element.node;
    if (element.corners == 3 || element.shape == ElementShape::tetrahedron) std::swap(node[1], node[2]);
    if (element.shape == ElementShape::quadrilateral || element.corners == 8) std::swap(node[1], node[3]);
    if (element.corners == 8) std::swap(node[5], node[7]);
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
