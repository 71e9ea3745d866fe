#pragma once

#include <span>
#include <vector>

#include "gas/sample.hpp"
#include "model/model.hpp"
#include "simulation/outputs.hpp"

namespace corpuscle {

/// Turns a model's gauges into history columns, each quantity with its standard error. Remembers what every gauge had seen at its
/// last sample. Errors of facets and faces: hits come like rain (Poisson), so the variance of an impulse is the sum of the squares of
/// the impulses it is made of, in any state of the gas. Errors of regions: see GasSampleError.
class Gauges {
public:
    explicit Gauges(const Model& model);

    /// Adds a source for each gauge; it refers to this object, the model and the clock.
    void add_to(OutputPlan& plan, const Clock& clock);

    /// What was seen so far, for a restart.
    [[nodiscard]] FieldSet state();

private:
    /// What hits have done to a gauge since the start of the run.
    struct Load {
        double area = 0;     ///< now [m2]
        double impulse = 0;  ///< against the facets' normals [N s]
        double squares = 0;  ///< its variance [N2 s2]
        Vector3d force;      ///< impulse as a vector [N s]
        Vector3d squared;    ///< its variance, by component [N2 s2]
    };

    [[nodiscard]] Load load_on(const PartGauge& gauge) const;
    [[nodiscard]] Load load_on(const FaceGauge& gauge) const;
    void sample_load(std::size_t index, const Load& load, double time, std::span<double> values);
    void sample_region(std::size_t index, double time, std::span<double> values);
    void integrate(std::size_t index, const GasSample& gas, double volume, double passed);

    const Model& model_;
    std::vector<double> time_;             ///< of the last sample [s]
    std::vector<double> impulse_;          ///< of a load [N s], of a region [Pa s]
    std::vector<double> variance_;         ///< of the impulse, squared
    std::vector<Vector3d> force_;          ///< impulse as a vector [N s]
    std::vector<Vector3d> force_squares_;  ///< its variance [N2 s2]
    std::vector<double> first_;            ///< pressure of a region at the start [Pa]
    std::vector<double> first_error_;      ///< [Pa]
    std::vector<double> last_;             ///< at the last sample [Pa]
    std::vector<double> last_error_;       ///< [Pa]
    std::vector<double> trail_;            ///< errors of a region's earlier samples that are still the error of this one [Pa s]
};

}  // namespace corpuscle
