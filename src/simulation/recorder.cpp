#include "simulation/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gas/sample.hpp"
#include "output/vtk/cells.hpp"
#include "output/vtk/image.hpp"
#include "output/vtk/points.hpp"
#include "parallel/loops.hpp"
#include "structure/energy.hpp"
#include "structure/fields.hpp"

namespace corpuscle {

namespace {

/// Half the cross product of a facet's edges, where its nodes are now [m2].
Vector3d area_vector(const Structure& structure, const Facet& facet)
{
    const std::vector<Vector3d>& at = structure.nodes.position;
    return 0.5 * cross(at[facet.node[1]] - at[facet.node[0]], at[facet.node[2]] - at[facet.node[0]]);
}

double face_area(const Domain& domain, int face)
{
    const Vector3d size = domain.box.size();
    return size[(face / 2 + 1) % 3] * size[(face / 2 + 2) % 3];
}

constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};

/// Columns "<owner>.<quantity>_x" and so on.
void add_vector_columns(HistorySource& source, const std::string& owner, const std::string& quantity, const std::string& unit)
{
    for (const char* axis : axis_names) source.columns.push_back({owner + "." + quantity + "_" + axis, unit});
}

}  // namespace

Recorder::Recorder(Model& model)
    : model_(model), seen_impulse_(model.gauges.size()), seen_time_(model.gauges.size()), seen_pressure_(2 * model.gauges.size())
{
}

OutputPlan Recorder::plan(const Clock& clock)
{
    OutputPlan plan;
    for (const Probe& probe : model_.probes) add_probe(plan, probe);
    for (std::size_t g = 0; g < model_.gauges.size(); ++g) add_gauge(plan, g, clock);
    add_energies(plan);
    if (model_.output.fields_every > 0) add_files(plan);
    plan.end_time = model_.end_time;
    plan.restart_every = model_.output.restart_every;
    return plan;
}

void Recorder::add_probe(OutputPlan& plan, const Probe& probe) const
{
    HistorySource source;
    source.every = probe.every;
    if (probe.displacement) add_vector_columns(source, probe.name, "displacement", "m");
    if (probe.velocity) add_vector_columns(source, probe.name, "velocity", "m/s");
    source.sample = [&nodes = model_.structure.nodes, probe](std::span<double> values) {
        std::size_t column = 0;
        const auto put = [&](const Vector3d& vector) {
            for (int a = 0; a < 3; ++a) values[column++] = vector[a];
        };
        if (probe.displacement) put(nodes.position[probe.node] - nodes.reference[probe.node]);
        if (probe.velocity) put(nodes.contact_velocity(probe.node));
    };
    plan.history.push_back(std::move(source));
}

/// Every gauge shows pressure and specific impulse; one in the gas also its density, velocity and number of particles.
void Recorder::add_gauge(OutputPlan& plan, std::size_t index, const Clock& clock)
{
    const Gauge& gauge = model_.gauges[index];
    HistorySource source;
    source.every = gauge.every;
    source.columns = {{gauge.name + ".pressure", "Pa"}, {gauge.name + ".impulse", "Pa s"}};
    if (const auto* part = std::get_if<PartGauge>(&gauge.place)) {
        source.sample = [this, index, &clock, part](std::span<double> values) {
            sample_pressure(index, part_impulse(part->part) / part_area(part->part), clock.end(), values);
        };
    } else if (const auto* face = std::get_if<FaceGauge>(&gauge.place)) {
        source.sample = [this, index, &clock, face](std::span<double> values) {
            const double outward = face->face % 2 == 0 ? -1 : 1;
            const double given = outward * model_.gas.passages.face[face->face].momentum[face->face / 2];
            sample_pressure(index, given / face_area(model_.gas.domain, face->face), clock.end(), values);
        };
    } else {
        source.columns.push_back({gauge.name + ".density", "kg/m3"});
        add_vector_columns(source, gauge.name, "velocity", "m/s");
        source.columns.push_back({gauge.name + ".particles", "1"});
        source.sample = [this, index, &clock](std::span<double> values) { sample_region(index, clock.end(), values); };
    }
    plan.history.push_back(std::move(source));
}

/// Mean pressure since the last sample, from the specific impulse so far.
void Recorder::sample_pressure(std::size_t index, double impulse, double time, std::span<double> values)
{
    const double passed = time - seen_time_[index];
    values[0] = passed > 0 ? (impulse - seen_impulse_[index]) / passed : 0.0;
    values[1] = impulse;
    seen_impulse_[index] = impulse;
    seen_time_[index] = time;
}

/// State of the gas in a region; its impulse is that of the pressure above the one at the start.
void Recorder::sample_region(std::size_t index, double time, std::span<double> values)
{
    const RegionGauge& region = std::get<RegionGauge>(model_.gauges[index].place);
    const GasSample gas = sample(model_.gas, region.shape, region.volume);
    double& initial = seen_pressure_[2 * index];
    double& last = seen_pressure_[2 * index + 1];
    if (time == 0) initial = last = gas.pressure;
    seen_impulse_[index] += (0.5 * (last + gas.pressure) - initial) * (time - seen_time_[index]);
    seen_time_[index] = time;
    last = gas.pressure;
    const std::array<double, 7> shown{gas.pressure,
                                      seen_impulse_[index],
                                      gas.density,
                                      gas.velocity.x,
                                      gas.velocity.y,
                                      gas.velocity.z,
                                      static_cast<double>(gas.particles)};
    std::copy(shown.begin(), shown.end(), values.begin());
}

