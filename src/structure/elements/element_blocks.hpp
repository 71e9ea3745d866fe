#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "fields/field.hpp"
#include "math/lanes.hpp"
#include "math/vector3.hpp"
#include "structure/elements/element_values.hpp"

namespace corpuscle {

/// Blocks that a thread takes at a time: a few microseconds of work, so that threads end their loop together.
inline constexpr std::size_t blocks_at_a_time = 8;

/// What elements of any kind keep: numbers in blocks of `lane_count` elements side by side, which elements are left, and how long a
/// step each allows.
class ElementBlocks {
public:
    ElementBlocks() = default;
    ElementBlocks(std::size_t elements, int slots);

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::size_t block_count() const { return left_.size() / lane_count; }
    [[nodiscard]] Lanes* block(std::size_t b) { return data_.data() + b * block_size(); }
    [[nodiscard]] const Lanes* block(std::size_t b) const { return data_.data() + b * block_size(); }
    [[nodiscard]] double slot(std::size_t element, int s) const { return block(element / lane_count)[s][element % lane_count]; }
    void set_slot(std::size_t element, int s, double value) { block(element / lane_count)[s][element % lane_count] = value; }
    /// Asks memory for the numbers of a block that comes soon: waiting for them would cost as much as a third of the arithmetic.
    void fetch_ahead(std::size_t b) const
    {
        if (b < block_count()) prefetch(block(b), block_size() * sizeof(Lanes));
    }

    /// Whether an element is still there. Eroded ones keep their last numbers, feel nothing and resist nothing.
    [[nodiscard]] bool is_left(std::size_t element) const { return left_[element] != 0; }
    void remove(std::size_t element);
    /// Whether all elements of a block are left, or none.
    [[nodiscard]] bool whole(std::size_t b) const;
    [[nodiscard]] bool gone(std::size_t b) const;
    /// 1 for each element of a block that is left, 0 for others.
    [[nodiscard]] Lanes left(std::size_t b) const { return load_lanes(&left_[b * lane_count]); }

    /// Enters what step the elements of a block allow [s]; not a number if one has gone wrong.
    void set_transit(std::size_t b, const Lanes& transit);
    [[nodiscard]] double transit(std::size_t element) const { return transit_[element]; }
    /// Takes the smallest transit; returns the first element without one, or size().
    std::size_t review();
    [[nodiscard]] double stable_step() const { return stable_step_; }

    /// What a restart needs; `noun` names the elements.
    std::vector<Field> state(const std::string& prefix, const std::string& noun);

private:
    [[nodiscard]] std::size_t block_size() const { return static_cast<std::size_t>(slots_); }

