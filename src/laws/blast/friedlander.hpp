#pragma once

namespace corpuscle {

/// A blast pulse at a point, p(t) = peak (1 - t/T) exp(-decay t/T) for 0 <= t <= T and nothing else: the positive phase only.
/// Time counts from the arrival of the shock. Source: Friedlander, Proc. R. Soc. A 186 (1946) 322.
struct Friedlander {
    double peak = 0;      ///< [Pa]
    double duration = 0;  ///< T [s]
    double decay = 0;     ///< [1]; below zero for pulses fuller than a triangle

    [[nodiscard]] double pressure(double time) const;  ///< [Pa] at a time [s]
    [[nodiscard]] double impulse(double time) const;   ///< [Pa s] from the arrival to a time [s], exact
};

/// The pulse of a peak [Pa] and duration [s] whose integral is an impulse [Pa s].
/// Throws InputError if one of them is not positive, or the impulse is too large for a pulse that falls from its peak (0.718 peak T).
[[nodiscard]] Friedlander fit_friedlander(double peak, double duration, double impulse);

}  // namespace corpuscle
