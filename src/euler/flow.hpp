#pragma once

#include "base/clock.hpp"
#include "euler/grid.hpp"

namespace corpuscle {

/// Readies a grid whose cells were laid out or read back: finds what is quiet, the stable step, the gases in each block.
void prepare(EulerGrid& grid);

/// Moves the gases on by the clock's step, then lets the explosive burn that the detonation has reached at its end. Returns what the
/// explosive gave to the gas. Euler's equations of several gases in one pressure and velocity (Allaire, Clerc, Kokh, J. Comput. Phys. 181
/// (2002) 577), second order in space and time where the flow is smooth: see docs/theory/euler.md.
EulerAmount flow(EulerGrid& grid, const Clock& clock);

/// A stable step found by the last `flow` or `prepare` [s].
[[nodiscard]] double stable_step(const EulerGrid& grid);

/// Cells of the active blocks.
[[nodiscard]] std::size_t active_cells(const EulerGrid& grid);

}  // namespace corpuscle
