#pragma once

#include <utility>
#include <vector>

namespace corpuscle {

/// A quantity over time [s]: straight between its points, as at the first before it and as at the last behind it.
class TimeCurve {
public:
    TimeCurve() : TimeCurve(0.0) {}
    explicit TimeCurve(double constant) : TimeCurve({{0.0, constant}}) {}
    /// Points (time, value) in the order of time, none at the time of another; at least one.
    explicit TimeCurve(const std::vector<std::pair<double, double>>& points);

    [[nodiscard]] double value(double time) const;
    /// Its integral from one time to another, exact.
    [[nodiscard]] double integral(double from, double to) const { return once(to) - once(from); }
    /// The integral from 0 to a time of its integral from 0: the way of a body whose acceleration it is, exact.
    [[nodiscard]] double way(double time) const { return twice(time) - twice(0) - once(0) * time; }

private:
    /// A piece between two points, or before the first or behind the last: what is known where it begins.
    struct Piece {
        double start = 0;  ///< [s]
        double value = 0, slope = 0;
        double once = 0, twice = 0;  ///< integral, and integral of the integral, from the first point
    };

    [[nodiscard]] const Piece& piece_at(double time) const;
    [[nodiscard]] double once(double time) const;
    [[nodiscard]] double twice(double time) const;

    std::vector<Piece> pieces_;  ///< the one before the first point, then one from each point
};

}  // namespace corpuscle
