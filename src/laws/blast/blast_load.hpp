#pragma once

#include "laws/blast/friedlander.hpp"
#include "laws/blast/kingery_bulmash.hpp"

namespace corpuscle {

/// What a blast wave does to a surface that it meets at an angle: with c the cosine between the surface's outward normal and the direction
/// to the charge, p = p_r c^2 + p_i (1 + c^2 - 2 c) for c >= 0, and the incident p_i alone for a surface that looks away. Source: the
/// ConWep rule as given by Randers-Pehrson & Bannister, ARL-TR-1310 (1997).
class BlastLoad {
public:
    BlastLoad() = default;

    /// Fits a pulse to each of the wave's two peaks and impulses; the cosine is as above.
    BlastLoad(const BlastWave& wave, double cosine);

    [[nodiscard]] double pressure(double time) const;              ///< over ambient [Pa], at a time after detonation [s]
    [[nodiscard]] double impulse(double start, double end) const;  ///< between two times after detonation, exact [Pa s]
    [[nodiscard]] double arrival() const { return arrival_; }      ///< after detonation [s]
    [[nodiscard]] double end() const;                              ///< of the positive phase, after detonation [s]
    [[nodiscard]] double peak() const;                             ///< over ambient [Pa]

private:
    double arrival_ = 0;
    Friedlander incident_, reflected_;
    double incident_share_ = 0, reflected_share_ = 0;
};

}  // namespace corpuscle
