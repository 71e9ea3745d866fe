#include "app/command_line.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands/commands.hpp"
#include "app/terminal/report_error.hpp"
#include "base/error.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

using Command = std::function<int(const Options&)>;

/// The commands and what they take.
class CommandLine {
public:
    CommandLine()
    {
        app_.require_subcommand(1);
        app_.set_version_flag("--version", "corpuscle " CORPUSCLE_VERSION);
        add_case_commands();
        add_word_commands();
    }

    void parse(int argc, char** argv) { app_.parse(argc, argv); }
    /// Prints help, version, or what is wrong with the command line.
    int answer(const CLI::ParseError& error) { return app_.exit(error) == 0 ? exit_done : exit_wrong_input; }
    int execute()
    {
        std::error_code error;
        options_.program = std::filesystem::read_symlink("/proc/self/exe", error);
        if (options_.threads > 0) set_thread_count(options_.threads);
        return command_(options_);
    }

private:
    CLI::App* add(const std::string& name, const std::string& meaning, Command command)
    {
        CLI::App* sub = app_.add_subcommand(name, meaning);
        sub->callback([this, command = std::move(command)] { command_ = command; });
        return sub;
    }

    void add_case_commands()
    {
        CLI::App* run = add("run", "Simulate a case", run_command);
        run->add_option("case", options_.subject, "The case (.toml)")->required();
        run->add_option("--out", options_.out, "Folder for the results (default: results/<name of the case>)");
        run->add_flag("--force", options_.force, "Replace the results of an earlier run");
        run->add_flag("--quiet", options_.quiet, "No progress, no tables");
        add_settings(run);
        CLI::App* resume = add("resume", "Go on with an interrupted run", resume_command);
        resume->add_option("folder", options_.subject, "Its folder of results")->required();
        resume->add_flag("--quiet", options_.quiet, "No progress, no tables");
        add_settings(resume, "Change end_time or a key of output: key=value, such as end_time=\"4 ms\"");
        CLI::App* report = add("report", "Make report.html again", report_command);
        report->add_option("folder", options_.subject, "A folder of results")->required();
        add_radial(add("radial", "Solve a case's one spherical charge in free gas, in one dimension", radial_command));
        CLI::App* check = add("check", "Everything but the steps: masses, counts, memory, expected time, warnings", check_command);
        check->add_option("case", options_.subject, "The case (.toml)")->required();
        add_settings(check);
    }

    void add_radial(CLI::App* radial)
    {
        radial->add_option("case", options_.subject, "The case (.toml)")->required();
        radial->add_option("--at", options_.at,
                           "Distances from the charge's center [m], such as 0.5,1,2 (default: those of the sphere gauges)");
        radial->add_option("--cells", options_.cells, "Cells in a radius of the charge (default: 100)")->check(CLI::Range(10, 2000));
        radial->add_option("--out", options_.out, "Folder for history.csv and profile.csv (default: nothing is written)");
        radial->add_flag("--force", options_.force, "Replace earlier results");
        add_settings(radial);
    }

    void add_settings(CLI::App* sub, const std::string& meaning = "Change a value: key=value, such as charge.0.mass=\"20 kg\"")
    {
        sub->add_option("--set", options_.settings, meaning)->allow_extra_args(false)->take_all();
        add_threads(sub);
    }

    void add_threads(CLI::App* sub)
    {
        sub->add_option("--threads", options_.threads, "Threads (default: all processors)")->check(CLI::Range(1, 4096));
    }

    void add_word_commands()
    {
        CLI::App* fresh = add("new", "Write a commented case to start from: plate", new_command);
        fresh->add_option("name", options_.subject, "The starter: plate")->required();
        fresh->add_option("--out", options_.out, "The file to write (default: NAME.toml)");
        fresh->add_flag("--force", options_.force, "Replace an existing file");
        CLI::App* list = add("list", "List explosives, materials, gases or fields", list_command);
        list->add_option("kind", options_.subject, "explosives, materials, gases or fields")->required();
        CLI::App* bench = add("bench", "Time the step's loops beside reference loops", bench_command);
        bench->add_option("name", options_.subject,
                          "reference, gas, sizes (1e5 to 2e7 particles), shells or euler (default: all but sizes)");
        bench->add_flag("--json", options_.json, "As JSON");
        bench->add_option("--out", options_.out, "A file for the JSON, besides the table");
        bench->add_option("--threads", options_.threads, "Threads (default: 1, then 2)")->check(CLI::Range(1, 4096));
        CLI::App* explain = add("explain", "Explain a key of a case", explain_command);
        explain->add_option("key", options_.subject, "The key, such as charge.mass");
        explain->add_flag("--markdown", options_.markdown, "The whole reference page");
    }

    CLI::App app_{"Blast on structures with gas particles", "corpuscle"};
    Options options_;
    Command command_;
};

int guarded(CommandLine& line)
{
    try {
        return line.execute();
    } catch (const SafetyStop& stop) {
        report_error(stop);
        return exit_safety_stop;
    } catch (const Error& error) {
        report_error(error);
        return exit_wrong_input;
    } catch (const std::bad_alloc&) {
        report_error(Error("there is not enough memory", "give the case fewer particles or elements, or use a larger machine"));
        return exit_wrong_input;
    } catch (const std::exception& error) {
        report_error(Error(error.what(), "this should not happen: please report it with the case"));
        return exit_safety_stop;
    }
}

}  // namespace

int run_command_line(int argc, char** argv)
{
    CommandLine line;
    try {
        line.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return line.answer(error);
    }
    return guarded(line);
}

}  // namespace corpuscle
