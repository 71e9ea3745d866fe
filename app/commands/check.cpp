#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "app/commands/commands.hpp"
#include "app/commands/ensemble.hpp"
#include "app/terminal/table.hpp"
#include "input/case/read_case.hpp"
#include "input/memory.hpp"
#include "input/presets.hpp"
#include "input/survey.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

void print_start(const FreeBlast& start)
{
    fmt::print("the run starts at {:.4g} ms: the blast, solved in one dimension, has then reached {:.4g} m of {:.4g} m to what it meets\n",
               1e3 * start.time, start.front, start.obstacle);
}

void print_gas(const GasPlan& plan, const std::vector<GaugeInput>& gauges)
{
    TextTable table({"gas", "law", "mass [kg]", "particles", "particle mass [kg]"});
    for (std::size_t i = 0; i < plan.fills.size(); ++i) {
        const Species& species = plan.gas.species[plan.fills[i].species];
        const std::string name =
            plan.fills[i].charge >= 0 ? fmt::format("{} (charge {})", species.name, plan.fills[i].charge + 1) : species.name;
        table.row({name, law_name(species.law), fmt::format("{:.6g}", plan.masses[i]), fmt::format("{}", plan.counts[i]),
                   fmt::format("{:.4g}", species.particle_mass)});
    }
    fmt::print("{}", table.text());
    const auto [least, most] = std::minmax_element(plan.gas.species.begin(), plan.gas.species.end(),
                                                   [](const Species& a, const Species& b) { return a.particle_mass < b.particle_mass; });
    fmt::print("heaviest over lightest particle: {:.3g}\n", most->particle_mass / least->particle_mass);
    if (plan.start) print_start(*plan.start);
    if (std::any_of(gauges.begin(), gauges.end(), [](const GaugeInput& gauge) { return gauge.point.has_value(); }))
        fmt::print("a gauge at a point sees the gas in a ball of {:.3g} mm about it\n", 1e3 * plan.point_radius());
    fmt::print("\n");
}

void print_grid(const EulerPlan& plan)
{
    TextTable table({"gas", "law", "density [kg/m3]", "pressure [Pa]", "mass [kg]"});
    const std::size_t charges = plan.fills.size() - plan.charge_masses.size();
    for (std::size_t f = 0; f < plan.fills.size(); ++f) {
        const EulerSample& state = plan.fills[f].state;
        const EulerMaterial& material = plan.materials[state.material];
        const bool charge = f >= charges;
        table.row({charge ? fmt::format("{} (charge {})", material.name, f - charges + 1) : material.name, law_name(material.law),
                   fmt::format("{:.6g}", state.density), fmt::format("{:.6g}", state.pressure),
                   charge ? fmt::format("{:.6g}", plan.charge_masses[f - charges]) : "-"});
    }
    fmt::print("{}", table.text());
    std::string counts, widths;
    for (std::size_t d = 0; d < 3; ++d) {
        if (plan.faces[d].empty()) continue;
        counts += fmt::format("{}{}", counts.empty() ? "" : " x ", plan.cells_along(d));
        const auto [least, most] = plan.widths(d);
        widths += widths.empty() ? "" : " x ";
        widths += most < (1 + 1e-9) * least ? fmt::format("{:.4g}", 1e3 * least) : fmt::format("{:.4g}-{:.4g}", 1e3 * least, 1e3 * most);
    }
    fmt::print("{} cells: {}, each {} mm\n", plan.cells(), counts, widths);
    if (plan.start) print_start(*plan.start);
    fmt::print("\n");
}

/// A number with what it is of: "2.1 (17)".
std::string with_number(double value, std::int64_t number)
{
    return fmt::format("{:.2f} ({})", value, number);
}

