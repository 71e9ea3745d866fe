#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "input/meshes/abaqus_words.hpp"
#include "input/meshes/affine_map.hpp"
#include "input/meshes/numbered_mesh.hpp"

namespace corpuscle {

/// What makes nodes and elements of others in an Abaqus file: *NGEN, *NFILL (straight and even), *NCOPY, *ELGEN, *ELCOPY.
/// Source: Abaqus Keywords Reference Guide.
class AbaqusMaker {
public:
    explicit AbaqusMaker(const DeckLines& lines) : lines_(lines) {}

    [[nodiscard]] static bool knows(const std::string& keyword);
    /// Begins a keyword, for that mesh; `read` takes each data line, `finish` does what needs all of them.
    void begin(const AbaqusKeyword& keyword, NumberedMesh& mesh);
    void read();
    void finish();

private:
    using Numbers = std::vector<std::int64_t>;

    /// Copies along one direction: how many with the first, and what is added to numbers of nodes and elements.
    struct Row {
        std::int64_t count = 1, nodes = 0, elements = 0;
    };

    [[nodiscard]] std::int64_t option(const char* name) const;
    [[nodiscard]] Numbers whole_fields(std::size_t least) const;
    [[nodiscard]] const Vector3d& place_of(std::int64_t node);
    void add_node(std::int64_t number, const Vector3d& place);
    void add_between(std::int64_t first, std::int64_t last, std::int64_t intervals, std::int64_t increment, const char* what);
    void generate_nodes();
    void fill_nodes();
    void generate_elements();
    void add_copy(const NumberedMesh::Element& master, std::int64_t nodes, std::int64_t elements, bool mirrored = false);
    void copy_nodes();
    void copy_elements();
    [[nodiscard]] AffineMap copy_map() const;
    [[nodiscard]] AffineMap shift_map() const;

    const DeckLines& lines_;
    NumberedMesh* mesh_ = nullptr;
    NumberedMesh::Set* set_ = nullptr;  ///< that what is made belongs to
    AbaqusKeyword keyword_;
    DeckPlace place_;                        ///< of the keyword
    std::vector<std::vector<double>> data_;  ///< of *NCOPY
};

}  // namespace corpuscle
