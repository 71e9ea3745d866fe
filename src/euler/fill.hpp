#pragma once

#include <functional>
#include <vector>

#include "euler/grid.hpp"
#include "mesh/shape.hpp"

namespace corpuscle {

/// A gas in one state, at a point.
struct EulerSample {
    std::size_t material = 0;
    double density = 0;    ///< [kg/m3]
    double pressure = 0;   ///< [Pa]
    Vector3d velocity{};   ///< [m/s]
    double energy = 0;     ///< specific; where above 0 it stands, not the pressure [J/kg]
    bool unburnt = false;  ///< explosive that waits
};

/// Lays the cells out from the state at points: a cell is the mean of samples^n points, evenly spread along each of its n axes that are
/// not inert; one point takes the cell's middle. Ends with `prepare`. Explosive that waits must be of a material that burns; its
/// `held_energy` is set from its state.
void fill(EulerGrid& grid, const std::function<EulerSample(const Vector3d&)>& sample, std::size_t samples = 1);

/// A state within a shape.
struct EulerFill {
    Shape shape;
    EulerSample state;
};

/// Lays the cells out from shapes, later ones over earlier ones: a cell at a boundary has as much of each as its points say. The mass of a
/// charge, and of a material that fills only one shape, is then made exact, unless something cuts it, by moving boundaries within the cells
/// they cross. In
/// spherical and axisymmetric grids a point (x, y) is taken for (x, 0, 0), (x, 0, y). Refuses a point that is in no shape by InputError.
void fill(EulerGrid& grid, const std::vector<EulerFill>& fills, std::size_t samples = 8);

/// Lays cells out anew, each as it is at its middle, but for those that hold explosive: a wall that cuts a cell divides fills there.
void fill_at_middles(EulerGrid& grid, const std::vector<EulerFill>& fills, const std::vector<std::size_t>& cells);

}  // namespace corpuscle
