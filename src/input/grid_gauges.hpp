#pragma once

#include "euler/grid.hpp"
#include "input/case/record_input.hpp"
#include "model/records.hpp"

namespace corpuscle {

/// A gauge of the gases on a grid. In round grids a ball is taken where a turn about the axis carries it into the half plane y = 0, a box
/// where that half plane cuts it. A point, and a region that no cell's points lie in, is the cell
/// around it or its middle. `end_time` [s] gives the interval where the case does not. Errors: InputError at the gauge.
[[nodiscard]] Gauge make_grid_gauge(const GaugeInput& input, const EulerGrid& grid, double end_time);

}  // namespace corpuscle
