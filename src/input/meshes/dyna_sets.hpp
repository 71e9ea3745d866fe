#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "input/meshes/dyna_cards.hpp"
#include "input/meshes/numbered_mesh.hpp"

namespace corpuscle {

/// Shells and solids of a deck may have the same numbers: those of solids are kept apart by this.
constexpr std::int64_t dyna_solid_numbers = NumberedMesh::numbers / 2;

/// What a set of an LS-DYNA deck is of.
enum class DynaSetKind { nodes, parts, shells, solids, segments };

/// Reads the sets of an LS-DYNA deck into sets of a mesh: by number ("node_set_7", "part_set_7", ...), and by title if they have one.
class DynaSets {
public:
    DynaSets(DynaCards& cards, NumberedMesh& mesh) : cards_(cards), mesh_(mesh) {}

    /// Begins a set with the options of its keyword; false if sets with these are not read.
    [[nodiscard]] bool begin(DynaSetKind kind, const std::string& options);
    /// Takes up a card of the set: its title, its number, then its members.
    void read();
    /// Puts in the parts that sets name, once all elements have come. Returns the numbers of parts named that have none.
    [[nodiscard]] std::set<std::int64_t> add_parts(const std::set<std::int64_t>& parts_with_elements);
    /// The name of the set of nodes of that number.
    [[nodiscard]] static std::string node_set_name(std::int64_t id);

private:
    /// Parts from first to last that a set is to hold, or their nodes.
    struct Parts {
        NumberedMesh::Set* set = nullptr;
        std::int64_t first = 0, last = 0;
        bool nodes = false;
        DeckPlace place;
    };

    void open_set();
    void read_general();
    void read_ranges();
    void add(DynaSetKind kind, std::int64_t first, std::int64_t last, std::int64_t step = 1);
    void add_set(const std::string& name, bool of_elements);
    [[nodiscard]] std::int64_t shift_of(DynaSetKind kind) const;

    DynaCards& cards_;
    NumberedMesh& mesh_;
    DynaSetKind kind_ = DynaSetKind::nodes;
    std::string form_, title_;
    bool titled_ = false;  ///< the next line is the title
    NumberedMesh::Set* set_ = nullptr;
    std::vector<Parts> parts_;
};

/// A number from 0 on (0 where the field is blank or missing), and one that must be there. Refused at the present line.
[[nodiscard]] std::int64_t dyna_number(const DynaCards& cards, const std::vector<std::string_view>& fields, std::size_t index,
                                       const char* what);
[[nodiscard]] std::int64_t dyna_needed(const DynaCards& cards, const std::vector<std::string_view>& fields, std::size_t index,
                                       const char* what);
/// The number as the whole deck knows it, of one in a file whose numbers are shifted.
[[nodiscard]] std::int64_t dyna_shifted(const DynaCards& cards, std::int64_t number, std::int64_t shift);

}  // namespace corpuscle
