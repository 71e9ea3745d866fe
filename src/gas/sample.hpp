#pragma once

#include <limits>

#include "gas/gas.hpp"
#include "mesh/shape.hpp"

namespace corpuscle {

/// Standard errors of what a sample says, from the particles it counted: each one's share of the sum, squared and added (Poisson).
struct GasSampleError {
    double density = 0;                                             ///< [kg/m3]
    Vector3d velocity;                                              ///< of each component [m/s]
    double kinetic_pressure = 0;                                    ///< [Pa]
    double pressure = 0;                                            ///< [Pa]
    double temperature = std::numeric_limits<double>::quiet_NaN();  ///< [K]
};

/// The gas in a region at one moment.
struct GasSample {
    std::size_t particles = 0;
    double density = 0;           ///< [kg/m3]
    Vector3d velocity;            ///< of the mass [m/s]
    double kinetic_pressure = 0;  ///< of the motion relative to it [Pa]
    double pressure = 0;          ///< kinetic and virial [Pa]
    double energy = 0;            ///< thermal, translational and internal, per mass [J/kg]
    double temperature =
        std::numeric_limits<double>::quiet_NaN();  ///< translational [K]; not a number where the molar mass of a species is not known
    GasSampleError error;
};

/// Measures the burnt gas within a shape of known volume [m3], and how far chance may have moved each number: `n` particles that
/// come and go independently. Where a law is stiff the number in a region wavers less, so the errors are upper bounds there.
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
