#include <fstream>

#include <fmt/format.h>

#include "app/commands/commands.hpp"
#include "app/terminal/table.hpp"
#include "base/error.hpp"
#include "simulation/bench.hpp"

namespace corpuscle {

namespace {

/// A number with so many digits behind the point; nothing for 0.
std::string figure(double value, int digits)
{
    return value > 0 ? fmt::format("{:.{}f}", value, digits) : "-";
}

}  // namespace

int bench_command(const Options& options)
{
    BenchSettings settings;
    settings.name = options.subject;
    if (options.threads > 0) settings.threads = {options.threads};
    const std::vector<BenchLine> lines = run_bench(settings);
    if (!options.out.empty()) {
        std::ofstream file(options.out);
        file << bench_json(lines) << "\n";
        if (!file) throw InputError(fmt::format("cannot write {}", options.out), "expected a file in a folder that is there");
    }
    if (options.json) {
        fmt::print("{}\n", bench_json(lines));
        return 0;
    }
    TextTable table(
        {"loop", "threads", "ns a thing and step", "over reference copy", "least bytes moved", "over memory limit", "bytes resident"});
    for (const BenchLine& line : lines) {
        table.row({line.name, fmt::format("{}", line.threads), figure(line.nanoseconds, 1), figure(line.ratio, 2), figure(line.moved, 0),
                   figure(line.limit, 1), figure(line.resident, 1)});
    }
    fmt::print("{}", table.text());
    return 0;
}

}  // namespace corpuscle
