#include "mesh/facet_lists.hpp"

#include <cmath>

#include "parallel/loops.hpp"

namespace corpuscle {
namespace {

constexpr double spare_reach = 0.01;  ///< for rounding, in single precision, of what relies on the lists, in cells

/// A box with what rounding may need.
Box with_spare(Box reach, const Lattice& lattice)
{
    reach.grow(spare_reach * lattice.size);
    return reach;
}

/// All places to which a facet's plane may go within its reach, widened by half a cell: which cells of a column across it are near.
struct WidePlane {
    WidePlane(const Lattice& lattice, const Vector3d* corners, const Box& reach) : lattice_(lattice), corner_(corners[0])
    {
        const Vector3d area = cross(corners[1] - corners[0], corners[2] - corners[0]);
        if (norm(area) > 0) normal_ = area / norm(area);
        const Vector3d steep{std::abs(normal_.x), std::abs(normal_.y), std::abs(normal_.z)};
        across = steep.x >= steep.y && steep.x >= steep.z ? 0 : steep.y >= steep.z ? 1 : 2;
        if (normal_[across] < 0) normal_ = -normal_;
        above_ = 0.5 * lattice.size * (steep[(across + 1) % 3] + steep[(across + 2) % 3]);
        below_ = -above_;
        for (int axis = 0; axis < 3; ++axis) {
            above_ += normal_[axis] * (normal_[axis] > 0 ? reach.upper[axis] : reach.lower[axis]);
            below_ += normal_[axis] * (normal_[axis] > 0 ? reach.lower[axis] : reach.upper[axis]);
        }
    }

    /// Cuts the column of cells at c (its layers other than that across the plane) down to those near the plane.
    void narrow(const std::array<std::int32_t, 3>& c, std::int32_t& bottom, std::int32_t& top) const
    {
        const double slope = normal_[across];
        if (slope == 0) return;
        const int e = (across + 1) % 3, f = (across + 2) % 3;
        const double along_e = lattice_.lower[e] + (c[e] + 0.5) * lattice_.size - corner_[e];
        const double along_f = lattice_.lower[f] + (c[f] + 0.5) * lattice_.size - corner_[f];
        const double middle = corner_[across] - (normal_[e] * along_e + normal_[f] * along_f) / slope - lattice_.lower[across];
        bottom = std::max(bottom, lattice_.layer(std::clamp((middle + below_ / slope) * lattice_.inverse_size, -1.0, 1e9), across));
        top = std::min(top, lattice_.layer(std::clamp((middle + above_ / slope) * lattice_.inverse_size, -1.0, 1e9), across));
    }

    int across = 0;  ///< axis that goes most steeply through the plane

private:
    const Lattice& lattice_;
    Vector3d corner_;
    Vector3d normal_;               ///< unit, towards larger coordinates along `across`
    double below_ = 0, above_ = 0;  ///< how far the widened plane goes from the corner, along the normal [m]
};

/// visit(c) for each cell of a block that lies near a facet: column by column across the facet's plane.
template <class Visit>
void visit_cells(const CellBlock& block, const WidePlane& plane, const Visit& visit)
{
    const int d = plane.across, e = (d + 1) % 3, f = (d + 2) % 3;
    std::array<std::int32_t, 3> c{};
    for (c[f] = block.low[f]; c[f] <= block.high[f]; ++c[f]) {
        for (c[e] = block.low[e]; c[e] <= block.high[e]; ++c[e]) {
            std::int32_t bottom = block.low[d], top = block.high[d];
            plane.narrow(c, bottom, top);
            for (c[d] = bottom; c[d] <= top; ++c[d]) visit(c);
        }
    }
}

}  // namespace

/// A counting sort: slabs of cells count and then place their facets, each by one thread, so the lists do not depend on threads.
/// Counts stand two cells ahead, so that they end as the lists' beginnings without a second array.
void FacetLists::make(const Lattice& lattice, const FacetPlaces& places, std::span<const std::uint32_t> facets)
{
    enclose(lattice, places, facets);
    cut_slabs(facets.size());
    first_.assign(block_.cells() + 2, 0);
    visit_slabs(lattice, places, facets, [&](std::size_t cell, std::uint32_t) { ++first_[cell + 2]; });
    for (std::size_t c = 2; c < first_.size(); ++c) first_[c] += first_[c - 1];
    listed_.resize(first_.back());
    visit_slabs(lattice, places, facets, [&](std::size_t cell, std::uint32_t facet) { listed_[first_[cell + 1]++] = facet; });
    first_.pop_back();
}

/// Finds the block of cells about each facet, and about all.
void FacetLists::enclose(const Lattice& lattice, const FacetPlaces& places, std::span<const std::uint32_t> facets)
{
    near_.resize(facets.size());
    for_each(facets.size(), [&](std::size_t i) {
        Box box;
        for (int k = 0; k < 3; ++k) box.include(places.corners[3 * static_cast<std::size_t>(facets[i]) + k]);
        const Box reach = with_spare(places.reach[facets[i]], lattice);
        box.lower += reach.lower;
        box.upper += reach.upper;
        near_[i] = lattice.block(box);
    });
    block_ = sum_chunks<CellBlock>(facets.size(), [&](std::size_t begin, std::size_t end) {
        CellBlock about;
        for (std::size_t i = begin; i < end; ++i) about += near_[i];
        return about;
    });
}

/// Cuts the block along its longer of y and z into as many slabs as threads are worth while.
void FacetLists::cut_slabs(std::size_t facets)
{
    const int axis = block_.layers(2) >= block_.layers(1) ? 2 : 1;
    const std::size_t wanted = part_count(facets, 2048);
    std::vector<std::size_t> begun(static_cast<std::size_t>(block_.layers(axis)), 0);
    if (wanted > 1) {
        for (const CellBlock& near : near_) ++begun[static_cast<std::size_t>(near.low[axis] - block_.low[axis])];
    }
    slabs_.clear();
    CellBlock slab = block_;
    std::size_t passed = 0;
    for (std::int32_t layer = block_.low[axis]; layer < block_.high[axis]; ++layer) {
        passed += begun[static_cast<std::size_t>(layer - block_.low[axis])];
        if (passed * wanted < (slabs_.size() + 1) * facets || wanted == 1) continue;
        slab.high[axis] = layer;
        slabs_.push_back(slab);
        slab.low[axis] = layer + 1;
    }
    slab.high[axis] = block_.high[axis];
    slabs_.push_back(slab);
}

/// visit(cell, facet) for every facet and each cell near it, facets of one cell in the order of their numbers, slabs side by side.
template <class Visit>
void FacetLists::visit_slabs(const Lattice& lattice, const FacetPlaces& places, std::span<const std::uint32_t> facets,
                             const Visit& visit) const
{
    for_each_dynamic(slabs_.size(), 1, [&](std::size_t s) {
        for (std::size_t i = 0; i < facets.size(); ++i) {
            const CellBlock own = near_[i].meet(slabs_[s]);
            if (own.cells() == 0) continue;
            const WidePlane plane(lattice, &places.corners[3 * static_cast<std::size_t>(facets[i])],
                                  with_spare(places.reach[facets[i]], lattice));
            visit_cells(own, plane, [&](const std::array<std::int32_t, 3>& c) { visit(block_.index(c), facets[i]); });
        }
    });
}

}  // namespace corpuscle
