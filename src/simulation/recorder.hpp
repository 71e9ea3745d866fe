#pragma once

#include <memory>
#include <vector>

#include "model/model.hpp"
#include "simulation/outputs.hpp"
#include "simulation/phases.hpp"
#include "simulation/summary_verdict.hpp"

namespace corpuscle {

/// Turns what a model is asked to record into history columns and files. Keeps, for gauges, what they had seen at their last sample.
class Recorder {
public:
    explicit Recorder(Model& model);

    /// What is to be written while the run goes on; refers to this recorder, the model and the clock.
    [[nodiscard]] OutputPlan plan(const Clock& clock);

    /// Memory of the gauges, for a restart.
    [[nodiscard]] FieldSet state();

    /// Gauges whose noise is known: relative standard error of the peak pressure, by the hits in an interval.
    [[nodiscard]] std::vector<Verdict> verdicts() const;

private:
    void add_probe(OutputPlan& plan, const Probe& probe) const;
    void add_gauge(OutputPlan& plan, std::size_t index, const Clock& clock);
    void add_energies(OutputPlan& plan) const;
    void add_files(OutputPlan& plan) const;
    void sample_region(std::size_t index, double time, std::span<double> values);
    void sample_pressure(std::size_t index, double impulse, double time, std::span<double> values);
    [[nodiscard]] double part_impulse(std::uint32_t part) const;
    [[nodiscard]] double part_area(std::uint32_t part) const;

    Model& model_;
    std::vector<double> seen_impulse_;   ///< of each gauge at its last sample [Pa s]
    std::vector<double> seen_time_;      ///< [s]
    std::vector<double> seen_pressure_;  ///< of region gauges: at the start, and at the last sample, in turn [Pa]
};

}  // namespace corpuscle
