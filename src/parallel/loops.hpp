#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

namespace corpuscle {

/// Threads that the loops below use. Results never depend on it: not one bit.
void set_thread_count(int count);
[[nodiscard]] int thread_count();
/// Which of a loop's threads this is, from 0.
[[nodiscard]] std::size_t thread_number();

/// Items that a sum adds up as one piece, whatever the number of threads.
inline constexpr std::size_t chunk_size = 4096;

/// body(i) for i in [0, count), in any order; bodies must not write what another reads.
template <class Body>
void for_each(std::size_t count, const Body& body)
{
#pragma omp parallel for schedule(static) if (count > 256)
    for (std::size_t i = 0; i < count; ++i) body(i);
}

/// The pieces of one loop, dealt out: each worker has pieces that follow one another, the same in every loop of that size, so that what
/// it works on stays in its own cache; whoever is done takes from what others have left.
class WorkShares {
public:
    WorkShares(std::size_t pieces, std::size_t workers);

    /// body(piece) for every piece that `worker` comes to; all pieces are done when all workers that began have come back.
    template <class Body>
    void work(std::size_t worker, const Body& body)
    {
        for (std::size_t k = 0; k < shares_.size(); ++k) {
            Share& share = shares_[(worker + k) % shares_.size()];
            for (std::size_t p = share.next.fetch_add(1); p < share.end; p = share.next.fetch_add(1)) body(p);
        }
    }

private:
    struct alignas(64) Share {
        std::atomic<std::size_t> next;
        std::size_t end;
    };
    std::vector<Share> shares_;
};

/// As `for_each` for items of unequal cost: dealt out `grain` at a time.
template <class Body>
void for_each_dynamic(std::size_t count, std::size_t grain, const Body& body)
{
    const std::size_t pieces = (count + grain - 1) / grain;
    WorkShares shares(pieces, std::min(pieces, static_cast<std::size_t>(thread_count())));
#pragma omp parallel if (pieces > 1)
    shares.work(thread_number(), [&](std::size_t piece) {
        for (std::size_t i = piece * grain; i < std::min(count, (piece + 1) * grain); ++i) body(i);
    });
}

/// As `for_each` for bodies that write only their own item: vectorised.
template <class Body>
void for_each_simd(std::size_t count, const Body& body)
{
#pragma omp parallel for simd schedule(static) if (count > 4096)
    for (std::size_t i = 0; i < count; ++i) body(i);
}

/// body(i) for i in [0, count) one after another by one thread, several side by side: bodies must not write what another reads.
template <class Body>
inline void for_simd(std::size_t count, const Body& body)
{
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) body(i);
}

/// body(part, begin, end): [0, count) in `parts` contiguous pieces, one task each (parts: see `part_count`).
template <class Body>
void for_each_part(std::size_t count, std::size_t parts, const Body& body)
{
#pragma omp parallel for schedule(static, 1)
    for (std::size_t part = 0; part < parts; ++part) body(part, count * part / parts, count * (part + 1) / parts);
}

/// body(scratch, i) for i in [0, count), in any order, items of unequal cost and room to work in for each thread: as many threads
/// as there are `scratches`.
template <class Scratch, class Body>
void for_each_with(std::vector<Scratch>& scratches, std::size_t count, const Body& body)
{
    WorkShares shares(count, scratches.size());
    for_each_part(scratches.size(), scratches.size(),
                  [&](std::size_t part, std::size_t, std::size_t) { shares.work(part, [&](std::size_t i) { body(scratches[part], i); }); });
}

/// How many pieces are worth making of `count` items.
[[nodiscard]] std::size_t part_count(std::size_t count, std::size_t smallest = 1024);

/// Reduction in a fixed order: `term(begin, end)` reduces one chunk of at most `size` items to a T, and the chunks' results are
/// added (+=) in order. The same bits for any number of threads.
template <class T, class Term>
T sum_chunks(std::size_t count, const Term& term, std::size_t size = chunk_size)
{
    const std::size_t chunks = (count + size - 1) / size;
    std::vector<T> partial(chunks);
    for_each_dynamic(chunks, 1, [&](std::size_t c) { partial[c] = term(c * size, std::min(count, (c + 1) * size)); });
    T total{};
    for (const T& p : partial) total += p;
    return total;
}

/// Sum of term(i) for i in [0, count), in a fixed order.
template <class T, class Term>
T sum(std::size_t count, const Term& term)
{
    return sum_chunks<T>(count, [&](std::size_t begin, std::size_t end) {
        T total{};
        for (std::size_t i = begin; i < end; ++i) total += term(i);
        return total;
    });
}

/// Smallest term(i), or `start` if none is smaller.
template <class Term>
double minimum(std::size_t count, double start, const Term& term)
{
    double least = start;
#pragma omp parallel for schedule(static) reduction(min : least) if (count > 256)
    for (std::size_t i = 0; i < count; ++i) least = std::min(least, static_cast<double>(term(i)));
    return least;
}

/// Exclusive prefix sum in place; returns the total.
template <class T>
T exclusive_scan(std::vector<T>& values)
{
    T total{};
    for (T& value : values) {
        const T own = value;
        value = total;
        total += own;
    }
    return total;
}

}  // namespace corpuscle
