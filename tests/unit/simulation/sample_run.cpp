#include "sample_run.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "output/history/history.hpp"
#include "output/replace_file.hpp"
#include "simulation/run_folder.hpp"
#include "simulation/summary_history.hpp"

namespace corpuscle {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// The values of one line: a probe, a gauge sampled at half the rate, three energies.
std::vector<double> line(int i)
{
    const double time = 3e-3 * i / 600;
    const double after = std::max(0.0, time - 0.16e-3);
    const double wave = std::exp(-after / 2e-3);
    const double deflection = 0.047 * wave * std::sin(2 * std::numbers::pi * after / 3.2e-3);
    const double velocity = after > 0 ? 90 * wave * std::cos(2 * std::numbers::pi * after / 3.2e-3) : 0;
    const double pressure = after > 0 ? 101325 + 91e6 * std::exp(-after / 0.08e-3) : 101325;
    const double impulse = 8.5e3 * (1 - std::exp(-after / 0.08e-3));
    const bool gauge = i % 2 == 0;
    const double given = 2e5 * (1 - std::exp(-after / 0.3e-3));
    return {0,           1e-9,       -deflection, -velocity, gauge ? pressure : nothing, gauge ? impulse : nothing, 68.2e6 - given,
            given * 0.4, given * 0.6};
}

}  // namespace

ReportData sample_run()
{
    ReportData data;
    data.history.columns = {{"center.displacement_x", "m"},
                            {"center.displacement_y", "m"},
                            {"center.displacement_z", "m"},
                            {"center.velocity_z", "m/s"},
                            {"wall.pressure", "Pa"},
                            {"wall.impulse", "Pa s"},
                            {"energy.gas", "J"},
                            {"energy.kinetic", "J"},
                            {"energy.internal", "J"}};
    data.history.values.resize(data.history.columns.size());
    for (int i = 0; i <= 600; ++i) {
        data.history.times.push_back(3e-3 * i / 600);
        const std::vector<double> values = line(i);
        for (std::size_t column = 0; column < values.size(); ++column) data.history.values[column].push_back(values[column]);
    }
    RunSummary& summary = data.summary;
    summary.title = "15 kg TNT, 700 mm from a \"clamped\" <RHA> plate & frame";
    summary.program = "corpuscle 0.1.0 (g++ 12.2.0)";
    summary.command = "corpuscle run case.toml --threads 2";
    summary.end_time = 3e-3;
    summary.steps = 1234;
    summary.wall_seconds = 14.2;
    summary.cpu_seconds = 27.9;
    summary.peak_memory = 123'456'789;
    summary.threads = 2;
    summary.seed = 7;
    summary.particles = {{"air", 17'600}, {"tnt", 2'400}};
    summary.elements = 512;
    summary.particle_steps = 24'680'000;
    summary.element_steps = 631'808;
    summary.seconds = {{"burn", 0.1},    {"accelerate", 0.2}, {"collide", 5.5},  {"fly", 5.25},
                       {"contact", 1.5}, {"resist", 0.75},    {"ledger", 0.125}, {"outputs", 0.5}};
    summary.mass_error = 0;
    summary.momentum_error = 2.5e-7;
    summary.energy_error = -3.1e-3;
    summary.transfers = {{"gas", "structure", 0, {0.1, -0.2, -1650}, 8.4e4}, {"ambient", "gas", 0.25, {1, 2, 3}, -4.5e4}};
    summary.verdicts = {noise_verdict(2500), resolution_verdict(0.09, 0.7)};
    summary.references = {{"center.displacement_z", -0.047, "experiment <A & B>"}};
    add_probes(summary, data.history, {"center"});
    add_gauges(summary, data.history, {"wall"});
    summary.parts["plate"] = {{0.1, -0.2, -1650}, 0.0123, 4.5e4, 8.9e4, {0, 0, -1600}, 1.3e5};
    data.resolved_case = "title = \"15 kg TNT\"  # </pre><script>\nend_time = \"3 ms\"\n";
    return data;
}

void write_sample_run(const std::filesystem::path& folder)
{
    const ReportData data = sample_run();
    const RunFolder run(folder);
    write_summary(run.summary(), data.summary);
    replace_file(run.resolved_case(), data.resolved_case);
    History history(run.history(), data.history.columns);
    for (std::size_t i = 0; i < data.history.times.size(); ++i) {
        std::vector<double> values;
        for (const auto& column : data.history.values) values.push_back(column[i]);
        history.add(data.history.times[i], values);
    }
}

}  // namespace corpuscle
