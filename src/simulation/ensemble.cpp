#include "simulation/ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "output/history/history.hpp"
#include "simulation/ensemble_summary.hpp"
#include "simulation/machine.hpp"
#include "simulation/report.hpp"

namespace corpuscle {

namespace fs = std::filesystem;

namespace {

/// Writes a table aside, then names it.
void write_history(const fs::path& path, const HistoryTable& table)
{
    const fs::path aside = path.string() + ".part";
    {
        History history(aside, table.columns);
        for (std::size_t row = 0; row < table.times.size(); ++row) {
            std::vector<double> values;
            for (const std::vector<double>& column : table.values) values.push_back(column[row]);
            history.add(table.times[row], values);
        }
    }
    fs::rename(aside, path);
}

}  // namespace

Ensemble::Ensemble(fs::path folder, std::uint64_t first_seed, int members, double end_time)
    : folder_(std::move(folder)), end_time_(end_time)
{
    for (int i = 0; i < members; ++i) seeds_.push_back(first_seed + static_cast<std::uint64_t>(i));
}

RunFolder Ensemble::member(std::uint64_t seed) const
{
    return RunFolder(folder_.path() / fmt::format("seed_{}", seed));
}

void Ensemble::check(Existing existing) const
{
    folder_.check(existing);
    for (const std::uint64_t seed : seeds_) member(seed).check(existing);
}

void Ensemble::create(Existing existing) const
{
    check(existing);
    folder_.create(existing);
    fs::remove(folder_.fields());
    fs::remove(folder_.restart());
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
        const bool older = entry.is_directory() && entry.path().filename().string().starts_with("seed_");
        if (older && RunFolder(entry.path()).has_results()) RunFolder(entry.path()).create(Existing::replace);
    }
}

bool Ensemble::is_done(std::uint64_t seed) const
{
    const fs::path path = member(seed).summary();
    if (!fs::exists(path)) return false;
    const RunSummary summary = read_summary(path);
    return summary.status == "done" && summary.end_time >= end_time_ * (1 - 1e-9);
}

bool Ensemble::has_state(std::uint64_t seed) const
{
    const fs::path states = member(seed).restart();
    if (!fs::exists(member(seed).resolved_case()) || !fs::is_directory(states)) return false;
    const fs::directory_iterator files(states);
    return std::any_of(begin(files), end(files), [](const auto& file) { return file.path().extension() == ".hdf"; });
}

double Ensemble::reached() const
{
    double latest = 0;
    for (const std::uint64_t seed : seeds_)
        if (fs::exists(member(seed).summary())) latest = std::max(latest, read_summary(member(seed).summary()).end_time);
    return latest;
}

RunSummary Ensemble::write_results(const SampleTimes& times, const std::string& title, const std::string& status, const std::string& reason,
                                   double wall_seconds) const
{
    std::vector<RunSummary> summaries;
    std::vector<HistoryTable> histories;
    for (const std::uint64_t seed : seeds_) {
        if (!is_done(seed)) continue;
        summaries.push_back(read_summary(member(seed).summary()));
        histories.push_back(read_history(member(seed).history()));
    }
    RunSummary summary = ensemble_summary(summaries, seeds_);
    summary.title = title;
    summary.status = status;
    summary.reason = reason;
    summary.program = program_text();
    summary.command = command_text();
    summary.wall_seconds = wall_seconds;
    if (histories.empty()) {
        fs::remove(folder_.history());
    } else {
        write_history(folder_.history(), ensemble_history(histories, times));
    }
    write_summary(folder_.summary(), summary);
    write_report(folder_.path());
    return summary;
}

}  // namespace corpuscle
