#pragma once

#include <limits>
#include <vector>

#include "base/clock.hpp"
#include "fields/transfer.hpp"

namespace corpuscle {

struct Structure;
struct Part;

/// When an element of a part is taken out. A shell goes when all its points are beyond a limit, so that it bends before it tears.
struct Erosion {
    double plastic_strain = std::numeric_limits<double>::infinity();    ///< equivalent [1]
    double principal_stress = std::numeric_limits<double>::infinity();  ///< largest principal stress, tension [Pa]
    double tension = std::numeric_limits<double>::infinity();           ///< mean tension, minus the pressure [Pa]
    double step = 0;                                                    ///< stable step below which it goes [s]

    [[nodiscard]] bool any() const
    {
        constexpr double never = std::numeric_limits<double>::infinity();
        return plastic_strain < never || principal_stress < never || tension < never || step > 0;
    }
};

/// What has left with eroded elements since the start.
struct Eroded {
    double elements = 0;
    double mass = 0;      ///< [kg]
    double internal = 0;  ///< strain energy, plastic work and hourglass energy [J]
};

/// Takes out the elements of a part that are beyond its limits: their loads, their share of the nodes' masses with the motion it has, their
/// energy, and the facets between them and nothing. Returns what left: mass, momentum and energy, "structure" to "eroded".
/// Nodes without an element are left standing where they are, without mass.
Transfer erode(Structure& structure, Part& part, const Clock& clock);

/// Marks the facets that have no element, or one on both sides, as hidden, and those whose other element alone is left as turned.
void hide_facets(Structure& structure);

}  // namespace corpuscle
