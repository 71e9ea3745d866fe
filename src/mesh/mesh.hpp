#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "math/vector3.hpp"

namespace corpuscle {

/// Kinds of elements a mesh can hold.
enum class ElementShape : std::uint8_t { triangle, quadrilateral, tetrahedron, hexahedron };

[[nodiscard]] constexpr int node_count(ElementShape shape)
{
    switch (shape) {
        case ElementShape::triangle: return 3;
        case ElementShape::quadrilateral:
        case ElementShape::tetrahedron: return 4;
        case ElementShape::hexahedron: break;
    }
    return 8;
}

/// One element of a mesh: its corners, as indices of the mesh's nodes.
struct MeshElement {
    ElementShape shape = ElementShape::quadrilateral;
    std::array<std::uint32_t, 8> node{};
    std::int64_t number = 0;  ///< in the file it was read from, for people; 0: none
};

/// A mesh as a mesher gives it: nodes, elements and named sets of both; no physics. Lengths in m.
struct Mesh {
    std::vector<Vector3d> nodes;
    std::vector<MeshElement> elements;
    std::map<std::string, std::vector<std::uint32_t>> node_sets;     ///< e.g. "rim", "x=0"
    std::map<std::string, std::vector<std::uint32_t>> element_sets;  ///< e.g. a gmsh physical group
    std::vector<std::string> remarks;                                ///< what of the file was left out, for people
};

}  // namespace corpuscle
