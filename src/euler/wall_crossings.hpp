#pragma once

#include <span>
#include <vector>

#include "euler/grid.hpp"
#include "mesh/surface.hpp"

namespace corpuscle {

/// Edges that only one facet has, hidden ones left out: bit e of a facet's number stands for the edge across from its node e.
[[nodiscard]] std::vector<std::uint8_t> free_edges(const Surface& surface);

/// Where the lines through the cells' middles along the grid's axes meet the surface's facets that are not hidden, with nodes at `nodes`
/// [m], sorted along the faces of the grid. Two facets judge their common edge by the same number, so no line slips between them; at
/// edges in `free` (see free_edges) it reaches over by a twentieth of a cell, so that parts which lie flush with each other are tight.
/// The middles are moved aside by some 1e-6 of a cell, so that a surface laid through them has them on one side.
[[nodiscard]] std::vector<WallCrossing> find_crossings(const EulerGrid& grid, const Surface& surface, std::span<const std::uint8_t> free,
                                                       std::span<const Vector3d> nodes);

/// A cell whose middle was passed by the surface, the first facet that did, and its unit normal.
struct SweptCell {
    std::size_t cell = 0;
    std::uint32_t facet = 0;
    Vector3d normal;
    bool solid = false;   ///< the facet is the face of a solid ...
    bool within = false;  ///< ... that the cell now lies in
};

/// The cells whose middles the facets pass as the nodes go straight from start to end, in ascending order.
[[nodiscard]] std::vector<SweptCell> swept_cells(const EulerGrid& grid, const Surface& surface, const NodePath& nodes);

}  // namespace corpuscle
