#pragma once

#include "gas/gas.hpp"

namespace corpuscle {

/// Puts the particles in the order of the cells along the curve, drops those that are gone and cuts the cells anew.
/// Between two steps few particles leave their bucket (a box with about a thousand): those alone change place over long distances,
/// the rest is sorted inside its bucket, in cache. In place: besides its 32 bytes a particle needs its part of the movers. Which
/// particles share a cell depends on their places alone, their order within it on the last one's; neither on the number of threads.
void sort(Gas& gas);

/// Bytes that the particles and cells take in memory; what the last sort needed besides is in `gas.cells.sort_bytes`.
[[nodiscard]] std::size_t resident_bytes(const Gas& gas);

}  // namespace corpuscle
