#pragma once

#include <vector>

#include "euler/grid.hpp"
#include "fields/transfer.hpp"
#include "model/ledger.hpp"

// The gases on a grid in the ledger's words: space, and the holders "gas" and "explosive".

namespace corpuscle {

/// A vector of the grid's axes in space: of rings (radius, height) in the half plane y = 0, of shells along x.
[[nodiscard]] Vector3d in_space(EulerSpace space, const Vector3d& vector);

/// What the grid holds the whole way round, explosive that waits included. Momentum that goes round sums to nothing.
[[nodiscard]] Holding held(const EulerGrid& grid);

/// What the gases gave to each edge since the passages were `before`.
[[nodiscard]] std::vector<Transfer> given_to_edges(const EulerGrid& grid, const EulerPassages& before);

/// What burning explosive gave to the gases.
[[nodiscard]] Transfer given_by_burning(const EulerAmount& released);

/// Area of a face of the grid, the whole way round [m2].
[[nodiscard]] double face_area(const EulerGrid& grid, int face);

}  // namespace corpuscle
