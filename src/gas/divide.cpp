#include "gas/divide.hpp"

#include <algorithm>
#include <bit>

namespace corpuscle {

namespace {

constexpr std::uint32_t particles_per_bin = 3;

Cell make_cell(std::uint32_t first, std::uint32_t count, std::uint32_t depth)
{
    Cell cell;
    cell.first = first;
    cell.count = count & 0xFFFFFFu;
    cell.depth = depth & 0xFFu;
    return cell;
}

}  // namespace

void Divider::take_remaining(const Particle* first, std::size_t count)
{
    if (particles_.size() < taken_ + count) particles_.resize(taken_ + count + 64);
    Particle* const taken = particles_.data();
    for (std::size_t i = 0; i < count; ++i) {
        taken[taken_] = first[i];
        taken_ += first[i].tag & particle_tag::gone ? 0 : 1;
    }
}

void Divider::divide(std::uint64_t start_key, int depth, Particle* target, std::uint32_t first, Division& division)
{
    start_key_ = start_key;
    target_ = target;
    first_ = first;
    const auto bins_wanted = static_cast<std::uint32_t>(taken_) / particles_per_bin + 1;
    const int levels =
        std::min({static_cast<int>(std::bit_width(bins_wanted - 1)), CurveBranch::level_limit, CellCurve::depth_limit - depth});
    bin_depth_ = depth + levels;
    branch_.set(curve_, depth, levels);
    bin_start_.assign((std::size_t{1} << levels) + 1, 0);
    place(target);
    Node node = whole_;
    node.begin = 0;
    node.end = 1u << levels;
    node.depth = static_cast<std::uint32_t>(depth);
    cut(node, division);
    taken_ = 0;
}

/// Writes the particles to the target, bin after bin.
void Divider::place(Particle* target)
{
    const std::size_t count = taken_;
    bin_.resize(count);
    std::uint32_t* const start = bin_start_.data();
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t bin = branch_.index(curve_.steps(particles_[i].position));
        bin_[i] = static_cast<std::uint16_t>(bin);
        ++start[bin + 1];
    }
    for (std::size_t b = 1; b < bin_start_.size(); ++b) start[b] += start[b - 1];
    // Each bin's start runs on to its end, the next one's start: shifting them by one puts them back.
    for (std::size_t i = 0; i < count; ++i) target[start[bin_[i]]++] = particles_[i];
    for (std::size_t b = bin_start_.size() - 1; b > 0; --b) start[b] = start[b - 1];
    start[0] = 0;
}

std::uint64_t Divider::key_of_bin(std::uint32_t bin) const
{
    return start_key_ + bin * CellCurve::keys_of(bin_depth_);
}

/// Names the pieces that a box is, and goes on with its halves until its particles are in cells.
void Divider::cut(const Node& node, Division& division)
{
    const std::uint32_t begin = bin_start_[node.begin], count = bin_start_[node.end] - begin;
    Node next = node;
    const bool last = node.depth == CellCurve::depth_limit;  // what cannot be halved holds what it holds
    if (node.bucket && (count <= limits_.bucket || last)) {
        division.buckets.push_back({key_of_bin(node.begin), first_ + begin, node.depth});
        next.bucket = false;
    }
    if (count == 0) return;
    if ((node.group && count <= limits_.group) || last) {
        if (node.group) division.groups.push_back(make_cell(first_ + begin, count, node.depth));
        next.group = false;
    }
    if (count <= limits_.cell || last) {
        division.cells.push_back(make_cell(first_ + begin, count, node.depth));
        return;
    }
    if (node.end - node.begin == 1) {
        cut_finer(next, division);
        return;
    }
    next.depth = node.depth + 1;
    next.end = (node.begin + node.end) / 2;
    cut(next, division);
    next.begin = next.end;
    next.end = node.end;
    cut(next, division);
}

/// Sorts and cuts a bin that is still too full.
void Divider::cut_finer(const Node& node, Division& division)
{
    if (!finer_) finer_ = std::make_unique<Divider>(curve_, limits_);
    const std::uint32_t begin = bin_start_[node.begin], end = bin_start_[node.end];
    finer_->take_remaining(target_ + begin, end - begin);
    finer_->whole_.bucket = node.bucket;
    finer_->whole_.group = node.group;
    finer_->divide(key_of_bin(node.begin), static_cast<int>(node.depth), target_ + begin, first_ + begin, division);
}

}  // namespace corpuscle
