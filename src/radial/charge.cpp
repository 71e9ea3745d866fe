#include "radial/charge.hpp"

#include <cmath>
#include <numbers>

#include "radial/zoning.hpp"

namespace corpuscle {

double ball_radius(double mass, double density)
{
    return std::cbrt(mass / density * 3 / (4 * std::numbers::pi));
}

RadialFlow lay_charge(const RadialCharge& charge, const RadialCells& cells, double reach, Symmetry symmetry)
{
    const double width = charge.radius / cells.per_radius;
    RadialZone explosive{graded_edges(0, charge.radius, width, width / cells.surface_ratio), charge.products, charge.density,
                         charge.energy};
    explosive.detonation_velocity = charge.detonation_velocity;
    const RadialZone air{growing_edges(charge.radius, reach, width, cells.growth_power), charge.ambient, charge.ambient_density,
                         energy(charge.ambient, charge.ambient_density, charge.ambient_pressure)};
    return RadialFlow(symmetry, {explosive, air});
}

}  // namespace corpuscle
