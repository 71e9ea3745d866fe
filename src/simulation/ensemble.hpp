#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "simulation/ensemble_history.hpp"
#include "simulation/run_folder.hpp"
#include "simulation/summary.hpp"

namespace corpuscle {

/// Runs of one case that differ by their seed, each in a folder of its own within the ensemble's.
class Ensemble {
public:
    /// `members` runs to `end_time` [s] with the seeds first_seed, first_seed + 1, ... Names only; touches nothing.
    Ensemble(std::filesystem::path folder, std::uint64_t first_seed, int members, double end_time);

    [[nodiscard]] const std::vector<std::uint64_t>& seeds() const { return seeds_; }
    [[nodiscard]] const RunFolder& folder() const { return folder_; }
    /// DIR/seed_7.
    [[nodiscard]] RunFolder member(std::uint64_t seed) const;

    /// Refuses (InputError), before anything is written, what create() would refuse.
    void check(Existing existing) const;
    /// Makes the ensemble's folder, or empties it and all its members' of an older run's results.
    void create(Existing existing) const;

    /// Whether a member has run to the end, and whether it has a state to go on from.
    [[nodiscard]] bool is_done(std::uint64_t seed) const;
    [[nodiscard]] bool has_state(std::uint64_t seed) const;
    /// The latest time that a member has come to [s].
    [[nodiscard]] double reached() const;

    /// Writes what the members that are done say together: history.csv (none without any), summary.json, report.html. Gives the summary.
    RunSummary write_results(const SampleTimes& times, const std::string& title, const std::string& status, const std::string& reason,
                             double wall_seconds) const;

private:
    RunFolder folder_;
    std::vector<std::uint64_t> seeds_;
    double end_time_;  ///< [s]
};

}  // namespace corpuscle
