#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "base/clock.hpp"
#include "model/model.hpp"
#include "simulation/outputs.hpp"
#include "simulation/phases.hpp"
#include "simulation/recorder.hpp"
#include "simulation/structure_pace.hpp"
#include "simulation/summary.hpp"

namespace corpuscle {

/// How a run ended.
enum class Ending { done, interrupted };

/// Where a run stands, for progress lines.
struct Progress {
    double time = 0;      ///< [s]
    double end_time = 0;  ///< [s]
    std::uint64_t step = 0;
    double duration = 0;      ///< of the last step [s]
    std::string step_set_by;  ///< "gas", "structure" or "euler"
    double energy_error = 0;  ///< relative
    std::size_t particles = 0;
    std::size_t cells = 0;    ///< of the grid
    double wall_seconds = 0;  ///< since the start or the resume
};

/// Counts of work done, for the cost of a run.
struct Work {
    std::uint64_t particle_steps = 0;
    std::uint64_t element_steps = 0;
};

/// Advances a model from its start, or from a saved state, to its end, writing into a run's folder.
class Simulation {
public:
    /// A new run. The folder has been made by RunFolder::create.
    Simulation(std::unique_ptr<Model> model, RunFolder folder);

    /// Goes on from the newest whole state in the folder, in which the model's case has run.
    [[nodiscard]] static std::unique_ptr<Simulation> resume(std::unique_ptr<Model> model, RunFolder folder);

    /// Steps to the end, or until `stop` is set or a file "stop" is dropped into the folder; then the state is saved. `tell` is
    /// called after each step. Throws SafetyStop (state saved, summary written) if the run is no longer sound.
    Ending run(const std::atomic<bool>& stop, const std::function<void(const Progress&)>& tell);

    /// One step of the whole model.
    void step();

    [[nodiscard]] const Model& model() const { return *model_; }
    [[nodiscard]] const Clock& clock() const { return clock_; }
    [[nodiscard]] const Phases& phases() const { return phases_; }
    [[nodiscard]] Progress progress() const;
    /// Everything known of the run so far.
    [[nodiscard]] RunSummary summary() const;
    [[nodiscard]] Log& log() { return outputs_->log(); }

private:
    struct Resumed {};
    Simulation(std::unique_ptr<Model> model, RunFolder folder, Resumed);

    void begin();
    void take_up();
    [[nodiscard]] double next_step();
    void burn();
    void flow();
    void close_books();
    void check_soundness() const;
    [[nodiscard]] std::string first_not_finite() const;
    [[nodiscard]] PartSummary summarize_part(std::uint32_t p) const;
    [[nodiscard]] RestartContent state();
    [[nodiscard]] std::vector<FieldSet> sets();
    void write_results(const std::string& status, const std::string& reason);
    void log_step();

    std::unique_ptr<Model> model_;
    RunFolder folder_;
    Clock clock_;
    Phases phases_;
    Work work_;
    StructurePace pace_;
    Recorder recorder_;
    std::unique_ptr<Outputs> outputs_;
    FacePassages entered_;              ///< passages of the gas that are in the ledger
    EulerPassages entered_by_cells_{};  ///< those of the gases on a grid
    Passage entered_asleep_;            ///< what gas asleep was given, as it is in the ledger
    double steady_step_ = 0;            ///< of the gas, kept while it fits [s]
    std::string step_set_by_ = "gas";
    std::map<std::string, std::uint64_t> particles_at_start_;  ///< by species
    double wall_before_ = 0;                                   ///< of the run before it was resumed [s]
    double cpu_before_ = 0;                                    ///< [s]
    std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace corpuscle
