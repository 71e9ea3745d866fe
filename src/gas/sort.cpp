#include "gas/sort.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "parallel/sort.hpp"

namespace corpuscle {

namespace {

constexpr std::uint32_t bucket_limit = 1024;

/// What a bucket keeps and what comes to it.
struct Moves {
    std::vector<std::uint32_t> kept;   ///< particles that stay, by bucket
    std::vector<Particle> movers;      ///< in the order they were found
    std::vector<std::uint32_t> order;  ///< of the movers by bucket
    std::vector<std::uint32_t> start;  ///< first in `order` of each bucket, and the end
};

std::size_t bucket_count(const Cells& cells)
{
    return cells.buckets.size() - 1;
}

/// Index of the bucket whose stretch of the curve holds the key.
std::uint32_t bucket_of(const Cells& cells, std::uint64_t key)
{
    const auto after = std::upper_bound(cells.buckets.begin(), cells.buckets.end() - 1, key,
                                        [](std::uint64_t k, const Bucket& bucket) { return k < bucket.start_key; });
    return static_cast<std::uint32_t>(after - cells.buckets.begin()) - 1;
}

/// Closes up one bucket's particles that stay in it, and hands those that leave to `movers`. Returns how many stay.
std::uint32_t pick_movers(Gas& gas, std::size_t bucket, std::vector<Particle>& movers)
{
    Cells& cells = gas.cells;
    const std::uint64_t lowest = cells.buckets[bucket].start_key, beyond = cells.buckets[bucket + 1].start_key;
    const std::uint32_t first = cells.buckets[bucket].first, end = cells.buckets[bucket + 1].first;
    std::uint32_t next = first;
    for (std::uint32_t i = first; i < end; ++i) {
        const Particle& particle = gas.particles[i];
        if (particle.tag & particle_tag::gone) continue;
        const std::uint64_t key = cells.curve.key(particle.position);
        if (key < lowest || key >= beyond) {
            movers.push_back(particle);
            continue;
        }
        if (next != i) gas.particles[next] = particle;
        cells.keys[next++] = key;
    }
    return next - first;
}

/// Takes newcomers, which stand behind the sorted particles, as movers.
void pick_newcomers(const Gas& gas, std::vector<Particle>& movers)
{
    for (std::size_t i = gas.cells.buckets.back().first; i < gas.particles.size(); ++i) {
        const Particle& particle = gas.particles[i];
        if (!(particle.tag & particle_tag::gone)) movers.push_back(particle);
    }
}

/// Finds who leaves which bucket and where to.
Moves find_moves(Gas& gas)
{
    Moves moves;
    const std::size_t buckets = bucket_count(gas.cells);
    moves.kept.resize(buckets);
    const std::size_t parts = part_count(buckets, 8);
    std::vector<std::vector<Particle>> found(parts);
    for_each_part(buckets, parts, [&](std::size_t part, std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) moves.kept[b] = pick_movers(gas, b, found[part]);
    });
    pick_newcomers(gas, found.back());

    std::size_t held = 0;
    for (const auto& list : found) held += list.capacity() * sizeof(Particle);
    moves.movers = std::move(found[0]);
    for (std::size_t part = 1; part < parts; ++part) moves.movers.insert(moves.movers.end(), found[part].begin(), found[part].end());
    moves.order.resize(moves.movers.size());
    moves.start = stable_counting_sort(
        moves.movers.size(), buckets, [&](std::size_t i) { return bucket_of(gas.cells, gas.cells.curve.key(moves.movers[i].position)); },
        [&](std::size_t i, std::uint32_t position) { moves.order[position] = static_cast<std::uint32_t>(i); });
    gas.cells.sort_bytes = held + (parts > 1 ? moves.movers.capacity() * sizeof(Particle) : 0) +
                           (moves.kept.size() + moves.order.size() + moves.start.size()) * sizeof(std::uint32_t);
    return moves;
}

/// Moves what each bucket keeps to the bucket's new place. Neighbours that move the same way form a chain, which is moved from
/// its far end on; chains do not touch each other's places.
void shift_buckets(Gas& gas, const std::vector<std::uint32_t>& kept, const std::vector<std::uint32_t>& new_first)
{
    const std::vector<Bucket>& buckets = gas.cells.buckets;
    const auto shift = [&](std::size_t b) {
        const std::uint32_t from = buckets[b].first, to = new_first[b];
        if (from == to || kept[b] == 0) return;
        std::memmove(&gas.particles[to], &gas.particles[from], kept[b] * sizeof(Particle));
        std::memmove(&gas.cells.keys[to], &gas.cells.keys[from], kept[b] * sizeof(std::uint64_t));
    };
    const auto upward = [&](std::size_t b) { return new_first[b] > buckets[b].first; };
    std::vector<std::uint32_t> chains;  // first bucket of each
    for (std::size_t b = 0; b < kept.size(); ++b) {
        if (b == 0 || upward(b) != upward(b - 1)) chains.push_back(static_cast<std::uint32_t>(b));
    }
    chains.push_back(static_cast<std::uint32_t>(kept.size()));
    for_each_dynamic(chains.size() - 1, 1, [&](std::size_t c) {
        if (upward(chains[c])) {
            for (std::size_t b = chains[c + 1]; b-- > chains[c];) shift(b);
        } else {
            for (std::size_t b = chains[c]; b < chains[c + 1]; ++b) shift(b);
        }
    });
}

/// Space for sorting one bucket, kept by its thread.
struct Scratch {
    std::vector<std::uint32_t> bin_start;
    std::vector<std::uint32_t> order;
    std::vector<std::uint64_t> keys;
    std::vector<Particle> particles;
};

/// Sorts `order` by key: by the leading bits into about as many bins as keys, then within each bin.
void order_by_key(const std::uint64_t* keys, std::uint32_t count, Scratch& scratch)
{
    const auto [least, most] = std::minmax_element(keys, keys + count);
    const std::uint64_t lowest = *least, range = *most - lowest;
    int shift = 0;
    while (range >> shift >= count) ++shift;
    const std::size_t bins = static_cast<std::size_t>(range >> shift) + 1;
    scratch.bin_start.assign(bins + 1, 0);
    scratch.order.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) ++scratch.bin_start[(keys[i] - lowest) >> shift];
    std::exclusive_scan(scratch.bin_start.begin(), scratch.bin_start.end(), scratch.bin_start.begin(), 0u);
    for (std::uint32_t i = 0; i < count; ++i) scratch.order[scratch.bin_start[(keys[i] - lowest) >> shift]++] = i;
    if (shift == 0) return;
    const auto before = [keys](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b] || (keys[a] == keys[b] && a < b); };
    std::uint32_t begin = 0;
    for (std::size_t bin = 0; bin < bins; ++bin) {
        const std::uint32_t end = scratch.bin_start[bin];
        if (end - begin > 1) std::sort(scratch.order.begin() + begin, scratch.order.begin() + end, before);
        begin = end;
    }
}

