#include "input/build_euler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <fmt/format.h>

#include "input/build_gas.hpp"
#include "input/charges.hpp"
#include "input/gas_states.hpp"
#include "input/grid_start.hpp"
#include "input/grid_symmetry.hpp"
#include "input/placed.hpp"
#include "input/shapes.hpp"

namespace corpuscle {

namespace {

constexpr std::uint64_t most_cells = 4'000'000'000;

/// The axes that a symmetry leaves, in the words of messages.
std::vector<std::string> axes_of(EulerSpace space)
{
    switch (space) {
        case EulerSpace::planar: return {"x", "y", "z"};
        case EulerSpace::axisymmetric: return {"the radius", "z"};
        case EulerSpace::spherical: break;
    }
    return {"the radius"};
}

/// The key of `edges` that says what an axis' ends do.
const std::array<Edge, 2>& edges_along(const EulerInput& input, std::size_t axis)
{
    if (axis == 0) return input.edges.x;
    if (axis == 2 || input.symmetry == EulerSpace::axisymmetric) return input.edges.z;
    return input.edges.y;
}

void check_box(const EulerInput& input)
{
    const std::vector<std::string> axes = axes_of(input.symmetry);
    const Place& place = input.places.of("box");
    if (input.box.size() != axes.size())
        throw InputError(fmt::format("the box of [euler] has {} ranges, its symmetry leaves {}", input.box.size(), axes.size()),
                         input.symmetry == EulerSpace::planar         ? "expected [[x_min, x_max], [y_min, y_max], [z_min, z_max]]"
                         : input.symmetry == EulerSpace::axisymmetric ? "expected [[0, radius], [z_min, z_max]]"
                                                                      : "expected [[0, radius]]",
                         place);
    for (std::size_t axis = 0; axis < axes.size(); ++axis) check_ascends(input.box[axis][0], input.box[axis][1], axes[axis], place);
    if (input.symmetry != EulerSpace::planar && input.box[0][0] != 0)
        throw InputError(fmt::format("the radius of [euler] begins at {} m", input.box[0][0]), "expected 0", place);
}

/// Refuses what `edges` says of axes that there are none of.
void check_edges(const EulerInput& input)
{
    const std::array<Edge, 2> silent = EdgesInput{}.y;
    const bool y = input.symmetry != EulerSpace::planar && input.edges.y != silent;
    const bool z = input.symmetry == EulerSpace::spherical && input.edges.z != silent;
    if (y || z)
        throw InputError(fmt::format("edges of [euler] along {}, an axis that its symmetry does not leave", y ? "y" : "z"),
                         input.symmetry == EulerSpace::spherical ? "expected x alone: the radius" : "expected x, the radius, and z alone",
                         input.places.of("edges"));
}

/// Faces of the cells of an axis with a fine part.
std::vector<double> faces_along(const EulerInput& input, std::size_t axis)
{
    const auto& [lower, upper] = input.box[axis];
    return faces_with_fine_part(lower, upper, input.fine_box[axis], *input.cell_size, *input.edge_cell_size);
}

/// Cells along an axis: as many as asked for, or of about the size asked for.
std::uint64_t cells_along(const EulerInput& input, std::size_t axis)
{
    if (!input.cell_size) return input.cells[axis];
    if (!input.fine_box.empty()) {
        const auto& fine = input.fine_box[axis];
        const double in_fine = (fine[1] - fine[0]) / *input.cell_size;
        return in_fine > 1e6 ? most_cells : faces_along(input, axis).size() - 1;
    }
    const double count = std::round((input.box[axis][1] - input.box[axis][0]) / *input.cell_size);
    return count < 1 ? 1 : count > 1e6 ? most_cells : static_cast<std::uint64_t>(count);
}

/// Refuses a fine part of the grid that is not one.
void check_fine_box(const EulerInput& input)
{
    if (input.fine_box.empty() && !input.edge_cell_size) return;
    const Place& place = input.places.of(input.fine_box.empty() ? "edge_cell_size" : "fine_box");
    if (input.fine_box.empty() || !input.edge_cell_size || !input.cell_size)
        throw InputError("fine_box, cell_size and edge_cell_size go together", "expected all three, or none of fine_box and edge_cell_size",
                         place);
    const std::vector<std::string> axes = axes_of(input.symmetry);
    if (input.fine_box.size() != axes.size())
        throw InputError(fmt::format("fine_box has {} ranges, the box has {}", input.fine_box.size(), axes.size()),
                         "expected a range for each of the box's", place);
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        const auto &fine = input.fine_box[axis], &box = input.box[axis];
        check_ascends(fine[0], fine[1], axes[axis], place);
        if (fine[0] < box[0] || fine[1] > box[1])
            throw InputError(fmt::format("fine_box runs from {} m to {} m along {}, out of the box", fine[0], fine[1], axes[axis]),
                             fmt::format("expected it within {} m and {} m", box[0], box[1]), place);
    }
    if (*input.edge_cell_size < *input.cell_size)
        throw InputError(fmt::format("edge_cell_size, {} m, is below cell_size, {} m", *input.edge_cell_size, *input.cell_size),
                         "expected wider cells at the edges", input.places.of("edge_cell_size"));
}

void cut_axes(EulerPlan& plan, const EulerInput& input)
{
    const Place& place = input.places.of(input.cell_size ? "cell_size" : "cells");
    if (!input.cell_size && input.cells.size() != input.box.size())
        throw InputError(fmt::format("cells along {} axes, but the box has {}", input.cells.size(), input.box.size()),
                         "expected as many numbers as the box has ranges", place);
    std::uint64_t all = 1;
    for (std::size_t axis = 0; axis < input.box.size(); ++axis) {
        const std::uint64_t count = cells_along(input, axis);
        all *= std::min(count, most_cells / all + 1);
        if (all > most_cells) throw InputError("the grid has more than 4e9 cells", "expected larger or fewer cells", place);
        if (count == 2 || count == 3)
            throw InputError(fmt::format("{} cells along {}: too few for a flow", count, axes_of(input.symmetry)[axis]),
                             "expected 4 or more, or 1 where nothing flows", place);
        const auto& [lower, upper] = input.box[axis];
        plan.faces[axis] = input.fine_box.empty() ? even_faces(lower, upper, count) : faces_along(input, axis);
    }
}

/// The box in space that the grid stands for, the whole way round, and what its faces do.
Domain domain_of(const EulerInput& input)
{
    const auto& box = input.box;
    const double reach = box[0][1];
    const EdgesInput& e = input.edges;
    if (input.symmetry == EulerSpace::planar)
        return {{{box[0][0], box[1][0], box[2][0]}, {box[0][1], box[1][1], box[2][1]}}, {e.x[0], e.x[1], e.y[0], e.y[1], e.z[0], e.z[1]}};
    const bool round = input.symmetry == EulerSpace::spherical;
    const double lower = round ? -reach : box[1][0], upper = round ? reach : box[1][1];
    const std::array<Edge, 2> ends = round ? std::array<Edge, 2>{e.x[1], e.x[1]} : e.z;
    return {{{-reach, -reach, lower}, {reach, reach, upper}}, {e.x[1], e.x[1], e.x[1], e.x[1], ends[0], ends[1]}};
}

/// What the grid's own faces do: on the axis, or in the center, of a round grid there is no edge, only a mirror.
void set_edges(EulerPlan& plan, const EulerInput& input)
{
    for (std::size_t axis = 0; axis < input.box.size(); ++axis) {
        for (std::size_t side = 0; side < 2; ++side) {
            const bool mirror = plan.space != EulerSpace::planar && axis == 0 && side == 0;
            plan.edges[2 * axis + side] = mirror || edges_along(input, axis)[side] == Edge::rigid ? EulerEdge::rigid : EulerEdge::open;
        }
    }
}

bool same_law(const EquationOfState& first, const EquationOfState& second)
{
    const MieGrueneisen a = mie_grueneisen(first), b = mie_grueneisen(second);
    const auto numbers = [](const MieGrueneisen& m) { return std::tie(m.x0, m.x1, m.g, m.a, m.b, m.r1, m.r2, m.reference_density); };
    return a.cold == b.cold && numbers(a) == numbers(b);
}

/// Adds a gas, under a name no other has.
std::size_t add_material(EulerPlan& plan, const std::string& name, const EquationOfState& law, double molar_mass)
{
    if (plan.materials.size() == most_euler_materials)
        throw InputError(fmt::format("there are more than {} gases, each explosive one of its own", most_euler_materials),
                         "give fewer explosives, or fills of fewer gases");
    EulerMaterial material{name, law, {}, molar_mass};
    const auto taken = [&](const EulerMaterial& other) { return other.name == material.name; };
    for (int n = 2; std::any_of(plan.materials.begin(), plan.materials.end(), taken); ++n) material.name = fmt::format("{} {}", name, n);
    plan.materials.push_back(std::move(material));
    return plan.materials.size() - 1;
}

/// The gas of that name and law, added if it is new.
std::size_t gas_index(EulerPlan& plan, const GasValues& values, const EquationOfState& law)
{
    const std::string name = values.name.empty() ? "gas" : values.name;
    for (std::size_t m = 0; m < plan.materials.size(); ++m) {
        const std::string& known = plan.materials[m].name;
        if ((known == name || known.starts_with(name + " ")) && same_law(plan.materials[m].law, law)) return m;
    }
    return add_material(plan, name, law, values.molar_mass.value_or(0));
}

/// The gas all around; its box reaches beyond the grid's, so that no face is left out by rounding.
void fill_around(EulerPlan& plan, const EulerInput& input)
{
    if (!input.fill) return;
    at_place(input.fill->place, [&] {
        const GasState state = usual_state(*input.fill->values);
        Box box = plan.domain.box;
        box.grow(1e-6 * norm(box.size()));
        plan.fills.push_back(
            {Shape::box(box), {gas_index(plan, *input.fill->values, state.law), state.density, state.pressure, {}, 0, false}});
    });
}

void add_fill(EulerPlan& plan, const FillInput& input, const CaseDescription& description)
{
    check_revolved(plan.space, input.shape, "fill");
    at_place(input.places.own, [&] {
        const GasState state = state_of(input);
        const Shape shape = make_shape(input.shape, description);
        if (!(shape.volume_within(plan.domain.box) > 0))
            throw InputError("the fill lies outside the gas box", "expected some of it within", input.places.of("shape"));
        const Vector3d velocity = grid_velocity(plan.space, input);
        plan.fills.push_back({shape, {gas_index(plan, *input.gas.values, state.law), state.density, state.pressure, velocity, 0, false}});
    });
}

/// The pressure that explosive rests under: that of the last fill around its middle.
double pressure_around(const EulerPlan& plan, const Shape& shape)
{
    const Vector3d middle = shape.bounds().center();
    for (std::size_t f = plan.fills.size(); f-- > 0;)
        if (!plan.fills[f].state.unburnt && plan.fills[f].shape.contains(middle)) return plan.fills[f].state.pressure;
    throw InputError("no gas surrounds the charge", "expected fill = \"air\" in [euler]");
}

/// Adds where and when the charge is lit, in the grid's coordinates.
void add_lightings(std::vector<EulerLighting>& lightings, const EulerPlan& plan, const ChargeInput& input, const Shape& shape)
{
    const Box charge = grid_box(plan.space, shape.bounds());
    for (const DetonationInput& lit : input.detonation) {
        check_on_axis(plan.space, lit.point, "a charge is lit", input.places.of("detonation"));
        lightings.push_back({grid_point(plan.space, lit.point), lit.time, charge});
    }
    if (input.detonation.empty()) lightings.push_back({grid_point(plan.space, input.center.value_or(shape.bounds().center())), 0, charge});
}

/// The explosive of a charge that rests under a pressure: one that other charges have already, or a new one.
std::size_t explosive_index(EulerPlan& plan, const ExplosiveValues& values, const EquationOfState& law, double pressure)
{
    const double energy = values.energy_density / values.density;
    for (const EulerFill& fill : plan.fills) {
        const EulerMaterial& known = plan.materials[fill.state.material];
        if (fill.state.unburnt && fill.state.pressure == pressure && same_law(known.law, law) && known.explosive.energy == energy &&
            known.explosive.detonation_velocity == values.detonation_velocity)
            return fill.state.material;
    }
    const std::size_t material = add_material(plan, values.name.empty() ? "products" : values.name, law, 0);
    plan.materials[material].explosive.energy = energy;
    plan.materials[material].explosive.detonation_velocity = values.detonation_velocity;
    return material;
}

void add_charge(EulerPlan& plan, const ChargeInput& input, const CaseDescription& description)
{
    const ExplosiveValues& values = *input.explosive.values;
    const Shape shape = make_charge_shape(input, description);
    check_within(shape, plan.domain, input, "[euler]");
    check_revolved(plan.space, input);
    at_place(input.explosive.place, [&] {
        const EquationOfState law = make_law(values.law, values.density);
        check(law, values.name);
        const double around = pressure_around(plan, shape);
        const std::size_t material = explosive_index(plan, values, law, around);
        add_lightings(plan.materials[material].explosive.lightings, plan, input, shape);
        plan.fills.push_back({shape, {material, values.density, around, {}, 0, true}});
        plan.charge_shapes.push_back(shape);
        plan.charge_masses.push_back(values.density * shape.volume_within(plan.domain.box));
    });
}

/// Width of the widest cell that reaches into a box of space [m].
double widest_cell(const EulerPlan& plan, const Box& box)
{
    double widest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!plan.live(axis)) continue;
        const int of_space = plan.space == EulerSpace::axisymmetric && axis == 1 ? 2 : static_cast<int>(axis);
        widest = std::max(widest, plan.widths(axis, box.lower[of_space], box.upper[of_space])[1]);
    }
    return widest;
}

