#pragma once

#include <span>

#include "laws/eos/mie_grueneisen.hpp"

namespace corpuscle {

/// A gas in its part of a mixed cell.
struct PhasePart {
    const MieGrueneisen* law = nullptr;
    double share = 0;   ///< of the volume [1]
    double mass = 0;    ///< in the cell's volume [kg/m3]
    double energy = 0;  ///< internal, in the cell's volume [J/m3]
};

/// Moves the boundary between two gases of a cell until their pressures are the same, each along its isentrope: returns the first one's
/// share of the volume; the sum of both stays. Gases that are in one pressure already keep their shares.
[[nodiscard]] double relaxed_share(const PhasePart& first, const PhasePart& second);

/// The same between any number of gases (up to `most_euler_materials`), which must all have mass and a share: their shares afterwards.
void relax_shares(std::span<const PhasePart> parts, std::span<double> shares);

}  // namespace corpuscle
