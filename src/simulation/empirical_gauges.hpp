#pragma once

#include <string>
#include <vector>

#include "laws/blast/blast_load.hpp"
#include "model/model.hpp"
#include "simulation/outputs.hpp"

namespace corpuscle {

/// What the curves of Kingery and Bulmash say at each gauge of a model with a known blast, as if nothing stood in its way and nothing else
/// reflected it: in the gas the incident pulse, on a face or part the mean of the reflected pulses of its area by distance and angle, as
/// the ConWep load has them. Positive phase only. A gauge that reaches nearer to the charge or farther from it than the curves has none.
class EmpiricalGauges {
public:
    explicit EmpiricalGauges(const Model& model);

    /// Adds a source beside each gauge: the history columns `pressure` and `impulse` of its name (kingery_bulmash_name); refers to this
    /// object and the clock.
    void add_to(OutputPlan& plan, const Clock& clock) const;

private:
    /// A piece of what the gauge sees.
    struct Piece {
        double weight = 0;  ///< share of the gauge's area [1]
        BlastLoad load;
    };
    struct EmpiricalGauge {
        std::string name;
        double every = 0;               ///< [s]
        double ambient = 0;             ///< pressure that the gauge shows before anything comes [Pa]
        bool impulse_of_whole = false;  ///< whether the ambient pressure counts in its impulse
        std::vector<Piece> pieces;
    };
    [[nodiscard]] static EmpiricalGauge beside(const Gauge& gauge, const Model& model);

    double detonation_time_ = 0;  ///< [s]
    double start_time_ = 0;       ///< of the run [s]
    std::vector<EmpiricalGauge> gauges_;
};

}  // namespace corpuscle
