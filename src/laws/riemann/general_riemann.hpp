#pragma once

#include <optional>

#include "laws/eos/equation_of_state.hpp"
#include "laws/riemann/isentrope.hpp"

namespace corpuscle {

/// A gas of any law at one side of a Riemann problem. Density zero is vacuum.
struct GasSide {
    EquationOfState law;
    double density = 0;   ///< [kg/m3]
    double velocity = 0;  ///< [m/s]
    double pressure = 0;  ///< [Pa]

    [[nodiscard]] double energy() const;       ///< specific [J/kg], 0 in vacuum
    [[nodiscard]] double sound_speed() const;  ///< [m/s], 0 in vacuum
};

/// Exact solution of the Riemann problem of two gases of any law, such as detonation products (JWL) against air, vacuum included: shocks by
/// the Hugoniot e - e0 = (p + p0)(v0 - v)/2, rarefactions by the isentrope integrated. Where both gases are ideal or Noble-Abel,
/// `RiemannSolution` gives the same in closed form. Source: Menikoff & Plohr, Rev. Mod. Phys. 61 (1989) 75; convex isentropes.
class GeneralRiemannSolution {
public:
    /// Solves. Throws InputError for a state that no gas can have, or a shock beyond the law's reach.
    GeneralRiemannSolution(const GasSide& left, const GasSide& right);

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
    [[nodiscard]] GasSide at(double speed) const;

private:
    /// A gas that waves run into leftwards, and all it can become.
    class Half {
    public:
        explicit Half(const GasSide& side);
        [[nodiscard]] const GasSide& ahead() const { return ahead_; }
        [[nodiscard]] bool empty() const { return ahead_.density == 0; }
        [[nodiscard]] double escape_speed() const { return expansion_ ? expansion_->escape_speed() : 0.0; }
        /// The gas behind the wave that takes it to a pressure.
        [[nodiscard]] GasSide behind(double pressure) const;
        /// Speed of the foremost point of that wave, leftwards negative.
        [[nodiscard]] double wave_speed(double pressure) const;
        /// State on a ray left of the interface; `star` is the pressure there, 0 if the gas ends in nothing.
        [[nodiscard]] GasSide at(double star, double speed) const;

    private:
        [[nodiscard]] GasSide shocked(double pressure) const;
        [[nodiscard]] GasSide expanded(const Isentrope::Point& point) const;
        GasSide ahead_;
        double energy_ = 0;
        std::optional<Isentrope> expansion_;
    };

    Half left_, right_mirrored_;
    double pressure_ = 0;
    double velocity_ = 0;
    bool vacuum_ = false;
};

}  // namespace corpuscle
