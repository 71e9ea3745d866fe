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
    bool elements = false;                       ///< that set, or these numbers, are of elements, whose nodes are meant
    DeckPlace place;
    int face = 0;  ///< of those elements, as Abaqus numbers sides of solids from 1; 0: all nodes

    static constexpr int free_faces = -1;  ///< all faces of solids that no other has
};

/// A mesh by the numbers its file gives nodes and elements, in whatever order they come. Sets may name what is not there yet.
class NumberedMesh {
public:
    struct Set {
        std::string name;  ///< as first written; the key may be in capitals
        std::vector<SetMember> members;
        bool as_listed = false;  ///< their order counts; else it is that of the numbers
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
    /// A surface, as a set of nodes; one that has the name of a set of nodes or elements is "surface NAME".
    Set& surface(const std::string& key, const std::string& name);

    /// The node or element of a number that has been added, null if there is none. Good until the next is added.
    [[nodiscard]] const Node* find_node(std::int64_t number);
    [[nodiscard]] const Element* find_element(std::int64_t number);
    /// The numbers in a set so far, each once, in the order of the set. Refuses, at the present line, a set that is not there.
    [[nodiscard]] std::vector<std::int64_t> nodes_in_set(const DeckLines& lines, const std::string& key);
    [[nodiscard]] std::vector<std::int64_t> elements_in_set(const DeckLines& lines, const std::string& key);
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
    using Sets = std::map<std::string, Set>;
    using Places = std::unordered_map<std::int64_t, std::size_t>;

    void add_numbers(const DeckLines& lines, bool of_nodes, const std::string& key, int depth, std::vector<std::int64_t>& members);
    [[nodiscard]] std::vector<std::int64_t> numbers_in_set(const DeckLines& lines, bool of_nodes, const std::string& key);

    std::vector<Node> nodes_;
    std::vector<Element> elements_;
    Sets node_sets_, element_sets_, surfaces_;
    Places node_at_, element_at_;                     ///< of those that have been looked through
    std::size_t nodes_seen_ = 0, elements_seen_ = 0;  ///< how many have been
};

/// Turns the order of an element's corners round, so that it is right in a mirror.
void mirror(NumberedMesh::Element& element);

/// The shape of a surface element or a solid from its corners in the order of its file, repeated corners left out: triangle or
/// quadrilateral of 4, tetrahedron or hexahedron of 8. Refuses wedges and pyramids at the present line.
[[nodiscard]] NumberedMesh::Element surface_element(const DeckLines& lines, std::int64_t number, std::array<std::int64_t, 4> corners);
[[nodiscard]] NumberedMesh::Element solid_element(const DeckLines& lines, std::int64_t number, const std::array<std::int64_t, 8>& corners);

}  // namespace corpuscle
