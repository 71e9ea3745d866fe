#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fields/transfer.hpp"
#include "math/statistics.hpp"
#include "math/vector3.hpp"
#include "simulation/summary_verdict.hpp"

namespace corpuscle {

/// What a probed quantity did over the run, in its SI unit.
struct ProbeSummary {
    double minimum = 0;
    double maximum = 0;
    double final = 0;
    double time_of_minimum = 0;  ///< [s]
    double time_of_maximum = 0;  ///< [s]
};

/// What the curves of Kingery and Bulmash say of a gauge's place, as if nothing stood between it and the charge.
struct EmpiricalSummary {
    double peak_pressure = 0;  ///< [Pa]
    double impulse = 0;        ///< greatest specific impulse within the run [Pa s]
    double arrival = 0;        ///< [s], not a number if nothing came within the run
};

/// What a gauge saw.
struct GaugeSummary {
    double peak_pressure = 0;                                               ///< [Pa]
    double impulse = 0;                                                     ///< greatest specific impulse [Pa s]
    double arrival = 0;                                                     ///< [s], not a number if nothing came
    double peak_pressure_error = std::numeric_limits<double>::quiet_NaN();  ///< standard error of that sample [Pa]
    double impulse_error = std::numeric_limits<double>::quiet_NaN();        ///< standard error of that impulse [Pa s]
    std::optional<EmpiricalSummary> kingery_bulmash = {};
};

/// What a part of the structure took up.
struct PartSummary {
    Vector3d impulse;               ///< given to it by gas and loads [N s]
    double max_plastic_strain = 0;  ///< equivalent
    double kinetic_energy = 0;      ///< at the end [J]
    double internal_energy = 0;     ///< at the end [J]
    Vector3d gas_impulse = {};      ///< of that by gas [N s]
    double gas_work = 0;            ///< of gas on it [J]
};

/// A value to compare a curve with, from the case (an experiment, another code).
struct ReferenceValue {
    std::string column;  ///< of the history: "center.displacement_z"
    double value = 0;    ///< in the column's unit
    std::string label;   ///< "experiment (Neuberger et al. 2009)"
};

/// What runs that differ by their seed say together.
struct EnsembleSummary {
    std::vector<std::uint64_t> seeds;             ///< of all members
    std::vector<std::uint64_t> done;              ///< those that ran to the end: what the statistics are of
    std::map<std::string, Statistic> quantities;  ///< by place in summary.json: "/probes/center/displacement_z_m/max"

    friend bool operator==(const EnsembleSummary&, const EnsembleSummary&) = default;
};

/// Everything there is to say about a run in numbers: what summary.json holds. Version 1; keys are only ever added.
struct RunSummary {
    std::string title;
    std::string status = "done";  ///< "done", "stopped" (by its own safety), "interrupted"
    std::string reason;           ///< why it stopped, empty if done
    std::string program;          ///< name, version, compiler
    std::string command;          ///< that started the run
    double end_time = 0;          ///< reached [s]
    std::uint64_t steps = 0;
    double wall_seconds = 0;
    double cpu_seconds = 0;
    std::uint64_t peak_memory = 0;  ///< [byte]
    int threads = 1;
    int ranks = 1;
    std::uint64_t seed = 1;

    std::map<std::string, std::uint64_t> particles;  ///< by species
    std::uint64_t elements = 0;
    std::uint64_t grains = 0;
    std::uint64_t cells = 0;
    std::uint64_t particle_steps = 0;  ///< particles moved, summed over the steps
    std::uint64_t element_steps = 0;
    std::uint64_t grain_steps = 0;
    std::uint64_t cell_steps = 0;
    std::uint64_t squeezed_cells = 0;  ///< of a grid, passed by a wall whose gas found no way to stay on its side: 0 in a sound run
    std::vector<std::pair<std::string, double>> seconds;  ///< wall time of each phase, in the order of the step [s]

    double mass_error = 0;            ///< relative
    double momentum_error = 0;        ///< relative
    double energy_error = 0;          ///< relative
    std::vector<Transfer> transfers;  ///< who gave what to whom, summed over the run
    std::vector<Verdict> verdicts;    ///< beyond those of the three errors: noise, resolution, ...
    std::vector<ReferenceValue> references;

    std::map<std::string, std::map<std::string, ProbeSummary>> probes;  ///< by probe, then by summary_key() of the quantity
    std::map<std::string, GaugeSummary> gauges;
    std::map<std::string, PartSummary> parts;
    std::optional<EnsembleSummary> ensemble;  ///< if this is of several runs: all numbers above are then means, sums or the worst
};

/// A quantity's key with its unit: ("displacement_z", "m") -> "displacement_z_m", ("velocity_x", "m/s") -> "velocity_x_m_per_s",
/// ("impulse", "Pa s") -> "impulse_pa_s"; a unit "1" adds nothing.
[[nodiscard]] std::string summary_key(const std::string& quantity, const std::string& unit);

/// All verdicts of a run: mass, momentum and energy from the ledger's errors, then its own.
[[nodiscard]] std::vector<Verdict> all_verdicts(const RunSummary& summary);

/// The text of summary.json. A number that is not finite becomes null.
[[nodiscard]] std::string summary_text(const RunSummary& summary);

/// Writes summary.json aside and renames it. Throws Error.
void write_summary(const std::filesystem::path& path, const RunSummary& summary);

/// The summary that a text of summary_text says; `name` tells errors whose it is. Throws InputError.
[[nodiscard]] RunSummary parse_summary(const std::string& text, const std::string& name);

/// Reads a summary.json back. Throws InputError if it is none.
[[nodiscard]] RunSummary read_summary(const std::filesystem::path& path);

}  // namespace corpuscle
