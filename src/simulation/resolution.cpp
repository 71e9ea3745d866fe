#include "simulation/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/distance.hpp"

namespace corpuscle {

namespace {

/// From each charge's first detonation point to its furthest particle [m].
std::vector<double> radii(const Gas& gas)
{
    std::vector<double> radius(gas.charges.size());
    for (const Particle& particle : gas.particles) {
        if (!(particle.tag & particle_tag::unburnt)) continue;
        const std::uint32_t charge = particle_tag::charge(particle.tag);
        const Vector3d& lit = gas.charges[charge].points.front().point;
        radius[charge] = std::max(radius[charge], norm(Vector3d(particle.position) - lit));
    }
    return radius;
}

/// To the nearest facet or face of the gas box with a gauge [m]; infinity without either.
double stand_off(const Model& model, const Vector3d& point)
{
    double nearest = std::numeric_limits<double>::infinity();
    const std::vector<Vector3d>& at = model.structure.nodes.position;
    for (const Facet& facet : model.structure.surface.facets)
        nearest = std::min(nearest, distance_to_triangle(point, {at[facet.node[0]], at[facet.node[1]], at[facet.node[2]]}));
    for (const Gauge& gauge : model.gauges) {
        const auto* face = std::get_if<FaceGauge>(&gauge.place);
        if (face == nullptr) continue;
        const Box& box = model.gas.domain.box;
        const int axis = face->face / 2;
        nearest = std::min(nearest, std::abs(point[axis] - (face->face % 2 == 0 ? box.lower : box.upper)[axis]));
    }
    return nearest;
}

}  // namespace

std::vector<Verdict> judge_resolution(const Model& model)
{
    const Gas& gas = model.gas;
    const std::vector<double> radius = radii(gas);
    const double air = gas.ambient.density > 0 ? std::cbrt(gas.species[gas.ambient.species].particle_mass / gas.ambient.density) : 0;
    double across = 0, way = 0;
    for (std::size_t c = 0; c < gas.charges.size(); ++c) {
        const Charge& charge = gas.charges[c];
        if (!(radius[c] > 0)) continue;
        const double spacing = std::cbrt(gas.species[charge.species].particle_mass / charge.density);
        const double distance = stand_off(model, charge.points.front().point);
        across = std::max(across, spacing / (2 * radius[c]));
        if (std::isfinite(distance)) way = std::max(way, std::max(air, spacing * std::max(1.0, distance / radius[c])) / distance);
    }
    std::vector<Verdict> verdicts;
    if (across > 0) verdicts.push_back({"charge", across, 0.1, "spacing of the explosive's particles, over the charge's diameter"});
    if (way > 0) verdicts.push_back(resolution_verdict(way, 1));
    return verdicts;
}

}  // namespace corpuscle
