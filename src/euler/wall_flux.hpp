#pragma once

#include "euler/grid.hpp"

namespace corpuscle {

/// A cell as a wall or a corner meets it.
struct CellState {
    EulerCell mixture;
    double inverse_gamma = 0;                            ///< X of the mixture
    double cold = 0;                                     ///< Q of the mixture [Pa]
    std::array<double, most_euler_materials> mass{};     ///< of each material, per volume [kg/m3]
    std::array<double, most_euler_materials> energy{};   ///< internal, of each, per volume [J/m3]
    std::array<double, most_euler_materials> unburnt{};  ///< of the mass, what waits to burn [kg/m3]
};
[[nodiscard]] CellState cell_state(const EulerGrid& grid, std::size_t cell);

/// Pressure of gas on a wall towards which it goes at a speed [m/s] (below 0: away from it): behind the shock, or at the end of the
/// rarefaction, that brings it to rest on the wall; exact for an ideal gas whose gamma is rho c^2/p [Pa].
[[nodiscard]] double wall_pressure(const EulerCell& cell, double speed);

/// What flows from one cell to another through an opening, by the three waves of HLLC across its area [m2], given to both cells' sources.
void flow_through(const CellState& from, const CellState& to, const Vector3d& area, WallSource& of_from, WallSource& of_to);

}  // namespace corpuscle
