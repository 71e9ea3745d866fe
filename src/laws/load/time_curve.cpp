#include "laws/load/time_curve.hpp"

#include <algorithm>
#include <cassert>

namespace corpuscle {

TimeCurve::TimeCurve(const std::vector<std::pair<double, double>>& points)
{
    assert(!points.empty());
    pieces_.push_back({points.front().first, points.front().second, 0, 0, 0});
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& [time, value] = points[i];
        const bool last = i + 1 == points.size();
        const double slope = last ? 0.0 : (points[i + 1].second - value) / (points[i + 1].first - time);
        pieces_.push_back({time, value, slope, once(time), twice(time)});
    }
}

const TimeCurve::Piece& TimeCurve::piece_at(double time) const
{
    const auto after =
        std::upper_bound(pieces_.begin() + 1, pieces_.end(), time, [](double t, const Piece& piece) { return t < piece.start; });
    return *(after - 1);
}

double TimeCurve::value(double time) const
{
    const Piece& p = piece_at(time);
    return p.value + p.slope * (time - p.start);
}

double TimeCurve::once(double time) const
{
    const Piece& p = piece_at(time);
    const double h = time - p.start;
    return p.once + h * (p.value + 0.5 * p.slope * h);
}

double TimeCurve::twice(double time) const
{
    const Piece& p = piece_at(time);
    const double h = time - p.start;
    return p.twice + h * (p.once + h * (0.5 * p.value + p.slope * h / 6));
}

}  // namespace corpuscle
