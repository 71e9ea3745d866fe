#pragma once

namespace corpuscle {

/// The flow of a point blast at a place and time.
struct BlastFlow {
    double density = 0;   ///< [kg/m3]
    double velocity = 0;  ///< outward [m/s]
    double pressure = 0;  ///< [Pa]
};

/// Exact similarity solution of a point blast: energy released at a point of a cold ideal gas at rest, 1 < gamma < 2, pressure ahead of
/// the front nothing. The front runs as R = beta (E t^2/rho)^(1/5). Source: Sedov 1946; von Neumann 1947; the closed form in the
/// parameter V = (5/2) u t/r as in Landau & Lifshitz, Fluid Mechanics, section 106.
class SedovBlast {
public:
    /// Throws InputError for gamma outside its range, density [kg/m3] or energy [J] not positive.
    SedovBlast(double gamma, double density, double energy);

    [[nodiscard]] double beta() const { return beta_; }       ///< [1]
    [[nodiscard]] double radius(double time) const;           ///< of the front [m]
    [[nodiscard]] double front_speed(double time) const;      ///< [m/s]
    [[nodiscard]] BlastFlow behind_front(double time) const;  ///< the strong shock's jump: the peak of all three

    /// The flow at a radius > 0 [m] and a time > 0 [s].
    [[nodiscard]] BlastFlow at(double radius, double time) const;

private:
    double gamma_, density_, energy_, beta_;
};

}  // namespace corpuscle
