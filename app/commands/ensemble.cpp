#include "app/commands/ensemble.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <deque>
#include <fstream>

#include <fmt/format.h>

#include "app/command_line.hpp"
#include "app/terminal/child.hpp"
#include "app/terminal/interrupt.hpp"
#include "app/terminal/results.hpp"
#include "input/build.hpp"
#include "input/case/read_case.hpp"
#include "input/memory.hpp"
#include "output/log.hpp"
#include "output/replace_file.hpp"
#include "parallel/loops.hpp"
#include "simulation/ensemble.hpp"
#include "simulation/machine.hpp"

namespace corpuscle {

namespace {

/// When a case wants each of its columns sampled.
SampleTimes sample_times(const CaseDescription& description)
{
    SampleTimes times;
    times.end = description.end_time;
    times.otherwise = description.output.energies_every.value_or(description.end_time / 300);
    for (const ProbeInput& probe : description.probes) times.every[probe.name] = interval_of(probe.every, times.end);
    for (const GaugeInput& gauge : description.gauges) times.every[gauge.name] = interval_of(gauge.every, times.end);
    return times;
}

/// Has the members run, each by a program of its own, and keeps account of how they ended.
class Conductor {
public:
    Conductor(const Ensemble& ensemble, const Options& options, int at_once)
        : ensemble_(ensemble),
          options_(options),
          at_once_(at_once),
          threads_(std::max(1, thread_count() / at_once)),
          log_(ensemble.folder().log())
    {
        for (const std::uint64_t seed : ensemble.seeds())
            if (!ensemble.is_done(seed)) waiting_.push_back(seed);
        done_ = ensemble.seeds().size() - waiting_.size();
        tell(fmt::format("{} runs, {} of them done, {} at a time on {} thread{} each", ensemble.seeds().size(), done_, at_once_, threads_,
                         threads_ == 1 ? "" : "s"));
    }

    /// Until all are done, or until the user or a file "stop" asks for an end: then every member saves its state.
    void conduct()
    {
        const InterruptWatch watch;
        while (!running_.empty() || (!waiting_.empty() && !stopping_)) {
            while (!stopping_ && !waiting_.empty() && running_.size() < static_cast<std::size_t>(at_once_)) start_next();
            const FolderRequest request = ensemble_.folder().take_request();
            if (!stopping_ && (watch.requested() || request == FolderRequest::stop)) stop();
            if (request == FolderRequest::save) save();
            collect();
        }
    }

    [[nodiscard]] std::string status() const
    {
        if (stopping_ || interrupted_) return "interrupted";
        return failures_.empty() ? "done" : "stopped";
    }
    [[nodiscard]] const std::string& failures() const { return failures_; }

private:
    struct Running {
        std::uint64_t seed;
        Child child;
    };

    void start_next()
    {
        const std::uint64_t seed = waiting_.front();
        waiting_.pop_front();
        const RunFolder folder = ensemble_.member(seed);
        std::vector<std::string> words{options_.program.string()};
        const std::vector<std::string> fresh{"run",
                                             ensemble_.folder().resolved_case().string(),
                                             "--out",
                                             folder.path().string(),
                                             "--force",
                                             "--set",
                                             "ensemble=1",
                                             "--set",
                                             fmt::format("gas.seed={}", seed)};
        std::vector<std::string> old{"resume", folder.path().string()};
        for (const std::string& setting : options_.settings) old.insert(old.end(), {"--set", setting});
        const std::vector<std::string>& task = ensemble_.has_state(seed) ? old : fresh;
        words.insert(words.end(), task.begin(), task.end());
        for (const std::string& word : {std::string("--quiet"), std::string("--threads"), std::to_string(threads_)}) words.push_back(word);
        std::filesystem::create_directories(folder.path());
        running_.push_back({seed, Child(words)});
    }

    /// Members under way save their states and end; no other starts.
    void stop()
    {
        stopping_ = true;
        for (const Running& run : running_) run.child.ask_to_stop();
    }

    /// A file in a member's folder asks it to save its state.
    void save() const
    {
        for (const Running& run : running_) std::ofstream(ensemble_.member(run.seed).path() / "save").put('\n');
    }

    /// Takes leave of the members that have ended, after a moment's rest.
    void collect()
    {
        const timespec moment{0, 20'000'000};
        nanosleep(&moment, nullptr);
        for (Running& run : running_)
            if (const std::optional<int> code = run.child.ended()) note_end(run.seed, *code);
        std::erase_if(running_, [](Running& run) { return run.child.ended().has_value(); });
    }

