#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "laws/strength/flow_root.hpp"

namespace corpuscle {

/// Strength and failure after Johnson and Cook (1983, 7th Int. Symp. on Ballistics; 1985, Eng. Fract. Mech. 21, 31):
///     sigma_y = (A + B eps_p^n) (1 + C ln(rate*)) (1 - T*^m),        rate* = plastic rate / reference rate, not below 1,
///     damage rate = plastic rate / failure strain,
///     failure strain = (D1 + D2 exp(D3 mean stress / equivalent stress)) (1 + D4 ln(rate*)) (1 + D5 T*),
/// T* = (T - T_room) / (T_melt - T_room) from 0 to 1. A share of the plastic work (Taylor and Quinney) heats the point, without conduction;
/// the temperature of the start of a step rules it. At T* = 1, or damage 1, a point has next to no strength.
struct JohnsonCook {
    double a = 0, b = 0;               ///< [Pa]
    double n = 1;                      ///< [1]
    double c = 0;                      ///< [1]
    double reference_rate = 1;         ///< [1/s]
    double m = 1;                      ///< [1]
    double room_temperature = 293;     ///< at which A, B, n hold; that of the start [K]
    double melting_temperature = 1e9;  ///< [K]
    double heat_capacity = 0;          ///< density times specific heat [J/(m3 K)]; 0: nothing warms up
    double heat_share = 0.9;           ///< of plastic work [1]
    double d1 = 0, d2 = 0, d3 = 0;     ///< of failure [1]; all 0: it does not fail
    double d4 = 0, d5 = 0;             ///< [1]

    [[nodiscard]] static constexpr bool yields() { return true; }
    [[nodiscard]] static constexpr bool has_back_stress() { return false; }
    [[nodiscard]] static constexpr bool heats() { return true; }
    [[nodiscard]] static constexpr bool damages() { return true; }
    [[nodiscard]] static constexpr double back_modulus() { return 0.0; }
    [[nodiscard]] bool fails() const { return d1 != 0 || d2 != 0; }

    /// T* of a rise of temperature [K].
    [[nodiscard]] double homologous(double heat) const { return std::clamp(heat / (melting_temperature - room_temperature), 0.0, 1.0); }

    /// Yield stress at a plastic strain, plastic strain rate [1/s] and rise of temperature [K]. [Pa]
    [[nodiscard]] double yield_stress(double plastic_strain, double rate, double heat) const
    {
        return yield_with_slope(plastic_strain, rate, heat, 1.0).value;
    }

    /// The same and its slope in a step of `duration` [s].
    [[nodiscard]] YieldStress yield_with_slope(double plastic_strain, double rate, double heat, double duration) const
    {
        const double power = plastic_strain > 0 ? std::pow(plastic_strain, n) : 0.0;
        const double hard = a + b * power, hardening = plastic_strain > 0 ? b * n * power / plastic_strain : 0.0;
        const bool fast = rate > reference_rate;
        const double factor = fast ? 1.0 + c * std::log(rate / reference_rate) : 1.0, growth = fast ? c / (rate * duration) : 0.0;
        const double soft = softening(heat);
        return {hard * factor * soft, (hardening * factor + hard * growth) * soft};
    }

    /// Strain at failure under a mean stress over the equivalent stress, at a rate [1/s] and rise of temperature [K]. [1]
    [[nodiscard]] double failure_strain(double triaxiality, double rate, double heat) const
    {
        const double factor = rate > reference_rate ? 1.0 + d4 * std::log(rate / reference_rate) : 1.0;
        const double strain = (d1 + d2 * std::exp(d3 * triaxiality)) * factor * (1.0 + d5 * homologous(heat));
        return std::max(strain, least_failure_strain);
    }

    template <class Point>
    auto yield_of(const Point& point) const
    {
        return each_lane([this](double strain, double heat) { return yield_stress(strain, 0.0, heat); }, point.plastic_strain, point.heat);
    }

    template <class Real, class Point>
    Real flow(const FlowTrial<Real>& trial, const Point& point, double duration) const
    {
        return solve_flow(*this, trial, point, duration);
    }

    /// Damage and heat of a plastic strain increment.
    template <class Real, class Point>
    void remember(Point& point, const Real& plastic, const Real& mean, const Real& equivalent, const Real& plastic_work,
                  double duration) const
    {
        if (fails()) {
            const Real triaxiality = mean / (equivalent + 1e-30);
            point.damage = point.damage + plastic / strain_at_failure(triaxiality, Real(plastic / duration), point.heat);
        }
        if (heat_capacity > 0) point.heat = point.heat + (heat_share / heat_capacity) * plastic_work;
    }

    template <class Stiffness, class Point, class Strain>
    auto stretch(const Stiffness& stiffness, Point& point, const Strain& strain, double duration) const
    {
        return mises_stretch(*this, stiffness, point, strain, duration);
    }

private:
    static constexpr double least_failure_strain = 1e-4, least_strength = 1e-6;

    [[nodiscard]] double softening(double heat) const
    {
        const double t = homologous(heat);
        return std::max(least_strength, t > 0 ? 1.0 - std::pow(t, m) : 1.0);
    }

    [[nodiscard]] double strain_at_failure(double triaxiality, double rate, double heat) const
    {
        return failure_strain(triaxiality, rate, heat);
    }
    [[nodiscard]] Lanes strain_at_failure(const Lanes& triaxiality, const Lanes& rate, const Lanes& heat) const
    {
        return Lanes([&](auto lane) { return failure_strain(triaxiality[lane], rate[lane], heat[lane]); });
    }
};

}  // namespace corpuscle
