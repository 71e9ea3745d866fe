#pragma once

#include <algorithm>
#include <cmath>

namespace corpuscle {

/// A straight line through points, by least squares.
class LineFit {
public:
    void add(double x, double y) { n_ += 1, x_ += x, y_ += y, xx_ += x * x, xy_ += x * y, yy_ += y * y; }
    [[nodiscard]] double slope() const { return (xy_ - x_ * y_ / n_) / (xx_ - x_ * x_ / n_); }
    [[nodiscard]] double at_zero() const { return y_ / n_ - slope() * x_ / n_; }
    /// Deviation of the points from the line.
    [[nodiscard]] double scatter() const
    {
        return std::sqrt(std::max(0.0, (yy_ - y_ * y_ / n_ - slope() * slope() * (xx_ - x_ * x_ / n_)) / (n_ - 2)));
    }
    [[nodiscard]] double error_of_slope() const { return scatter() / std::sqrt(xx_ - x_ * x_ / n_); }
    [[nodiscard]] double error_at_zero() const { return error_of_slope() * std::sqrt(xx_ / n_); }

private:
    double n_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0, yy_ = 0;
};

}  // namespace corpuscle
