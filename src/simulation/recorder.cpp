#include "simulation/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gas/sample.hpp"
#include "model/grid_books.hpp"
#include "output/vtk/cells.hpp"
#include "output/vtk/image.hpp"
#include "output/vtk/points.hpp"
#include "parallel/loops.hpp"
#include "simulation/grid_file.hpp"
#include "structure/energy.hpp"
#include "structure/fields.hpp"

namespace corpuscle {

namespace {

constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};

/// Columns "<owner>.<quantity>_x" and so on.
void add_vector_columns(HistorySource& source, const std::string& owner, const std::string& quantity, const std::string& unit)
{
    for (const char* axis : axis_names) source.columns.push_back({owner + "." + quantity + "_" + axis, unit});
}

}  // namespace

Recorder::Recorder(Model& model)
    : model_(model),
      gauges_(model),
      grid_gauges_(model),
      facet_loads_(model),
      empirical_gauges_(model),
      resolution_(judge_resolution(model))
{
}

OutputPlan Recorder::plan(const Clock& clock)
{
    OutputPlan plan;
    for (const Probe& probe : model_.probes) add_probe(plan, probe);
    gauges_.add_to(plan, clock);
    grid_gauges_.add_to(plan, clock);
    empirical_gauges_.add_to(plan, clock);
    add_energies(plan);
    if (model_.output.fields_every > 0) add_files(plan, clock);
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
        if (probe.displacement) put(nodes.path().end[probe.node] - nodes.reference[probe.node]);
        if (probe.velocity) put(nodes.contact_velocity(probe.node));
    };
    plan.history.push_back(std::move(source));
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
        const EulerContents cells = contents(model_.euler);
        const StructureEnergy solid = energy(model_.structure);
        const std::array<double, 7> shown{gas.gas.energy + cells.gas.energy,
                                          gas.explosive.energy + cells.explosive.energy,
                                          solid.kinetic,
                                          solid.internal,
                                          solid.plastic,
                                          solid.hourglass,
                                          model_.ledger.error().energy};
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

void write_structure(Structure& structure, const FieldSet& loads, const VtkOptions& options, const std::filesystem::path& path)
{
    const std::vector<MeshElement> elements = cells(structure);
    FieldSet shown = element_fields(structure);
    shown.fields.insert(shown.fields.end(), loads.fields.begin(), loads.fields.end());
    const Field places = derived_field<Vector3d>("position", "m", "place", structure.nodes.size(),
                                                 [&structure](std::size_t i) { return structure.nodes.path().end[i]; });
    write_cells(path, places, cell_grid(elements), {node_fields(structure), shown}, options);
}

}  // namespace

void Recorder::add_files(OutputPlan& plan, const Clock& clock)
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
    if (model_.euler.cells() > 0 && settings.averages > 0) {
        plan.fields.push_back(
            {"cells", settings.fields_every, [this, options](const auto& path) { write_grid(model_.euler, options, path); }});
    }
    if (!model_.structure.parts.empty()) {
        plan.fields.push_back({"structure", settings.fields_every, [this, options, &clock](const auto& path) {
                                   write_structure(model_.structure, facet_loads_.picture(clock.end()), options, path);
                               }});
    }
}

std::vector<Verdict> Recorder::verdicts() const
{
    std::vector<Verdict> verdicts = resolution_;
    const std::vector<std::uint64_t>& hits = model_.gas_structure.facet_hits();
    std::vector<double> by_part(model_.structure.parts.size());
    for (std::size_t f = 0; f < hits.size(); ++f) by_part[model_.structure.surface.facets[f].part] += static_cast<double>(hits[f]);
    double deforming = 0;
    for (std::size_t p = 0; p < by_part.size(); ++p) deforming += model_.structure.parts[p].rigid() ? 0.0 : by_part[p];
    if (deforming > 0) verdicts.push_back(noise_verdict(deforming));
    return verdicts;
}

}  // namespace corpuscle
