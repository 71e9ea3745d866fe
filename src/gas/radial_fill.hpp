#pragma once

#include <vector>

#include "gas/gas.hpp"

namespace corpuscle {

/// Gas between two radii of a radial flow; velocities outward, straight between the radii.
struct RadialLayer {
    double inner = 0;           ///< [m]
    double outer = 0;           ///< [m]
    double density = 0;         ///< [kg/m3]
    double energy = 0;          ///< internal, specific [J/kg]
    double inner_velocity = 0;  ///< [m/s]
    double outer_velocity = 0;  ///< [m/s]
};

/// One gas of a radial flow, to be filled with particles: layers side by side, and what they hold in the whole sphere.
struct RadialFill {
    Vector3d center;  ///< [m]
    std::uint32_t species = 0;
    std::vector<RadialLayer> layers;  ///< innermost first
    double mass = 0;                  ///< [kg]
    double momentum = 0;              ///< radial, outward [kg m/s]
    double energy = 0;                ///< kinetic and internal [J]
};

/// The part of a sphere that a domain holds whose faces cut it only in planes through its center: all of it, or half, a quarter, an eighth.
struct Sector {
    std::array<int, 3> side{};  ///< of each axis: -1, 1 for the half on that side of the center, 0 for both

    [[nodiscard]] double share() const;  ///< of the whole sphere
    /// Mean of the outward directions in the sector.
    [[nodiscard]] Vector3d mean_direction() const { return {0.5 * side[0], 0.5 * side[1], 0.5 * side[2]}; }
};
[[nodiscard]] Sector sector_of(const Domain& domain, const Vector3d& center);

/// Puts `count` particles of the fill's species where its layers lie in the domain. They stand in shells a spacing apart, evenly over the
/// directions (one at random in each of equal solid angles), and in mass evenly over the radius; velocities are the layer's, plus thermal
/// ones as `fill` draws them, in blocks of 64 whose mean and energy are the layer's. Then velocities are shifted and the thermal part
/// scaled so that momentum (radial, and as a vector) and energy are the fill's share in the sector, to round-off. Mass is that of `count`
/// particles: the caller's.
void fill_radial(Gas& gas, const RadialFill& fill, std::size_t count);

}  // namespace corpuscle