    std::size_t size_ = 0;
    int slots_ = 0;                ///< numbers an element keeps
    std::vector<Lanes> data_;      ///< by block and number
    std::vector<double> left_;     ///< 1 or 0, whole blocks
    std::vector<double> transit_;  ///< of each element [s]; infinite where eroded
    double stable_step_ = 0;       ///< [s]
};

/// A number of each element of a block.
inline Lanes load_slot(const Lanes* own, int slot)
{
    return own[slot];
}

inline void store_slot(Lanes* own, int slot, const Lanes& value)
{
    own[slot] = value;
}

inline Vector3<Lanes> load_vector(const Lanes* own, int slot)
{
    return {load_slot(own, slot), load_slot(own, slot + 1), load_slot(own, slot + 2)};
}

inline void store_vector(Lanes* own, int slot, const Vector3<Lanes>& v)
{
    store_slot(own, slot, v.x);
    store_slot(own, slot + 1, v.y);
    store_slot(own, slot + 2, v.z);
}

/// Lane by lane, for vectors.
inline Vector3<Lanes> select(const LaneMask& mask, const Vector3<Lanes>& yes, const Vector3<Lanes>& no)
{
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

/// A vector at each of N corners of a block's elements.
template <std::size_t N>
using LaneCorners = std::array<Vector3<Lanes>, N>;

/// Corner values of one block's elements, side by side; `corners` are the nodes of its first element.
template <std::size_t N>
LaneCorners<N> gather(const std::vector<Vector3d>& values, const std::array<std::uint32_t, N>* corners)
{
    alignas(64) double side[N][3][lane_count];
    for (int lane = 0; lane < lane_count; ++lane) {
        for (std::size_t corner = 0; corner < N; ++corner) {
            const Vector3d& v = values[corners[lane][corner]];
            side[corner][0][lane] = v.x;
            side[corner][1][lane] = v.y;
            side[corner][2][lane] = v.z;
        }
    }
    LaneCorners<N> result;
    for (std::size_t corner = 0; corner < N; ++corner)
        result[corner] = {load_lanes(side[corner][0]), load_lanes(side[corner][1]), load_lanes(side[corner][2])};
    return result;
}

/// As `gather`, but where an element is eroded what `instead` has: places as meshed keep its geometry sound.
template <std::size_t N>
LaneCorners<N> gather_left(const ElementBlocks& blocks, std::size_t b, const std::vector<Vector3d>& values,
                           const std::vector<Vector3d>& instead, const std::array<std::uint32_t, N>* corners)
{
    LaneCorners<N> result = gather(values, corners);
    if (blocks.whole(b)) return result;
    const LaneCorners<N> other = gather(instead, corners);
    const LaneMask left = blocks.left(b) > 0.5;
    for (std::size_t corner = 0; corner < N; ++corner) result[corner] = select(left, result[corner], other[corner]);
    return result;
}

/// The way of each corner in a step; eroded elements do not move. [m] of [m/s] and [s]
template <std::size_t N>
LaneCorners<N> gather_way(const ElementBlocks& blocks, std::size_t b, const std::vector<Vector3d>& velocity, double duration,
                          const std::array<std::uint32_t, N>* corners)
{
    LaneCorners<N> result = gather(velocity, corners);
    const Lanes factor = duration * blocks.left(b);
    for (Vector3<Lanes>& way : result) way = way * factor;
    return result;
}

/// Writes forces (and moments, where there are any) that act on the elements as the opposite loads on their nodes; nothing of eroded ones.
template <std::size_t N>
void write_loads(const ElementBlocks& blocks, std::size_t b, const LaneCorners<N>& forces, const LaneCorners<N>* moments, CornerLoad* loads)
{
    alignas(64) double side[6][lane_count] = {};
    const std::size_t first = b * lane_count, lanes = std::min<std::size_t>(lane_count, blocks.size() - first);
    const Lanes sign = -blocks.left(b);
    for (std::size_t corner = 0; corner < N; ++corner) {
        const Vector3<Lanes> f = forces[corner] * sign;
        const Lanes* parts[] = {&f.x, &f.y, &f.z};
        for (int i = 0; i < 3; ++i) store_lanes(*parts[i], side[i]);
        if (moments) {
            const Vector3<Lanes> m = (*moments)[corner] * sign;
            const Lanes* turns[] = {&m.x, &m.y, &m.z};
            for (int i = 0; i < 3; ++i) store_lanes(*turns[i], side[3 + i]);
        }
        for (std::size_t lane = 0; lane < lanes; ++lane)
            loads[N * (first + lane) + corner] = {{side[0][lane], side[1][lane], side[2][lane]},
                                                  {side[3][lane], side[4][lane], side[5][lane]}};
    }
}

/// A load of each element of a block, side by side.
struct LaneLoad {
    Vector3<Lanes> force, moment;
};

/// The loads of one corner of a block's elements, `stride` loads apart; of less than a whole block the last stands for the missing ones.
inline LaneLoad load_side_by_side(const CornerLoad* loads, std::size_t stride, std::size_t lanes)
{
    alignas(64) double side[6][lane_count];
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        const CornerLoad& load = loads[stride * std::min(lane, lanes - 1)];
        for (int axis = 0; axis < 3; ++axis) {
            side[axis][lane] = load.force[axis];
            side[3 + axis][lane] = load.moment[axis];
        }
    }
    return {{load_lanes(side[0]), load_lanes(side[1]), load_lanes(side[2])},
            {load_lanes(side[3]), load_lanes(side[4]), load_lanes(side[5])}};
}

/// Writes the loads of `write_loads` and returns the work that the mean of the old and new ones does on the elements while their corners
/// move and turn. [J]
template <std::size_t N>
Lanes exchange_loads(const ElementBlocks& blocks, std::size_t b, const LaneCorners<N>& forces, const LaneCorners<N>& moments,
                     const LaneCorners<N>& moves, const LaneCorners<N>& turns, CornerLoad* loads)
{
    const std::size_t first = b * lane_count, lanes = std::min<std::size_t>(lane_count, blocks.size() - first);
    Lanes twice = 0.0;
    for (std::size_t corner = 0; corner < N; ++corner) {
        const LaneLoad before = load_side_by_side(loads + N * first + corner, N, lanes);
        twice = twice + dot(forces[corner] - before.force, moves[corner]) + dot(moments[corner] - before.moment, turns[corner]);
    }
    write_loads(blocks, b, forces, &moments, loads);
    return 0.5 * twice;
}

/// Repeats the last element until the elements fill whole blocks.
template <class T>
void fill_blocks(std::vector<T>& elements)
{
    while (elements.size() % lane_count != 0) elements.push_back(T(elements.back()));
}

/// Corner places in the middle of the step. [m]
template <std::size_t N>
LaneCorners<N> halfway(const LaneCorners<N>& end, const LaneCorners<N>& move)
{
    LaneCorners<N> middle;
    for (std::size_t c = 0; c < N; ++c) middle[c] = end[c] - move[c] * Lanes(0.5);
    return middle;
}

/// What kinds of elements of N corners that keep their numbers in blocks have in common.
template <std::size_t N>
class BlockElements {
public:
    [[nodiscard]] std::size_t size() const { return blocks_.size(); }
    [[nodiscard]] int corner_count() const { return static_cast<int>(N); }
    [[nodiscard]] std::uint32_t node(std::size_t element, int corner) const { return corners_[element][static_cast<std::size_t>(corner)]; }
    [[nodiscard]] bool is_left(std::size_t element) const { return blocks_.is_left(element); }
    /// Takes an element out: from now on it feels nothing and resists nothing.
    void remove(std::size_t element) { blocks_.remove(element); }
    /// 2 / (highest frequency) of an element, and the smallest of all, after the last resist. [s]
    [[nodiscard]] double transit(std::size_t element) const { return blocks_.transit(element); }
    [[nodiscard]] double stable_step() const { return blocks_.stable_step(); }

protected:
    using CornerNodes = std::array<std::uint32_t, N>;

    BlockElements() = default;
    /// Elements at the structure's nodes, that keep `slots` numbers each.
    BlockElements(std::vector<CornerNodes> corners, int slots) : blocks_(corners.size(), slots), corners_(std::move(corners))
    {
        fill_blocks(corners_);
    }
    /// Corners of the elements of a block.
    [[nodiscard]] const CornerNodes* corners_of_block(std::size_t b) const { return &corners_[b * lane_count]; }

    ElementBlocks blocks_;
    std::vector<CornerNodes> corners_;  ///< whole blocks: the last element is repeated to fill its block
};

}  // namespace corpuscle
