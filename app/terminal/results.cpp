#include "app/terminal/results.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/terminal/table.hpp"

namespace corpuscle {

namespace {

std::string measured_text(const RunSummary& summary)
{
    TextTable table({"measured", "quantity", "least", "greatest", "at the end"});
    for (const auto& [probe, quantities] : summary.probes)
        for (const auto& [quantity, value] : quantities)
            table.row({probe, quantity, fmt::format("{:.4g}", value.minimum), fmt::format("{:.4g}", value.maximum),
                       fmt::format("{:.4g}", value.final)});
    for (const auto& [gauge, value] : summary.gauges) {
        table.row({gauge, "pressure_pa", "-", fmt::format("{:.4g}", value.peak_pressure), "-"});
        table.row({gauge, "impulse_pa_s", "-", fmt::format("{:.4g}", value.impulse), "-"});
    }
    return summary.probes.empty() && summary.gauges.empty() ? "" : table.text() + "\n";
}

std::string phases_text(const RunSummary& summary)
{
    TextTable table({"phase", "seconds", "share [%]"});
    double sum = 0;
    for (const auto& [phase, seconds] : summary.seconds) {
        table.row({phase, fmt::format("{:.2f}", seconds), fmt::format("{:.1f}", 100 * seconds / std::max(summary.wall_seconds, 1e-9))});
        sum += seconds;
    }
    const double rest = std::max(0.0, summary.wall_seconds - sum);
    table.row({"rest", fmt::format("{:.2f}", rest), fmt::format("{:.1f}", 100 * rest / std::max(summary.wall_seconds, 1e-9))});
    return table.text() + "\n";
}

/// Wall nanoseconds for each unit of work of the whole run.
std::string pace_text(const RunSummary& summary)
{
    std::string text = fmt::format("{} steps to {:.4g} ms in {:.2f} s on {} threads", summary.steps, 1e3 * summary.end_time,
                                   summary.wall_seconds, summary.threads);
    if (summary.particle_steps > 0)
        text += fmt::format(", {:.1f} ns a particle and step", 1e9 * summary.wall_seconds / static_cast<double>(summary.particle_steps));
    if (summary.cell_steps > 0)
        text += fmt::format(", {:.1f} ns a cell and step", 1e9 * summary.wall_seconds / static_cast<double>(summary.cell_steps));
    return text + fmt::format("; memory {:.0f} MB\n", static_cast<double>(summary.peak_memory) / 1e6);
}

/// Quantities that a reader looks for first; the rest is in the report.
bool is_shown(const std::string& place)
{
    return !place.starts_with("/parts/") && place.find("time_of_") == std::string::npos && place.find("_error_") == std::string::npos;
}

}  // namespace

std::string ensemble_text(const RunSummary& summary)
{
    const EnsembleSummary& ensemble = *summary.ensemble;
    TextTable table({"measured", "mean", "standard error", "95 % from", "to", "deviation of a run"});
    for (const auto& [place, statistic] : ensemble.quantities) {
        if (!is_shown(place)) continue;
        table.row({place.substr(place.find('/', 1) + 1), fmt::format("{:.4g}", statistic.mean),
                   fmt::format("{:.2g}", statistic.standard_error), fmt::format("{:.4g}", statistic.low),
                   fmt::format("{:.4g}", statistic.high), fmt::format("{:.2g}", statistic.deviation)});
    }
    return fmt::format("\n{}\n{} of {} runs done in {:.2f} s of wall and {:.2f} s of CPU time\n", table.text(), ensemble.done.size(),
                       ensemble.seeds.size(), summary.wall_seconds, summary.cpu_seconds);
}

std::string results_text(const RunSummary& summary)
{
    return fmt::format("\n{}{}{}errors of the books: mass {:.1e}, momentum {:.1e}, energy {:.1e}\n", measured_text(summary),
                       phases_text(summary), pace_text(summary), summary.mass_error, summary.momentum_error, summary.energy_error);
}

}  // namespace corpuscle
