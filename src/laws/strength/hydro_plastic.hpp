#pragma once

#include "laws/strength/bilinear_plastic.hpp"

namespace corpuscle {

/// Elastic-plastic solid whose pressure follows an equation of state, for strong compression and for soft solids:
///     p = p_H(V) (1 - G eta/2) + G E,        p_H = rho0 c0^2 eta / (1 - s eta)^2,   eta = 1 - V  (compression),
///     p = rho0 c0^2 (1/V - 1) + G E                                                              (expansion)
/// (Mie and Grueneisen about the Hugoniot Us = c0 + s up, G rho constant), with V the volume and E the internal energy, both per volume at
/// the start. E takes the work of all stresses. With s = 0 and G = 0 the pressure is linear in 1/V - 1 but for eta. The deviator is that
/// of BilinearPlastic; the tension may not pass a limit (spall: the pressure stays there). For solids only.
struct HydroPlastic {
    BilinearPlastic deviator;
    double density = 0;           ///< rho0, at the start [kg/m3]
    double sound_speed = 0;       ///< c0 [m/s]
    double slope = 0;             ///< s [1]
    double grueneisen = 0;        ///< G [1]
    double tension_limit = 1e99;  ///< largest tension [Pa]

    [[nodiscard]] static constexpr bool yields() { return true; }
    [[nodiscard]] bool has_back_stress() const { return deviator.has_back_stress(); }
    [[nodiscard]] static constexpr bool has_equation_of_state() { return true; }
    [[nodiscard]] static constexpr bool for_shells() { return false; }

    template <class Point>
    auto yield_of(const Point& point) const
    {
        return deviator.yield_of(point);
    }

    /// Pressure at a volume over that at the start, and an energy per volume at the start [J/m3]. [Pa]
    template <class Real>
    [[nodiscard]] Real pressure(const Real& volume, const Real& energy) const
    {
        return cold_pressure(volume) + grueneisen * energy;
    }

    /// What the energy does not change. [Pa]
    template <class Real>
    [[nodiscard]] Real cold_pressure(const Real& volume) const
    {
        const double modulus = density * sound_speed * sound_speed;
        const Real eta = 1.0 - volume, dense = 1.0 / volume - 1.0;
        const Real room = larger(1.0 - slope * eta, Real(0.05));  // the Hugoniot ends where s eta = 1
        const Real hugoniot = modulus * eta / (room * room) * (1.0 - 0.5 * grueneisen * eta);
        return select(eta > 0.0, hugoniot, Real(modulus * dense));
    }

    /// Bulk modulus -V dp/dV at constant entropy. [Pa]
    template <class Point>
    [[nodiscard]] auto bulk_modulus(const SolidStiffness&, const Point& point) const
    {
        using Real = decltype(point.plastic_strain);
        constexpr double small = 1e-5;
        const Real slope_of_cold =
            (cold_pressure(Real(point.volume * (1.0 - small))) - cold_pressure(Real(point.volume * (1.0 + small)))) * (0.5 / small);
        const Real hot = grueneisen * point.volume * larger(pressure(point.volume, point.energy), Real(0.0));
        return larger(slope_of_cold + hot, Real(0.1 * density * sound_speed * sound_speed));
    }

    /// The deviator by its law, then volume, energy and pressure together: linear in the energy, so solved at once.
    template <class Real>
    SolidResponse<Real> stretch(const SolidStiffness& stiffness, SolidPoint<Real>& point, const SolidStrain<Real>& strain,
                                double duration) const
    {
        const Real growth = volume_strain(strain), mean_before = mean_stress(point.stress);
        SolidStrain<Real> shape = strain;
        shape.xx = strain.xx - growth * (1.0 / 3.0);
        shape.yy = strain.yy - growth * (1.0 / 3.0);
        shape.zz = strain.zz - growth * (1.0 / 3.0);
        point.stress = with_mean_added(point.stress, Real(-mean_before));
        const SolidStress<Real> before = point.stress;
        const SolidResponse<Real> response = deviator.stretch(stiffness, point, shape, duration);
        const Real volume = point.volume * (1.0 + 0.5 * growth) / (1.0 - 0.5 * growth), gained = volume - point.volume;
        const Real shape_work = 0.5 * (work(before, shape) + work(point.stress, shape)) * (0.5 * (volume + point.volume));
        const Real without = point.energy + shape_work + 0.5 * mean_before * gained;
        point.energy = (without - 0.5 * cold_pressure(volume) * gained) / (1.0 + 0.5 * grueneisen * gained);
        point.volume = volume;
        const Real now = larger(pressure(volume, point.energy), Real(-tension_limit));
        point.stress = with_mean_added(point.stress, Real(-now));
        return response;
    }
};

}  // namespace corpuscle
