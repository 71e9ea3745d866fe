#include "gas/sort.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "gas/divide.hpp"
#include "gas/sleep.hpp"
#include "parallel/sort.hpp"

namespace corpuscle {

namespace {

/// A bucket holds about a thousand particles: what is sorted in cache.
DivisionLimits limits_of(const GasSettings& settings)
{
    const std::uint32_t group = std::max(settings.group_limit, settings.cell_limit);
    return {settings.cell_limit, group, std::max(1024u, 2 * group)};
}

using Places = std::vector<std::uint32_t>;

std::size_t bucket_count(const Cells& cells)
{
    return cells.buckets.size() - 1;
}

/// Into how many pieces so many buckets are shared out: some for each thread, so that none waits long for another.
std::size_t pieces_of(std::size_t buckets)
{
    return std::clamp<std::size_t>(buckets / 8, 1, 8 * static_cast<std::size_t>(thread_count()));
}

template <class T>
std::size_t bytes(const std::vector<T>& values)
{
    return values.capacity() * sizeof(T);
}

/// Finds the bucket that a key is in: a table over the leading bits, then halving.
class BucketFinder {
public:
    explicit BucketFinder(const std::vector<Bucket>& buckets) : buckets_(buckets)
    {
        const std::size_t count = buckets.size() - 1;
        const int bits = std::min(20, static_cast<int>(std::bit_width(count)) + 1);
        shift_ = CellCurve::depth_limit - bits;
        first_.resize((std::size_t{1} << bits) + 1);
        std::uint32_t bucket = 0;
        for (std::size_t t = 0; t + 1 < first_.size(); ++t) {
            while (bucket + 1 < count && buckets[bucket + 1].start_key <= t << shift_) ++bucket;
            first_[t] = bucket;
        }
        first_.back() = static_cast<std::uint32_t>(count - 1);
    }

    [[nodiscard]] std::uint32_t operator()(std::uint64_t key) const
    {
        const std::size_t t = key >> shift_;
        std::uint32_t low = first_[t], high = first_[t + 1];
        while (low < high) {
            const std::uint32_t middle = (low + high + 1) / 2;
            if (buckets_[middle].start_key <= key) {
                low = middle;
            } else {
                high = middle - 1;
            }
        }
        return low;
    }

private:
    const std::vector<Bucket>& buckets_;
    int shift_ = 0;
    std::vector<std::uint32_t> first_;  ///< bucket in which the keys with these leading bits begin
};

/// Particles that change their bucket, newcomers included.
struct Movers {
    std::vector<Particle> particles;
    Places bucket;                 ///< of each
    Places order;                  ///< of the particles by bucket
    Places start;                  ///< first in `order` of each bucket, and the end
    std::vector<Vector3d> turned;  ///< impulses of particles that gas asleep turned back [N s]

    void add(const Particle& particle, std::uint32_t to)
    {
        particles.push_back(particle);
        bucket.push_back(to);
    }
    [[nodiscard]] std::uint32_t coming_to(std::size_t b) const { return start[b + 1] - start[b]; }
};

/// Where a particle is, after it has been turned back if gas sleeps there.
CellCurve::Steps awake_place(const Gas& gas, Particle& particle, Movers& movers)
{
    const CellCurve& curve = gas.cells.curve;
    const CellCurve::Steps place = curve.steps(particle.position);
    if (!gas.sleeping.holds(curve.key(place))) return place;
    movers.turned.push_back(turn_back(gas, particle));
    return curve.steps(particle.position);
}

/// Lists the particles that leave a bucket and marks them as gone there. Returns how many stay.
std::uint32_t pick_movers(Gas& gas, std::size_t b, const BucketFinder& find, Movers& movers)
{
    const CellCurve& curve = gas.cells.curve;
    const Bucket& bucket = gas.cells.buckets[b];
    const std::uint32_t end = gas.cells.buckets[b + 1].first;
    const CellCurve::Extent extent = curve.extent(bucket.start_key, static_cast<int>(bucket.depth));
    std::uint32_t kept = 0;
    for (std::uint32_t i = bucket.first; i < end; ++i) {
        Particle& particle = gas.particles[i];
        if (particle.tag & particle_tag::gone) continue;
        CellCurve::Steps place = curve.steps(particle.position);
        if (!extent.holds(place)) place = awake_place(gas, particle, movers);
        if (extent.holds(place)) {
            ++kept;
            continue;
        }
        movers.add(particle, find(curve.key(place)));
        particle.tag |= particle_tag::gone;
    }
    return kept;
}

/// Lists newcomers: gas that has woken, before the sorted particles, and gas that has come in, behind them.
void pick_newcomers(Gas& gas, const BucketFinder& find, Movers& movers)
{
    const auto pick = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Particle& particle = gas.particles[i];
            if (particle.tag & particle_tag::gone) continue;
            const CellCurve::Steps place = awake_place(gas, particle, movers);
            movers.add(particle, find(gas.cells.curve.key(place)));
        }
    };
    pick(gas.sleeping.particles, gas.cells.buckets.front().first);
    pick(gas.cells.buckets.back().first, gas.particles.size());
}

