#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "gas/gas.hpp"

namespace corpuscle {

/// Finds the spheres of one species that may be met: they are listed by where they are at the start of a step, in cubes that a
/// hash gives a place in one table, so that neither empty space nor a thousandfold density costs memory.
class SphereGrid {
public:
    /// Lists the given particles of a species, none of which goes farther than `travel` [m] in the step; cubes of side at least `side` [m].
    SphereGrid(const Gas& gas, std::vector<std::uint32_t> particles, double travel, double side);

    /// Farthest way of any sphere in the step [m].
    [[nodiscard]] double travel() const { return travel_; }
    /// Side of a cube [m].
    [[nodiscard]] double side() const { return side_; }
    [[nodiscard]] const std::vector<std::uint32_t>& particles() const { return particles_; }

    /// visit(particle) for every sphere that is listed in a cube that meets the box [m], in an order that does not depend on threads.
    template <class Visit>
    void visit(const Vector3d& lower, const Vector3d& upper, const Visit& visit) const
    {
        const std::array<std::int64_t, 3> from = cube_of(lower), to = cube_of(upper);
        for (std::int64_t z = from[2]; z <= to[2]; ++z)
            for (std::int64_t y = from[1]; y <= to[1]; ++y)
                for (std::int64_t x = from[0]; x <= to[0]; ++x) {
                    const std::uint64_t key = key_of({x, y, z});
                    const std::size_t slot = slot_of(key);
                    for (std::uint32_t k = start_[slot]; k < start_[slot + 1]; ++k)
                        if (keys_[k] == key) visit(particles_[k]);
                }
    }

private:
    static constexpr std::int64_t most_cubes = 1 << 20;  ///< along an axis

    [[nodiscard]] std::array<std::int64_t, 3> cube_of(const Vector3d& place) const
    {
        std::array<std::int64_t, 3> cube{};
        for (int a = 0; a < 3; ++a) {
            const double sides = (place[a] - lower_[a]) * inverse_side_;
            const double inside = sides > 0 ? std::min(sides, static_cast<double>(most_cubes)) : 0.0;  // 0 for what is no number, too
            cube[static_cast<std::size_t>(a)] = static_cast<std::int64_t>(inside);
        }
        return cube;
    }
    [[nodiscard]] static std::uint64_t key_of(const std::array<std::int64_t, 3>& cube)
    {
        return static_cast<std::uint64_t>(cube[0]) | static_cast<std::uint64_t>(cube[1]) << 21 | static_cast<std::uint64_t>(cube[2]) << 42;
    }
    [[nodiscard]] std::size_t slot_of(std::uint64_t key) const
    {
        return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15u) >> (64 - slot_bits_));
    }

    double travel_ = 0, side_ = 0, inverse_side_ = 0;
    Vector3d lower_;
    int slot_bits_ = 1;
    std::vector<std::uint32_t> particles_;  ///< by slot
    std::vector<std::uint64_t> keys_;       ///< cube of each
    std::vector<std::uint32_t> start_;      ///< of each slot, and the end
};

}  // namespace corpuscle
