#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace corpuscle {

/// A face of a solid element, its corners in the order in which it faces out of that element.
struct SolidFace {
    std::array<std::uint32_t, 4> node{};
    int corners = 4;                    ///< 3 or 4
    std::uint32_t element = 0;          ///< whose face it is
    std::uint32_t other = 0xFFFFFFFFu;  ///< the element on its other side
    static constexpr std::uint32_t none = 0xFFFFFFFFu;

    [[nodiscard]] bool is_outer() const { return other == none; }
};

/// Every face of every tetrahedron and hexahedron once, in the order in which the elements show them first. Surface elements have none.
[[nodiscard]] std::vector<SolidFace> solid_faces(std::span<const MeshElement> elements);

}  // namespace corpuscle
