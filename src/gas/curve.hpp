#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "math/box.hpp"

namespace corpuscle {

/// A space-filling curve through a box by repeated halving: bit d of a key says which half of the box of depth d a point is
/// in, each box being halved across its longest side. In a cube this is Morton's curve (1966); in any other box cells keep
/// sides within 1:2 and still fill the box exactly. 63 bits a key, at most 24 a direction (a float knows no more).
class CellCurve {
public:
    static constexpr int depth_limit = 63;

    CellCurve() = default;
    explicit CellCurve(const Box& box);

    /// Key of a point [m]; points outside count as on the box's face.
    [[nodiscard]] std::uint64_t key(const Vector3f& point) const
    {
        return axes_[0].key(point.x) | axes_[1].key(point.y) | axes_[2].key(point.z);
    }

    /// The box of depth `depth` that holds the key.
    [[nodiscard]] Box cell(std::uint64_t key, int depth) const;

    /// Volume of any box of that depth [m3].
    [[nodiscard]] double volume(int depth) const { return volume_[depth]; }

    /// Half diagonal of any box of that depth [m].
    [[nodiscard]] double radius(int depth) const { return radius_[depth]; }

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
    struct Axis {
        float lower = 0;
        float scale = 0;        ///< integer steps a metre
        std::int32_t last = 0;  ///< largest integer coordinate
        int bits = 0;
        std::array<std::uint8_t, depth_limit> depth_of_bit{};    ///< from the most significant bit
        std::array<std::array<std::uint64_t, 256>, 3> spread{};  ///< a byte of the coordinate, its bits put in their places

        [[nodiscard]] std::uint64_t key(float coordinate) const
        {
            const float steps = (coordinate - lower) * scale;
            const float inside = steps > 0 ? std::min(steps, static_cast<float>(last)) : 0.0f;  // 0 for what is no number, too
            const std::int32_t q = static_cast<std::int32_t>(inside);
            return spread[0][q & 0xFF] | spread[1][q >> 8 & 0xFF] | spread[2][q >> 16 & 0xFF];
        }
    };

    Box box_;
    std::array<Axis, 3> axes_;
    std::array<std::uint8_t, depth_limit> axis_of_depth_{};
    std::array<double, depth_limit + 1> volume_{};
    std::array<double, depth_limit + 1> radius_{};
};

}  // namespace corpuscle
