#include "input/grid_start.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/error.hpp"
#include "euler/fill.hpp"
#include "euler/flow.hpp"
#include "gas/radial_fill.hpp"
#include "input/build_euler.hpp"
#include "input/grid_symmetry.hpp"
#include "model/grid_books.hpp"

namespace corpuscle {

namespace {

/// Points along each axis of a cell, by the axes along which gas flows: about as many in a cell.
constexpr std::array<std::size_t, 4> blast_points{1, 64, 10, 5};

double ball_volume(double radius)
{
    return 4 * std::numbers::pi / 3 * radius * radius * radius;
}

/// The radial flow at points of the grid.
class BlastProfile {
public:
    explicit BlastProfile(const EulerPlan& plan)
        : plan_(plan), center_(grid_point(plan.space, plan.start->gas[0].center)), products_(plan.fills.back().state.material)
    {
        for (std::size_t gas = 0; gas < 2; ++gas)
            for (const RadialLayer& layer : plan.start->gas[gas].layers) layers_.push_back({layer, gas});
    }
    /// The state at a point in the grid's coordinates: within the front the blast's, beyond it that of the last fill but the charge.
    [[nodiscard]] EulerSample at(const Vector3d& point) const
    {
        const Vector3d way = point - center_;
        const double radius = norm(way);
        return radius < plan_.start->front ? within(way, radius) : beyond(point);
    }

private:
    struct Layer {
        RadialLayer radial;
        std::size_t gas;
    };
    [[nodiscard]] EulerSample within(const Vector3d& way, double radius) const
    {
        const auto ends = [](const Layer& layer, double r) { return layer.radial.outer < r; };
        const auto found = std::lower_bound(layers_.begin(), layers_.end() - 1, radius, ends);
        const RadialLayer& layer = found->radial;
        const double part = std::clamp((radius - layer.inner) / (layer.outer - layer.inner), 0.0, 1.0);
        const double speed = layer.inner_velocity + part * (layer.outer_velocity - layer.inner_velocity);
        const std::size_t material = found->gas == 0 ? products_ : plan_.fills.front().state.material;
        return {material, layer.density, 0, radius > 0 ? (speed / radius) * way : Vector3d{}, layer.energy, false};
    }
    [[nodiscard]] EulerSample beyond(const Vector3d& point) const
    {
        const Vector3d place = in_space(plan_.space, point);
        for (std::size_t f = plan_.fills.size() - 1; f-- > 1;)
            if (plan_.fills[f].shape.contains(place)) return plan_.fills[f].state;
        return plan_.fills.front().state;
    }

