#pragma once

#include <cstdint>
#include <string>

namespace corpuscle {

/// One check of a finished run: a number that should stay below its limit.
struct Verdict {
    std::string name;     ///< "energy"
    double value = 0;     ///< without a unit, as a fraction
    double limit = 0;     ///< the run passes up to here
    std::string meaning;  ///< what the number is, in one line

    /// A number that is not finite never passes.
    [[nodiscard]] bool passed() const { return value <= limit; }
};

/// Mass that the ledger misses over the mass it holds: only rounding is allowed.
[[nodiscard]] Verdict mass_verdict(double relative_error);

/// Momentum that the ledger misses over the momentum that passed through it. The gas stores velocities as floats: rounding, and no more.
[[nodiscard]] Verdict momentum_verdict(double relative_error);

/// Energy that the ledger misses over the energy it holds: what the structure's time integration does not conserve.
[[nodiscard]] Verdict energy_verdict(double relative_error);

/// Scatter of a pressure averaged from `hits` bounces, sqrt(4 / (pi hits)) of it: each hit's impulse has the Rayleigh law of a
/// half-Maxwellian flux, mean square over squared mean 4/pi.
[[nodiscard]] Verdict noise_verdict(double hits);

/// Spacing of the particles [m] where they load the structure, over the stand-off [m].
[[nodiscard]] Verdict resolution_verdict(double spacing, double length);

}  // namespace corpuscle
