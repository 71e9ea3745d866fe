#include "radial/gauge.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle {

RadialSample sample(const RadialFlow& flow, double radius)
{
    const std::vector<double>& edges = flow.edges();
    const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, radius);
    const auto cell = static_cast<std::size_t>(above - edges.begin()) - 1;
    const double share = std::clamp((radius - edges[cell]) / (edges[cell + 1] - edges[cell]), 0.0, 1.0);
    const std::size_t last = flow.cells() - 1;
    const std::size_t lower = radius < flow.middle(cell) ? (cell == 0 ? 0 : cell - 1) : std::min(cell, last - 1);
    double pressure = flow.pressures()[cell];
    if (last > 0) {
        const double way = (radius - flow.middle(lower)) / (flow.middle(lower + 1) - flow.middle(lower));
        pressure = std::lerp(flow.pressures()[lower], flow.pressures()[lower + 1], std::clamp(way, 0.0, 1.0));
    }
    return {flow.time(), pressure, flow.densities()[cell], std::lerp(flow.velocities()[cell], flow.velocities()[cell + 1], share)};
}

void RadialGauge::record(const RadialFlow& flow)
{
    if (flow.edges()[flow.disturbed()] >= radius) samples.push_back(sample(flow, radius));
}

BlastMeasures measure_blast(const std::vector<RadialSample>& samples, double ambient_pressure)
{
    BlastMeasures measures;
    const auto over = [&](std::size_t i) { return samples[i].pressure - ambient_pressure; };
    std::size_t i = 0, peak = 0;
    for (; i < samples.size() && (over(peak) <= 1e-3 * ambient_pressure || over(i) > 0.8 * over(peak)); ++i)
        if (over(i) > over(peak)) peak = i;
    if (samples.empty() || over(peak) <= 1e-3 * ambient_pressure) return measures;
    measures.overpressure = over(peak);
    std::size_t first = 0;
    while (over(first) < 0.5 * over(peak)) ++first;
    measures.arrival = samples[first].time;
    for (i = 1; i < samples.size(); ++i) {
        measures.complete = i > peak && over(i) <= 0;
        if (measures.complete) break;
        measures.impulse += 0.5 * std::max(0.0, over(i) + over(i - 1)) * (samples[i].time - samples[i - 1].time);
    }
    measures.duration = samples[std::min(i, samples.size() - 1)].time - measures.arrival;
    return measures;
}

}  // namespace corpuscle
