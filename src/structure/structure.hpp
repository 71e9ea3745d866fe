#pragma once

#include <cstdint>
#include <vector>

#include "base/clock.hpp"
#include "fields/transfer.hpp"
#include "mesh/surface.hpp"
#include "structure/drive.hpp"
#include "structure/nodes.hpp"
#include "structure/part.hpp"

namespace corpuscle {

/// All solid parts, their nodes and the surface they show. An empty one is legal and costs nothing.
/// Built by `add_part` (structure/builder.hpp).
struct Structure {
    Nodes nodes;
    std::vector<Part> parts;
    Surface surface;
    std::vector<Drive> drives;  ///< whose motion is prescribed

    std::vector<CornerLoad> corner_loads;     ///< by element and corner, over all parts
    std::vector<std::uint32_t> corner_begin;  ///< of each node, into `corners`; node count + 1
    std::vector<std::uint32_t> corners;       ///< the corner loads each node gathers
    double force_work = 0;                    ///< what nodal forces and moments have added to the kinetic energy [J]
    Eroded eroded;

    [[nodiscard]] std::size_t element_count() const
    {
        return parts.empty() ? 0 : parts.back().first_element + parts.back().element_count();
    }
};

/// Longest step central difference may take now: 0.9 of the smallest element transit (2 / highest frequency of any element:
/// plate waves, bending, transverse shear). [s], infinity if nothing can move.
[[nodiscard]] double stable_step(const Structure& structure);

/// Strain increments of the step just made (velocity * duration, seen from the middle of the step), new stresses, and nodal
/// forces and moments at `position`; takes out elements beyond their part's limits. Returns what left with them ("structure" to
/// "eroded"). Throws SafetyStop naming the element and part that is no longer finite.
std::vector<Transfer> resist(Structure& structure, const Clock& clock);

/// Central difference: velocity += (impulse + force * mean of this and the last duration) / mass, then position += velocity *
/// duration; takes up the impulses; what is driven goes as prescribed. Returns what supports and drives gave ("support", "prescribed
/// motion" to "structure").
std::vector<Transfer> accelerate(Structure& structure, const Clock& clock);

}  // namespace corpuscle
