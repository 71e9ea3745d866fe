#include "mesh/clearance_map.hpp"

#include <algorithm>

#include "parallel/loops.hpp"

namespace corpuscle {
namespace {

/// A pass of the Chebyshev distance transform across rows: each of n rows of `width` cells, `stride` apart, becomes the smallest over
/// its neighbours (itself included) of the larger of their value and their distance.
void widen(const std::uint8_t* in, std::uint8_t* out, std::int32_t n, std::size_t stride, std::size_t width)
{
    for (std::int32_t i = 0; i < n; ++i) {
        std::uint8_t* to = out + i * stride;
        std::copy_n(in + i * stride, width, to);
        for (std::int32_t r = 1; r < ClearanceMap::limit; ++r) {
            const std::uint8_t least = static_cast<std::uint8_t>(r);
            for (const std::int32_t j : {i - r, i + r}) {
                if (j < 0 || j >= n) continue;
                const std::uint8_t* from = in + j * stride;
                for (std::size_t x = 0; x < width; ++x) to[x] = std::min(to[x], std::max(from[x], least));
            }
        }
    }
}

/// Along a row of single cells: distances to the nearest 0, forth and back.
void measure_row(std::uint8_t* row, std::int32_t n)
{
    for (std::int32_t i = 1; i < n; ++i) row[i] = std::min<std::uint8_t>(row[i], static_cast<std::uint8_t>(row[i - 1] + 1));
    for (std::int32_t i = n - 2; i >= 0; --i) row[i] = std::min<std::uint8_t>(row[i], static_cast<std::uint8_t>(row[i + 1] + 1));
}

}  // namespace

/// visit(first cell's place in a block-wide array, the same in the lattice's) for each row of cells along x.
template <class Visit>
void ClearanceMap::for_each_row(const CellBlock& block, const Visit& visit) const
{
    const std::size_t rows = static_cast<std::size_t>(block.layers(1)) * block.layers(2);
    for_each(block.cells() > 0 ? rows : 0, [&](std::size_t r) {
        const auto y = static_cast<std::int32_t>(r % block.layers(1)), z = static_cast<std::int32_t>(r / block.layers(1));
        visit(r * block.layers(0), all_.index({block.low[0], block.low[1] + y, block.low[2] + z}));
    });
}

void ClearanceMap::measure(const Lattice& lattice, const FacetLists& still, const FacetLists& moving)
{
    all_ = lattice.all();
    to_still_.assign(all_.cells(), limit);
    const CellBlock about = measure_about(still);
    for_each_row(about, [&](std::size_t row, std::size_t first) { std::copy_n(&near_[row], about.layers(0), &to_still_[first]); });
    to_any_ = to_still_;
    changed_ = {};
    measure_moving(moving);
}

void ClearanceMap::measure_moving(const FacetLists& moving)
{
    for_each_row(changed_, [&](std::size_t, std::size_t first) { std::copy_n(&to_still_[first], changed_.layers(0), &to_any_[first]); });
    changed_ = measure_about(moving);
    for_each_row(changed_, [&](std::size_t row, std::size_t first) {
        for (std::int32_t x = 0; x < changed_.layers(0); ++x) to_any_[first + x] = std::min(near_[row + x], to_still_[first + x]);
    });
}

/// Fills `near_` with the distances to the cells that list facets, by one pass in each direction; returns the cells so near to any.
CellBlock ClearanceMap::measure_about(const FacetLists& lists)
{
    if (lists.block().cells() == 0) return {};
    const CellBlock about = lists.block().widened(limit - 1).meet(all_);
    const std::int32_t width = about.layers(0);
    const std::size_t row = width, plane = row * about.layers(1);
    near_.assign(about.cells(), limit);
    scratch_.resize(about.cells());
    for_each(static_cast<std::size_t>(lists.block().layers(1)) * lists.block().layers(2), [&](std::size_t r) {
        std::array<std::int32_t, 3> c = lists.block().low;
        c[1] += static_cast<std::int32_t>(r % lists.block().layers(1));
        c[2] += static_cast<std::int32_t>(r / lists.block().layers(1));
        const std::size_t own = lists.block().index(c), here = about.index(c);
        for (std::int32_t x = 0; x < lists.block().layers(0); ++x) near_[here + x] = lists.any(own + x) ? 0 : limit;
        measure_row(&near_[about.index({about.low[0], c[1], c[2]})], width);
    });
    for_each_dynamic(about.layers(2), 1, [&](std::size_t z) { widen(&near_[z * plane], &scratch_[z * plane], about.layers(1), row, row); });
    for_each_dynamic(about.layers(1), 1, [&](std::size_t y) { widen(&scratch_[y * row], &near_[y * row], about.layers(2), plane, row); });
    return about;
}

}  // namespace corpuscle
