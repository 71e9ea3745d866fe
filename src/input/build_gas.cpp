#include "input/build_gas.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "gas/hard_spheres.hpp"
#include "input/charges.hpp"
#include "input/gas_states.hpp"
#include "input/placed.hpp"
#include "input/shapes.hpp"
#include "input/solid_cuts.hpp"
#include "input/unlike_masses.hpp"
#include "laws/collision/hard_spheres.hpp"

namespace corpuscle {

namespace {

Domain make_domain(const GasInput& input)
{
    for (int axis = 0; axis < 3; ++axis) {
        const auto& [low, high] = input.box[static_cast<std::size_t>(axis)];
        check_ascends(low, high, std::string(1, "xyz"[axis]), input.places.of("box"));
    }
    const EdgesInput& e = input.edges;
    return {box_of(input.box), {e.x[0], e.x[1], e.y[0], e.y[1], e.z[0], e.z[1]}};
}

/// The species of that name and law, added if it is new. A run has room for 255.
std::uint32_t species_index(Gas& gas, const std::string& name, const EquationOfState& law)
{
    for (std::size_t i = 0; i < gas.species.size(); ++i)
        if (gas.species[i].name == name) return static_cast<std::uint32_t>(i);
    if (gas.species.size() == 255) throw InputError("there are more than 255 different gases", "give charges and fills fewer gases");
    gas.species.push_back({name, law, 0, internal_freedoms(heat_capacity_ratio(law))});
    return static_cast<std::uint32_t>(gas.species.size() - 1);
}

/// A name no other species has: the preset's, or a number behind what it is.
std::string species_name(const std::string& name, const char* what, std::size_t index)
{
    return name.empty() ? fmt::format("{} {}", what, index + 1) : name;
}

void add_background(GasPlan& plan, const GasInput& input)
{
    if (!input.fill) return;
    at_place(input.fill->place, [&] {
        const GasState state = usual_state(*input.fill->values);
        Fill fill{Shape::box(plan.gas.domain.box), {}, 0, state.density, state.energy_per_mass, {}, -1};
        fill.species = species_index(plan.gas, species_name(input.fill->values->name, "gas", 0), state.law);
        plan.gas.species[fill.species].molar_mass = input.fill->values->molar_mass.value_or(0);
        const double gamma = heat_capacity_ratio(state.law);
        plan.gas.ambient = {fill.species, state.density, state.pressure, (gamma - 1) * state.energy_per_mass};
        plan.fills.push_back(std::move(fill));
    });
}

void add_fills(GasPlan& plan, const CaseDescription& description)
{
    for (std::size_t i = 0; i < description.fills.size(); ++i) {
        const FillInput& input = description.fills[i];
        at_place(input.places.own, [&] {
            const GasState state = state_of(input);
            const Shape shape = make_shape(input.shape, description);
            Fill fill{shape, {}, 0, state.density, state.energy_per_mass, input.velocity, -1};
            fill.species = species_index(plan.gas, species_name(input.gas.values->name, "gas", i + 1), state.law);
            plan.gas.species[fill.species].molar_mass = input.gas.values->molar_mass.value_or(0);
            if (!(shape.volume_within(plan.gas.domain.box) > 0))
                throw InputError("the fill lies outside the gas box", "expected some of it within", input.places.of("shape"));
            for (Fill& earlier : plan.fills) earlier.cut_by.push_back(shape);
            plan.fills.push_back(std::move(fill));
        });
    }
}

Charge make_charge(const ChargeInput& input, const Shape& shape, std::uint32_t species, std::size_t index)
{
    const ExplosiveValues& values = *input.explosive.values;
    Charge charge{fmt::format("charge {}", index + 1),
                  species,
                  values.detonation_velocity,
                  values.energy_density / values.density,
                  values.density,
                  {},
                  0};
    for (const DetonationInput& lit : input.detonation) charge.points.push_back({lit.point, lit.time});
    if (charge.points.empty()) charge.points.push_back({input.center.value_or(shape.bounds().center()), 0.0});
    return charge;
}

void add_charges(GasPlan& plan, const CaseDescription& description, std::vector<std::string>& warnings)
{
    if (description.charges.size() > 255)
        throw InputError("there are more than 255 charges", "expected fewer", description.charges.back().places.own);
    for (std::size_t i = 0; i < description.charges.size(); ++i) {
        const ChargeInput& input = description.charges[i];
        const ExplosiveValues& values = *input.explosive.values;
        const Shape shape = make_charge_shape(input, description);
        check_within(shape, plan.gas.domain, input, "[gas]");
        for (std::size_t j = 0; j < i; ++j)
            if (plan.charge_shapes[j].bounds().overlaps(shape.bounds()))
                warnings.push_back(fmt::format("charges {} and {} may overlap: the later one takes the place", j + 1, i + 1));
        at_place(input.explosive.place, [&] {
            const EquationOfState law = make_law(values.law, values.density);
            check(law, values.name);
            Fill fill{shape, {}, 0, values.density, values.energy_density / values.density, {}, static_cast<std::int64_t>(i)};
            fill.species = species_index(plan.gas, species_name(values.name, "explosive", i), law);
            plan.gas.charges.push_back(make_charge(input, shape, fill.species, i));
            for (const DetonationPoint& lit : plan.gas.charges.back().points)
                if (!shape.contains(lit.point)) warnings.push_back(fmt::format("charge {}: a detonation point lies outside it", i + 1));
            for (Fill& earlier : plan.fills) earlier.cut_by.push_back(shape);
            plan.fills.push_back(std::move(fill));
            plan.charge_shapes.push_back(shape);
        });
    }
}

/// Sum over the fills of a species.
template <class T>
T species_sum(const GasPlan& plan, std::uint32_t species, const std::vector<T>& values)
{
    T total{};
    for (std::size_t i = 0; i < plan.fills.size(); ++i)
        if (plan.fills[i].species == species) total += values[i];
    return total;
}

/// Particles of each species: the total shared by mass, or products and the rest each by mass.
std::vector<std::size_t> species_counts(const GasPlan& plan, const ParticleCounts& wanted)
{
    const std::size_t count = plan.gas.species.size();
    std::vector<double> masses(count), products(count), others(count);
    for (std::uint32_t s = 0; s < count; ++s) {
        masses[s] = species_sum(plan, s, plan.masses);
        const bool explosive =
            std::any_of(plan.gas.charges.begin(), plan.gas.charges.end(), [&](const Charge& charge) { return charge.species == s; });
        (explosive ? products : others)[s] = masses[s];
    }
    if (wanted.total) return share_particles(masses, *wanted.total);
    const auto shared = [&](const std::vector<double>& part, std::optional<std::uint64_t> total) {
        const bool any = std::any_of(part.begin(), part.end(), [](double mass) { return mass > 0; });
        return any && total ? share_particles(part, *total) : std::vector<std::size_t>(count, 0);
    };
    std::vector<std::size_t> counts = shared(products, wanted.products);
    const std::vector<std::size_t> rest = shared(others, wanted.air);
    for (std::size_t s = 0; s < count; ++s) counts[s] += rest[s];
    return counts;
}

/// Particle masses and the particles of each fill. One mass a species, so a fill's mass is met to half a particle.
void share_out(GasPlan& plan, const GasInput& input)
{
    for (const Fill& fill : plan.fills) plan.masses.push_back(fill.density * volume(fill, plan.gas.domain));
    const std::vector<std::size_t> counts = species_counts(plan, input.particles);
    for (std::uint32_t s = 0; s < plan.gas.species.size(); ++s) {
        Species& species = plan.gas.species[s];
        const double mass = species_sum(plan, s, plan.masses);
        if (!(mass > 0))
            throw InputError(fmt::format("nothing is left of the gas '{}': later fills take its whole place", species.name),
                             "leave it out or make room for it", input.places.own);
        if (counts[s] == 0)
            throw InputError(fmt::format("the gas '{}' ({:.4g} kg) gets no particles", species.name, mass),
                             "expected more particles: a total, or products and air", input.places.of("particles"));
        species.particle_mass = mass / static_cast<double>(counts[s]);
    }
    for (std::size_t i = 0; i < plan.fills.size(); ++i)
        plan.counts.push_back(
            static_cast<std::size_t>(std::llround(plan.masses[i] / plan.gas.species[plan.fills[i].species].particle_mass)));
}

/// Where a species' gas was named: in a charge, a fill or as the gas all around.
const Place& species_place(const GasPlan& plan, const CaseDescription& description, std::uint32_t species)
{
    for (std::size_t i = 0; i < plan.gas.charges.size(); ++i)
        if (plan.gas.charges[i].species == species) return description.charges[i].explosive.place;
    const std::size_t background = description.gas->fill ? 1 : 0;
    for (std::size_t i = 0; i < description.fills.size(); ++i)
        if (plan.fills[background + i].species == species) return description.fills[i].gas.place;
    return description.gas->fill->place;
}

/// Names all that disturbs the gas all around from the start: charges, other fills, open edges. Else gas that touches them could sleep.
void add_disturbances(GasPlan& plan)
{
    std::vector<Disturbance>& disturbances = plan.gas.sleeping.disturbances;
    for (std::size_t i = 1; i < plan.fills.size(); ++i) disturbances.push_back({plan.fills[i].shape.bounds(), 0});
    for (int face = 0; face < face_count; ++face) {
        if (plan.gas.domain.edges[static_cast<std::size_t>(face)] != Edge::open) continue;
        Box sheet = plan.gas.domain.box;
        (face % 2 == 0 ? sheet.upper : sheet.lower)[face / 2] = (face % 2 == 0 ? sheet.lower : sheet.upper)[face / 2];
        disturbances.push_back({sheet, 0});
    }
}

/// Gives every species the radius of its spheres. Beyond an ambient edge no sphere pushes: all pressure there is of motion, so gas flows
/// in as from gas that is denser by the spheres' pressure over their kinetic one.
void make_spheres(GasPlan& plan, const CaseDescription& description, std::vector<std::string>& warnings)
{
    const GasInput& input = *description.gas;
    for (std::uint32_t s = 0; s < plan.gas.species.size(); ++s) {
        Species& species = plan.gas.species[s];
        double densest = 0;
        for (const Fill& fill : plan.fills)
            if (fill.species == s) densest = std::max(densest, fill.density);
        at_place(species_place(plan, description, s), [&] { species.radius = sphere_radius(species, input.packing, densest); });
    }
    if (plan.gas.ambient.density > 0) {
        const Species& outside = plan.gas.species[plan.gas.ambient.species];
        plan.gas.ambient.density *= carnahan_starling(sphere_packing(plan.gas.ambient.density / outside.particle_mass, outside.radius));
    }
    if (input.mean_free_path != GasInput{}.mean_free_path)
        warnings.emplace_back("gas.mean_free_path has no effect with collision = \"hard_spheres\": the radius of the spheres sets it");
}

/// Does the shape hold any point of the triangle? Halved until its edges are shorter than `fine`.
bool meets(const Shape& shape, const std::array<Vector3d, 3>& corner, double fine)
{
    Box bounds;
    for (const Vector3d& c : corner) bounds.include(c);
    if (!shape.bounds().overlaps(bounds)) return false;
    if (std::any_of(corner.begin(), corner.end(), [&](const Vector3d& c) { return shape.contains(c); })) return true;
    int longest = 0;
    double length = 0;
    for (int e = 0; e < 3; ++e) {
        const double edge = norm(corner[static_cast<std::size_t>((e + 1) % 3)] - corner[static_cast<std::size_t>(e)]);
        if (edge > length) {
            length = edge;
            longest = e;
        }
    }
    if (length < fine) return false;
    const Vector3d a = corner[static_cast<std::size_t>(longest)], b = corner[static_cast<std::size_t>((longest + 1) % 3)],
                   c = corner[static_cast<std::size_t>((longest + 2) % 3)];
    const Vector3d middle = 0.5 * (a + b);
    return meets(shape, {a, middle, c}, fine) || meets(shape, {middle, b, c}, fine);
}

/// Fills the gas around a blast that has been solved in one dimension, and the blast itself: nothing waits any more.
Gas fill_from_sphere(GasPlan plan)
{
    const SphericalStart& start = *plan.start;
    if (!plan.gas.sleeping.disturbances.empty())
        plan.gas.sleeping.disturbances.push_back({Shape::sphere(start.gas[1].center, start.front).bounds(), 0});
    for (std::size_t i = 0; i < plan.fills.size(); ++i) {
        Fill& own = plan.fills[i];
        if (own.charge >= 0) {
            fill_radial(plan.gas, start.gas[0], plan.counts[i]);
        } else if (i == 0) {
            own.cut_by.back() = Shape::sphere(start.gas[1].center, start.edge);
            fill(plan.gas, own, plan.counts[i] - start.inner_particles);
            fill_radial(plan.gas, start.gas[1], start.inner_particles);
        } else {
            fill(plan.gas, own, plan.counts[i]);
        }
    }
    return std::move(plan.gas);
}

}  // namespace

double tidy_gamma(double gamma)
{
    return std::min(gamma, 5.0 / 3);
}

EquationOfState make_law(const LawValues& values, double density)
{
    if (values.jwl) return Jwl{values.jwl->a, values.jwl->b, values.jwl->r1, values.jwl->r2, values.jwl->omega, density};
    if (values.noble_abel)
        return NobleAbel{tidy_gamma(values.noble_abel->gamma), values.noble_abel->co_volume,
                         values.noble_abel->reference_density.value_or(density)};
    return IdealGas{values.ideal ? tidy_gamma(values.ideal->gamma) : 1.4};
}

std::size_t GasPlan::particles() const
{
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

double GasPlan::point_radius() const
{
    const AmbientGas& around = gas.ambient;
    const double room = around.density > 0 ? gas.species[around.species].particle_mass / around.density
                                           : gas.domain.box.volume() / static_cast<double>(particles());
    return 3 * std::cbrt(room);
}

GasPlan plan_gas(const CaseDescription& description, std::vector<std::string>& warnings)
{
    const GasInput& input = *description.gas;
    if (description.charges.empty() && description.fills.empty())
        throw InputError("there is gas but no [[charge]] and no [[fill]]: nothing would happen",
                         "expected a [[charge]] with explosive, mass and center", input.places.own);
    GasPlan plan;
    plan.gas.settings.seed = input.seed;
    plan.gas.settings.mean_free_path = input.mean_free_path;
    plan.gas.settings.cell_limit = input.cell_limit;
    plan.gas.settings.partners = input.partners;
    plan.gas.settings.relaxation = input.relaxation;
    plan.gas.settings.cfl = input.cfl;
    plan.gas.settings.rule = input.collision;
    plan.gas.domain = make_domain(input);
    add_background(plan, input);
    add_fills(plan, description);
    add_charges(plan, description, warnings);
    cut_by_solids(plan, description);
    const bool ambient =
        std::find(plan.gas.domain.edges.begin(), plan.gas.domain.edges.end(), Edge::ambient) != plan.gas.domain.edges.end();
    if (ambient && !input.fill)
        warnings.emplace_back("edges are \"ambient\" but [gas] has no fill: vacuum lies outside, so they act as \"open\"");
    if (input.fill && input.sleep) add_disturbances(plan);
    share_out(plan, input);
    if (input.collision == CollisionRule::hard_spheres) make_spheres(plan, description, warnings);
    std::vector<double> masses;
    for (std::uint32_t s = 0; s < plan.gas.species.size(); ++s) masses.push_back(species_sum(plan, s, plan.masses));
    warn_of_unlike_masses(plan.gas.species, masses, warnings);
    return plan;
}

void check_charges_apart(const GasPlan& plan, const Structure& structure, const CaseDescription& description)
{
    for (std::size_t i = 0; i < plan.charge_shapes.size(); ++i) {
        const Shape& shape = plan.charge_shapes[i];
        const Vector3d size = shape.bounds().size();
        const double fine = 0.05 * std::min({size.x, size.y, size.z});
        for (const Facet& facet : structure.surface.facets) {
            const std::vector<Vector3d>& at = structure.nodes.position;
            const std::array<Vector3d, 3> corner{at[facet.node[0]], at[facet.node[1]], at[facet.node[2]]};
            if (!meets(shape, corner, fine)) continue;
            const Vector3d middle = (1.0 / 3.0) * (corner[0] + corner[1] + corner[2]);
            throw InputError(fmt::format("the charge overlaps part '{}' near ({:.4g}, {:.4g}, {:.4g}) m", structure.parts[facet.part].name,
                                         middle.x, middle.y, middle.z),
                             "move one of them: expected the whole charge on one side of the part",
                             description.charges[i].places.of(description.charges[i].center ? "center" : "shape"));
        }
    }
}

Gas fill_gas(GasPlan plan)
{
    plan.gas.particles.reserve(plan.particles());
    if (plan.start) return fill_from_sphere(std::move(plan));
    for (std::size_t i = 0; i < plan.fills.size(); ++i) fill(plan.gas, plan.fills[i], plan.counts[i]);
    return std::move(plan.gas);
}

}  // namespace corpuscle
