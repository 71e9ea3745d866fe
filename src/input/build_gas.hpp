#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gas/fill.hpp"
#include "input/case/case_description.hpp"
#include "input/spherical_start.hpp"
#include "structure/structure.hpp"

namespace corpuscle {

/// A heat capacity ratio as given, but 5/3 for what is above it (1.667): a particle has no fewer freedoms. [1]
[[nodiscard]] double tidy_gamma(double gamma);

/// The law of preset values; `density` is the reference where the values give none.
[[nodiscard]] EquationOfState make_law(const LawValues& values, double density);

/// A gas ready to be filled: settings, species with their particle masses, charges, ambient gas; and what will fill it.
struct GasPlan {
    Gas gas;
    std::vector<Fill> fills;
    std::vector<double> masses;       ///< of each fill within the domain [kg]
    std::vector<std::size_t> counts;  ///< particles of each fill
    std::vector<Shape> charge_shapes;
    std::optional<SphericalStart> start;  ///< if the particles begin from the blast in one dimension

    [[nodiscard]] std::size_t particles() const;
    /// Of the ball that a gauge at a point sees: three spacings of the undisturbed gas, a hundred particles; in a vacuum, of all particles
    /// spread over the box. [m]
    [[nodiscard]] double point_radius() const;
};

/// Works out everything but the particles themselves. Errors: InputError at the place of what is wrong: no charge and no fill, a
/// charge outside the box or cut by an edge that is no plane of symmetry, states that cannot be, too few particles.
[[nodiscard]] GasPlan plan_gas(const CaseDescription& description, std::vector<std::string>& warnings);

/// Refuses a charge that the structure cuts, at the charge's place.
void check_charges_apart(const GasPlan& plan, const Structure& structure, const CaseDescription& description);

/// Fills the gas as planned.
[[nodiscard]] Gas fill_gas(GasPlan plan);

}  // namespace corpuscle