/// Impulse on a part against its facets' normals [N s].
double Recorder::part_impulse(std::uint32_t part) const
{
    const std::vector<Facet>& facets = model_.structure.surface.facets;
    return sum<double>(facets.size(), [&](std::size_t f) {
        if (facets[f].part != part) return 0.0;
        Vector3d impulse = model_.gas_structure.facet_impulse()[f];
        for (const auto& load : model_.loads) impulse += load->facet_impulse()[f];
        return -dot(impulse, normalized(area_vector(model_.structure, facets[f])));
    });
}

double Recorder::part_area(std::uint32_t part) const
{
    const std::vector<Facet>& facets = model_.structure.surface.facets;
    return sum<double>(facets.size(),
                       [&](std::size_t f) { return facets[f].part == part ? norm(area_vector(model_.structure, facets[f])) : 0.0; });
}

void Recorder::add_energies(OutputPlan& plan) const
{
    HistorySource source;
    source.every = model_.output.history_every;
    for (const char* name : {"gas", "explosive", "structure_kinetic", "structure_internal", "structure_plastic", "structure_hourglass"}) {
        source.columns.push_back({std::string("energy.") + name, "J"});
    }
    source.columns.push_back({"ledger.energy_error", "1"});
    source.sample = [this](std::span<double> values) {
        const GasContents gas = contents(model_.gas);
        const StructureEnergy solid = energy(model_.structure);
        const std::array<double, 7> shown{gas.gas.energy,  gas.explosive.energy,        solid.kinetic, solid.internal, solid.plastic,
                                          solid.hourglass, model_.ledger.error().energy};
        std::copy(shown.begin(), shown.end(), values.begin());
    };
    plan.history.push_back(std::move(source));
}

namespace {

/// Every n-th particle, so that no more than `limit` are drawn.
void write_particles(const Gas& gas, std::size_t limit, const VtkOptions& options, const std::filesystem::path& path)
{
    const std::size_t stride = std::max<std::size_t>(1, (gas.particles.size() + limit - 1) / std::max<std::size_t>(1, limit));
    Gas shown;
    shown.species = gas.species;
    for (std::size_t i = 0; i < gas.particles.size(); i += stride) {
        if (!(gas.particles[i].tag & particle_tag::gone)) shown.particles.push_back(gas.particles[i]);
    }
    const Field places = derived_field<Vector3f>("position", "m", "place", shown.particles.size(),
                                                 [&shown](std::size_t i) { return shown.particles[i].position; });
    write_points(path, places, particle_fields(shown), options);
}

void write_averages(const Gas& gas, int cells, const VtkOptions& options, const std::filesystem::path& path)
{
    const Vector3d size = gas.domain.box.size();
    const GasGrid grid = average(gas, std::max({size.x, size.y, size.z}) / std::max(1, cells));
    const std::array<std::int64_t, 3> counts{static_cast<std::int64_t>(grid.cells[0]), static_cast<std::int64_t>(grid.cells[1]),
                                             static_cast<std::int64_t>(grid.cells[2])};
    const Vector3d cell{size.x / static_cast<double>(counts[0]), size.y / static_cast<double>(counts[1]),
                        size.z / static_cast<double>(counts[2])};
    write_image(path, cell_centers(counts, grid.box.lower, cell), fields(grid), options);
}

void write_structure(Structure& structure, const VtkOptions& options, const std::filesystem::path& path)
{
    const std::vector<MeshElement> elements = cells(structure);
    const Field places = derived_field<Vector3d>("position", "m", "place", structure.nodes.size(),
                                                 [&structure](std::size_t i) { return structure.nodes.position[i]; });
    write_cells(path, places, cell_grid(elements), {node_fields(structure), element_fields(structure)}, options);
}

}  // namespace

void Recorder::add_files(OutputPlan& plan) const
{
    const OutputSettings& settings = model_.output;
    const VtkOptions options{settings.compress ? 1 : 0};
    if (!model_.gas.species.empty()) {
        if (settings.particles_shown > 0) {
            plan.fields.push_back({"gas", settings.fields_every, [this, options, limit = settings.particles_shown](const auto& path) {
                                       write_particles(model_.gas, limit, options, path);
                                   }});
        }
        if (settings.averages > 0) {
            plan.fields.push_back({"cells", settings.fields_every, [this, options, cells = settings.averages](const auto& path) {
                                       write_averages(model_.gas, cells, options, path);
                                   }});
        }
    }
    if (!model_.structure.parts.empty()) {
        plan.fields.push_back(
            {"structure", settings.fields_every, [this, options](const auto& path) { write_structure(model_.structure, options, path); }});
    }
}

FieldSet Recorder::state()
{
    if (model_.gauges.empty()) return {"gauges", {}};
    return {"gauges",
            {stored_field("impulse", "Pa s", "specific impulse at the last sample", seen_impulse_),
             stored_field("time", "s", "time of the last sample", seen_time_),
             stored_field("pressure", "Pa", "pressure at the start and at the last sample", seen_pressure_)}};
}

std::vector<Verdict> Recorder::verdicts() const
{
    std::vector<Verdict> verdicts;
    const std::vector<std::uint64_t>& hits = model_.gas_structure.facet_hits();
    std::vector<double> by_part(model_.structure.parts.size());
    for (std::size_t f = 0; f < hits.size(); ++f) by_part[model_.structure.surface.facets[f].part] += static_cast<double>(hits[f]);
    double deforming = 0;
    for (std::size_t p = 0; p < by_part.size(); ++p) deforming += model_.structure.parts[p].rigid() ? 0.0 : by_part[p];
    if (deforming > 0) verdicts.push_back(noise_verdict(deforming));
    return verdicts;
}

}  // namespace corpuscle
