#pragma once

#include <cstddef>
#include <limits>
#include <span>

namespace corpuscle {

/// Share of intervals that hold the true mean.
inline constexpr double usual_confidence = 0.95;

/// What independent samples of one quantity say about it, in its unit. Not a number where there are too few: of one sample only the mean
/// is known.
struct Statistic {
    std::size_t count = 0;  ///< samples
    double mean = std::numeric_limits<double>::quiet_NaN();
    double deviation = std::numeric_limits<double>::quiet_NaN();       ///< standard deviation of a sample (n - 1)
    double standard_error = std::numeric_limits<double>::quiet_NaN();  ///< of the mean
    double low = std::numeric_limits<double>::quiet_NaN();             ///< lower end of the mean's confidence interval
    double high = std::numeric_limits<double>::quiet_NaN();            ///< upper end

    friend bool operator==(const Statistic&, const Statistic&) = default;
};

/// Mean and scatter of samples, those that are not finite left out, and the interval mean +- t s/sqrt(n) with Student's t of n - 1 degrees,
/// which holds the true mean of normally distributed samples with the given confidence.
[[nodiscard]] Statistic statistic_of(std::span<const double> samples, double confidence = usual_confidence);

}  // namespace corpuscle
