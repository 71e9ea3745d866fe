#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/clock.hpp"
#include "output/history/history.hpp"
#include "output/log.hpp"
#include "output/restart/restart_folder.hpp"
#include "output/vtk/series.hpp"
#include "simulation/outputs_interval.hpp"
#include "simulation/run_folder.hpp"

namespace corpuscle {

/// Columns of the history that are sampled together: a probe, a gauge, the energies.
struct HistorySource {
    double every = 0;  ///< [s]
    std::vector<HistoryColumn> columns;
    std::function<void(std::span<double> values)> sample;  ///< writes a value a column
};

/// A family of files for ParaView: "gas", "cells", "structure".
struct FieldSource {
    std::string family;
    double every = 0;                                              ///< [s]
    std::function<void(const std::filesystem::path& path)> write;  ///< writes one file
};

/// Everything a run writes while it goes on.
struct OutputPlan {
    std::vector<HistorySource> history;
    std::vector<FieldSource> fields;
    double end_time = std::numeric_limits<double>::infinity();  ///< of the run [s]; at the end of its last step everything is due
    double restart_every = 600;                                 ///< wall clock [s]
    std::function<RestartContent()> state;                      ///< everything to go on from; no restarts if empty
};

/// Writes what is due, when it is due, into a run's folder.
class Outputs {
public:
    /// For a new run in a folder made by RunFolder::create. Throws Error.
    Outputs(RunFolder folder, OutputPlan plan);

    /// For a run that goes on from a state saved at `time` [s]: what lies after it in the history and the series is cut off. Throws Error.
    Outputs(RunFolder folder, OutputPlan plan, double time);

    /// The next simulated time [s] at which something is due, for a step that wants to end there.
    [[nodiscard]] double next_due() const;

    /// Writes the samples and dumps that are due at the end of the clock's step. Called before Clock::end_step, and once at the start of a
    /// new run, when the step has no length yet, for the initial state.
    void write_due(const Clock& clock);

    /// Between steps: saves a restart if its wall time has come or a file "save" was dropped into the folder.
    void save_due();

    /// Between steps: saves a restart now. Nothing if the plan has no state.
    void save();

    /// After the last step: writes the present sample and dump of every source that has not been written at this time (none, if the plan
    /// knew the end), and a restart. Sources are then asked between steps: Clock::time, not Clock::end, is the present.
    void finish(const Clock& clock);

    /// Whether a file "stop" was dropped into the folder; looked for at most once a second of wall time.
    [[nodiscard]] bool stop_requested();

    [[nodiscard]] Log& log() { return log_; }
    [[nodiscard]] const RunFolder& folder() const { return folder_; }

private:
    using WallClock = std::chrono::steady_clock;

    struct Family {
        VtkSeries series;
        Interval interval;
    };

    Outputs(RunFolder folder, OutputPlan plan, std::optional<double> resumed);
    void sample(double time, const std::vector<bool>& due);
    void look_for_requests();

    RunFolder folder_;
    OutputPlan plan_;
    Log log_;
    History history_;
    std::vector<Interval> samplings_;
    std::vector<Family> families_;
    RestartFolder restart_;
    double sampled_ = -1;  ///< time of the last line of the history [s]
    WallClock::time_point saved_at_;
    WallClock::time_point looked_at_;
    FolderRequest request_ = FolderRequest::none;
};

}  // namespace corpuscle
