#pragma once

#include <string>

#include "structure/structure.hpp"

namespace corpuscle {

/// Where the structure's energy is. [J]
struct StructureEnergy {
    double kinetic = 0;      ///< with the impulses that wait for the next accelerate
    double internal = 0;     ///< strain energy and plastic work
    double plastic = 0;      ///< the plastic work in `internal`
    double hourglass = 0;    ///< held or spent by hourglass control
    double integration = 0;  ///< work of nodal forces not found in the elements: half a step's power in transit (comes and goes),
                             ///< and what stepping in time makes (< 0) or loses (> 0): the measure of a run's energy error

    /// Closes exactly against the work of impulses, since `integration` is in it.
    [[nodiscard]] double total() const { return kinetic + internal + hourglass + integration; }
};

/// Energies of all parts together.
[[nodiscard]] StructureEnergy energy(const Structure& structure);

/// Energies of one part; `integration` is 0, as it belongs to no part.
[[nodiscard]] StructureEnergy part_energy(const Structure& structure, const Part& part);

/// Largest plastic strain of a part. [1]
[[nodiscard]] double max_plastic_strain(const Part& part);

/// Momentum of the nodes with the waiting impulses (of those that can move). [kg m/s]
[[nodiscard]] Vector3d momentum(const Structure& structure);

/// Which element has the fastest node, in words: where to look when a run has gone wrong; "" where nothing moves.
[[nodiscard]] std::string fastest_element(const Structure& structure);

}  // namespace corpuscle
