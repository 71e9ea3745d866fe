#include "parallel/loops.hpp"

#include <omp.h>

namespace corpuscle {

void set_thread_count(int count)
{
    omp_set_num_threads(std::max(1, count));
}

int thread_count()
{
    return omp_get_max_threads();
}

std::size_t thread_number()
{
    return static_cast<std::size_t>(omp_get_thread_num());
}

WorkShares::WorkShares(std::size_t pieces, std::size_t workers) : shares_(workers)
{
    for (std::size_t w = 0; w < workers; ++w) {
        shares_[w].next = pieces * w / workers;
        shares_[w].end = pieces * (w + 1) / workers;
    }
}

std::size_t part_count(std::size_t count, std::size_t smallest)
{
    const auto threads = static_cast<std::size_t>(thread_count());
    return std::clamp<std::size_t>(count / smallest, 1, threads);
}

}  // namespace corpuscle
