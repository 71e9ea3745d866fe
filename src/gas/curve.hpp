#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "math/box.hpp"

namespace corpuscle {

/// A space-filling curve through a box by repeated halving: bit d of a key says which half of the box of depth d a point is
/// in, each box being halved across its longest side. In a cube this is Morton's curve (1966); in any other box cells keep
/// sides within 1:2 and still fill the box exactly. 63 bits a key, at most 24 a direction (a float knows no more).
class CellCurve {
public:
    static constexpr int depth_limit = 63;

    /// Whole numbers of smallest steps along each axis.
    using Steps = std::array<std::uint32_t, 3>;

    CellCurve() = default;
    explicit CellCurve(const Box& box);

    /// Place of a point [m] in steps; points outside count as on the box's face.
    [[nodiscard]] Steps steps(const Vector3f& point) const
    {
        return {axes_[0].steps(point.x), axes_[1].steps(point.y), axes_[2].steps(point.z)};
    }

    /// Key of a place or of a point [m].
    [[nodiscard]] std::uint64_t key(const Steps& place) const
    {
        return axes_[0].key(place[0]) | axes_[1].key(place[1]) | axes_[2].key(place[2]);
    }
    [[nodiscard]] std::uint64_t key(const Vector3f& point) const { return key(steps(point)); }

    /// The box of depth `depth` that holds the key.
    [[nodiscard]] Box cell(std::uint64_t key, int depth) const;

    /// The lowest place of that box, and how many steps it goes on beyond that along each axis.
    struct Extent {
        Steps lowest, reach;

        [[nodiscard]] bool holds(const Steps& place) const
        {
            return place[0] - lowest[0] <= reach[0] && place[1] - lowest[1] <= reach[1] && place[2] - lowest[2] <= reach[2];
        }
    };
    [[nodiscard]] Extent extent(std::uint64_t key, int depth) const;

    /// Volume of any box of that depth [m3].
    [[nodiscard]] double volume(int depth) const { return volume_[depth]; }

    /// Side of the cube of that volume [m].
    [[nodiscard]] float side(int depth) const { return side_[depth]; }

    /// Half diagonal of any box of that depth [m].
    [[nodiscard]] double radius(int depth) const { return radius_[depth]; }

    /// How many keys a box of that depth holds.
    [[nodiscard]] static std::uint64_t keys_of(int depth) { return std::uint64_t{1} << (depth_limit - depth); }

    /// First key of the box of that depth that holds `key`.
    [[nodiscard]] static std::uint64_t first_key(std::uint64_t key, int depth)
    {
        return depth == 0 ? 0 : key >> (depth_limit - depth) << (depth_limit - depth);
    }

    /// Depth of the smallest box that holds both keys.
    [[nodiscard]] static int common_depth(std::uint64_t a, std::uint64_t b)
    {
        const std::uint64_t difference = a ^ b;
        return difference == 0 ? depth_limit : std::countl_zero(difference) - 1;
    }

private:
    friend class CurveBranch;

    struct Axis {
        float lower = 0;
        float scale = 0;         ///< steps a metre
        std::uint32_t last = 0;  ///< place
        int bits = 0;
        std::array<std::uint8_t, depth_limit> depth_of_bit{};    ///< from the most significant bit
        std::array<std::uint8_t, depth_limit + 1> bits_above{};  ///< that boxes of a depth have taken
        std::array<std::array<std::uint64_t, 256>, 3> spread{};  ///< a byte of the place, its bits put where the key has them

        [[nodiscard]] std::uint32_t steps(float coordinate) const
        {
            const float exact = (coordinate - lower) * scale;
            const float inside = exact > 0 ? std::min(exact, static_cast<float>(last)) : 0.0f;  // 0 for what is no number, too
            return static_cast<std::uint32_t>(static_cast<std::int32_t>(inside));
        }
        [[nodiscard]] std::uint64_t key(std::uint32_t place) const
        {
            return spread[0][place & 0xFF] | spread[1][place >> 8 & 0xFF] | spread[2][place >> 16 & 0xFF];
        }
    };

    Box box_;
    std::array<Axis, 3> axes_;
    std::array<std::uint8_t, depth_limit> axis_of_depth_{};
    std::array<double, depth_limit + 1> volume_{};
    std::array<double, depth_limit + 1> radius_{};
    std::array<float, depth_limit + 1> side_{};
};

/// The boxes some levels below those of one depth, numbered along the curve within the box that holds them.
class CurveBranch {
public:
    static constexpr int level_limit = 12;

    /// Numbers the boxes `levels` (at most `level_limit`) below boxes of depth `depth`.
    void set(const CellCurve& curve, int depth, int levels);

    /// Number of the box that a place is in.
    [[nodiscard]] std::uint32_t index(const CellCurve::Steps& place) const
    {
        return axes_[0].index(place[0]) | axes_[1].index(place[1]) | axes_[2].index(place[2]);
    }

private:
    struct Axis {
        int shift = 0;
        std::uint32_t mask = 0;
        std::array<std::uint16_t, 1 << level_limit> spread{};

        [[nodiscard]] std::uint32_t index(std::uint32_t place) const { return spread[place >> shift & mask]; }
    };
    std::array<Axis, 3> axes_;
};

}  // namespace corpuscle
