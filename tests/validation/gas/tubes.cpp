#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "verification/gas/point_blast.hpp"
#include "verification/gas/tube.hpp"

/// The particle gas against exact gas dynamics; one JSON object a line.
///     validate_tubes states           star states, errors at three spacings and profiles of every tube
///     validate_tubes path             Sod's tube: mean free path, spacing and their ratio varied apart
///     validate_tubes stream           a stream into a wall: mean free path alone, in small cells
///     validate_tubes noise            Sod's tube: scatter between seeds as the number of particles grows
///     validate_tubes smear            errors and CPU time over mean free path, cell limit and time step
///     validate_tubes blast            Sedov's point blast

namespace corpuscle {
namespace {

double cpu_seconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Prints one line at once, so that a run that is cut short leaves what it has.
void print(const std::string& line)
{
    std::puts(line.c_str());
    std::fflush(stdout);
}

std::string list(const std::array<double, 3>& values)
{
    return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", values[0], values[1], values[2]);
}

/// A tube run to its end.
struct Run {
    TubeCase tube;
    ExactFlow flow;
    Gas gas;
    double inverse_spacing = 0;
    std::uint64_t steps = 0;
    double cpu = 0;  ///< [s]

    Run(const TubeCase& chosen, double inverse, std::size_t particles, const GasSettings& settings = {})
        : tube(chosen), flow(exact_flow(chosen)), gas(filled_tube(chosen, 1 / inverse, particles, settings)), inverse_spacing(inverse)
    {
        const double start = cpu_seconds();
        steps = run_until(gas, tube.end_time);
        cpu = cpu_seconds() - start;
    }
};

/// What every line says of a run.
std::string head(const std::string& kind, const Run& run)
{
    const GasSettings& s = run.gas.settings;
    const TubeErrors errors = tube_errors(run.gas, run.tube, run.flow);
    return fmt::format(
        "{{\"kind\": \"{}\", \"tube\": \"{}\", \"inverse_spacing\": {:g}, \"particles\": {}, \"kappa\": {:g}, "
        "\"cell_limit\": {}, \"group_limit\": {}, \"cfl\": {:g}, \"steps\": {}, \"cpu_s\": {:.2f}, \"l1\": {}, \"noise\": {}",
        kind, run.tube.name, run.inverse_spacing, run.gas.particles.size(), s.mean_free_path, s.cell_limit, s.group_limit, s.cfl, run.steps,
        run.cpu, list(errors.sum), list(errors.noise));
}

/// Measured, exact and one sigma of a star state.
std::string star(const Run& run, const std::string& side, const std::array<double, 2>& rays)
{
    const Slice found = star_state(run.gas, run.tube, rays);
    return fmt::format(", \"{}\": {}, \"{}_exact\": {}, \"{}_sigma\": {}", side, list(found.state.values()), side,
                       list(exact_mean(run.tube, run.flow, found.lower, found.upper).values()), side, list(found.sigma.values()));
}

void print_states(const Run& run)
{
    std::string line = head("states", run);
    if (run.flow.has_star) line += star(run, "left", run.flow.star_left_edges) + star(run, "right", run.flow.star_right_edges);
    print(line + "}");
}

/// The profile in bins of 1/100 m, beside the exact one.
void print_profile(const Run& run)
{
    std::vector<double> places;
    std::array<std::vector<double>, 3> found, exact;
    for (const Slice& bin : tube_bins(run.gas, run.tube, run.flow, 0.01)) {
        places.push_back(bin.middle());
        const FlowState at = run.flow.at((bin.middle() - run.tube.membrane) / run.tube.end_time);
        for (int q = 0; q < 3; ++q) {
            found[q].push_back(bin.state.values()[q]);
            exact[q].push_back(at.values()[q]);
        }
    }
    std::string line = fmt::format("{{\"kind\": \"profile\", \"tube\": \"{}\", \"inverse_spacing\": {:g}, \"x\": [{:.5g}]", run.tube.name,
                                   run.inverse_spacing, fmt::join(places, ", "));
    for (int q = 0; q < 3; ++q)
        line += fmt::format(", \"{0}\": [{1:.5g}], \"exact_{0}\": [{2:.5g}]", flow_names[q], fmt::join(found[q], ", "),
                            fmt::join(exact[q], ", "));
    print(line + "}");
}

void states()
{
    std::vector<TubeCase> tubes{sod_tube(),
                                strong_shock_tube(),
                                noble_abel_tube(1.4, 0.1),
                                noble_abel_tube(1.4, 0.3),
                                noble_abel_tube(1.4, 0.6),
                                noble_abel_tube(1.2, 0.3),
                                noble_abel_tube(5.0 / 3, 0.6),
                                vacuum_tube(IdealGas{1.4}),
                                vacuum_tube(NobleAbel{1.4, 0.6, 1}),
                                torn_tube(2),
                                torn_tube(5)};
    for (const TubeCase& tube : tubes) {
        for (const double inverse : {64.0, 128.0, 256.0}) {
            const Run run(tube, inverse, 300000);
            print_states(run);
            if (inverse == 256) print_profile(run);
        }
    }
    for (const double inverse : {128.0, 256.0, 512.0}) {
        const Run run(tnt_tube(0.01), inverse, 300000);
        print_states(run);
        if (inverse == 512) print_profile(run);
    }
}

/// Spacing at fixed mean free path in spacings, mean free path at fixed spacing, and spacing at fixed mean free path in metres.
void path()
{
    GasSettings settings;
    for (const double inverse : {32.0, 64.0, 128.0, 256.0, 512.0}) print(head("spacing", Run(sod_tube(), inverse, 300000, settings)) + "}");
    for (const double kappa : {0.25, 0.5, 1.0, 2.0, 4.0}) {
        settings.mean_free_path = kappa;
        print(head("kappa", Run(sod_tube(), 128, 300000, settings)) + "}");
    }
    for (const double kappa : {0.5, 1.0, 2.0, 4.0}) {
        settings.mean_free_path = kappa;
        print(head("metres", Run(sod_tube(), 64 * kappa, 300000, settings)) + "}");
    }
}

void stream()
{
    for (const double kappa : {8.0, 4.0, 2.0, 1.0})
        print(head("stream", Run(stream_tube(), 800, 600000, {.cell_limit = 4, .mean_free_path = kappa, .cfl = 0.8})) + "}");
}

/// Root mean square over bins and seeds of what differs from the mean over the seeds, beside the deviation that theory gives.
void noise()
{
    constexpr int seeds = 6;
    for (const std::size_t particles : {12500u, 50000u, 200000u, 800000u}) {
        std::vector<std::vector<Slice>> bins;
        for (int seed = 1; seed <= seeds; ++seed) {
            GasSettings settings;
            settings.seed = static_cast<std::uint64_t>(seed);
            const Run run(sod_tube(), 64, particles, settings);
            bins.push_back(tube_bins(run.gas, run.tube, run.flow));
        }
        std::array<double, 3> found{}, theory{};
        for (std::size_t b = 0; b < bins[0].size(); ++b) {
            for (int q = 0; q < 3; ++q) {
                double mean = 0, squares = 0;
                for (const auto& own : bins) mean += own[b].state.values()[q] / seeds;
                for (const auto& own : bins) squares += std::pow(own[b].state.values()[q] - mean, 2) / (seeds - 1);
                found[q] += squares / static_cast<double>(bins[0].size());
                theory[q] += std::pow(bins[0][b].sigma.values()[q], 2) / static_cast<double>(bins[0].size());
            }
        }
        for (int q = 0; q < 3; ++q) {
            found[q] = std::sqrt(found[q]);
            theory[q] = std::sqrt(theory[q]);
        }
        print(fmt::format("{{\"kind\": \"noise\", \"particles\": {}, \"seeds\": {}, \"scatter\": {}, \"theory\": {}}}", particles, seeds,
                          list(found), list(theory)));
    }
}

void smear()
{
    const auto one = [](const TubeCase& tube, std::uint32_t cell, double kappa, double cfl, std::uint32_t group = 64) {
        GasSettings settings;
        settings.cell_limit = cell;
        settings.group_limit = group;
        settings.mean_free_path = kappa;
        settings.cfl = cfl;
        print(head("smear", Run(tube, 128, 200000, settings)) + "}");
    };
    for (const std::uint32_t cell : {8u, 16u, 32u}) {
        for (const double kappa : {0.25, 0.5, 1.0, 2.0}) {
            one(sod_tube(), cell, kappa, 0.4);
            one(strong_shock_tube(), cell, kappa, 0.4);
        }
    }
    for (const double cfl : {0.1, 0.2, 0.8}) {
        one(sod_tube(), 16, 1, cfl);
        one(strong_shock_tube(), 16, 1, cfl);
        one(noble_abel_tube(1.4, 0.6), 16, 1, cfl);
    }
    for (const std::uint32_t group : {8u, 16u, 32u, 64u}) one(noble_abel_tube(1.4, 0.6), 8, 1, 0.4, group);
}

/// Fronts at several times, and the profile at the last.
void blast(std::size_t particles, const GasSettings& settings, bool profile)
{
    const SedovBlast exact(PointBlast::gamma, 1, PointBlast::whole_energy);
    PointBlast blast(particles, settings);
    const double start = cpu_seconds();
    std::vector<Shell> found;
    for (const double time : {0.2, 0.4, 0.6, 0.8, 1.0}) {
        blast.run_until(time);
        found = shells(blast, 0.01, 1.15);
        double peak = 0, error = 0;
        for (const Shell& shell : found) {
            peak = std::max(peak, shell.flow.density);
            error += std::abs(shell.flow.density - exact.at(0.5 * (shell.lower + shell.upper), time).density) * 0.01;
        }
        print(fmt::format(
            "{{\"kind\": \"blast\", \"particles\": {}, \"kappa\": {:g}, \"cell_limit\": {}, \"cfl\": {:g}, \"spacing\": {:.5g}, \"ball\": "
            "{:.4g}, \"time\": {}, "
            "\"steps\": {}, \"cpu_s\": {:.1f}, \"front\": {:.5g}, \"half_rise\": {:.5g}, \"by_momentum\": {:.5g}, \"peak\": {:.4g}, "
            "\"l1_density\": {:.4g}}}",
            particles, settings.mean_free_path, settings.cell_limit, settings.cfl, blast.spacing, blast.ball_radius, time,
            blast.clock.step(), cpu_seconds() - start, exact.radius(time), half_rise(found), momentum_radius(blast), peak, error));
    }
    if (!profile) return;
    std::array<std::vector<double>, 7> columns;
    for (const Shell& shell : found) {
        const double middle = 0.5 * (shell.lower + shell.upper);
        const BlastFlow at = exact.at(middle, 1);
        const std::array<double, 7> row{middle,     shell.flow.density, shell.flow.velocity, shell.flow.pressure,
                                        at.density, at.velocity,        at.pressure};
        for (std::size_t c = 0; c < row.size(); ++c) columns[c].push_back(row[c]);
    }
    constexpr std::array<const char*, 7> names{"r", "density", "velocity", "pressure", "exact_density", "exact_velocity", "exact_pressure"};
    std::string line = fmt::format("{{\"kind\": \"blast profile\", \"particles\": {}, \"kappa\": {:g}", particles, settings.mean_free_path);
    for (std::size_t c = 0; c < names.size(); ++c) line += fmt::format(", \"{}\": [{:.5g}]", names[c], fmt::join(columns[c], ", "));
    print(line + "}");
}

void blasts()
{
    GasSettings settings;
    for (const std::size_t particles : {10000u, 100000u, 1000000u}) blast(particles, settings, true);
    for (const std::uint32_t cell : {4u, 8u, 16u, 32u}) {
        for (const double kappa : {0.1, 0.25, 0.5, 1.0, 2.0}) {
            settings.mean_free_path = kappa;
            settings.cell_limit = cell;
            blast(100000, settings, false);
        }
    }
    settings.mean_free_path = 0.25;
    settings.cell_limit = 8;
    for (const double cfl : {0.1, 0.2, 0.6, 0.8, 1.2}) {
        settings.cfl = cfl;
        blast(100000, settings, false);
    }
    settings.cfl = 0.4;
    blast(1000000, settings, true);
}

}  // namespace
}  // namespace corpuscle

int main(int argc, char** argv)
{
    using namespace corpuscle;
    const std::string what = argc > 1 ? argv[1] : "";
    if (what == "states")
        states();
    else if (what == "path")
        path();
    else if (what == "stream")
        stream();
    else if (what == "noise")
        noise();
    else if (what == "smear")
        smear();
    else if (what == "blast")
        blasts();
    else
        return std::fputs("usage: validate_tubes states|path|noise|smear|blast\n", stderr), 2;
    return 0;
}
