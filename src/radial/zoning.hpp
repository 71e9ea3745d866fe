#pragma once

#include <vector>

namespace corpuscle {

/// Edges of cells from one radius to another [m] whose widths grow (or shrink) geometrically from about `first` to about `last` [m].
[[nodiscard]] std::vector<double> graded_edges(double from, double to, double first, double last);

/// Edges of cells from one radius to at least another [m] whose widths start at `first` and grow with the radius to a power: 0 even, 1 in
/// proportion.
[[nodiscard]] std::vector<double> growing_edges(double from, double to, double first, double power);

}  // namespace corpuscle
