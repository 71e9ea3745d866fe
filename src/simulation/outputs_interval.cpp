#include "simulation/outputs_interval.hpp"

#include <cmath>
#include <limits>

namespace corpuscle {

namespace {

constexpr double tolerance = 1e-6;  ///< of the interval

}  // namespace

Interval::Interval(double every) : every_(every) {}

double Interval::next() const
{
    if (count_ == 0) return 0;
    return every_ > 0 && std::isfinite(every_) ? count_ * every_ : std::numeric_limits<double>::infinity();
}

bool Interval::take(double time)
{
    const double margin = count_ == 0 || !std::isfinite(every_) ? 0 : tolerance * every_;
    if (time < next() - margin) return false;
    resume(time);
    return true;
}

void Interval::resume(double time)
{
    const bool repeats = every_ > 0 && std::isfinite(every_);
    count_ = repeats ? std::floor(time / every_ + tolerance) + 1 : 1;
}

}  // namespace corpuscle
