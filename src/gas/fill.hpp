#pragma once

#include <vector>

#include "gas/gas.hpp"
#include "mesh/shape.hpp"

namespace corpuscle {

/// A gas state in a region: `shape` within the domain, less what later fills take.
struct Fill {
    Shape shape;
    std::vector<Shape> cut_by;  ///< later fills
    std::uint32_t species = 0;
    double density = 0;          ///< [kg/m3]
    double energy_per_mass = 0;  ///< internal and translational heat [J/kg]
    Vector3d velocity;           ///< of the whole [m/s]
    std::int64_t charge = -1;    ///< the charge this is, waiting for its detonation; -1: gas from the start
};

/// Volume of the part of the domain that a fill takes [m3]; exact where its cuts lie wholly inside it and apart from one another,
/// else to about 1e-5.
[[nodiscard]] double volume(const Fill& fill, const Domain& domain);

/// Puts `count` particles of the fill's species into its region. Quiet start: one particle at random in each cell of a lattice;
/// neighbours take opposite thermal velocities (Maxwell-Boltzmann) and internal energies from the Gamma law; then shifted and
/// scaled so that mean velocity and both energies are those asked for, to round-off.
/// Needs the species' particle mass; refuses a region without room for the particles by InputError.
void fill(Gas& gas, const Fill& fill, std::size_t count);

/// How many particles each mass of gas gets of a whole count, so that particle masses are as equal as can be.
[[nodiscard]] std::vector<std::size_t> share_particles(const std::vector<double>& masses, std::size_t total);

}  // namespace corpuscle
