#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "math/vector3.hpp"

namespace corpuscle {

/// A triangle of a body's surface, met by gas from both sides. Its normal follows the right hand over its nodes.
struct Facet {
    std::array<std::uint32_t, 3> node{};
    std::uint32_t element = 0;  ///< the element it belongs to, over all parts
    std::uint32_t part = 0;
    std::uint32_t other = no_element;  ///< the element on its other side, of solids
    bool solid = false;                ///< it is the face of a solid, its normal out of `element`

    static constexpr std::uint32_t no_element = 0xFFFFFFFFu;
};

/// Surface of the structure: facets over shared nodes.
struct Surface {
    std::vector<Facet> facets;
    std::vector<std::uint8_t> hidden;  ///< of each facet, 1: it is not there, its element eroded or both its sides solid
    std::vector<std::uint8_t> turned;  ///< of each facet, 1: the solid lies on its other side, for its own element has eroded

    [[nodiscard]] bool is_hidden(std::size_t facet) const { return facet < hidden.size() && hidden[facet] != 0; }
    [[nodiscard]] bool is_turned(std::size_t facet) const { return facet < turned.size() && turned[facet] != 0; }
};

/// Where the nodes of a surface are at both ends of a step; in between they move on straight lines. [m]
struct NodePath {
    std::span<const Vector3d> start;
    std::span<const Vector3d> end;

    [[nodiscard]] Vector3d at(std::uint32_t node, double fraction) const { return start[node] + fraction * (end[node] - start[node]); }
};

}  // namespace corpuscle
