#pragma once

#include <memory>
#include <vector>

#include "model/model.hpp"
#include "simulation/empirical_gauges.hpp"
#include "simulation/facet_loads.hpp"
#include "simulation/gauges.hpp"
#include "simulation/grid_gauges.hpp"
#include "simulation/outputs.hpp"
#include "simulation/phases.hpp"
#include "simulation/resolution.hpp"
#include "simulation/summary_verdict.hpp"

namespace corpuscle {

/// Turns what a model is asked to record into history columns and files.
class Recorder {
public:
    explicit Recorder(Model& model);

    /// What is to be written while the run goes on; refers to this recorder, the model and the clock.
    [[nodiscard]] OutputPlan plan(const Clock& clock);

    /// Memory of the gauges, for a restart.
    [[nodiscard]] std::vector<FieldSet> states() { return {gauges_.state(), grid_gauges_.state(), facet_loads_.state()}; }

    /// How fine the particles are, and the noise of the load by all its hits.
    [[nodiscard]] std::vector<Verdict> verdicts() const;

private:
    void add_probe(OutputPlan& plan, const Probe& probe) const;
    void add_energies(OutputPlan& plan) const;
    void add_files(OutputPlan& plan, const Clock& clock);
    Model& model_;
    Gauges gauges_;
    GridGauges grid_gauges_;
    FacetLoads facet_loads_;
    EmpiricalGauges empirical_gauges_;
    std::vector<Verdict> resolution_;  ///< of the model as it was built
};

}  // namespace corpuscle
