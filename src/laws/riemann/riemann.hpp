#pragma once

#include "laws/eos/noble_abel.hpp"

namespace corpuscle {

/// A gas at one side of a Riemann problem; an ideal gas is one whose co-volume is nothing. Density zero is vacuum.
struct RiemannSide {
    double density = 0;    ///< [kg/m3]
    double velocity = 0;   ///< [m/s]
    double pressure = 0;   ///< [Pa]
    double gamma = 1.4;    ///< heat capacity ratio
    double co_volume = 0;  ///< volume kept by the molecules of a kilogram [m3/kg]

    [[nodiscard]] double sound_speed() const;  ///< [m/s], 0 in vacuum
    [[nodiscard]] double energy() const;       ///< specific [J/kg], 0 in vacuum
};

/// A side filled with a gas of a Noble-Abel law.
[[nodiscard]] RiemannSide riemann_side(const NobleAbel& law, double density, double velocity, double pressure);

/// Exact solution of the Riemann problem of two gases, each ideal or Noble-Abel with its own gamma and co-volume, vacuum included.
/// Source: Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, ch. 4. With v - b in place of v a Noble-Abel gas obeys the
/// ideal gas's jump conditions and isentropes at a fixed mass; only distances in space know b.
class RiemannSolution {
public:
    /// Solves. Throws InputError for a state that cannot be: pressure not positive, molecules that fill all space, gamma <= 1.
    RiemannSolution(const RiemannSide& left, const RiemannSide& right);

    /// Whether the gases lose touch (or one of them is not there): no star state then.
    [[nodiscard]] bool has_vacuum() const { return vacuum_; }
    [[nodiscard]] double star_pressure() const { return pressure_; }  ///< [Pa]
    [[nodiscard]] double star_velocity() const { return velocity_; }  ///< of the interface [m/s]
    [[nodiscard]] double star_density_left() const;                   ///< [kg/m3]
    [[nodiscard]] double star_density_right() const;                  ///< [kg/m3]

    /// Speed of the foremost point of the wave that runs into that side: a shock, or the head of a rarefaction [m/s].
    [[nodiscard]] double left_wave_speed() const;
    [[nodiscard]] double right_wave_speed() const;

    /// State on the ray x/t = `speed` [m/s]; density 0 in vacuum.
    [[nodiscard]] RiemannSide at(double speed) const;

private:
    RiemannSide left_, right_mirrored_;
    double pressure_ = 0;
    double velocity_ = 0;
    bool vacuum_ = false;
};

}  // namespace corpuscle
