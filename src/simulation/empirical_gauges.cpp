#include "simulation/empirical_gauges.hpp"

#include <cmath>

#include "model/grid_books.hpp"
#include "simulation/summary_history.hpp"

namespace corpuscle {

namespace {

/// Points along each side of a face of the box whose pulses are averaged.
constexpr int face_points = 32;

/// A point that the blast meets: its weight in the mean and the direction that it looks to; a gauge in the gas looks nowhere.
struct Target {
    double weight = 1;
    Vector3d point;   ///< [m]
    Vector3d normal;  ///< unit vector, or nothing
};

/// Cosine of the angle at which the wave comes; 0, side-on, where there is no surface.
double cosine_at(const Target& target, const Vector3d& ray, double distance)
{
    return std::abs(dot(target.normal, ray)) / distance;
}

/// The middles of n by n equal parts of a face of a box.
std::vector<Target> targets_on(const Box& box, int face)
{
    const int across = face / 2, first = (across + 1) % 3, second = (across + 2) % 3;
    const Vector3d size = box.size();
    std::vector<Target> targets;
    for (int i = 0; i < face_points; ++i) {
        for (int j = 0; j < face_points; ++j) {
            Target target{1.0 / (face_points * face_points), face % 2 == 0 ? box.lower : box.upper, {}};
            target.point[first] = box.lower[first] + size[first] * (i + 0.5) / face_points;
            target.point[second] = box.lower[second] + size[second] * (j + 0.5) / face_points;
            target.normal[across] = 1;
            targets.push_back(target);
        }
    }
    return targets;
}

/// A face of a grid: of a box, the end of a cylinder (rings of equal area), its mantle, or a ball's surface.
std::vector<Target> targets_on(const EulerGrid& grid, int face)
{
    const auto lower = [&](std::size_t d) { return grid.axes[d].faces.front(); };
    const auto upper = [&](std::size_t d) { return grid.axes[d].faces.back(); };
    if (grid.space == EulerSpace::planar) return targets_on({{lower(0), lower(1), lower(2)}, {upper(0), upper(1), upper(2)}}, face);
    if (grid.space == EulerSpace::spherical) return {{1, {upper(0), 0, 0}, {1, 0, 0}}};
    constexpr int rings = face_points * face_points;
    std::vector<Target> targets;
    for (int i = 0; i < rings; ++i) {
        const double share = (i + 0.5) / rings;
        if (face == 1) {
            targets.push_back({1.0 / rings, {upper(0), 0, lower(1) + share * (upper(1) - lower(1))}, {1, 0, 0}});
        } else {
            targets.push_back({1.0 / rings, {upper(0) * std::sqrt(share), 0, face == 2 ? lower(1) : upper(1)}, {0, 0, 1}});
        }
    }
    return targets;
}

/// The facets of a part that the wave meets, those of solids only where they look towards the charge. Weights are shares of all of the
/// part's area, below 0 where the push is along the facet's normal, as a part's gauge counts it.
std::vector<Target> targets_on(const Structure& structure, std::uint32_t part, const Vector3d& charge)
{
    const std::vector<Vector3d>& at = structure.nodes.reference;
    std::vector<Target> targets;
    double area = 0;
    for (std::size_t f = 0; f < structure.surface.facets.size(); ++f) {
        const Facet& facet = structure.surface.facets[f];
        if (facet.part != part || structure.surface.is_hidden(f)) continue;
        const Vector3d &a = at[facet.node[0]], &b = at[facet.node[1]], &c = at[facet.node[2]];
        const Vector3d vector = 0.5 * cross(b - a, c - a), middle = (a + b + c) / 3.0;
        const bool towards = dot(vector, middle - charge) < 0;
        area += norm(vector);
        if (towards || !facet.solid) targets.push_back({(towards ? 1 : -1) * norm(vector), middle, normalized(vector)});
    }
    for (Target& target : targets) target.weight /= area;
    return targets;
}

double solid_share(const Structure& structure, std::uint32_t part)
{
    double solid = 0, all = 0;
    for (std::size_t f = 0; f < structure.surface.facets.size(); ++f) {
        const Facet& facet = structure.surface.facets[f];
        if (facet.part != part || structure.surface.is_hidden(f)) continue;
        all += 1;
        solid += facet.solid ? 1 : 0;
    }
    return all > 0 ? solid / all : 0;
}

/// The middle of the cells of a region.
Vector3d middle_of(const EulerGrid& grid, const GridRegionGauge& region)
{
    Vector3d sum;
    double volume = 0;
    for (std::size_t i = 0; i < region.cells.size(); ++i) {
        sum += region.volumes[i] * grid.middle(region.cells[i]);
        volume += region.volumes[i];
    }
    return in_space(grid.space, sum / volume);
}

std::vector<Target> targets_of(const Gauge& gauge, const Model& model)
{
    const Vector3d& charge = model.known_blast->center;
    if (const auto* part = std::get_if<PartGauge>(&gauge.place)) return targets_on(model.structure, part->part, charge);
    if (const auto* face = std::get_if<FaceGauge>(&gauge.place)) return targets_on(model.gas.domain.box, face->face);
    if (const auto* face = std::get_if<GridFaceGauge>(&gauge.place)) return targets_on(model.euler, face->face);
    if (const auto* cells = std::get_if<GridRegionGauge>(&gauge.place)) return {{1, middle_of(model.euler, *cells), {}}};
    return {{1, std::get<RegionGauge>(gauge.place).shape.bounds().center(), {}}};
}

}  // namespace

EmpiricalGauges::EmpiricalGauges(const Model& model) : start_time_(model.start_time)
{
    if (!model.known_blast) return;
    detonation_time_ = model.known_blast->time;
    for (const Gauge& gauge : model.gauges) {
        EmpiricalGauge empirical = beside(gauge, model);
        if (!empirical.pieces.empty()) gauges_.push_back(std::move(empirical));
    }
}

EmpiricalGauges::EmpiricalGauge EmpiricalGauges::beside(const Gauge& gauge, const Model& model)
{
    const KnownBlast& blast = *model.known_blast;
    const ScaledDistanceRange range = scaled_distance_range(blast.burst);
    EmpiricalGauge empirical{kingery_bulmash_name(gauge.name), gauge.every, blast.ambient, true, {}};
    if (const auto* part = std::get_if<PartGauge>(&gauge.place)) empirical.ambient *= solid_share(model.structure, part->part);
    if (std::holds_alternative<RegionGauge>(gauge.place) || std::holds_alternative<GridRegionGauge>(gauge.place))
        empirical.impulse_of_whole = false;
    for (const Target& target : targets_of(gauge, model)) {
        const Vector3d ray = target.point - blast.center;
        const double distance = norm(ray), scaled = scaled_distance(blast.mass, distance);
        if (scaled < range.nearest || scaled > range.farthest) return {};
        empirical.pieces.push_back(
            {target.weight, BlastLoad(kingery_bulmash(blast.burst, blast.mass, distance), cosine_at(target, ray, distance))});
    }
    return empirical;
}

void EmpiricalGauges::add_to(OutputPlan& plan, const Clock& clock) const
{
    for (const EmpiricalGauge& gauge : gauges_) {
        HistorySource source;
        source.every = gauge.every;
        source.columns = {{gauge.name + ".pressure", "Pa"}, {gauge.name + ".impulse", "Pa s"}};
        source.sample = [this, &gauge, &clock](std::span<double> values) {
            const double from = start_time_ - detonation_time_, now = clock.end() - detonation_time_;
            values[0] = gauge.ambient;
            values[1] = gauge.impulse_of_whole ? gauge.ambient * (now - from) : 0;
            for (const Piece& piece : gauge.pieces) {
                values[0] += piece.weight * piece.load.pressure(now);
                values[1] += piece.weight * piece.load.impulse(from, now);
            }
        };
        plan.history.push_back(std::move(source));
    }
}

}  // namespace corpuscle
