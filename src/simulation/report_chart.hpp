#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace corpuscle {

/// Ends of a band around a curve; empty: no band.
struct Band {
    std::vector<double> low;
    std::vector<double> high;
};

/// One curve of a chart, in SI.
struct Curve {
    std::string label;
    std::vector<double> x;                   ///< growing
    std::vector<double> y;                   ///< as long as x; points that are not finite are left out
    Band band = {};                          ///< as long as x, if there is one
    std::optional<std::size_t> beside = {};  ///< number of the curve that this one is a reference for: its colour, dashed
};

/// A value to compare with, drawn as a dashed line.
struct ReferenceLine {
    double value = 0;
    std::string label;
};

/// A diagram of curves over one axis.
struct Chart {
    std::string title;
    std::string x_name;  ///< "time"
    std::string x_unit;  ///< SI
    std::string y_name;
    std::string y_unit;  ///< SI
    std::vector<Curve> curves;
    std::vector<ReferenceLine> references;
};

/// Round values for an axis from `low` to `high`: multiples of 1, 2 or 5 times a power of ten, about `wanted` of them, covering the range.
[[nodiscard]] std::vector<double> axis_ticks(double low, double high, int wanted);

/// A curve with at most about `limit` points that looks the same: first, lowest, highest and last point of each of equal slices of x.
/// Points that are not finite are dropped.
[[nodiscard]] std::vector<std::pair<double, double>> thinned(const Curve& curve, std::size_t limit);

/// The chart as an HTML figure: an inline drawing, a legend, and its points for the pointer's read-out. Needs the report's style and
/// script.
[[nodiscard]] std::string drawn(const Chart& chart);

}  // namespace corpuscle
