#include <fmt/format.h>

#include "app/commands/commands.hpp"
#include "app/terminal/table.hpp"
#include "simulation/bench.hpp"

namespace corpuscle {

int bench_command(const Options& options)
{
    BenchSettings settings;
    settings.name = options.subject;
    if (options.threads > 0) settings.threads = {options.threads};
    const std::vector<BenchLine> lines = run_bench(settings);
    if (options.json) {
        fmt::print("{}\n", bench_json(lines));
        return 0;
    }
    TextTable table({"loop", "threads", "ns a thing and step", "over reference copy", "bytes a thing"});
    for (const BenchLine& line : lines) {
        table.row({line.name, fmt::format("{}", line.threads), fmt::format("{:.1f}", line.nanoseconds), fmt::format("{:.2f}", line.ratio),
                   line.bytes > 0 ? fmt::format("{:.1f}", line.bytes) : "-"});
    }
    fmt::print("{}", table.text());
    return 0;
}

}  // namespace corpuscle
