#pragma once

#include "euler/grid.hpp"

namespace corpuscle {

/// Finds when each explosive, as it was laid out, will have burnt.
void plan_burning(EulerGrid& grid);

/// Lets explosive burn that the detonation has reached at a time [s]: as the front passes two and a half cells, what waits in a cell
/// becomes products and gets its energy. What was moved into burnt cells
/// meanwhile burns too, and all of it when the front has passed the whole charge, so the sum is exact. Returns mass and energy
/// that the explosive gave.
EulerAmount burn(EulerGrid& grid, double time);

}  // namespace corpuscle
