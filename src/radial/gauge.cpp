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

BlastMeasures measure_blast(const std::vector<RadialSample>& samples, double ambient_pressure, double noise)
{
    BlastMeasures measures;
    const auto over = [&](std::size_t i) { return samples[i].pressure - ambient_pressure; };
    std::size_t peak = 0;
    for (std::size_t i = 0; i < samples.size() && (over(peak) <= noise || over(i) > 0.5 * over(peak)); ++i)
        if (over(i) > over(peak)) peak = i;
    if (samples.empty() || over(peak) <= noise) return measures;
    measures.overpressure = over(peak);
    std::size_t foot = peak;
    while (foot > 0 && over(foot) > 0) --foot;
    std::size_t arrived = foot;
    while (over(arrived) < 0.5 * over(peak)) ++arrived;
    measures.arrival = samples[arrived].time;
    std::size_t i = foot + 1;
    for (; i < samples.size() && !measures.complete; ++i) {
        measures.impulse += 0.5 * std::max(0.0, over(i) + over(i - 1)) * (samples[i].time - samples[i - 1].time);
        measures.complete = i > peak && over(i) <= 0;
    }
    measures.duration = samples[i - 1].time - measures.arrival;
    return measures;
}

}  // namespace corpuscle
