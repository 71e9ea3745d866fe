#pragma once

#include <cstdint>
#include <vector>

#include "gas/curve.hpp"

namespace corpuscle {

/// A box of the curve and the particles in it: a run of the sorted array. 8 bytes.
struct Cell {
    std::uint32_t first = 0;
    std::uint32_t count : 24 = 0;
    std::uint32_t depth : 8 = 0;  ///< how often the domain was halved

    [[nodiscard]] std::uint32_t end() const { return first + count; }
};

/// A run of the curve that is sorted as one piece: from its start key to the next bucket's.
struct Bucket {
    std::uint64_t start_key = 0;
    std::uint32_t first = 0;
};

/// How the sorted particles are cut.
struct Cells {
    CellCurve curve;
    std::vector<std::uint64_t> keys;  ///< of the sorted particles
    std::vector<Cell> cells;          ///< in which partners are drawn
    std::vector<Cell> groups;         ///< larger boxes that hold whole cells: their density gives the virial pressure
    std::vector<Bucket> buckets;      ///< for the next sort; one more ends the last
    std::size_t sort_bytes = 0;       ///< that the last sort needed besides
};

/// Cuts sorted keys by halving boxes until none holds more than `limit` (unless keys are equal): the boxes with something in
/// them, in order. The cut depends on the keys alone: not on threads, not on the past.
[[nodiscard]] std::vector<Cell> cut(const std::vector<std::uint64_t>& keys, std::uint32_t limit);

}  // namespace corpuscle