/// Says where a charge is no more than some cells wide: its products then come out too thin.
void warn_of_coarse_cells(const EulerPlan& plan, std::vector<std::string>& warnings)
{
    constexpr double wanted = 8;
    for (std::size_t c = 0; c < plan.charge_shapes.size(); ++c) {
        const double widest = widest_cell(plan, plan.charge_shapes[c].bounds());
        const double across = std::cbrt(plan.charge_shapes[c].volume() * 6 / 3.14159265358979) / widest;
        if (across < wanted)
            warnings.push_back(fmt::format("charge {} is only {:.1f} cells across: its near field is smeared out; {} or more are wanted",
                                           c + 1, across, wanted));
    }
}

}  // namespace

std::size_t EulerPlan::cells() const
{
    return cells_along(0) * cells_along(1) * cells_along(2);
}

std::array<double, 2> EulerPlan::widths(std::size_t axis, double from, double to) const
{
    std::array<double, 2> widths{std::numeric_limits<double>::infinity(), 0};
    for (std::size_t i = 0; i + 1 < faces[axis].size(); ++i) {
        if (faces[axis][i + 1] < from || faces[axis][i] > to) continue;
        const double width = faces[axis][i + 1] - faces[axis][i];
        widths = {std::min(widths[0], width), std::max(widths[1], width)};
    }
    return widths;
}

