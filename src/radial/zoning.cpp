#include "radial/zoning.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle {

std::vector<double> graded_edges(double from, double to, double first, double last)
{
    const double length = to - from;
    first = std::min(first, 0.5 * length);
    last = std::min(last, 0.5 * length);
    const double wanted = (length - first) / (length - last);  // of one width to the one before
    const bool even = std::abs(last / first - 1) < 1e-3;
    const double count = std::max(1.0, std::round(even ? length / first : 1 + std::log(last / first) / std::log(wanted)));
    const double ratio = count < 2 ? 1.0 : std::pow(last / first, 1 / (count - 1));
    std::vector<double> edges{from};
    double width = 1;
    for (double i = 0; i < count; ++i, width *= ratio) edges.push_back(edges.back() + width);
    const double scale = length / (edges.back() - from);
    for (double& edge : edges) edge = from + scale * (edge - from);
    edges.back() = to;
    return edges;
}

std::vector<double> growing_edges(double from, double to, double first, double power)
{
    std::vector<double> edges{from};
    while (edges.back() < to) edges.push_back(edges.back() + first * (from > 0 ? std::pow(edges.back() / from, power) : 1.0));
    return edges;
}

}  // namespace corpuscle
