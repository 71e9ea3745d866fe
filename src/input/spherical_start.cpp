#include "input/spherical_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "input/build_gas.hpp"
#include "input/gas_states.hpp"
#include "input/placed.hpp"
#include "input/shapes.hpp"
#include "mesh/distance.hpp"
#include "radial/charge.hpp"

namespace corpuscle {

namespace {

/// Cells of the radial flow in a radius of the charge: peaks in its neighbourhood are then good to 2 %.
constexpr RadialCells cells{100, 30, 0.25};

/// The front stops at this share of the way to what it will meet.
constexpr double nearing = 0.95;

double distance_to_obstacles(const GasPlan& plan, const Structure& structure, const CaseDescription& description, const Vector3d& center)
{
    double nearest = std::min(distance_to_faces(plan.gas.domain, center), distance_to_structure(structure, center));
    const std::size_t first = description.gas->fill ? 1 : 0;
    for (std::size_t i = first; i < first + description.fills.size(); ++i)
        nearest = std::min(nearest, distance_to_box(center, plan.fills[i].shape.bounds()));
    return nearest;
}

/// The ball a charge is; refuses another shape.
SphereInput ball_of(const ChargeInput& charge, const std::string& who)
{
    const bool form = charge.shape.form && *charge.shape.form == ChargeForm::sphere;
    if (!form && !charge.shape.sphere)
        throw InputError(who + " with a charge that is no sphere", "expected shape = \"sphere\"", charge.places.of("shape"));
    if (!form) return *charge.shape.sphere;
    check_form(charge);
    return {*charge.center, charge.radius ? *charge.radius : ball_radius(*charge.mass, charge.explosive.values->density)};
}

/// Runs the flow until its front is near `reach` [m] and all has burnt; refuses one that does not get there in time [s].
void run_until_near(RadialFlow& flow, double reach, double time, const Place& place)
{
    while (flow.burning() || flow.edges()[flow.disturbed()] < nearing * reach) {
        if (flow.time() > time)
            throw InputError("start = \"spherical\", but the blast meets nothing before end_time", "expected a later end_time, or no start",
                             place);
        flow.step(flow.stable_step());
    }
}

/// Layers and sums of one gas of the flow within an edge, for the whole sphere.
RadialFill layers_of(const RadialFlow& flow, std::uint32_t gas, std::size_t last)
{
    RadialFill fill;
    const double all = whole(flow.symmetry());
    for (std::size_t i = 0; i < last; ++i) {
        if (flow.gas(i) != gas) continue;
        const double low = flow.velocities()[i], high = flow.velocities()[i + 1], mass = all * flow.masses()[i];
        fill.layers.push_back({flow.edges()[i], flow.edges()[i + 1], flow.densities()[i], flow.energies()[i], low, high});
        fill.mass += mass;
        fill.momentum += 0.5 * mass * (low + high);
        fill.energy += mass * (flow.energies()[i] + 0.25 * (low * low + high * high));
    }
    return fill;
}

/// Adds a layer of still gas outside, so that the fill's part in the sector is a whole number of particles.
void round_up(SphericalStart& start, const GasPlan& plan, double share)
{
    const AmbientGas& around = plan.gas.ambient;
    RadialFill& fill = start.gas[1];
    const double particle_mass = plan.gas.species[around.species].particle_mass / share;
    const double inside = std::ceil(fill.mass / particle_mass), added = inside * particle_mass - fill.mass;
    const double energy_per_mass = fill.layers.back().energy;
    start.edge = std::cbrt(std::pow(start.front, 3) + 3 * added / (whole(Symmetry::spherical) * around.density));
    fill.layers.push_back({start.front, start.edge, around.density, energy_per_mass, 0, 0});
    fill.mass += added;
    fill.energy += added * energy_per_mass;
    start.inner_particles = static_cast<std::size_t>(inside);
}

}  // namespace

double distance_to_box(const Vector3d& point, const Box& box)
{
    Vector3d away;
    for (int axis = 0; axis < 3; ++axis) away[axis] = std::max({0.0, box.lower[axis] - point[axis], point[axis] - box.upper[axis]});
    return norm(away);
}

double distance_to_faces(const Domain& domain, const Vector3d& center)
{
    const Sector sector = sector_of(domain, center);
    double nearest = std::numeric_limits<double>::infinity();
    for (int face = 0; face < face_count; ++face) {
        const int axis = face / 2, side = sector.side[static_cast<std::size_t>(axis)];
        const bool through = face % 2 == 0 ? side > 0 : side < 0;
        if (through && domain.edges[static_cast<std::size_t>(face)] == Edge::rigid) continue;
        const double wall = face % 2 == 0 ? domain.box.lower[axis] : domain.box.upper[axis];
        nearest = std::min(nearest, std::abs(center[axis] - wall));
    }
    return nearest;
}

double distance_to_structure(const Structure& structure, const Vector3d& center)
{
    double nearest = std::numeric_limits<double>::infinity();
    const std::vector<Vector3d>& at = structure.nodes.position;
    for (const Facet& facet : structure.surface.facets)
        nearest = std::min(nearest, distance_to_triangle(center, {at[facet.node[0]], at[facet.node[1]], at[facet.node[2]]}));
    return nearest;
}

LoneCharge lone_charge(const CaseDescription& description, const std::string& who, const Place& place)
{
    const auto& fill = description.gas ? description.gas->fill : description.euler->fill;
    if (description.charges.size() != 1)
        throw InputError(fmt::format("{} with {} charges", who, description.charges.size()), "expected one [[charge]]", place);
    if (!fill)
        throw InputError(who + " without a gas all around",
                         fmt::format("expected fill = \"air\" in [{}]", description.gas ? "gas" : "euler"), place);
    const ChargeInput& input = description.charges.front();
    const SphereInput ball = ball_of(input, who);
    const DetonationInput lit = input.detonation.empty() ? DetonationInput{ball.center, 0} : input.detonation.front();
    if (input.detonation.size() > 1 || norm(lit.point - ball.center) > 1e-6 * ball.radius)
        throw InputError(who + " with a charge that is not lit at its center alone",
                         "expected one detonation point, at the center, or none", input.places.of("detonation"));
    const ExplosiveValues& values = *input.explosive.values;
    const GasState around = at_place(fill->place, [&] { return usual_state(*fill->values); });
    const RadialCharge radial{make_law(values.law, values.density),
                              values.density,
                              values.energy_density / values.density,
                              values.detonation_velocity,
                              ball.radius,
                              around.law,
                              around.density,
                              around.pressure};
    return {radial, ball.center, lit.time};
}

FreeBlast solve_free_blast(const LoneCharge& lone, double obstacle, double end_time, const Place& place)
{
    FreeBlast blast;
    blast.obstacle = obstacle;
    const double least = 1.5 * lone.charge.radius / nearing;
    if (obstacle < least)
        throw InputError(
            fmt::format("start = \"spherical\", but something the blast will meet is {:.4g} m from the charge's center", obstacle),
            fmt::format("expected {:.4g} m or more, or no start", least), place);
    RadialFlow flow = lay_charge(lone.charge, cells, obstacle);
    run_until_near(flow, obstacle, end_time - lone.lit, place);
    blast.time = lone.lit + flow.time();
    blast.front = flow.edges()[flow.disturbed()];
    blast.gas = {layers_of(flow, 0, flow.disturbed()), layers_of(flow, 1, flow.disturbed())};
    for (RadialFill& fill : blast.gas) fill.center = lone.center;
    return blast;
}

SphericalStart solve_spherical_start(const GasPlan& plan, const Structure& structure, const CaseDescription& description)
{
    const std::string who = "start = \"spherical\"";
    const Place& place = description.gas->places.of("start");
    if (!description.loads.empty())
        throw InputError(who + " beside a [[load]]: the load's beginning would be missed", "leave one of them out", place);
    if (description.gas->collision == CollisionRule::hard_spheres)
        throw InputError(who + " with hard spheres, whose radius is that of the fills at time 0", "expected collision = \"displaced\"",
                         place);
    const LoneCharge lone = lone_charge(description, who, place);
    const double obstacle = distance_to_obstacles(plan, structure, description, lone.center);
    SphericalStart start{solve_free_blast(lone, obstacle, description.end_time, place)};
    start.gas[0].species = plan.gas.charges.front().species;
    start.gas[1].species = plan.gas.ambient.species;
    round_up(start, plan, sector_of(plan.gas.domain, lone.center).share());
    return start;
}

}  // namespace corpuscle