    void note_end(std::uint64_t seed, int code)
    {
        const bool stopped_before_its_first_step = stopping_ && code == 128 + SIGTERM;
        if (code == exit_done) {
            ++done_;
            tell(fmt::format("seed {} done ({} of {})", seed, done_, ensemble_.seeds().size()));
        } else if (code == exit_interrupted || stopped_before_its_first_step) {
            interrupted_ = true;
            tell(fmt::format("seed {} interrupted{}", seed, code == exit_interrupted ? ", state saved" : ""));
        } else {
            failures_ += fmt::format("{}seed {} ended with code {}", failures_.empty() ? "" : ", ", seed, code);
            tell(fmt::format("seed {} ended with code {}: see {}", seed, code, ensemble_.member(seed).log().string()));
        }
    }

    void tell(const std::string& line)
    {
        log_.line(line);
        if (options_.quiet) return;
        fmt::print(stderr, "{}\n", line);
        std::fflush(stderr);
    }

    const Ensemble& ensemble_;
    const Options& options_;
    int at_once_;
    int threads_;  ///< of each member
    Log log_;
    std::deque<std::uint64_t> waiting_;
    std::vector<Running> running_;
    std::size_t done_ = 0;
    bool stopping_ = false;
    bool interrupted_ = false;
    std::string failures_;
};

int exit_code_of(const std::string& status)
{
    if (status == "done") return exit_done;
    return status == "interrupted" ? exit_interrupted : exit_safety_stop;
}

/// Runs what is to run and leaves the results.
int finish(const Ensemble& ensemble, const Options& options, const CaseDescription& description, std::size_t memory)
{
    const auto started = std::chrono::steady_clock::now();
    Conductor conductor(ensemble, options, members_at_once(description.ensemble, memory));
    conductor.conduct();
    const std::string status = conductor.status(), folder = ensemble.folder().path().string();
    const std::filesystem::path earlier = ensemble.folder().summary();
    const double wall_before = std::filesystem::exists(earlier) ? read_summary(earlier).wall_seconds : 0;
    const RunSummary summary = ensemble.write_results(sample_times(description), description.title, status, conductor.failures(),
                                                      wall_before + wall_seconds_since(started));
    if (!options.quiet) fmt::print("{}", ensemble_text(summary));
    if (status == "interrupted") {
        fmt::print("interrupted, states saved; go on with: corpuscle resume {}\n", folder);
    } else {
        fmt::print("results in {}, report {}\n", folder, ensemble.folder().report().string());
    }
    return exit_code_of(status);
}

Ensemble ensemble_of(const CaseDescription& description, const RunFolder& folder)
{
    return {std::filesystem::absolute(folder.path()), description.gas->seed, description.ensemble, description.end_time};
}

}  // namespace

int members_at_once(int members, std::size_t memory_of_one)
{
    const std::size_t free = machine_memory().available;
    const std::size_t room = free == 0 ? 1 : std::max<std::size_t>(1, free / std::max<std::size_t>(1, memory_of_one));
    return static_cast<int>(std::min<std::size_t>({static_cast<std::size_t>(members), static_cast<std::size_t>(thread_count()), room}));
}

int run_ensemble(const Options& options, const CaseDescription& description, const RunFolder& folder)
{
    const Existing existing = options.force ? Existing::replace : Existing::refuse;
    folder.check(existing);
    CaseSurvey survey = survey_case(description);
    const Ensemble ensemble = ensemble_of(description, folder);
    ensemble.check(existing);
    const std::size_t memory = survey.memory;
    build(description, survey).reset();  // what a member would refuse is refused before anything is written
    ensemble.create(existing);
    replace_file(folder.resolved_case(), resolved_case(description));
    for (const std::string& warning : survey.warnings)
        if (!options.quiet) fmt::print(stderr, "warning: {}\n", warning);
    return finish(ensemble, options, description, memory);
}

int resume_ensemble(const Options& options, const CaseDescription& description, const RunFolder& folder)
{
    const std::size_t memory = survey_case(description).memory;
    const Ensemble ensemble = ensemble_of(description, folder);
    if (ensemble.reached() > description.end_time * (1 + 1e-12))
        throw InputError(
            fmt::format("a run has come to {:.6g} s already, beyond the end time of {:.6g} s", ensemble.reached(), description.end_time),
            "expected a later end_time");
    if (!options.settings.empty()) replace_file(folder.resolved_case(), resolved_case(description));
    return finish(ensemble, options, description, memory);
}

}  // namespace corpuscle
