#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "app/command_line.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/ensemble.hpp"
#include "app/terminal/interrupt.hpp"
#include "app/terminal/progress.hpp"
#include "app/terminal/results.hpp"
#include "input/build.hpp"
#include "input/case/read_case.hpp"
#include "input/presets.hpp"
#include "output/replace_file.hpp"
#include "simulation/report.hpp"
#include "simulation/simulation.hpp"

namespace corpuscle {

namespace {

/// Where the results go: as asked for, else results/<the case's name>, or its folder's where all cases are called "case".
std::filesystem::path results_folder(const Options& options)
{
    if (!options.out.empty()) return options.out;
    const std::filesystem::path file = std::filesystem::absolute(options.subject);
    const std::string stem = file.stem().string();
    const std::string folder = file.parent_path().filename().string();
    return std::filesystem::path("results") / (stem == "case" && !folder.empty() ? folder : stem);
}

/// The parts and the quality of their meshes, in the log.
void tell_parts(const CaseSurvey& survey, Log& log)
{
    for (const PartReport& part : survey.parts) log.line(part.text());
}

void tell_warnings(const CaseSurvey& survey, Log& log, bool quiet)
{
    for (const std::string& warning : survey.warnings) {
        log.warning(warning);
        if (!quiet) fmt::print(stderr, "warning: {}\n", warning);
    }
}

/// Runs under the eye of the display; the simulation leaves summary and report, also when it stops itself.
Ending run_watched(Simulation& simulation, ProgressDisplay& display)
{
    const InterruptWatch watch;
    try {
        const Ending ending = simulation.run(watch.requested(), [&](const Progress& progress) { display.show(progress); });
        display.finish();
        return ending;
    } catch (const SafetyStop&) {
        display.finish();
        throw;
    }
}

/// Steps to the end and says what came of it.
int finish(Simulation& simulation, const RunFolder& folder, const Options& options)
{
    ProgressDisplay display(options.quiet ? ProgressStyle::none : isatty(STDERR_FILENO) != 0 ? ProgressStyle::bar : ProgressStyle::lines);
    const Ending ending = run_watched(simulation, display);
    if (!options.quiet) fmt::print("{}", results_text(read_summary(folder.summary())));
    if (ending == Ending::interrupted) {
        fmt::print("interrupted, state saved; go on with: corpuscle resume {}\n", folder.path().string());
        return exit_interrupted;
    }
    fmt::print("results in {}, report {}\n", folder.path().string(), folder.report().string());
    return exit_done;
}

}  // namespace

namespace {

/// Refuses to change what the saved state was made with: only how far the run goes, and what it writes, may change half way.
void check_changes(const std::vector<std::string>& settings)
{
    for (const std::string& setting : settings) {
        const std::string key = setting.substr(0, setting.find('='));
        if (key == "end_time" || key.starts_with("output.")) continue;
        throw InputError(fmt::format("'{}' cannot be changed half way through a run", key),
                         "expected end_time or a key of output; start a new run for anything else", {"--set " + key, 0, 0});
    }
}

}  // namespace

int run_command(const Options& options)
{
    const RunFolder folder(results_folder(options));
    const Existing existing = options.force ? Existing::replace : Existing::refuse;
    const CaseDescription description = case_of(options);
    if (description.ensemble > 1) return run_ensemble(options, description, folder);
    folder.check(existing);
    CaseSurvey survey = survey_case(description);
    std::unique_ptr<Model> model = build(description, survey);
    folder.create(existing);
    replace_file(folder.resolved_case(), resolved_case(description));
    Simulation simulation(std::move(model), folder);
    tell_parts(survey, simulation.log());
    tell_warnings(survey, simulation.log(), options.quiet);
    return finish(simulation, folder, options);
}

int resume_command(const Options& options)
{
    const RunFolder folder(options.subject);
    if (!std::filesystem::exists(folder.resolved_case()))
        throw InputError(fmt::format("'{}' holds no run to go on with", options.subject),
                         "expected the folder of an earlier `corpuscle run`");
    check_changes(options.settings);
    CaseDescription description = read_case(folder.resolved_case(), options.settings);
    resolve_presets(description, preset_folders(description.folder, options.installed_share()));
    if (description.ensemble > 1) return resume_ensemble(options, description, folder);
    const std::unique_ptr<Simulation> simulation = Simulation::resume(build(description), folder);
    if (!options.settings.empty()) replace_file(folder.resolved_case(), resolved_case(description));
    return finish(*simulation, folder, options);
}

int report_command(const Options& options)
{
    fmt::print("{}\n", write_report(options.subject).string());
    return exit_done;
}

}  // namespace corpuscle
