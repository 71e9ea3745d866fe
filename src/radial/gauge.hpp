#pragma once

#include <vector>

#include "radial/flow.hpp"

namespace corpuscle {

/// The flow at one place and time.
struct RadialSample {
    double time = 0;      ///< [s]
    double pressure = 0;  ///< [Pa]
    double density = 0;   ///< [kg/m3]
    double velocity = 0;  ///< [m/s]
};

/// The flow at a radius [m] within its ends: pressure between the middles of cells, velocity between edges by straight lines, density of
/// the cell.
[[nodiscard]] RadialSample sample(const RadialFlow& flow, double radius);

/// What a place sees over time, while the flow reaches it.
struct RadialGauge {
    double radius = 0;  ///< [m]
    std::vector<RadialSample> samples;

    void record(const RadialFlow& flow);
};

/// The figures of a blast wave at a place. Pressures over the ambient one; nothing where no wave came.
struct BlastMeasures {
    double arrival = 0;       ///< when the pressure first passes half of the first peak [s]
    double overpressure = 0;  ///< first peak [Pa]
    double impulse = 0;       ///< of the positive phase: until the pressure is first the ambient one again [Pa s]
    double duration = 0;      ///< of that phase [s]
    bool complete = false;    ///< whether that phase ended within the record
};
/// Finds them in a record. The first peak is the highest pressure before it has fallen by half; later ones (a shock that follows) do not
/// count. What stays below `noise` [Pa] over the ambient pressure is no wave.
[[nodiscard]] BlastMeasures measure_blast(const std::vector<RadialSample>& samples, double ambient_pressure, double noise);

}  // namespace corpuscle
