#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "math/box.hpp"

namespace corpuscle {

/// A block of a lattice's cells, from layer `low` to layer `high` in each direction; empty where a high lies below its low.
struct CellBlock {
    std::array<std::int32_t, 3> low{0, 0, 0}, high{-1, -1, -1};

    [[nodiscard]] std::int32_t layers(int axis) const { return std::max(0, high[axis] - low[axis] + 1); }
    [[nodiscard]] std::size_t cells() const { return static_cast<std::size_t>(layers(0)) * layers(1) * layers(2); }
    /// Number of one of its cells, those of a row (along x) one after the other.
    [[nodiscard]] std::size_t index(const std::array<std::int32_t, 3>& c) const
    {
        return (static_cast<std::size_t>(c[2] - low[2]) * layers(1) + (c[1] - low[1])) * layers(0) + (c[0] - low[0]);
    }
    /// The cells that both have.
    [[nodiscard]] CellBlock meet(const CellBlock& other) const
    {
        CellBlock both = *this;
        for (int axis = 0; axis < 3; ++axis) {
            both.low[axis] = std::max(low[axis], other.low[axis]);
            both.high[axis] = std::min(high[axis], other.high[axis]);
        }
        return both;
    }
    [[nodiscard]] CellBlock widened(std::int32_t layers_more) const
    {
        CellBlock wide = *this;
        for (int axis = 0; axis < 3; ++axis) {
            wide.low[axis] -= layers_more;
            wide.high[axis] += layers_more;
        }
        return wide;
    }
    /// The smallest block about both.
    CellBlock& operator+=(const CellBlock& other)
    {
        if (other.cells() == 0) return *this;
        if (cells() == 0) return *this = other;
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], other.low[axis]);
            high[axis] = std::max(high[axis], other.high[axis]);
        }
        return *this;
    }
};

/// Cubes of one size that fill a box. Without cells its box is empty.
struct Lattice {
    static constexpr double nowhere = std::numeric_limits<double>::infinity();

    Vector3d lower{nowhere, nowhere, nowhere}, upper{-nowhere, -nowhere, -nowhere};  ///< of the box [m]
    double size = 1;                                                                 ///< of a cell [m]
    double inverse_size = 1;                                                         ///< [1/m]
    std::array<std::int32_t, 3> count{0, 0, 0};

    /// Layer of cells at so many cell sizes (at most 1e9) from the lower face, the outermost beyond it.
    [[nodiscard]] std::int32_t layer(double sizes, int axis) const
    {
        return std::clamp(static_cast<std::int32_t>(sizes), 0, count[axis] - 1);
    }
    /// The cells that a box meets, those nearest to it if it lies outside.
    [[nodiscard]] CellBlock block(const Box& box) const
    {
        CellBlock met;
        for (int axis = 0; axis < 3; ++axis) {
            met.low[axis] = layer((box.lower[axis] - lower[axis]) * inverse_size, axis);
            met.high[axis] = layer((box.upper[axis] - lower[axis]) * inverse_size, axis);
        }
        return met;
    }
    /// All cells.
    [[nodiscard]] CellBlock all() const { return {{0, 0, 0}, {count[0] - 1, count[1] - 1, count[2] - 1}}; }
};

}  // namespace corpuscle
