#pragma once

#include "gas/gas.hpp"

namespace corpuscle {

/// Puts the particles in the order of the cell curve, drops those that are gone and cuts the cells anew.
/// Between two steps few particles leave their bucket (a run of about a thousand): those alone change place over long
/// distances, the rest is sorted inside its bucket, in cache. In place: besides its 32 bytes a particle needs its key (8)
/// and its part of the movers. The order does not depend on the number of threads.
void sort(Gas& gas);

/// Bytes that the particles, their keys and cells take in memory; what the last sort needed besides is in `gas.cells.sort_bytes`.
[[nodiscard]] std::size_t resident_bytes(const Gas& gas);

}  // namespace corpuscle
