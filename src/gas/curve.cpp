#include "gas/curve.hpp"

namespace corpuscle {

CellCurve::CellCurve(const Box& box) : box_(box)
{
    constexpr int axis_limit = 24;
    Vector3d side = box.size();
    for (int depth = 0; depth < depth_limit; ++depth) {
        volume_[depth] = side.x * side.y * side.z;
        radius_[depth] = 0.5 * norm(side);
        int longest = -1;
        for (int a = 0; a < 3; ++a) {
            if (axes_[a].bits < axis_limit && (longest < 0 || side[a] > side[longest])) longest = a;
            axes_[a].bits_above[depth] = static_cast<std::uint8_t>(axes_[a].bits);
        }
        axis_of_depth_[depth] = static_cast<std::uint8_t>(longest);
        axes_[longest].depth_of_bit[axes_[longest].bits++] = static_cast<std::uint8_t>(depth);
        side[longest] *= 0.5;
    }
    volume_[depth_limit] = side.x * side.y * side.z;
    radius_[depth_limit] = 0.5 * norm(side);
    for (int depth = 0; depth <= depth_limit; ++depth) side_[depth] = static_cast<float>(std::cbrt(volume_[depth]));

    for (int a = 0; a < 3; ++a) {
        Axis& axis = axes_[a];
        axis.bits_above[depth_limit] = static_cast<std::uint8_t>(axis.bits);
        axis.lower = static_cast<float>(box.lower[a]);
        axis.scale = static_cast<float>(static_cast<double>(1 << axis.bits) / box.size()[a]);
        axis.last = (1u << axis.bits) - 1;
        for (int bit = 0; bit < axis.bits; ++bit) {
            const int depth = axis.depth_of_bit[axis.bits - 1 - bit];
            const std::uint64_t mask = std::uint64_t{1} << (depth_limit - 1 - depth);
            for (int byte = 0; byte < 256; ++byte) {
                if (byte >> (bit % 8) & 1) axis.spread[bit / 8][byte] |= mask;
            }
        }
    }
}

Box CellCurve::cell(std::uint64_t key, int depth) const
{
    Box cell = box_;
    for (int d = 0; d < depth; ++d) {
        const int a = axis_of_depth_[d];
        const double middle = 0.5 * (cell.lower[a] + cell.upper[a]);
        (key >> (depth_limit - 1 - d) & 1 ? cell.lower[a] : cell.upper[a]) = middle;
    }
    return cell;
}

CellCurve::Extent CellCurve::extent(std::uint64_t key, int depth) const
{
    Extent extent{};
    for (int a = 0; a < 3; ++a) {
        const Axis& axis = axes_[a];
        const int above = axis.bits_above[depth];
        for (int bit = 0; bit < above; ++bit) {
            if (key >> (depth_limit - 1 - axis.depth_of_bit[bit]) & 1) extent.lowest[a] |= 1u << (axis.bits - 1 - bit);
        }
        extent.reach[a] = (1u << (axis.bits - above)) - 1;
    }
    return extent;
}

void CurveBranch::set(const CellCurve& curve, int depth, int levels)
{
    for (int a = 0; a < 3; ++a) {
        const CellCurve::Axis& axis = curve.axes_[a];
        const int above = axis.bits_above[depth], below = axis.bits_above[depth + levels];
        Axis& own = axes_[a];
        own.shift = axis.bits - below;
        own.mask = (1u << (below - above)) - 1;
        own.spread[0] = 0;
        for (int bit = below - 1; bit >= above; --bit) {  // from the lowest on: each doubles the entries
            const std::uint32_t entries = 1u << (below - 1 - bit);
            const auto value = static_cast<std::uint16_t>(1u << (depth + levels - 1 - axis.depth_of_bit[bit]));
            for (std::uint32_t k = 0; k < entries; ++k) own.spread[entries + k] = own.spread[k] | value;
        }
    }
}

}  // namespace corpuscle
