#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "input/meshes/deck_lines.hpp"
#include "mesh/mesh.hpp"

namespace corpuscle {

/// What a set is said to hold: one number or every one of a range, or what another set holds.
struct SetMember {
    std::int64_t first = 0, last = 0, step = 1;  ///< a single number must exist, of a range those count that do
    std::string set;                             ///< if not empty, the set meant instead
    bool elements = false;                       ///< that set is one of elements, its nodes are meant
    DeckPlace place;
};

/// A mesh by the numbers its file gives nodes and elements, in whatever order they come. Sets may name what is not there yet.
class NumberedMesh {
public:
    struct Set {
        std::string name;  ///< as first written; the key may be in capitals
        std::vector<SetMember> members;
    };
    /// An element by its nodes' numbers. Elements without a shape (points, lines) are not kept, but their nodes are in the sets.
    struct Element {
        std::int64_t number = 0;
        std::optional<ElementShape> shape;
        int corners = 0;
        std::array<std::int64_t, 8> node{};
        DeckPlace place;
    };
    struct Node {
        std::int64_t number = 0;
        Vector3d position;
        DeckPlace place;
    };

    void add_node(const Node& node) { nodes_.push_back(node); }
    void add_element(const Element& element) { elements_.push_back(element); }
    /// The set of that key, empty if new.
    Set& node_set(const std::string& key, const std::string& name);
    Set& element_set(const std::string& key, const std::string& name);
    [[nodiscard]] bool empty() const { return nodes_.empty() && elements_.empty(); }

    /// Adds another mesh, all its numbers greater by `shift`, its nodes put in place by `placed`; its sets as "prefix.name", united with
    /// those of other such meshes as "name", and "prefix" for the whole.
    void add(const NumberedMesh& other, std::int64_t shift, const std::string& prefix,
             const std::function<Vector3d(const Vector3d&)>& placed);

    /// Elements and sets with numbers resolved. `shown` turns a number into the file's own. Refuses, at the line they stand in, elements
    /// and sets with nodes or elements that the file does not have, and numbers given twice.
    [[nodiscard]] Mesh mesh(const DeckLines& lines, const std::function<std::int64_t(std::int64_t)>& shown) const;

    /// Numbers of one mesh stay below this; others begin at its multiples.
    static constexpr std::int64_t numbers = std::int64_t{1} << 40;

private:
    std::vector<Node> nodes_;
    std::vector<Element> elements_;
    std::map<std::string, Set> node_sets_, element_sets_;
};

/// The shape of a surface element or a solid from its corners in the order of its file, repeated corners left out: triangle or
/// quadrilateral of 4, tetrahedron or hexahedron of 8. Refuses wedges and pyramids at the present line.
[[nodiscard]] NumberedMesh::Element surface_element(const DeckLines& lines, std::int64_t number, std::array<std::int64_t, 4> corners);
[[nodiscard]] NumberedMesh::Element solid_element(const DeckLines& lines, std::int64_t number, const std::array<std::int64_t, 8>& corners);

}  // namespace corpuscle
