#pragma once

#include <cstddef>
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

/// A box of the curve whose particles are sorted together. Buckets fill the domain without gaps, empty ones included.
struct Bucket {
    std::uint64_t start_key = 0;
    std::uint32_t first = 0;  ///< particle
    std::uint32_t depth = 0;
};

/// How the sorted particles are cut.
struct Cells {
    CellCurve curve;
    std::vector<Cell> cells;      ///< in which partners are drawn
    std::vector<Cell> groups;     ///< larger boxes that hold whole cells: their density gives the virial pressure
    std::vector<Bucket> buckets;  ///< in the order of the curve; one more ends the last
    std::size_t sort_bytes = 0;   ///< that the last sort needed besides
};

}  // namespace corpuscle
