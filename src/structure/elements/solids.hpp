#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "laws/strength/material.hpp"
#include "structure/elements/hex_modes.hpp"
#include "structure/elements/point_slots.hpp"
#include "structure/elements/turned.hpp"

// What solid elements of all shapes share.

namespace corpuscle {

/// Viscous pressure against compression that carries shocks over a few elements (von Neumann and Richtmyer 1950, Landshoff 1955):
///     q = density * side * rate * (linear * wave speed + quadratic * side * rate),    rate of compression > 0. [1]
struct BulkViscosity {
    double linear = 0.06;
    double quadratic = 1.5;
};

/// What solid elements of N corners are made from.
template <std::size_t N>
struct SolidInput {
    std::vector<std::array<std::uint32_t, N>> corners;  ///< the structure's nodes
    BulkViscosity viscosity;
    double hourglass_stiffness = 0.02;  ///< of one-point bricks: kappa of Flanagan and Belytschko [1]
    double hourglass_viscosity = 0.0;   ///< as a share of what damps a mode critically [1]
};

/// The material as solid elements use it.
struct SolidMaterial {
    SolidMaterial() = default;
    explicit SolidMaterial(const Material& m) : strength(m.strength), stiffness(m.young_modulus, m.poisson_ratio), density(m.density) {}

    Strength strength;
    SolidStiffness stiffness{1.0, 0.0};
    double density = 0;  ///< [kg/m3]

    /// Of plane waves. [m/s]
    [[nodiscard]] double wave_speed() const { return std::sqrt(stiffness.uniaxial() / density); }
};

/// Squared gradients of an element's shape functions, summed over its corners. [1/m2]
template <class Real>
struct GradientSquares {
    Real xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, yz = 0.0, zx = 0.0;

    void add(const Vector3<Real>& g)
    {
        xx = xx + g.x * g.x;
        yy = yy + g.y * g.y;
        zz = zz + g.z * g.z;
        xy = xy + g.x * g.y;
        yz = yz + g.y * g.z;
        zx = zx + g.z * g.x;
    }
    [[nodiscard]] Real trace() const { return xx + yy + zz; }
    /// At least its largest principal value, and that exactly where the two smaller ones are equal (Wolkowicz and Styan 1980).
    [[nodiscard]] Real largest() const
    {
        const Real mean = trace() * (1.0 / 3.0);
        const Real squares = xx * xx + yy * yy + zz * zz + 2.0 * (xy * xy + yz * yz + zx * zx);
        return mean + square_root(larger(2.0 * (squares * (1.0 / 3.0) - mean * mean), Real(0.0)));
    }
};

/// Highest frequency, squared, of a one-point solid with equal masses at `corners` corners and volume over mass `v` [m3/kg]; exact for a
/// cube, and where one gradient outdoes the others; else a bound from above. [1/s2]
template <class Real>
Real frequency_squared(const GradientSquares<Real>& g, double corners, const Real& v, const Real& bulk, double shear)
{
    return corners * v * ((bulk - 2.0 / 3.0 * shear) * g.trace() + 2.0 * shear * g.largest());
}

/// Viscous pressure and what it leaves of the stable step.
template <class Real>
struct ViscousPressure {
    Real pressure;    ///< [Pa]
    Real step_share;  ///< of the step without it [1]
};

/// `growth` is the volume strain of the step.
template <class Real>
ViscousPressure<Real> viscous_pressure(const BulkViscosity& q, const SolidMaterial& m, const Real& side, const Real& density,
                                       const Real& growth, double duration)
{
    const double speed = m.wave_speed();
    const Real rate = larger(growth * (-1.0 / duration), Real(0.0));
    const Real ratio = q.linear + q.quadratic * side * rate * (1.0 / speed);  // of critical damping
    const Real active = select(rate > 0.0, ratio, Real(0.0));
    return {density * side * speed * rate * active, square_root(1.0 + active * active) - active};
}

inline Lanes cube_root(const Lanes& a)
{
    return Lanes([&](auto lane) { return std::cbrt(a[lane]); });
}

/// Turns a point with the step and stretches it; returns the plastic work per volume. [J/m3]
template <class Law>
Lanes advance_point(const Law& law, const SolidStiffness& stiffness, SolidPoint<Lanes>& point, const StepRotation<Lanes>& turn,
                    const SolidStrain<Lanes>& strain, double duration)
{
    point.stress = turn * point.stress;
    if (law.has_back_stress()) point.back_stress = turn * point.back_stress;
    return law.stretch(stiffness, point, strain, duration).plastic_work;
}

/// Bulk modulus that waves meet at a point. [Pa]
template <class Law>
Lanes bulk_at(const Law& law, const SolidStiffness& stiffness, const SolidPoint<Lanes>& point)
{
    if constexpr (has_equation_of_state<Law>()) return law.bulk_modulus(stiffness, point);
    return stiffness.bulk();
}

/// Stress at which a point flows; next to endless for laws that do not yield. [Pa]
template <class Law>
Lanes strength_at(const Law& law, const SolidPoint<Lanes>& point)
{
    if constexpr (requires { law.yield_of(point); }) return larger(law.yield_of(point), von_mises(point.stress));
    return 1e100;
}

/// Viscous pressure heats a point whose pressure depends on its energy.
template <class Law>
void heat_by_viscosity(SolidPoint<Lanes>& point, const Lanes& pressure, const Lanes& growth)
{
    if constexpr (has_equation_of_state<Law>()) point.energy = point.energy - pressure * growth * point.volume;
}

/// Work of the mean of old and new loads on a motion; keeps the new ones from slot `first`. [J]
template <std::size_t N>
Lanes exchange_work(Lanes* own, int first, const std::array<const Vector3<Lanes>*, N>& loads,
                    const std::array<const Vector3<Lanes>*, N>& moves)
{
    Lanes twice = 0.0;
    for (std::size_t i = 0; i < N; ++i) {
        const int slot = first + 3 * static_cast<int>(i);
        twice = twice + dot(*loads[i] + load_vector(own, slot), *moves[i]);
        store_vector(own, slot, *loads[i]);
    }
    return 0.5 * twice;
}

}  // namespace corpuscle