    const EulerPlan& plan_;
    Vector3d center_;
    std::size_t products_;
    std::vector<Layer> layers_;
};

/// Cells of which the blast has reached a part.
std::vector<std::size_t> cells_reached(const EulerGrid& grid, const EulerPlan& plan)
{
    const Vector3d center = grid_point(plan.space, plan.start->gas[0].center);
    std::vector<std::size_t> reached;
    for (std::size_t c = 0; c < grid.cells(); ++c) {
        const auto at = grid.place(c);
        Box cell{center, center};
        for (int d = 0; d < 3; ++d) {
            const EulerAxis& axis = grid.axes[static_cast<std::size_t>(d)];
            if (axis.inert()) continue;
            cell.lower[d] = axis.faces[at[static_cast<std::size_t>(d)]];
            cell.upper[d] = axis.faces[at[static_cast<std::size_t>(d)] + 1];
        }
        if (distance_to_box(center, cell) < plan.start->front) reached.push_back(c);
    }
    return reached;
}

/// What cells hold: masses of products and surrounding gas, momentum in the grid's axes, energies.
struct CellsHolding {
    double volume = 0, products = 0, around = 0, kinetic = 0, internal = 0;
    Vector3d momentum;
};

double kinetic_energy(const EulerState& now, std::size_t cell)
{
    double density = 0;
    for (const auto& mass : now.mass) density += mass[cell];
    return 0.5 * norm_squared(Vector3d{now.motion[0][cell], now.motion[1][cell], now.motion[2][cell]}) / density;
}

CellsHolding held_in(const EulerGrid& grid, const std::vector<std::size_t>& cells, std::size_t products, std::size_t around)
{
    const EulerState& now = grid.now;
    CellsHolding held;
    for (const std::size_t c : cells) {
        const double volume = grid.volume(c), kinetic = kinetic_energy(now, c);
        held.volume += volume;
        held.products += volume * now.mass[products][c];
        held.around += volume * now.mass[around][c];
        held.kinetic += volume * kinetic;
        held.internal += volume * (now.energy[c] - kinetic);
        held.momentum += volume * Vector3d{now.motion[0][c], now.motion[1][c], now.motion[2][c]};
    }
    return held;
}

/// What the cells reached ought to hold: the blast's part in the domain, and still gas in the rest of them. Its momentum along an axis
/// through whose plane of symmetry the blast is cut; else there is none in sum.
CellsHolding wanted_in(const EulerPlan& plan, double volume)
{
    const FreeBlast& blast = *plan.start;
    const Sector sector = sector_of(plan.domain, blast.gas[0].center);
    const double share = sector.share(), still = volume - share * ball_volume(blast.front);
    const EulerSample& around = plan.fills.front().state;
    const double still_energy = energy(plan.materials[around.material].law, around.density, around.pressure);
    CellsHolding wanted;
    wanted.products = share * blast.gas[0].mass;
    wanted.around = share * blast.gas[1].mass + still * around.density;
    wanted.internal = share * (blast.gas[0].energy + blast.gas[1].energy) + still * around.density * still_energy;  // kinetic, too
    const Vector3d momentum = share * (blast.gas[0].momentum + blast.gas[1].momentum) * sector.mean_direction();
    wanted.momentum = plan.space == EulerSpace::axisymmetric ? Vector3d{0, momentum.z, 0} : momentum;
    return wanted;
}

double factor(double wanted, double found)
{
    return wanted != 0 && found != 0 ? wanted / found : 1;
}

/// Scales masses, momentum along each axis, then internal energy: sampling errs by parts in a thousand, which goes.
void make_exact(EulerGrid& grid, const EulerPlan& plan)
{
    const std::size_t products = plan.fills.back().state.material, around = plan.fills.front().state.material;
    const std::vector<std::size_t> cells = cells_reached(grid, plan);
    const CellsHolding found = held_in(grid, cells, products, around), wanted = wanted_in(plan, found.volume);
    EulerState& now = grid.now;
    for (const std::size_t c : cells) {
        const double internal = now.energy[c] - kinetic_energy(now, c);
        now.mass[products][c] *= factor(wanted.products, found.products);
        now.mass[around][c] *= factor(wanted.around, found.around);
        for (int d = 0; d < 3; ++d) now.motion[static_cast<std::size_t>(d)][c] *= factor(wanted.momentum[d], found.momentum[d]);
        now.energy[c] = internal + kinetic_energy(now, c);
    }
    const CellsHolding left = held_in(grid, cells, products, around);
    const double heat = (wanted.internal - left.kinetic) / left.internal;
    for (const std::size_t c : cells) {
        const double kinetic = kinetic_energy(now, c);
        now.energy[c] = kinetic + heat * (now.energy[c] - kinetic);
    }
}

/// Refuses cells so wide that one may hold both a part of the blast and of another fill.
void check_cells_between(const EulerPlan& plan, const Place& place)
{
    double across = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (plan.live(axis)) across = std::hypot(across, plan.widths(axis)[1]);
    if (plan.fills.size() > 2 && plan.start->front + across > plan.start->obstacle)
        throw InputError("start = \"spherical\" with cells wider than what is left of the way to the fill it meets",
                         fmt::format("expected cells below {:.3g} m", (plan.start->obstacle - plan.start->front) / 1.75), place);
}

}  // namespace

void plan_grid_start(EulerPlan& plan, const Structure& structure, const CaseDescription& description)
{
    const Place& place = description.euler->places.of("start");
    if (!description.loads.empty())
        throw InputError("start = \"spherical\" beside a [[load]]: the load's beginning would be missed", "leave one of them out", place);
    const LoneCharge lone = lone_charge(description, "start = \"spherical\"", place);
    double obstacle = std::min(distance_to_faces(plan.domain, lone.center), distance_to_structure(structure, lone.center));
    for (std::size_t f = 1; f + 1 < plan.fills.size(); ++f)
        obstacle = std::min(obstacle, distance_to_box(lone.center, plan.fills[f].shape.bounds()));
    plan.start = solve_free_blast(lone, obstacle, description.end_time, place);
    check_cells_between(plan, place);
    plan.materials[plan.fills.back().state.material].explosive = {};
}

void fill_from_blast(EulerGrid& grid, const EulerPlan& plan)
{
    const BlastProfile profile(plan);
    std::size_t axes = 0;
    for (const EulerAxis& axis : grid.axes) axes += axis.inert() ? 0 : 1;
    fill(grid, [&](const Vector3d& point) { return profile.at(point); }, blast_points[axes]);
    make_exact(grid, plan);
    prepare(grid);
}

}  // namespace corpuscle