/// Joins lists in their order.
Movers join(const std::vector<Movers>& lists)
{
    std::vector<std::size_t> start;
    for (const Movers& list : lists) start.push_back(list.particles.size());
    const std::size_t total = exclusive_scan(start);
    Movers all;
    all.particles.resize(total);
    all.bucket.resize(total);
    for_each_part(lists.size(), lists.size(), [&](std::size_t part, std::size_t, std::size_t) {
        std::copy(lists[part].particles.begin(), lists[part].particles.end(),
                  all.particles.begin() + static_cast<std::ptrdiff_t>(start[part]));
        std::copy(lists[part].bucket.begin(), lists[part].bucket.end(), all.bucket.begin() + static_cast<std::ptrdiff_t>(start[part]));
    });
    return all;
}

/// Finds who leaves which bucket and where to, and how many stay in each.
Movers find_movers(Gas& gas, Places& kept)
{
    const BucketFinder find(gas.cells.buckets);
    const std::size_t buckets = bucket_count(gas.cells), parts = pieces_of(buckets);
    std::vector<Movers> lists(parts);
    for_each_dynamic(parts, 1, [&](std::size_t part) {
        for (std::size_t b = buckets * part / parts; b < buckets * (part + 1) / parts; ++b)
            kept[b] = pick_movers(gas, b, find, lists[part]);
    });
    pick_newcomers(gas, find, lists.back());
    for (const Movers& list : lists) {
        for (const Vector3d& impulse : list.turned) gas.sleeping.turned.momentum += impulse;
    }
    gas.cells.sort_bytes = 0;
    if (parts > 1) {
        for (const Movers& list : lists) gas.cells.sort_bytes += bytes(list.particles) + bytes(list.bucket);
    }
    Movers movers = parts > 1 ? join(lists) : std::move(lists[0]);
    movers.order.resize(movers.particles.size());
    movers.start = stable_counting_sort(
        movers.particles.size(), buckets, [&](std::size_t i) { return movers.bucket[i]; },
        [&](std::size_t i, std::uint32_t position) { movers.order[position] = static_cast<std::uint32_t>(i); });
    gas.cells.sort_bytes += bytes(movers.particles) + bytes(movers.bucket) + bytes(movers.order) + bytes(movers.start) + bytes(kept);
    return movers;
}

/// Joins neighbouring halves that together will hold few: buckets are split as they fill, and so united as they empty; but not to boxes
/// that are halved less than `depth` times. Compacts with them the buckets' new first particles and first movers.
void unite(std::vector<Bucket>& buckets, Places& new_first, Places& first_mover, std::uint32_t limit, int depth)
{
    std::size_t united = 0;  // buckets so far
    for (std::size_t b = 0; b + 1 < buckets.size(); ++b) {
        buckets[united] = buckets[b];
        new_first[united] = new_first[b];
        first_mover[united] = first_mover[b];
        for (++united; united > 1; --united) {
            const Bucket &left = buckets[united - 2], &right = buckets[united - 1];
            const bool halves =
                left.depth == right.depth && CellCurve::common_depth(left.start_key, right.start_key) == static_cast<int>(left.depth) - 1;
            if (!halves || static_cast<int>(left.depth) <= depth || new_first[b + 1] - new_first[united - 2] > limit / 2) break;
            --buckets[united - 2].depth;
        }
    }
    const auto close = [&](auto& values) {
        values[united] = values.back();
        values.resize(united + 1);
    };
    close(buckets);
    close(new_first);
    close(first_mover);
}

