#pragma once

#include <cmath>

namespace corpuscle {

/// The share of a gas within a cell where it meets another: a step smoothed by a hyperbolic tangent, so that it stays a cell or two wide
/// however long it travels: a(x) = low + (high - low) (1 + sign tanh(beta (x - d)))/2, 0 <= x <= 1 across the cell, with the mean of the
/// cell. Source: Xiao, Honma, Kono, Int. J. Numer. Meth. Fluids 48 (2005) 1023 (THINC).
class SmoothStep {
public:
    /// Between the shares of the cells before and behind, which the cell's share lies between.
    SmoothStep(double before, double share, double behind, double steepness)
        : low_(before < behind ? before : behind), rise_(std::abs(behind - before)), upward_(behind > before), beta_(steepness)
    {
        const double mean = std::fmin(std::fmax((share - low_) / rise_, 1e-9), 1 - 1e-9);
        const double ratio = std::exp(beta_ * (2 * mean - 1));
        offset_ = (std::exp(beta_) - ratio) / (ratio - std::exp(-beta_));  // exp(2 beta d), from the cell's mean
    }

    /// Mean over the part of width `width` (0 to 1) at the lower or the upper face: what leaves through it in a step.
    [[nodiscard]] double mean_near(bool upper, double width) const
    {
        const bool high_x = upper == upward_;
        const double from = high_x ? 1 - width : 0, to = high_x ? 1 : width;
        if (width < 1e-5) return low_ + rise_ * rising(high_x ? 1 : 0);
        const double mean = std::log((std::exp(2 * beta_ * to) + offset_) / (std::exp(2 * beta_ * from) + offset_)) / (2 * beta_ * width);
        return low_ + rise_ * std::fmin(std::fmax(mean, 0.0), 1.0);
    }

private:
    /// The rising step at a place; a falling one is its mirror's image.
    [[nodiscard]] double rising(double x) const
    {
        const double e = std::exp(2 * beta_ * x);
        return e / (e + offset_);
    }
    double low_, rise_;
    bool upward_;
    double beta_, offset_ = 1;
};

}  // namespace corpuscle
