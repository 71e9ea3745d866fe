#include "simulation/simulation.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "euler/flow.hpp"
#include "gas/burn.hpp"
#include "gas/collide.hpp"
#include "gas/fly.hpp"
#include "gas/sample.hpp"
#include "gas/sleep.hpp"
#include "gas/sort.hpp"
#include "model/grid_books.hpp"
#include "parallel/loops.hpp"
#include "simulation/grid_culprit.hpp"
#include "simulation/machine.hpp"
#include "simulation/report.hpp"
#include "simulation/summary_history.hpp"
#include "structure/energy.hpp"
#include "structure/fields.hpp"

namespace corpuscle {

namespace {

constexpr double energy_limit = 0.02;  ///< of the energy that took part; beyond it a run is not sound
constexpr double mass_limit = 1e-9;    ///< of the mass: less than any particle
constexpr double log_lines = 200;      ///< in run.log, about

const char* outside(Edge edge)
{
    switch (edge) {
        case Edge::rigid: return "rigid edge";
        case Edge::open: return "open edge";
        case Edge::ambient: break;
    }
    return "ambient";
}

Passage difference(const Passage& now, const Passage& before)
{
    return {now.mass - before.mass, now.momentum - before.momentum, now.energy - before.energy};
}

}  // namespace

Simulation::Simulation(std::unique_ptr<Model> model, RunFolder folder, Resumed)
    : model_(std::move(model)), folder_(std::move(folder)), pace_(*model_), recorder_(*model_)
{
    for (const Species& species : model_->gas.species) particles_at_start_[species.name] = 0;
    for (const Particle& particle : model_->gas.particles)
        ++particles_at_start_[model_->gas.species[particle_tag::species(particle.tag)].name];
}

Simulation::Simulation(std::unique_ptr<Model> model, RunFolder folder) : Simulation(std::move(model), std::move(folder), Resumed{})
{
    begin();
    OutputPlan plan = recorder_.plan(clock_);
    plan.state = [this] { return state(); };
    outputs_ = std::make_unique<Outputs>(folder_, std::move(plan));
    outputs_->write_due(clock_);
    outputs_->save();
}

std::unique_ptr<Simulation> Simulation::resume(std::unique_ptr<Model> model, RunFolder folder)
{
    std::unique_ptr<Simulation> simulation(new Simulation(std::move(model), std::move(folder), Resumed{}));
    simulation->take_up();
    return simulation;
}

/// Prepares bodies that have just been built for their first step.
void Simulation::begin()
{
    model_->gas_structure.follow();
    lay_to_sleep(model_->gas, model_->walls());
    sort(model_->gas);
    survey(model_->gas);
    model_->grid_walls.begin();
    prepare(model_->euler);
    model_->ledger.open(model_->held(0));
    clock_.restore(model_->start_time, 0, 0, 0);
    pace_.begin(model_->start_time);
}

void Simulation::step()
{
    Model& model = *model_;
    clock_.begin_step(next_step());
    phases_.time("burn", [&] { burn(); });
    pace_.advance(clock_, phases_);
    phases_.time("wake", [&] { wake(model.gas, clock_); });
    phases_.time("redistribute", [&] { sort(model.gas); });
    phases_.time("follow", [&] { model.gas_structure.follow(); });
    phases_.time("collide", [&] { collide(model.gas, clock_, model.walls()); });
    phases_.time("fly", [&] { fly(model.gas, clock_, model.walls()); });
    phases_.time("walls", [&] { model.ledger.add(model.grid_walls.apply(clock_)); });
    phases_.time("flow", [&] { flow(); });
    phases_.time("contact", [&] { model.ledger.add(model.gas_structure.apply(clock_)); });
    phases_.time("ledger", [&] { close_books(); });
    phases_.time("output", [&] { outputs_->write_due(clock_); });
    clock_.end_step();
    work_.element_steps = pace_.clock().step() * model.structure.element_count();
    work_.particle_steps += model.gas.particles.size() - model.gas.sleeping.particles;
}

/// The step that gas and grid allow, fitted to the structure's own. That of the gas is kept as long as it is neither too long nor much too
/// short, so that the structure's stays steady. Gases on a grid take theirs as it is.
double Simulation::next_step()
{
    constexpr double margin = 0.95, slack = 1.25;
    const double gas = stable_step(model_->gas, clock_.time()),
                 cells = std::min(stable_step(model_->euler), model_->grid_walls.stable_step());
    if (steady_step_ > gas || gas > slack * steady_step_) steady_step_ = margin * gas;
    const double left = model_->end_time - clock_.time();
    const double fitted = pace_.fit(clock_.time(), std::min(steady_step_, cells), left);
    step_set_by_ = pace_.sets_step() ? "structure" : cells <= steady_step_ ? "euler" : "gas";
    return fitted;
}

void Simulation::burn()
{
    const Passage released = corpuscle::burn(model_->gas, clock_);
    if (released.mass > 0) model_->ledger.add(Transfer{"explosive", "gas", released.mass, released.momentum, released.energy});
}

/// Moves the gases on a grid, and enters what their explosive gave them.
void Simulation::flow()
{
    const EulerAmount released = corpuscle::flow(model_->euler, clock_);
    if (released.whole_mass() > 0) model_->ledger.add(given_by_burning(released));
}

/// Enters what passed the edges of the gas, closes the step's books and stops a run that is no longer sound.
void Simulation::close_books()
{
    const FacePassages& passages = model_->gas.passages;
    for (int face = 0; face < face_count; ++face) {
        const Passage given = difference(passages.face[face], entered_.face[face]);
        model_->ledger.add(Transfer{"gas", outside(model_->gas.domain.edges[face]), given.mass, given.momentum, given.energy});
    }
    entered_ = passages;
    const Passage turned = difference(model_->gas.sleeping.turned, entered_asleep_);
    model_->ledger.add(Transfer{"gas", "sleeping gas", turned.mass, turned.momentum, turned.energy});
    entered_asleep_ = model_->gas.sleeping.turned;
    model_->ledger.add(given_to_edges(model_->euler, entered_by_cells_));
    entered_by_cells_ = model_->euler.passages;
    model_->ledger.close_step(model_->held(pace_.clock().duration()));
    check_soundness();
}

void Simulation::check_soundness() const
{
    const LedgerError& error = model_->ledger.error();
    const std::string when = fmt::format("at step {}, time {:.6g} s", clock_.step() + 1, clock_.end());
    const bool grid = model_->euler.cells() > 0;
    const std::string remedy =
        fmt::format("the last good state is in restart/; try a smaller {}.cfl or a finer mesh, and look at the fields of the last dump",
                    grid ? "euler" : "gas");
    if (!std::isfinite(error.mass + error.energy + error.momentum))
        throw SafetyStop("a value is no longer finite " + when + first_not_finite(), remedy);
    if (error.mass > mass_limit)
        throw SafetyStop(fmt::format("{} lost {}: {:.3g} of the mass is missing{}{}", grid ? "gas is" : "a particle is", when, error.mass,
                                     grid ? "; " : "", fastest_cell(model_->euler)),
                         remedy);
    if (error.energy > energy_limit) {
        const std::string culprit = grid ? fastest_cell(model_->euler) : fastest_element(model_->structure);
        throw SafetyStop(
            fmt::format("energy is lost or made {}: {:.3g} of all energy{}{}", when, error.energy, culprit.empty() ? "" : "; ", culprit),
            remedy);
    }
}

/// Names the first particle, node or cell with a value that is not finite.
std::string Simulation::first_not_finite() const
{
    const auto finite = [](const auto& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
    for (std::size_t i = 0; i < model_->gas.particles.size(); ++i) {
        const Particle& p = model_->gas.particles[i];
        if (!finite(p.position) || !finite(p.velocity) || !std::isfinite(p.energy)) {
            return fmt::format(": particle {} of gas '{}'", i, model_->gas.species[particle_tag::species(p.tag)].name);
        }
    }
    const Nodes& nodes = model_->structure.nodes;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (finite(nodes.position[n]) && finite(nodes.velocity[n]) && finite(nodes.impulse[n])) continue;
        const Vector3d& at = nodes.reference[n];
        return fmt::format(": node {} of the structure, meshed at ({:.4g}, {:.4g}, {:.4g}) m", n, at.x, at.y, at.z);
    }
    return not_finite_cell(model_->euler);
}

Ending Simulation::run(const std::atomic<bool>& stop, const std::function<void(const Progress&)>& tell)
{
    try {
        while (clock_.time() < model_->end_time * (1 - 1e-12)) {
            if (stop || outputs_->stop_requested()) {
                outputs_->save();
                write_results("interrupted", stop ? "stopped by a signal" : "stopped by a file in the folder");
                return Ending::interrupted;
            }
            step();
            outputs_->save_due();
            log_step();
            tell(progress());
        }
    } catch (const SafetyStop& error) {
        outputs_->log().line(fmt::format("STOPPED: {}", error.what()));
        write_results("stopped", error.what());
        throw;
    }
    outputs_->finish(clock_);
    write_results("done", "");
    return Ending::done;
}

Progress Simulation::progress() const
{
    Progress now;
    now.time = clock_.time();
    now.end_time = model_->end_time;
    now.step = clock_.step();
    now.duration = clock_.duration();
    now.step_set_by = step_set_by_;
    now.energy_error = model_->ledger.error().energy;
    now.particles = model_->gas.particles.size();
    now.cells = model_->euler.cells();
    now.wall_seconds = wall_seconds_since(started_);
    return now;
}

/// A line in run.log for each of about 200 equal parts of the run, and for the first steps.
void Simulation::log_step()
{
    const double part = model_->end_time / log_lines;
    const bool crossed = std::floor(clock_.time() / part) > std::floor((clock_.time() - clock_.duration()) / part);
    if (clock_.step() > 3 && !crossed) return;
    const LedgerError& error = model_->ledger.error();
    outputs_->log().line(fmt::format(
        "step {:7} time {:.6e} s  dt {:.3e} s ({})  particles {}  active cells {}  errors: mass {:.1e} momentum {:.1e} energy {:.1e}",
        clock_.step(), clock_.time(), clock_.duration(), step_set_by_, model_->gas.particles.size(), active_cells(model_->euler),
        error.mass, error.momentum, error.energy));
}

RunSummary Simulation::summary() const
{
    RunSummary summary;
    const Model& model = *model_;
    summary.title = model.title;
    summary.program = program_text();
    summary.command = command_text();
    summary.end_time = clock_.time();
    summary.steps = clock_.step();
    summary.wall_seconds = wall_before_ + wall_seconds_since(started_);
    summary.cpu_seconds = cpu_before_ + cpu_seconds();
    summary.peak_memory = peak_memory();
    summary.threads = thread_count();
    summary.seed = model.gas.settings.seed;
    summary.particles = particles_at_start_;
    summary.elements = model.structure.element_count();
    summary.particle_steps = work_.particle_steps;
    summary.element_steps = work_.element_steps;
    summary.cells = model.euler.cells();
    summary.cell_steps = model.euler.worked;
    summary.squeezed_cells = model.euler.walls.squeezed;
    summary.seconds = phases_.seconds();
    summary.mass_error = model.ledger.error().mass;
    summary.momentum_error = model.ledger.error().momentum;
    summary.energy_error = model.ledger.error().energy;
    summary.transfers = model.ledger.totals();
    summary.verdicts = recorder_.verdicts();
    for (std::uint32_t p = 0; p < model.structure.parts.size(); ++p) summary.parts[model.structure.parts[p].name] = summarize_part(p);
    for (const Probe& probe : model.probes) {
        if (!probe.reference) continue;
        const char axis = "xyz"[probe.reference->component];
        summary.references.push_back({fmt::format("{}.displacement_{}", probe.name, axis), probe.reference->value, probe.reference->label});
    }
    return summary;
}

PartSummary Simulation::summarize_part(std::uint32_t p) const
{
    const Part& part = model_->structure.parts[p];
    const StructureEnergy held = part_energy(model_->structure, part);
    PartSummary summary;
    summary.max_plastic_strain = max_plastic_strain(part);
    summary.kinetic_energy = held.kinetic;
    summary.internal_energy = held.internal;
    const PartsGiven& by_gas = model_->gas_structure.given_to_parts();
    if (p < by_gas.work.size()) {
        summary.gas_impulse = by_gas.impulse[p];
        summary.gas_work = by_gas.work[p];
    }
    const std::vector<Facet>& facets = model_->structure.surface.facets;
    for (std::size_t f = 0; f < facets.size(); ++f) {
        if (facets[f].part != p) continue;
        summary.impulse += model_->gas_structure.facet_impulse()[f] + model_->grid_walls.facet_impulse()[f];
        for (const auto& load : model_->loads) summary.impulse += load->facet_impulse()[f];
    }
    for (const auto& load : model_->loads) summary.impulse += load->impulse_beside_facets(p);
    return summary;
}

/// Writes summary.json and report.html as the run stands.
void Simulation::write_results(const std::string& status, const std::string& reason)
{
    RunSummary summary = this->summary();
    summary.status = status;
    summary.reason = reason;
    std::vector<std::string> probes, gauges;
    for (const Probe& probe : model_->probes) probes.push_back(probe.name);
    for (const Gauge& gauge : model_->gauges) gauges.push_back(gauge.name);
    const HistoryTable history = read_history(folder_.history());
    add_probes(summary, history, probes);
    add_gauges(summary, history, gauges);
    write_summary(folder_.summary(), summary);
    write_report(folder_.path());
    outputs_->log().line(
        fmt::format("{} at {:.6e} s after {} steps, {:.1f} s of wall time", status, clock_.time(), clock_.step(), summary.wall_seconds));
}

RestartContent Simulation::state()
{
    RestartContent content;
    RestartValues& values = content.values;
    values["time"] = clock_.time();
    values["duration"] = clock_.duration();
    values["previous_duration"] = clock_.previous_duration();
    values["step"] = clock_.step();
    values["step_limit"] = model_->gas.step_limit;
    values["steady_step"] = steady_step_;
    values["collisions"] = model_->gas.collisions;
    values["force_work"] = model_->structure.force_work;
    values["particle_steps"] = work_.particle_steps;
    values["element_steps"] = work_.element_steps;
    values["cell_steps"] = model_->euler.worked;
    values["squeezed_cells"] = model_->euler.walls.squeezed;
    values["wall_seconds"] = wall_before_ + wall_seconds_since(started_);
    values["cpu_seconds"] = cpu_before_ + cpu_seconds();
    content.sets = sets();
    return content;
}

std::vector<FieldSet> Simulation::sets()
{
    std::vector<FieldSet> sets{corpuscle::state(model_->gas), corpuscle::state(model_->structure), pace_.state(),
                               model_->gas_structure.state(), corpuscle::state(model_->euler),     model_->grid_walls.state()};
    for (std::size_t i = 0; i < model_->loads.size(); ++i) {
        sets.push_back(model_->loads[i]->state());
        sets.back().name = fmt::format("load {}: {}", i + 1, model_->loads[i]->name());
    }
    sets.push_back(model_->ledger.state());
    for (FieldSet& set : recorder_.states()) sets.push_back(std::move(set));
    return sets;
}

/// Brings back the newest whole state and goes on with the outputs where it was.
void Simulation::take_up()
{
    std::vector<std::string> remarks;
    const RestartFile file = RestartFolder(folder_.restart()).open_newest(remarks);
    file.restore(sets());
    clock_.restore(file.number("time"), file.number("duration"), file.number("previous_duration"), file.count("step"));
    if (clock_.time() > model_->end_time * (1 + 1e-12))
        throw InputError(
            fmt::format("the run has come to {:.6g} s already, beyond the end time of {:.6g} s", clock_.time(), model_->end_time),
            "expected a later end_time");
    model_->gas.step_limit = file.number("step_limit");
    steady_step_ = file.number("steady_step");
    model_->gas.collisions = file.count("collisions");
    model_->structure.force_work = file.number("force_work");
    work_ = {file.count("particle_steps"), file.count("element_steps")};
    model_->grid_walls.begin();
    prepare(model_->euler);
    model_->euler.worked = file.count("cell_steps");
    model_->euler.walls.squeezed = file.count("squeezed_cells");
    wall_before_ = file.number("wall_seconds");
    cpu_before_ = file.number("cpu_seconds");
    entered_ = model_->gas.passages;
    entered_asleep_ = model_->gas.sleeping.turned;
    entered_by_cells_ = model_->euler.passages;
    OutputPlan plan = recorder_.plan(clock_);
    plan.state = [this] { return state(); };
    outputs_ = std::make_unique<Outputs>(folder_, std::move(plan), clock_.time());
    for (const std::string& remark : remarks) outputs_->log().line(remark);
    outputs_->log().line(fmt::format("resumed at {:.6e} s, step {}", clock_.time(), clock_.step()));
}

}  // namespace corpuscle
