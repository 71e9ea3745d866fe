#pragma once

#include <cstdint>
#include <vector>

#include "math/vector3.hpp"

namespace corpuscle {

/// Thermal velocities of variance 1 (neighbours take opposite ones) and internal energies of mean 1, of some particles; mean and scale
/// exact.
struct ThermalDraw {
    std::vector<Vector3d> velocity;
    std::vector<double> energy;
};

/// Maxwell-Boltzmann velocities and Gamma-distributed energies for particles of so many internal freedoms; `stream` keeps several draws of
/// one seed apart.
[[nodiscard]] ThermalDraw draw_thermal(std::size_t count, double internal_freedoms, std::uint64_t seed, std::uint64_t stream);

}  // namespace corpuscle
