#include "simulation/ensemble_summary.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace corpuscle {

namespace {

using Json = nlohmann::ordered_json;

/// What differs from seed to seed.
bool is_measured(const std::string& place)
{
    const bool of_seed = place.find("/kingery_bulmash/") == std::string::npos;
    return of_seed && (place.starts_with("/probes/") || place.starts_with("/gauges/") || place.starts_with("/parts/"));
}

/// Every measured number of every member, by its place.
std::map<std::string, std::vector<double>> samples_of(const std::vector<Json>& members)
{
    std::map<std::string, std::vector<double>> samples;
    for (const Json& member : members) {
        const Json leaves = member.flatten();
        for (const auto& [place, leaf] : leaves.items())
            if (is_measured(place) && leaf.is_number()) samples[place].push_back(leaf.get<double>());
    }
    return samples;
}

void add_work(RunSummary& sum, const RunSummary& member)
{
    sum.steps += member.steps;
    sum.wall_seconds += member.wall_seconds;
    sum.cpu_seconds += member.cpu_seconds;
    sum.particle_steps += member.particle_steps;
    sum.element_steps += member.element_steps;
    sum.grain_steps += member.grain_steps;
    sum.cell_steps += member.cell_steps;
    sum.squeezed_cells += member.squeezed_cells;
    sum.peak_memory = std::max(sum.peak_memory, member.peak_memory);
    for (std::size_t i = 0; i < std::min(sum.seconds.size(), member.seconds.size()); ++i) sum.seconds[i].second += member.seconds[i].second;
}

/// Of two relative errors the one further from 0; one that is not a number is the worst.
double worse(double a, double b)
{
    return std::abs(a) >= std::abs(b) || std::isnan(a) ? a : b;
}

void keep_worst(RunSummary& worst, const RunSummary& member)
{
    worst.mass_error = worse(worst.mass_error, member.mass_error);
    worst.momentum_error = worse(worst.momentum_error, member.momentum_error);
    worst.energy_error = worse(worst.energy_error, member.energy_error);
    for (std::size_t i = 0; i < std::min(worst.verdicts.size(), member.verdicts.size()); ++i)
        if (!(member.verdicts[i].value <= worst.verdicts[i].value)) worst.verdicts[i].value = member.verdicts[i].value;
}

}  // namespace

RunSummary ensemble_summary(const std::vector<RunSummary>& members, const std::vector<std::uint64_t>& seeds)
{
    RunSummary summary;
    EnsembleSummary ensemble;
    ensemble.seeds = seeds;
    if (!members.empty()) {
        std::vector<Json> texts;
        for (const RunSummary& member : members) texts.push_back(Json::parse(summary_text(member)));
        Json mean = texts.front();
        for (const auto& [place, samples] : samples_of(texts)) {
            ensemble.quantities[place] = statistic_of(samples);
            mean[Json::json_pointer(place)] = ensemble.quantities[place].mean;
        }
        summary = parse_summary(mean.dump(), "ensemble");
        for (std::size_t i = 1; i < members.size(); ++i) {
            add_work(summary, members[i]);
            keep_worst(summary, members[i]);
        }
    }
    for (const RunSummary& member : members) ensemble.done.push_back(member.seed);
    summary.transfers.clear();
    if (!seeds.empty()) summary.seed = seeds.front();
    summary.ensemble = std::move(ensemble);
    return summary;
}

}  // namespace corpuscle