/// Sorts the run of particles [first, end) and their keys.
void sort_run(Gas& gas, std::uint32_t first, std::uint32_t end, Scratch& scratch)
{
    const std::uint32_t count = end - first;
    if (count < 2) return;
    Particle* particles = &gas.particles[first];
    std::uint64_t* keys = &gas.cells.keys[first];
    order_by_key(keys, count, scratch);
    scratch.particles.resize(count);
    scratch.keys.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        scratch.particles[i] = particles[scratch.order[i]];
        scratch.keys[i] = keys[scratch.order[i]];
    }
    std::copy(scratch.particles.begin(), scratch.particles.end(), particles);
    std::copy(scratch.keys.begin(), scratch.keys.end(), keys);
}

/// Brings the movers into their buckets and sorts every bucket.
void settle(Gas& gas, const Moves& moves, const std::vector<std::uint32_t>& first)
{
    for_each_dynamic(moves.kept.size(), 8, [&](std::size_t b) {
        thread_local Scratch scratch;
        std::uint32_t next = first[b] + moves.kept[b];
        for (std::uint32_t k = moves.start[b]; k < moves.start[b + 1]; ++k, ++next) {
            const Particle& mover = moves.movers[moves.order[k]];
            gas.particles[next] = mover;
            gas.cells.keys[next] = gas.cells.curve.key(mover.position);
        }
        sort_run(gas, first[b], next, scratch);
    });
}

/// Sorts everything from any order: the first time, and when more particles move than stay.
void sort_from_scratch(Gas& gas)
{
    std::erase_if(gas.particles, [](const Particle& particle) { return particle.tag & particle_tag::gone; });
    const CellCurve& curve = gas.cells.curve;
    std::sort(gas.particles.begin(), gas.particles.end(),
              [&](const Particle& a, const Particle& b) { return curve.key(a.position) < curve.key(b.position); });
    gas.cells.keys.resize(gas.particles.size());
    for_each(gas.particles.size(), [&](std::size_t i) { gas.cells.keys[i] = curve.key(gas.particles[i].position); });
}

/// Sorts particles most of which are still in their bucket.
void sort_again(Gas& gas)
{
    const Moves moves = find_moves(gas);
    std::vector<std::uint32_t> first(moves.kept.size());
    for (std::size_t b = 0; b < first.size(); ++b) first[b] = moves.kept[b] + moves.start[b + 1] - moves.start[b];
    const std::uint32_t total = exclusive_scan(first);
    if (total > gas.particles.size()) gas.particles.resize(total);
    gas.cells.keys.resize(std::max<std::size_t>(gas.cells.keys.size(), total));
    shift_buckets(gas, moves.kept, first);
    gas.particles.resize(total);
    gas.cells.keys.resize(total);
    settle(gas, moves, first);
}

/// Cuts the sorted particles into cells, groups and the buckets of the next sort.
void cut_all(Gas& gas)
{
    Cells& cells = gas.cells;
    cells.cells = cut(cells.keys, gas.settings.cell_limit);
    cells.groups = cut(cells.keys, std::max(gas.settings.group_limit, gas.settings.cell_limit));
    const std::vector<Cell> runs = cut(cells.keys, bucket_limit);
    cells.buckets.clear();
    for (const Cell& run : runs) cells.buckets.push_back({CellCurve::first_key(cells.keys[run.first], run.depth), run.first});
    if (cells.buckets.empty()) cells.buckets.push_back({0, 0});
    cells.buckets.front().start_key = 0;
    cells.buckets.push_back({~std::uint64_t{0}, static_cast<std::uint32_t>(cells.keys.size())});
}

}  // namespace

void sort(Gas& gas)
{
    if (gas.particles.empty() && gas.cells.keys.empty()) return;
    if (gas.cells.buckets.size() < 2) {
        gas.cells.curve = CellCurve(gas.domain.box);
        sort_from_scratch(gas);
    } else {
        sort_again(gas);
    }
    cut_all(gas);
}

std::size_t resident_bytes(const Gas& gas)
{
    const auto bytes = [](const auto& values) { return values.size() * sizeof(values[0]); };
    return bytes(gas.particles) + bytes(gas.cells.keys) + bytes(gas.cells.cells) + bytes(gas.cells.groups) + bytes(gas.cells.buckets);
}

}  // namespace corpuscle