/// Sorts the buckets [begin, end) in place: their particles' old places and new ones overlap. Buckets that move up are sorted from
/// the last to the first, then those that move down from the first to the last: so none is written over another's old particles
/// before those are sorted. What other segments write over is saved beforehand.
class Segment {
public:
    Segment(Gas& gas, const Movers& movers, const Places& new_first, std::size_t begin, std::size_t end)
        : gas_(gas), movers_(movers), new_first_(new_first), begin_(begin), end_(end), pieces_(end - begin)
    {
    }

    /// Saves what the other segments write over. All segments, before any is sorted.
    void save()
    {
        const std::vector<Bucket>& old = gas_.cells.buckets;
        const std::uint32_t first = old[begin_].first, beyond = old[end_].first;
        head_end_ = std::clamp(new_first_[begin_], first, beyond);
        tail_begin_ = std::clamp(new_first_[end_], head_end_, beyond);
        const Particle* const particles = gas_.particles.data();
        head_.assign(particles + first, particles + head_end_);
        tail_.assign(particles + tail_begin_, particles + beyond);
    }

    void sort()
    {
        Divider divider(gas_.cells.curve, limits_of(gas_.settings));
        const auto moves_up = [&](std::size_t b) { return new_first_[b] > gas_.cells.buckets[b].first; };
        for (std::size_t b = end_; b-- > begin_;) {
            if (moves_up(b)) sort_bucket(b, divider);
        }
        for (std::size_t b = begin_; b < end_; ++b) {
            if (!moves_up(b)) sort_bucket(b, divider);
        }
    }

    /// Where the pieces of each bucket begin among those of their kind.
    struct Piece {
        std::size_t cells = 0, groups = 0, buckets = 0;
        std::size_t cell_count = 0, group_count = 0, bucket_count = 0;
    };
    [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
    [[nodiscard]] const Division& division() const { return division_; }
    [[nodiscard]] std::size_t saved_bytes() const { return bytes(head_) + bytes(tail_); }

private:
    void sort_bucket(std::size_t b, Divider& divider)
    {
        const Bucket& bucket = gas_.cells.buckets[b];
        take_old(bucket.first, gas_.cells.buckets[b + 1].first, divider);
        for (std::uint32_t k = movers_.start[b]; k < movers_.start[b + 1]; ++k) divider.take(movers_.particles[movers_.order[k]]);
        Piece& piece = pieces_[b - begin_];
        piece = {division_.cells.size(), division_.groups.size(), division_.buckets.size()};
        divider.divide(bucket.start_key, static_cast<int>(bucket.depth), gas_.particles.data() + new_first_[b], new_first_[b], division_);
        piece.cell_count = division_.cells.size() - piece.cells;
        piece.group_count = division_.groups.size() - piece.groups;
        piece.bucket_count = division_.buckets.size() - piece.buckets;
    }

    /// Takes the particles that stay of old places [first, end), some of which may have been saved.
    void take_old(std::uint32_t first, std::uint32_t end, Divider& divider) const
    {
        const std::uint32_t segment_first = gas_.cells.buckets[begin_].first;
        const std::uint32_t in_head = std::clamp(head_end_, first, end), in_tail = std::clamp(tail_begin_, in_head, end);
        if (in_head > first) divider.take_remaining(head_.data() + (first - segment_first), in_head - first);
        divider.take_remaining(gas_.particles.data() + in_head, in_tail - in_head);
        if (end > in_tail) divider.take_remaining(tail_.data() + (in_tail - tail_begin_), end - in_tail);
    }

    Gas& gas_;
    const Movers& movers_;
    const Places& new_first_;
    std::size_t begin_, end_;
    std::uint32_t head_end_ = 0, tail_begin_ = 0;
    std::vector<Particle> head_, tail_;
    Division division_;
    std::vector<Piece> pieces_;
};

/// Puts together what the segments have cut, in the order of the buckets.
void gather_pieces(Cells& cells, const std::vector<Segment>& segments, std::uint32_t particles)
{
    std::vector<Segment::Piece> start;
    Segment::Piece total;
    for (const Segment& segment : segments) {
        start.push_back(total);
        total.cells += segment.division().cells.size();
        total.groups += segment.division().groups.size();
        total.buckets += segment.division().buckets.size();
    }
    cells.cells.resize(total.cells);
    cells.groups.resize(total.groups);
    cells.buckets.resize(total.buckets);
    for_each_dynamic(segments.size(), 1, [&](std::size_t s) {
        Segment::Piece at = start[s];
        const Division& division = segments[s].division();
        for (const Segment::Piece& piece : segments[s].pieces()) {
            std::copy_n(division.cells.data() + piece.cells, piece.cell_count, cells.cells.data() + at.cells);
            std::copy_n(division.groups.data() + piece.groups, piece.group_count, cells.groups.data() + at.groups);
            std::copy_n(division.buckets.data() + piece.buckets, piece.bucket_count, cells.buckets.data() + at.buckets);
            at.cells += piece.cell_count;
            at.groups += piece.group_count;
            at.buckets += piece.bucket_count;
        }
    });
    cells.buckets.push_back({CellCurve::keys_of(0), particles, 0});
}

/// Gives every particle one bucket to begin with: buckets of equal size, into which particles are swapped in place. The first time only.
void make_buckets(Gas& gas)
{
    std::vector<Particle>& particles = gas.particles;
    const std::uint32_t awake = gas.sleeping.particles;  // the first of those that are
    std::erase_if(particles, [](const Particle& particle) { return particle.tag & particle_tag::gone; });
    gas.cells.curve = CellCurve(gas.domain.box);
    const CellCurve& curve = gas.cells.curve;
    const int enough = std::min(16, static_cast<int>(std::bit_width(particles.size() / limits_of(gas.settings).bucket)));
    const int depth = gas.sleeping.any() ? std::max(enough, gas.sleeping.depth) : enough;
    const auto bucket_of = [&](const Particle& particle) { return curve.key(particle.position) >> (CellCurve::depth_limit - depth); };
    Places next(std::size_t{1} << depth);
    for (std::size_t i = awake; i < particles.size(); ++i) ++next[bucket_of(particles[i])];
    exclusive_scan(next);
    for (std::uint32_t& first : next) first += awake;
    std::vector<Bucket> buckets;
    for (const std::uint32_t first : next)
        buckets.push_back({buckets.size() * CellCurve::keys_of(depth), first, static_cast<std::uint32_t>(depth)});
    buckets.push_back({CellCurve::keys_of(0), static_cast<std::uint32_t>(particles.size()), 0});
    for (std::size_t b = 0; b + 1 < buckets.size(); ++b) {
        while (next[b] < buckets[b + 1].first) {
            const std::size_t home = bucket_of(particles[next[b]]);
            if (home == b) {
                ++next[b];
            } else {
                std::swap(particles[next[b]], particles[next[home]++]);
            }
        }
    }
    gas.cells.buckets = std::move(buckets);
}

}  // namespace