EulerPlan plan_euler(const CaseDescription& description, std::vector<std::string>& warnings)
{
    const EulerInput& input = *description.euler;
    if (description.charges.empty() && description.fills.empty())
        throw InputError("there is [euler] but no [[charge]] and no [[fill]]: nothing would happen",
                         "expected a [[charge]] with explosive, mass and center", input.places.own);
    check_box(input);
    check_edges(input);
    check_fine_box(input);
    EulerPlan plan;
    plan.settings.cfl = input.cfl;
    plan.settings.skip_quiet = input.sleep;
    plan.space = input.symmetry;
    plan.domain = domain_of(input);
    cut_axes(plan, input);
    set_edges(plan, input);
    fill_around(plan, input);
    for (const FillInput& fill : description.fills) add_fill(plan, fill, description);
    for (const ChargeInput& charge : description.charges) add_charge(plan, charge, description);
    if (input.start != StartRule::spherical) warn_of_coarse_cells(plan, warnings);
    return plan;
}

EulerGrid fill_grid(const EulerPlan& plan)
{
    EulerGrid grid = make_grid(plan.space, plan.faces, plan.edges, plan.materials, plan.settings);
    if (plan.start) {
        fill_from_blast(grid, plan);
    } else {
        fill(grid, plan.fills);
    }
    return grid;
}

/// Waves along all axes together cross a cell at a charge's surface with about its detonation velocity for each axis; as the cloud spreads
/// over the charge's size in a time, they slow down. After a spherical start they are judged by the mean speed of the front until then.
double expected_grid_step(const EulerPlan& plan, double time)
{
    double rate = 0;
    for (const EulerFill& fill : plan.fills) {
        const EulerMaterial& material = plan.materials[fill.state.material];
        const double still = sound_speed(material.law, fill.state.density, energy(material.law, fill.state.density, fill.state.pressure));
        double speed = fill.state.unburnt ? 0 : 1.5 * still;
        if (fill.state.unburnt) {
            const double first = material.explosive.detonation_velocity, size = std::cbrt(fill.shape.volume());
            speed = first / std::pow(1 + time * first / (4 * size), 0.6);
        }
        if (plan.start && fill.state.unburnt) speed = 1.5 * plan.start->front / std::max(time, plan.start->time);
        double all = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (plan.live(axis)) all += speed / plan.widths(axis)[0];
        rate = std::max(rate, all);
    }
    return plan.settings.cfl / rate;
}

}  // namespace corpuscle
