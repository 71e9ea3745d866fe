#include "math/statistics.hpp"

#include <cmath>

#include "math/student.hpp"

namespace corpuscle {

Statistic statistic_of(std::span<const double> samples, double confidence)
{
    Statistic result;
    double sum = 0, squares = 0;
    for (const double sample : samples) {
        if (!std::isfinite(sample)) continue;
        ++result.count;
        sum += sample;
    }
    if (result.count == 0) return result;
    const auto count = static_cast<double>(result.count);
    result.mean = sum / count;
    if (result.count == 1) return result;
    for (const double sample : samples)
        if (std::isfinite(sample)) squares += (sample - result.mean) * (sample - result.mean);
    result.deviation = std::sqrt(squares / (count - 1));
    result.standard_error = result.deviation / std::sqrt(count);
    const double reach = student_limit(confidence, static_cast<int>(result.count) - 1) * result.standard_error;
    result.low = result.mean - reach;
    result.high = result.mean + reach;
    return result;
}

}  // namespace corpuscle
