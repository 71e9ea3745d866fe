#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/vector3.hpp"

namespace corpuscle {

/// Stands for a cell beyond the edge of the grid.
inline constexpr std::size_t no_cell = static_cast<std::size_t>(-1);

/// Where the straight line between two neighbouring cells' middles meets a facet of a moving surface.
struct WallCrossing {
    std::uint8_t axis = 0;           ///< that the line runs along
    std::size_t face = 0;            ///< of the grid between the two cells, as EulerWalls::face_number counts
    double place = 0;                ///< coordinate along the axis [m]
    std::uint32_t facet = 0;         ///< of the surface
    std::array<double, 3> weight{};  ///< of the facet's nodes where it is met: none below 0, their sum is 1
    Vector3d normal;                 ///< of the facet, a unit vector with a positive part along the axis
    bool solid = false;              ///< the facet is the face of a solid
    bool enters = false;             ///< and the solid lies beyond it along the axis
    bool beyond_rim = false;         ///< the line passes the facet: only its rim reaches over to it
};

/// A face of the grid that is shut because the surface lies between the two cells' middles. Each cell meets the crossing nearest to it.
struct WallFace {
    WallCrossing near_lower, near_upper;
    std::size_t lower = no_cell, upper = no_cell;  ///< the cells on its two sides
    std::array<std::size_t, 3> place{};            ///< of the upper cell along the axes (one beyond the last at an upper edge)
    double lower_length = 0, upper_length = 0;     ///< from each cell's middle to its crossing [m]
    double shift = 0;                              ///< of the wall from the face towards the upper cell, the mean of both crossings [m]
    Vector3d normal;                               ///< mean of both, unit, its part along the axis positive
    Vector3d area;                                 ///< of the wall, from the lower cell to the upper [m2]
    bool beyond_rim = false;                       ///< nothing is met but what rims reach over to
};

/// An opening between two cells that touch along an edge only, around the wall in a third: see docs/theory/euler.md.
struct WallCorner {
    std::size_t from = 0, to = 0;
    Vector3d area;  ///< from the first to the second [m2]
};

/// What walls and corners give to a cell, per time.
struct WallSource {
    std::array<double, 4> mass{};     ///< of each material [kg/s]
    std::array<double, 4> share{};    ///< of the volume, less what the divergence takes [m3/s]
    std::array<double, 4> part{};     ///< internal energy of each material [W]
    std::array<double, 4> unburnt{};  ///< of what waits to burn [kg/s]
    Vector3d momentum;                ///< [N]
    double energy = 0;                ///< [W]
};

/// Moving walls in a grid: which faces are shut, how much of the others is open, how much room each cell has.
/// Without walls all arrays are empty.
struct EulerWalls {
    std::vector<WallFace> faces;
    std::vector<WallCorner> corners;
    std::vector<double> room, room_next;              ///< of each cell, over its volume without walls; at the end of the step
    std::array<std::vector<double>, 3> open;          ///< of each face across an axis, over its area without walls
    std::array<std::vector<std::int32_t>, 3> shut;    ///< number in `faces` of each face across an axis, -1: not shut
    std::vector<std::array<std::size_t, 2>> widened;  ///< axis and number of the faces that are partly open
    std::vector<std::size_t> touched;                 ///< cells whose room is not that without walls
    std::vector<std::size_t> source_cells;            ///< cells that walls or corners give to
    std::vector<WallSource> sources;                  ///< of these cells
    std::vector<std::int32_t> source_of;              ///< number in `sources` of each cell, -1: none
    std::vector<std::uint8_t> solid;                  ///< of each cell, 1: it lies within a solid and holds no gas; empty without solids
    bool voids = false;                               ///< among them are cells of hollows that solids have left, where no gas has come yet
    std::uint64_t squeezed = 0;                       ///< cells passed by a wall whose gas had no way to stay on its side

    [[nodiscard]] bool any() const { return !room.empty(); }
    [[nodiscard]] bool is_solid(std::size_t cell) const { return !solid.empty() && solid[cell] != 0; }
};

}  // namespace corpuscle
