#include "simulation/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

#include "mesh/distance.hpp"
#include "model/grid_books.hpp"

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

/// The face of the box that a gauge is on, with the box's own axes; nothing for other gauges.
std::optional<int> gauged_face(const Gauge& gauge)
{
    if (const auto* face = std::get_if<FaceGauge>(&gauge.place)) return face->face;
    if (const auto* face = std::get_if<GridFaceGauge>(&gauge.place)) return face->face;
    return {};
}

double distance_to_face(const Model& model, const Vector3d& point, int face)
{
    const int axis = face / 2;
    if (model.euler.cells() > 0) {
        const std::vector<double>& faces = model.euler.axes[static_cast<std::size_t>(axis)].faces;
        const bool rings = model.euler.space == EulerSpace::axisymmetric && axis == 1;  // the grid's second axis is z
        return std::abs(point[rings ? 2 : axis] - (face % 2 == 0 ? faces.front() : faces.back()));
    }
    const Box& box = model.gas.domain.box;
    return std::abs(point[axis] - (face % 2 == 0 ? box.lower : box.upper)[axis]);
}

/// To the nearest facet or face of the gas box with a gauge [m]; infinity without either.
double stand_off(const Model& model, const Vector3d& point)
{
    double nearest = std::numeric_limits<double>::infinity();
    const std::vector<Vector3d>& at = model.structure.nodes.position;
    for (const Facet& facet : model.structure.surface.facets)
        nearest = std::min(nearest, distance_to_triangle(point, {at[facet.node[0]], at[facet.node[1]], at[facet.node[2]]}));
    for (const Gauge& gauge : model.gauges)
        if (const auto face = gauged_face(gauge)) nearest = std::min(nearest, distance_to_face(model, point, *face));
    return nearest;
}

/// Widest cell within a distance of a point of a grid, along the axes on which something flows [m].
double cell_width(const EulerGrid& grid, const Vector3d& point, double reach)
{
    double widest = 0;
    for (int d = 0; d < 3; ++d) {
        const EulerAxis& axis = grid.axes[static_cast<std::size_t>(d)];
        for (std::size_t i = 0; i < axis.cells() && !axis.inert(); ++i)
            if (axis.faces[i + 1] > point[d] - reach && axis.faces[i] < point[d] + reach) widest = std::max(widest, axis.width(i));
    }
    return widest;
}

/// From where a charge is lit to the furthest cell that holds it unburnt [m].
double charge_radius(const EulerGrid& grid, std::size_t material, const EulerLighting& lit)
{
    const std::vector<double>& unburnt = grid.now.unburnt[material];
    double radius = 0;
    for (std::size_t c = 0; c < unburnt.size(); ++c)
        if (unburnt[c] > 0 && lights(grid, grid.materials[material].explosive, lit, c))
            radius = std::max(radius, norm(grid.middle(c) - lit.point));
    return radius;
}

/// One lighting of each charge of an explosive: its first.
std::vector<EulerLighting> first_lightings(const EulerExplosive& explosive)
{
    std::vector<EulerLighting> first;
    for (const EulerLighting& lit : explosive.lightings) {
        const auto of_it = [&](const EulerLighting& other) {
            return norm(other.charge.lower - lit.charge.lower) + norm(other.charge.upper - lit.charge.upper) == 0;
        };
        if (std::none_of(first.begin(), first.end(), of_it)) first.push_back(lit);
    }
    return first;
}

std::vector<Verdict> judge_grid(const Model& model)
{
    const EulerGrid& grid = model.euler;
    double across = 0, way = 0;
    for (std::size_t m = 0; m < grid.materials.size(); ++m) {
        if (!grid.materials[m].explosive.burns()) continue;
        for (const EulerLighting& lit : first_lightings(grid.materials[m].explosive)) {
            const double radius = charge_radius(grid, m, lit), distance = stand_off(model, in_space(grid.space, lit.point));
            if (radius > 0) across = std::max(across, cell_width(grid, lit.point, radius) / (2 * radius));
            if (std::isfinite(distance)) way = std::max(way, cell_width(grid, lit.point, distance) / distance);
        }
    }
    std::vector<Verdict> verdicts;
    if (across > 0) verdicts.push_back({"charge", across, 0.125, "widest cell of the grid, over the charge's diameter"});
    if (way > 0)
        verdicts.push_back({"resolution", way, 0.03,
                            "widest cell of the grid, over the charge's distance; at the limit impulses come out one or two per cent low"});
    return verdicts;
}

std::vector<Verdict> judge_particles(const Model& model)
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

}  // namespace

std::vector<Verdict> judge_resolution(const Model& model)
{
    return model.euler.cells() > 0 ? judge_grid(model) : judge_particles(model);
}

}  // namespace corpuscle