void print_structure(const std::vector<PartReport>& parts)
{
    TextTable table(
        {"part", "kind", "elements", "nodes", "mass [kg]", "edges [mm]", "worst aspect", "warp [deg]", "Jacobian", "step [us]"});
    for (const PartReport& part : parts) {
        const MeshQuality& quality = part.quality;
        table.row({part.name, part.kind, fmt::format("{}", part.elements), fmt::format("{}", part.nodes),
                   part.mass > 0 ? fmt::format("{:.6g}", part.mass) : "-",
                   fmt::format("{:.3g} to {:.3g}", 1e3 * quality.min_edge, 1e3 * quality.max_edge),
                   with_number(quality.worst_aspect, part.slender), with_number(quality.worst_warp * 180 / std::numbers::pi, part.warped),
                   with_number(quality.min_scaled_jacobian, part.badly_shaped),
                   std::isfinite(part.step) ? with_number(1e6 * part.step, part.slowest) : "-"});
    }
    fmt::print("{}in brackets the number of the worst element, of the one that sets the step\n", table.text());
    const auto least =
        std::min_element(parts.begin(), parts.end(), [](const PartReport& a, const PartReport& b) { return a.step < b.step; });
    if (std::isfinite(least->step))
        fmt::print("the structure's step is set by element {} of part '{}': {:.3g} us\n", least->slowest, least->name, 1e6 * least->step);
    fmt::print("\n");
}

/// Seconds a run takes, about: 60 ns a particle and step on two threads, 250 ns a shell and step on one.
double expected_seconds(const CaseSurvey& survey, double steps, int threads)
{
    const double particles = survey.gas ? static_cast<double>(survey.gas->particles()) : 0;
    const double cells = survey.euler ? static_cast<double>(survey.euler->cells()) : 0;
    const double work = 120e-9 * particles + 250e-9 * static_cast<double>(survey.structure.element_count()) + 200e-9 * cells;
    return steps * (work / std::max(1, threads) + 20e-6);
}

std::string duration_text(double seconds)
{
    if (seconds < 120) return fmt::format("{:.2g} s", seconds);
    if (seconds < 7200) return fmt::format("{:.2g} min", seconds / 60);
    return fmt::format("{:.2g} h", seconds / 3600);
}

/// What all runs of an ensemble take together.
void print_ensemble(int members, const CaseSurvey& survey, double steps)
{
    const int at_once = members_at_once(members, survey.memory), threads = std::max(1, thread_count() / at_once);
    const double rounds = std::ceil(static_cast<double>(members) / at_once);
    fmt::print("an ensemble of {} such runs, {} at a time on {} thread{} each: memory about {}, {} times the work, wall time about {}\n",
               members, at_once, threads, threads == 1 ? "" : "s", bytes_text(static_cast<std::size_t>(at_once) * survey.memory), members,
               duration_text(rounds * expected_seconds(survey, steps, threads)));
}

}  // namespace

CaseDescription case_of(const Options& options)
{
    CaseDescription description = read_case(options.subject, options.settings);
    resolve_presets(description, preset_folders(description.folder, options.installed_share()));
    return description;
}

int check_command(const Options& options)
{
    const CaseDescription description = case_of(options);
    const CaseSurvey survey = survey_case(description);
    fmt::print("{}\n\n", description.title.empty() ? description.file.string() : description.title);
    if (survey.gas) print_gas(*survey.gas, description.gauges);
    if (survey.euler) print_grid(*survey.euler);
    if (!survey.structure.parts.empty()) print_structure(survey.parts);
    const double steps = expected_steps(survey, description.end_time);
    fmt::print("memory about {}, steps about {:.2g}, wall time about {} on {} threads\n", bytes_text(survey.memory), steps,
               duration_text(expected_seconds(survey, steps, thread_count())), thread_count());
    if (description.ensemble > 1) print_ensemble(description.ensemble, survey, steps);
    for (const std::string& warning : survey.warnings) fmt::print("warning: {}\n", warning);
    fmt::print("the case is good\n");
    return 0;
}

}  // namespace corpuscle