void sort(Gas& gas)
{
    if (gas.cells.buckets.empty()) make_buckets(gas);
    Places new_first(bucket_count(gas.cells) + 1, 0);
    Movers movers = find_movers(gas, new_first);
    for (std::size_t b = 0; b + 1 < new_first.size(); ++b) new_first[b] += movers.coming_to(b);
    exclusive_scan(new_first);
    for (std::uint32_t& first : new_first) first += gas.sleeping.particles;
    const std::uint32_t total = new_first.back();
    gas.particles.resize(std::max<std::size_t>(gas.particles.size(), total));
    unite(gas.cells.buckets, new_first, movers.start, limits_of(gas.settings).bucket, gas.sleeping.any() ? gas.sleeping.depth : 0);

    const std::size_t buckets = bucket_count(gas.cells);
    const std::size_t count = pieces_of(buckets);
    std::vector<Segment> segments;
    for (std::size_t s = 0; s < count; ++s) segments.emplace_back(gas, movers, new_first, buckets * s / count, buckets * (s + 1) / count);
    for_each_dynamic(count, 1, [&](std::size_t s) { segments[s].save(); });
    for_each_dynamic(count, 1, [&](std::size_t s) { segments[s].sort(); });
    for (const Segment& segment : segments) gas.cells.sort_bytes += segment.saved_bytes();
    gas.particles.resize(total);
    gather_pieces(gas.cells, segments, total);
}

std::size_t resident_bytes(const Gas& gas)
{
    return bytes(gas.particles) + bytes(gas.cells.cells) + bytes(gas.cells.groups) + bytes(gas.cells.buckets);
}

}  // namespace corpuscle
