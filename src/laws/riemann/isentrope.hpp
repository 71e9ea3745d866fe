#pragma once

#include <vector>

#include "laws/eos/equation_of_state.hpp"

namespace corpuscle {

/// States a gas goes through as it expands without heat from a density [kg/m3] and a specific energy [J/kg], down to nothing.
/// de/dlog(rho) = p/rho and dw/dlog(rho) = -c are integrated by the classical Runge-Kutta rule and kept in small steps; where the virial
/// pressure has become nothing beside the kinetic one the gas is ideal and the rest is a formula. For laws whose isentropes are convex
/// (ideal, Noble-Abel; JWL with A, B >= 0), where rarefactions are fans.
class Isentrope {
public:
    Isentrope(const EquationOfState& law, double density, double energy);

    struct Point {
        double density = 0;   ///< [kg/m3]
        double energy = 0;    ///< specific [J/kg]
        double pressure = 0;  ///< [Pa]
        double sound = 0;     ///< speed of sound [m/s]
        double gain = 0;      ///< speed won by expanding to here, the integral of c over -log(rho) [m/s]
    };
    [[nodiscard]] Point at_density(double density) const;    ///< density at most the first
    [[nodiscard]] Point at_pressure(double pressure) const;  ///< pressure above 0 and at most the first
    /// The place where gain - sound is `speed` [m/s], between the start and `last`: a ray of the fan that spreads from a point.
    [[nodiscard]] Point on_ray(double speed, double last_density) const;
    /// Speed won by expanding into nothing [m/s].
    [[nodiscard]] double escape_speed() const;

private:
    struct Node {
        double log_density = 0;
        double energy = 0;
        double gain = 0;
    };
    [[nodiscard]] Node slope(const Node& node) const;
    [[nodiscard]] Node stepped(const Node& from, double step) const;
    [[nodiscard]] Point point(const Node& node) const;
    [[nodiscard]] bool ideal(const Node& node) const;
    [[nodiscard]] Node ideal_tail(double log_density) const;
    /// Node of the table, or one short step from it, at a log of density.
    [[nodiscard]] Node reached(double log_density) const;

    EquationOfState law_;
    std::vector<Node> nodes_;  ///< densest first
};

}  // namespace corpuscle
