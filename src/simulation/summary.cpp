#include "simulation/summary.hpp"

#include <fmt/format.h>

#include <cctype>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "output/replace_file.hpp"

namespace corpuscle {

namespace {

using Json = nlohmann::ordered_json;

constexpr int summary_version = 1;

Json array_of(const Vector3d& vector)
{
    return Json::array({vector.x, vector.y, vector.z});
}

/// A number that was written; null stands for one that is not finite.
double number(const Json& value)
{
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

Vector3d vector_of(const Json& value)
{
    return {number(value.at(0)), number(value.at(1)), number(value.at(2))};
}

Json counts_of(const RunSummary& summary)
{
    return {{"particles", Json(summary.particles)}, {"elements", summary.elements}, {"grains", summary.grains}, {"cells", summary.cells}};
}

Json work_of(const RunSummary& summary)
{
    return {{"particle_steps", summary.particle_steps},
            {"element_steps", summary.element_steps},
            {"grain_steps", summary.grain_steps},
            {"cell_steps", summary.cell_steps},
            {"squeezed_cells", summary.squeezed_cells}};
}

Json ledger_of(const RunSummary& summary)
{
    Json ledger{{"mass_error", summary.mass_error}, {"momentum_error", summary.momentum_error}, {"energy_error", summary.energy_error}};
    ledger["transfers"] = Json::array();
    for (const Transfer& transfer : summary.transfers) {
        ledger["transfers"].push_back({{"from", transfer.from},
                                       {"to", transfer.to},
                                       {"mass_kg", transfer.mass},
                                       {"momentum_n_s", array_of(transfer.momentum)},
                                       {"energy_j", transfer.energy}});
    }
    return ledger;
}

Json verdicts_of(const RunSummary& summary)
{
    Json list = Json::array();
    for (const Verdict& verdict : all_verdicts(summary)) {
        list.push_back({{"name", verdict.name},
                        {"value", verdict.value},
                        {"limit", verdict.limit},
                        {"passed", verdict.passed()},
                        {"meaning", verdict.meaning}});
    }
    return list;
}

Json references_of(const RunSummary& summary)
{
    Json list = Json::array();
    for (const ReferenceValue& reference : summary.references) {
        list.push_back({{"column", reference.column}, {"value", reference.value}, {"label", reference.label}});
    }
    return list;
}

Json probes_of(const RunSummary& summary)
{
    Json probes = Json::object();
    for (const auto& [name, quantities] : summary.probes) {
        probes[name] = Json::object();
        for (const auto& [key, probe] : quantities) {
            probes[name][key] = {{"min", probe.minimum},
                                 {"max", probe.maximum},
                                 {"final", probe.final},
                                 {"time_of_min_s", probe.time_of_minimum},
                                 {"time_of_max_s", probe.time_of_maximum}};
        }
    }
    return probes;
}

Json gauges_of(const RunSummary& summary)
{
    Json gauges = Json::object();
    for (const auto& [name, gauge] : summary.gauges) {
        gauges[name] = {{"peak_pressure_pa", gauge.peak_pressure},
                        {"impulse_pa_s", gauge.impulse},
                        {"arrival_s", gauge.arrival},
                        {"peak_pressure_error_pa", gauge.peak_pressure_error},
                        {"impulse_error_pa_s", gauge.impulse_error}};
        if (const auto& known = gauge.kingery_bulmash)
            gauges[name]["kingery_bulmash"] = {
                {"peak_pressure_pa", known->peak_pressure}, {"impulse_pa_s", known->impulse}, {"arrival_s", known->arrival}};
    }
    return gauges;
}

Json parts_of(const RunSummary& summary)
{
    Json parts = Json::object();
    for (const auto& [name, part] : summary.parts) {
        parts[name] = {{"impulse_n_s", array_of(part.impulse)},         {"max_plastic_strain", part.max_plastic_strain},
                       {"kinetic_energy_j", part.kinetic_energy},       {"internal_energy_j", part.internal_energy},
                       {"gas_impulse_n_s", array_of(part.gas_impulse)}, {"gas_work_j", part.gas_work}};
    }
    return parts;
}

/// Each statistic at the place its quantity has in the summary itself.
Json ensemble_of(const EnsembleSummary& ensemble)
{
    Json quantities = Json::object();
    for (const auto& [place, statistic] : ensemble.quantities) {
        quantities[Json::json_pointer(place)] = {
            {"mean", statistic.mean}, {"deviation", statistic.deviation}, {"standard_error", statistic.standard_error},
            {"low", statistic.low},   {"high", statistic.high},           {"count", statistic.count}};
    }
    return {{"members", ensemble.seeds.size()},
            {"seeds", ensemble.seeds},
            {"done", ensemble.done},
            {"confidence", usual_confidence},
            {"quantities", quantities}};
}

EnsembleSummary read_ensemble(const Json& json)
{
    EnsembleSummary ensemble;
    json.at("seeds").get_to(ensemble.seeds);
    json.at("done").get_to(ensemble.done);
    const Json leaves = json.at("quantities").flatten();
    for (const auto& [place, leaf] : leaves.items()) {
        const std::size_t end = place.rfind('/');
        const std::string word = place.substr(end + 1);
        if (end == std::string::npos || end == 0) continue;
        Statistic& statistic = ensemble.quantities[place.substr(0, end)];
        if (word == "mean") statistic.mean = number(leaf);
        if (word == "deviation") statistic.deviation = number(leaf);
        if (word == "standard_error") statistic.standard_error = number(leaf);
        if (word == "low") statistic.low = number(leaf);
        if (word == "high") statistic.high = number(leaf);
        if (word == "count") leaf.get_to(statistic.count);
    }
    return ensemble;
}

void read_run(const Json& json, RunSummary& summary)
{
    summary.title = json.at("title").get<std::string>();
    summary.status = json.at("status").get<std::string>();
    summary.reason = json.value("reason", "");
    summary.program = json.value("program", "");
    summary.command = json.value("command", "");
    summary.end_time = number(json.at("end_time_s"));
    summary.steps = json.at("steps").get<std::uint64_t>();
    summary.wall_seconds = number(json.at("wall_s"));
    summary.cpu_seconds = number(json.at("cpu_s"));
    summary.peak_memory = json.at("peak_memory_bytes").get<std::uint64_t>();
    summary.threads = json.at("threads").get<int>();
    summary.ranks = json.at("ranks").get<int>();
    summary.seed = json.at("seed").get<std::uint64_t>();
}

void read_counts(const Json& counts, const Json& work, RunSummary& summary)
{
    counts.at("particles").get_to(summary.particles);
    counts.at("elements").get_to(summary.elements);
    counts.at("grains").get_to(summary.grains);
    counts.at("cells").get_to(summary.cells);
    work.at("particle_steps").get_to(summary.particle_steps);
    work.at("element_steps").get_to(summary.element_steps);
    work.at("grain_steps").get_to(summary.grain_steps);
    work.at("cell_steps").get_to(summary.cell_steps);
    summary.squeezed_cells = work.value("squeezed_cells", std::uint64_t{0});
}

void read_ledger(const Json& ledger, RunSummary& summary)
{
    summary.mass_error = number(ledger.at("mass_error"));
    summary.momentum_error = number(ledger.at("momentum_error"));
    summary.energy_error = number(ledger.at("energy_error"));
    if (!ledger.contains("transfers")) return;
    for (const Json& entry : ledger.at("transfers")) {
        summary.transfers.push_back({entry.at("from").get<std::string>(), entry.at("to").get<std::string>(), number(entry.at("mass_kg")),
                                     vector_of(entry.at("momentum_n_s")), number(entry.at("energy_j"))});
    }
}

/// The first three verdicts are made from the ledger's errors; only the others are kept.
void read_verdicts(const Json& list, RunSummary& summary)
{
    const std::size_t made = all_verdicts({}).size();
    for (std::size_t i = made; i < list.size(); ++i) {
        const Json& entry = list.at(i);
        summary.verdicts.push_back({entry.at("name").get<std::string>(), number(entry.at("value")), number(entry.at("limit")),
                                    entry.at("meaning").get<std::string>()});
    }
}

void read_bodies(const Json& json, RunSummary& summary)
{
    for (const auto& [name, quantities] : json.at("probes").items()) {
        for (const auto& [key, probe] : quantities.items()) {
            summary.probes[name][key] = {number(probe.at("min")), number(probe.at("max")), number(probe.at("final")),
                                         number(probe.at("time_of_min_s")), number(probe.at("time_of_max_s"))};
        }
    }
    for (const auto& [name, gauge] : json.at("gauges").items()) {
        summary.gauges[name] = {number(gauge.at("peak_pressure_pa")), number(gauge.at("impulse_pa_s")), number(gauge.at("arrival_s")),
                                number(gauge.value("peak_pressure_error_pa", Json())), number(gauge.value("impulse_error_pa_s", Json()))};
        if (const Json known = gauge.value("kingery_bulmash", Json()); !known.is_null())
            summary.gauges[name].kingery_bulmash =
                EmpiricalSummary{number(known.at("peak_pressure_pa")), number(known.at("impulse_pa_s")), number(known.at("arrival_s"))};
    }
    for (const auto& [name, part] : json.at("parts").items()) {
        summary.parts[name] = {vector_of(part.at("impulse_n_s")), number(part.at("max_plastic_strain")),
                               number(part.at("kinetic_energy_j")), number(part.at("internal_energy_j"))};
        if (!part.contains("gas_work_j")) continue;  // written by an earlier version
        summary.parts[name].gas_impulse = vector_of(part.at("gas_impulse_n_s"));
        summary.parts[name].gas_work = number(part.at("gas_work_j"));
    }
}

}  // namespace

std::string summary_key(const std::string& quantity, const std::string& unit)
{
    if (unit.empty() || unit == "1") return quantity;
    std::string key = quantity + "_";
    for (const char letter : unit) {
        if (letter == '/') {
            key += "_per_";
        } else if (letter == ' ') {
            key += '_';
        } else {
            key += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
        }
    }
    return key;
}

std::vector<Verdict> all_verdicts(const RunSummary& summary)
{
    std::vector<Verdict> verdicts{mass_verdict(summary.mass_error), momentum_verdict(summary.momentum_error),
                                  energy_verdict(summary.energy_error)};
    verdicts.insert(verdicts.end(), summary.verdicts.begin(), summary.verdicts.end());
    return verdicts;
}

std::string summary_text(const RunSummary& summary)
{
    Json json{{"version", summary_version},   {"title", summary.title},
              {"status", summary.status},     {"end_time_s", summary.end_time},
              {"steps", summary.steps},       {"wall_s", summary.wall_seconds},
              {"cpu_s", summary.cpu_seconds}, {"peak_memory_bytes", summary.peak_memory},
              {"threads", summary.threads},   {"ranks", summary.ranks},
              {"seed", summary.seed}};
    json["counts"] = counts_of(summary);
    json["work"] = work_of(summary);
    json["seconds"] = Json::object();
    for (const auto& [phase, seconds] : summary.seconds) json["seconds"][phase] = seconds;
    json["ledger"] = ledger_of(summary);
    json["probes"] = probes_of(summary);
    json["gauges"] = gauges_of(summary);
    json["parts"] = parts_of(summary);
    json["verdicts"] = verdicts_of(summary);
    json["references"] = references_of(summary);
    if (summary.ensemble) json["ensemble"] = ensemble_of(*summary.ensemble);
    json["reason"] = summary.reason;
    json["program"] = summary.program;
    json["command"] = summary.command;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_summary(const std::filesystem::path& path, const RunSummary& summary)
{
    replace_file(path, summary_text(summary), Durability::disk);
}

RunSummary parse_summary(const std::string& text, const std::string& name)
{
    try {
        const Json json = Json::parse(text);
        const int version = json.at("version").get<int>();
        if (version != summary_version) {
            throw InputError(fmt::format("'{}' has version {}, this program reads version {}", name, version, summary_version),
                             "use the program that wrote it");
        }
        RunSummary summary;
        read_run(json, summary);
        read_counts(json.at("counts"), json.at("work"), summary);
        for (const auto& [phase, seconds] : json.at("seconds").items()) summary.seconds.emplace_back(phase, number(seconds));
        read_ledger(json.at("ledger"), summary);
        read_bodies(json, summary);
        if (json.contains("verdicts")) read_verdicts(json.at("verdicts"), summary);
        if (json.contains("ensemble")) summary.ensemble = read_ensemble(json.at("ensemble"));
        for (const Json& entry : json.value("references", Json::array())) {
            summary.references.push_back(
                {entry.at("column").get<std::string>(), number(entry.at("value")), entry.at("label").get<std::string>()});
        }
        return summary;
    } catch (const nlohmann::json::exception& problem) {
        throw InputError(fmt::format("cannot understand '{}': {}", name, problem.what()), "is it the summary of a run?");
    }
}

RunSummary read_summary(const std::filesystem::path& path)
{
    return parse_summary(read_file(path), path.string());
}

}  // namespace corpuscle
