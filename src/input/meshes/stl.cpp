#include "input/meshes/stl.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "input/meshes/deck_lines.hpp"
#include "mesh/measure.hpp"
#include "mesh/transform.hpp"

namespace corpuscle {

namespace {

constexpr std::size_t header_bytes = 84, triangle_bytes = 50;
constexpr double coincident = 1e-7;  // of the body's diagonal

/// Number of triangles a binary file of these bytes announces.
std::uint32_t announced_triangles(std::string_view bytes)
{
    std::uint32_t count = 0;
    if (bytes.size() >= header_bytes) std::memcpy(&count, bytes.data() + header_bytes - sizeof(count), sizeof(count));
    return count;
}

/// Some writers put bytes behind the last triangle. Text has letters where the number of triangles stands: a number far too large.
bool is_binary(std::string_view bytes)
{
    const std::uint64_t count = announced_triangles(bytes), needed = header_bytes + triangle_bytes * count;
    return bytes.size() == needed || (count > 0 && bytes.size() > needed);
}

bool is_text(std::string_view bytes)
{
    const std::string start = in_capitals(bytes.substr(0, 2000));
    const std::size_t first = start.find_first_not_of(" \t\r\n");
    if (first == std::string::npos || !std::string_view(start).substr(first).starts_with("SOLID")) return false;
    return start.find("FACET") != std::string::npos || start.find("ENDSOLID") != std::string::npos;
}

void add_triangle(Mesh& mesh, const std::array<Vector3d, 3>& corners)
{
    const auto first = static_cast<std::uint32_t>(mesh.nodes.size());
    mesh.nodes.insert(mesh.nodes.end(), corners.begin(), corners.end());
    mesh.elements.push_back({ElementShape::triangle, {first, first + 1, first + 2}});
}

Vector3d real_vector(Scanner& scanner, const char* what)
{
    const double x = scanner.real(what), y = scanner.real(what), z = scanner.real(what);
    return {x, y, z};
}

Mesh read_binary(Scanner& scanner)
{
    scanner.set_binary(true);
    Mesh mesh;
    for (std::size_t i = 0; i + sizeof(std::uint32_t) < header_bytes; ++i) scanner.bytes<std::byte>("the header");
    const auto count = scanner.bytes<std::uint32_t>("the number of triangles");
    const auto vector = [&] {
        const float x = scanner.bytes<float>("a coordinate"), y = scanner.bytes<float>("a coordinate"),
                    z = scanner.bytes<float>("a coordinate");
        return Vector3d(Vector3f{x, y, z});
    };
    for (std::uint32_t i = 0; i < count; ++i) {
        vector();  // the normal: the order of the corners says the same
        std::array<Vector3d, 3> corners;
        for (Vector3d& corner : corners) {
            corner = vector();
            if (!std::isfinite(norm_squared(corner)))
                scanner.fail(fmt::format("triangle {} has a corner that is not a number", i + 1), "export the surface again");
        }
        add_triangle(mesh, corners);
        scanner.bytes<std::uint16_t>("the attribute of a triangle");
    }
    return mesh;
}

/// Whether a word is the one wanted, in small or capital letters.
bool is_word(std::string_view word, std::string_view wanted)
{
    return word == wanted || in_capitals(word) == in_capitals(wanted);
}

void expect(Scanner& scanner, std::string_view wanted)
{
    const std::string_view word = scanner.word(std::string(wanted).c_str());
    if (!is_word(word, wanted))
        scanner.fail(fmt::format("'{}' where '{}' was expected", word.substr(0, 40), wanted), "export the surface again, or as binary STL");
}

/// The corners of one facet, of which "facet" has been read.
std::array<Vector3d, 3> read_facet(Scanner& scanner)
{
    expect(scanner, "normal");
    for (int i = 0; i < 3; ++i) scanner.word("a normal");  // some writers put "nan" for triangles without area
    expect(scanner, "outer");
    expect(scanner, "loop");
    std::array<Vector3d, 3> corners;
    for (Vector3d& corner : corners) {
        expect(scanner, "vertex");
        corner = real_vector(scanner, "a coordinate");
    }
    expect(scanner, "endloop");
    expect(scanner, "endfacet");
    return corners;
}

Mesh read_text(Scanner& scanner)
{
    Mesh mesh;
    while (!scanner.at_end()) {
        expect(scanner, "solid");
        std::string name(trimmed_field(scanner.line()));
        const auto first = static_cast<std::uint32_t>(mesh.elements.size());
        for (std::string_view word = scanner.word("facet or endsolid"); !is_word(word, "endsolid");
             word = scanner.word("facet or endsolid")) {
            if (!is_word(word, "facet"))
                scanner.fail(fmt::format("'{}' where 'facet' or 'endsolid' was expected", word.substr(0, 40)), "export the surface again");
            add_triangle(mesh, read_facet(scanner));
        }
        scanner.line();
        if (name.empty()) name = "solid";
        for (std::uint32_t e = first; e < mesh.elements.size(); ++e) mesh.element_sets[name].push_back(e);
    }
    return mesh;
}

/// Drops triangles with two corners on one node.
void remove_collapsed(Mesh& mesh)
{
    std::vector<MeshElement> kept;
    std::vector<std::uint32_t> index(mesh.elements.size(), 0xFFFFFFFFu);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const auto& node = mesh.elements[e].node;
        if (node[0] == node[1] || node[1] == node[2] || node[2] == node[0]) continue;
        index[e] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(mesh.elements[e]);
    }
    mesh.elements = std::move(kept);
    for (auto& [name, set] : mesh.element_sets) {
        std::erase_if(set, [&](std::uint32_t element) { return index[element] == 0xFFFFFFFFu; });
        for (std::uint32_t& element : set) element = index[element];
    }
}

}  // namespace

bool looks_like_stl(const Scanner& scanner)
{
    return is_binary(scanner.rest()) || is_text(scanner.rest());
}

Mesh read_stl(Scanner scanner)
{
    const std::string_view bytes = scanner.rest();
    if (!is_binary(bytes) && !is_text(bytes)) {
        const std::uint64_t expected = header_bytes + std::uint64_t{triangle_bytes} * announced_triangles(bytes);
        scanner.set_binary(true);
        scanner.fail(fmt::format("neither text STL nor binary STL ({} triangles announced: {} bytes expected, the file has {})",
                                 announced_triangles(bytes), expected, bytes.size()),
                     "the file may be cut short: export it again");
    }
    Mesh mesh = is_binary(bytes) ? read_binary(scanner) : read_text(scanner);
    if (mesh.elements.empty())
        scanner.fail("the surface has no triangles", "in gmsh, set Mesh.SaveAll = 1 or make a physical group of the surfaces");
    merge_nodes(mesh, coincident * diagonal(mesh));
    remove_collapsed(mesh);
    remove_unused_nodes(mesh);
    if (mesh.elements.empty()) scanner.fail("all triangles of the surface are without area", "export the surface again");
    return mesh;
}

}  // namespace corpuscle
