#pragma once

#include <cstdint>

#include "base/clock.hpp"
#include "fields/field.hpp"
#include "model/model.hpp"
#include "simulation/phases.hpp"

namespace corpuscle {

/// Lets the structure go at a pace of its own beside the gas: several of its steps within one of the gas where its elements ask for
/// shorter ones, or one that spans several of the gas where they allow longer ones. The gas sees every node go straight through each of
/// its own steps (Nodes::path); impulses wait for the structure's next step, so each pair keeps its momentum and energy.
class StructurePace {
public:
    explicit StructurePace(Model& model) : model_(model) {}

    /// Before the first step, at a time [s].
    void begin(double time) { clock_.restore(time, 0, 0, 0); }

    /// The next step of all at `time` [s] that fits the structure's steps: no longer than `gas`, what gas and grid allow (infinity: nothing
    /// of theirs moves), and `left` [s]. Plans the structure's part in it.
    [[nodiscard]] double fit(double time, double gas, double left);

    /// Makes the structure's steps that are planned for the clock's step, with the loads in them, and enters what they exchanged.
    void advance(const Clock& clock, Phases& phases);

    /// The structure's own clock: it stands where the structure stands, maybe ahead of the gas.
    [[nodiscard]] const Clock& clock() const { return clock_; }
    /// Whether the structure made the step that `fit` gave shorter than the gas alone would take.
    [[nodiscard]] bool sets_step() const { return sets_step_; }

    /// What a restart needs besides the nodes.
    [[nodiscard]] FieldSet state();

private:
    [[nodiscard]] double own_step();
    [[nodiscard]] double whole_steps(double gas, double own) const;
    void step(double duration, Phases& phases);
    void show_path(const Clock& clock) const;

    Model& model_;
    Clock clock_;
    double steady_step_ = 0;  ///< of the structure, kept while it fits [s]
    double span_ = 0;         ///< of a step of the structure that goes beyond the gas's next [s]; 0: none does
    int planned_ = 0;         ///< steps of the structure in the gas's next; 0: it is ahead
    bool sets_step_ = false;
};

}  // namespace corpuscle
