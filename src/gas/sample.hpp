#pragma once

#include "gas/gas.hpp"
#include "mesh/shape.hpp"

namespace corpuscle {

/// The gas in a region at one moment.
struct GasSample {
    std::size_t particles = 0;
    double density = 0;           ///< [kg/m3]
    Vector3d velocity;            ///< of the mass [m/s]
    double kinetic_pressure = 0;  ///< of the motion relative to it [Pa]
    double pressure = 0;          ///< kinetic and virial [Pa]
    double energy = 0;            ///< thermal, translational and internal, per mass [J/kg]
};

/// Measures the burnt gas within a shape of known volume [m3]. Noise of the pressures is about 1/sqrt(particles).
[[nodiscard]] GasSample sample(const Gas& gas, const Shape& shape, double volume);

/// Cell averages on a regular grid over a box, for pictures: index (k * ny + j) * nx + i.
struct GasGrid {
    Box box;  ///< [m]
    std::array<std::size_t, 3> cells{};
    std::vector<float> density;        ///< [kg/m3]
    std::vector<Vector3f> velocity;    ///< [m/s]
    std::vector<float> pressure;       ///< kinetic and virial [Pa]
    std::vector<float> product_share;  ///< mass share of detonation products [1]

    [[nodiscard]] std::size_t size() const { return cells[0] * cells[1] * cells[2]; }
};

/// Averages the gas on a grid over the domain of about `cell_size` [m].
[[nodiscard]] GasGrid average(const Gas& gas, double cell_size);

/// What a gas grid shows, cell by cell.
[[nodiscard]] FieldSet fields(const GasGrid& grid);

/// What of each particle is shown: velocity, speed, species, specific internal energy, burnt or not.
[[nodiscard]] FieldSet particle_fields(const Gas& gas);

/// Everything of the gas that a restart needs.
[[nodiscard]] FieldSet state(Gas& gas);

}  // namespace corpuscle
