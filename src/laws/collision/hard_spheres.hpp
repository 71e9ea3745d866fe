#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "math/vector3.hpp"

namespace corpuscle {

/// Largest packing that the rule of hard spheres is proved for: share of the volume that spheres fill. They freeze at 0.49.
inline constexpr double largest_packing = 0.3;

/// Share of the volume that so many spheres a volume [1/m3] of that radius [m] fill.
[[nodiscard]] inline double sphere_packing(double number_density, double radius)
{
    return 4 * std::numbers::pi / 3 * number_density * radius * radius * radius;
}

/// Pressure of a fluid of equal hard spheres over its kinetic one, Z = (1 + f + f^2 - f^3)/(1 - f)^3 at packing f: within 0.3 % of
/// computed spheres up to freezing (Carnahan and Starling, J. Chem. Phys. 51 (1969) 635).
[[nodiscard]] constexpr double carnahan_starling(double packing)
{
    const double free = 1 - packing;
    return (1 + packing * (1 + packing * (1 - packing))) / (free * free * free);
}

/// How much denser than at random spheres stand at contact, chi = (1 - f/2)/(1 - f)^3, from Z = 1 + 4 f chi.
[[nodiscard]] constexpr double contact_value(double packing)
{
    const double free = 1 - packing;
    return (1 - 0.5 * packing) / (free * free * free);
}

/// The packing at which spheres have that pressure over their kinetic one, 1 <= Z <= Z(0.49), by halving.
[[nodiscard]] inline double packing_of(double compressibility)
{
    double low = 0, high = 0.49;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (carnahan_starling(middle) < compressibility ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// How often a sphere meets another [1/s]: sqrt2 pi n D^2 c chi, from the spheres a volume n [1/m3], the mean square of the distance
/// at contact D^2 [m2], the mean speed c [m/s] and the packing (Enskog 1922).
template <class Real>
[[nodiscard]] Real meeting_rate(Real number_density, Real squared_contact, Real mean_speed, Real packing)
{
    const Real free = 1 - packing;
    return Real(4.4428829) * number_density * squared_contact * mean_speed * (1 - Real(0.5) * packing) / (free * free * free);
}

/// When two points on straight courses, `place` [m] apart with the relative velocity `velocity` [m/s], come to the distance
/// `contact` [m]: 0 if they are nearer already and approach, infinity if they never do [s].
[[nodiscard]] inline double meeting_time(const Vector3d& place, const Vector3d& velocity, double contact)
{
    constexpr double never = std::numeric_limits<double>::infinity();
    const double approach = -dot(place, velocity);
    if (!(approach > 0)) return never;
    const double gap = norm_squared(place) - contact * contact;
    if (gap <= 0) return 0;
    const double root = approach * approach - norm_squared(velocity) * gap;
    return root < 0 ? never : gap / (approach + std::sqrt(root));
}

/// Exchange of energy between the motion of a pair along its line of centres and the internal freedoms of one of its spheres. At
/// equilibrium the spheres that meet have normal energies distributed as exp(-E/kT) and internal ones as e^(zeta/2 - 1) exp(-e/kT):
/// of the energy they share, the internal part is Beta(zeta/2, 1) distributed, a power of a uniform number. Drawing it anew keeps
/// that equilibrium, and is its own reverse.
class NormalExchange {
public:
    NormalExchange() = default;
    explicit NormalExchange(double internal_freedoms) : inverse_shape_(internal_freedoms > 0 ? 2 / internal_freedoms : 0) {}

    [[nodiscard]] bool exchanges() const { return inverse_shape_ > 0; }

    /// Internal share of the common energy from a uniform number in (0, 1).
    [[nodiscard]] double internal_share(double uniform) const { return std::pow(uniform, inverse_shape_); }

private:
    double inverse_shape_ = 0;  ///< 2/zeta
};

}  // namespace corpuscle
