#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "app/commands/commands.hpp"
#include "app/terminal/table.hpp"
#include "base/error.hpp"
#include "input/survey.hpp"
#include "laws/blast/kingery_bulmash.hpp"
#include "output/history/history.hpp"
#include "output/replace_file.hpp"
#include "radial/charge.hpp"
#include "radial/gauge.hpp"
#include "simulation/run_folder.hpp"

namespace corpuscle {

namespace {

/// Energy of detonation of the TNT of the empirical curves, by which other explosives are weighed [J/kg].
constexpr double tnt_energy = 7.0e9 / 1630;

/// Lines of history.csv, about.
constexpr double history_lines = 5000;

/// The numbers of a list such as 0.5,1,2; refuses anything else.
std::vector<double> numbers_of(const std::string& list)
{
    std::vector<double> numbers;
    const char* from = list.data();
    const char* const end = from + list.size();
    while (true) {
        double value = 0;
        const auto [after, error] = std::from_chars(from, end, value);
        if (error != std::errc() || !(value > 0) || !std::isfinite(value) || (after != end && *after != ','))
            throw InputError(fmt::format("--at {} is no list of distances", list), "expected metres, such as --at 0.5,1,2");
        numbers.push_back(value);
        if (after == end) return numbers;
        from = after + 1;
    }
}

/// Where the flow is watched: distances given, or those of the case's gauges at points or in balls.
std::vector<double> distances(const Options& options, const CaseDescription& description, const LoneCharge& lone)
{
    std::vector<double> found;
    if (!options.at.empty()) {
        found = numbers_of(options.at);
    } else {
        for (const GaugeInput& gauge : description.gauges)
            if (gauge.point || gauge.sphere) found.push_back(norm((gauge.point ? *gauge.point : gauge.sphere->center) - lone.center));
    }
    if (found.empty())
        throw InputError("there is nowhere to watch the blast: the case has no gauge at a point or in a sphere",
                         "give distances, such as --at 0.5,1,2");
    std::sort(found.begin(), found.end());
    return found;
}

/// No shock is further out at a time: the strong blast of a point with all the energy, the sound of still gas and the charge on top.
double farthest_front(const RadialCharge& charge, double time)
{
    const double energy = 4 * std::numbers::pi / 3 * std::pow(charge.radius, 3) * charge.density * charge.energy;
    const double sound = sound_speed(charge.ambient, charge.ambient_density,
                                     corpuscle::energy(charge.ambient, charge.ambient_density, charge.ambient_pressure));
    return 2 * charge.radius + 1.2 * std::pow(energy * time * time / charge.ambient_density, 0.2) + sound * time;
}

std::vector<HistoryColumn> columns_of(const std::vector<RadialGauge>& gauges)
{
    std::vector<HistoryColumn> columns;
    for (const RadialGauge& gauge : gauges) {
        const std::string name = fmt::format("at {:g} m", gauge.radius);
        columns.push_back({name + ".pressure", "Pa"});
        columns.push_back({name + ".density", "kg/m3"});
        columns.push_back({name + ".velocity", "m/s"});
    }
    return columns;
}

std::vector<double> values_at(const RadialFlow& flow, const std::vector<RadialGauge>& gauges)
{
    std::vector<double> values;
    for (const RadialGauge& gauge : gauges) {
        const RadialSample now = sample(flow, gauge.radius);
        values.insert(values.end(), {now.pressure, now.density, now.velocity});
    }
    return values;
}

/// The state of every cell at the end; products are gas 1, what surrounds them gas 2.
void write_profile(const std::filesystem::path& path, const RadialFlow& flow)
{
    std::string text = "radius [m],gas,density [kg/m3],velocity [m/s],pressure [Pa],energy [J/kg]\n";
    for (std::size_t i = 0; i < flow.cells(); ++i) {
        const double velocity = 0.5 * (flow.velocities()[i] + flow.velocities()[i + 1]);
        text += fmt::format("{},{},{},{},{},{}\n", flow.middle(i), flow.gas(i) + 1, flow.densities()[i], velocity, flow.pressures()[i],
                            flow.energies()[i]);
    }
    replace_file(path, text);
}

/// Runs to the end, the gauges watching; the history is written on the way if there is a folder.
RadialFlow solve(const LoneCharge& lone, const Options& options, double end, std::vector<RadialGauge>& gauges,
                 const std::optional<RunFolder>& folder)
{
    const double reach = std::max(farthest_front(lone.charge, end), 1.1 * gauges.back().radius);
    RadialFlow flow = lay_charge(lone.charge, {options.cells, 30, 0.25}, reach);
    std::optional<History> history;
    if (folder) history.emplace(folder->history(), columns_of(gauges));
    double due = 0;
    flow.run(end, [&](const RadialFlow& now) {
        for (RadialGauge& gauge : gauges) gauge.record(now);
        if (!history || now.time() < due) return;
        history->add(lone.lit + now.time(), values_at(now, gauges));
        due = now.time() + end / history_lines;
    });
    if (folder) write_profile(folder->path() / "profile.csv", flow);
    return flow;
}

/// Arrival, peak and impulse at each gauge, beside the empirical curves of as much TNT as has the charge's energy.
std::string measures_text(const LoneCharge& lone, const std::vector<RadialGauge>& gauges, double mass)
{
    TextTable table(
        {"distance [m]", "Z [m/kg^(1/3)]", "arrival [ms]", "peak [kPa]", "impulse [Pa s]", "KB arrival", "KB peak", "KB impulse"});
    const ScaledDistanceRange range = scaled_distance_range(Burst::spherical);
    for (const RadialGauge& gauge : gauges) {
        const BlastMeasures found = measure_blast(gauge.samples, lone.charge.ambient_pressure, 0.01 * lone.charge.ambient_pressure);
        const double z = scaled_distance(mass, gauge.radius);
        std::vector<std::string> row{fmt::format("{:g}", gauge.radius), fmt::format("{:.3f}", z)};
        const bool came = found.overpressure > 0;
        row.push_back(came ? fmt::format("{:.4f}", 1e3 * (lone.lit + found.arrival)) : "-");
        row.push_back(came ? fmt::format("{:.4g}", 1e-3 * found.overpressure) : "-");
        row.push_back(came ? fmt::format("{}{:.4g}", found.complete ? "" : "> ", found.impulse) : "-");
        const bool known = z >= range.nearest && z <= range.farthest;
        const BlastWave empirical = known ? kingery_bulmash(Burst::spherical, mass, gauge.radius) : BlastWave{};
        row.push_back(known ? fmt::format("{:.4f}", 1e3 * (lone.lit + empirical.arrival)) : "-");
        row.push_back(known ? fmt::format("{:.4g}", 1e-3 * empirical.incident_pressure) : "-");
        row.push_back(known ? fmt::format("{:.4g}", empirical.incident_impulse) : "-");
        table.row(row);
    }
    return table.text();
}

}  // namespace

int radial_command(const Options& options)
{
    const CaseDescription description = case_of(options);
    if (!description.gas && !description.euler)
        throw InputError("there is no [gas] for a blast", "expected [gas] or [euler] with a fill", description.places.own);
    const CaseSurvey survey = survey_case(description);
    const LoneCharge lone =
        lone_charge(description, "a blast in one dimension", description.gas ? description.gas->places.own : description.euler->places.own);
    std::vector<RadialGauge> gauges;
    for (const double distance : distances(options, description, lone)) gauges.push_back({distance, {}});
    if (!(description.end_time > lone.lit))
        throw InputError("the charge is lit after end_time", "expected a later end_time", description.places.of("end_time"));
    std::optional<RunFolder> folder;
    if (!options.out.empty()) {
        folder.emplace(options.out);
        folder->create(options.force ? Existing::replace : Existing::refuse);
    }
    const RadialFlow flow = solve(lone, options, description.end_time - lone.lit, gauges, folder);
    const double mass = 4 * std::numbers::pi / 3 * std::pow(lone.charge.radius, 3) * lone.charge.density * lone.charge.energy / tnt_energy;
    fmt::print(
        "{}{} cells, to {:g} ms. KB: curves of Kingery and Bulmash for {:.4g} kg of TNT in free air; measured blasts scatter by 15 to 25 % "
        "about "
        "them near the charge.\n",
        measures_text(lone, gauges, mass), flow.cells(), 1e3 * description.end_time, mass);
    return 0;
}

}  // namespace corpuscle
