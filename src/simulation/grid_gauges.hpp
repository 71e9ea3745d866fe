#pragma once

#include <span>
#include <vector>

#include "model/model.hpp"
#include "simulation/outputs.hpp"

namespace corpuscle {

/// Turns the gauges of a model's grid of gases into history columns. What a grid says has no noise, so there are no standard errors.
class GridGauges {
public:
    explicit GridGauges(const Model& model);

    /// Adds a source for each gauge; it refers to this object, the model and the clock.
    void add_to(OutputPlan& plan, const Clock& clock);

    /// What was seen so far, for a restart.
    [[nodiscard]] FieldSet state();

private:
    void sample_face(std::size_t index, double time, std::span<double> values);
    void sample_region(std::size_t index, double time, std::span<double> values);

    const Model& model_;
    std::vector<double> time_;     ///< of the last sample [s]
    std::vector<double> impulse_;  ///< specific, at that time [Pa s]
    std::vector<double> first_;    ///< pressure of a region at the start [Pa]
    std::vector<double> last_;     ///< at the last sample [Pa]
};

}  // namespace corpuscle
