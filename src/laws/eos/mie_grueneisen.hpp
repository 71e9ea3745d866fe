#pragma once

#include <variant>

#include "laws/eos/equation_of_state.hpp"
#include "math/fast.hpp"

namespace corpuscle {

/// Any law of gas written for loops over cells, without a choice inside: with X = 1/Gamma,
///     rho e = X(rho) p - Q(rho),   X = x0 + x1 rho,   X rho c^2 = Z(rho) + G p,
/// where Q = X p_cold is minus the energy per volume at no pressure, Z = X (rho dp_cold/drho - p_cold), G = gamma/(gamma - 1).
/// Ideal: X = 1/(gamma - 1); Noble-Abel: X = (1 - phi)/(gamma - 1); JWL: X = 1/w, p_cold the two exponential terms. Source: the laws
/// themselves (Mie-Grueneisen's form p = p_cold + Gamma rho e).
struct MieGrueneisen {
    double x0 = 2.5;                 ///< [1]
    double x1 = 0;                   ///< [m3/kg]
    double g = 3.5;                  ///< G [1]
    bool cold = false;               ///< whether Q and Z are other than nothing
    double a = 0, b = 0;             ///< A/w, B/w [Pa]
    double r1 = 1, r2 = 1;           ///< [1]
    double omega = 0.4;              ///< w [1]
    double reference_density = 1;    ///< rho0 [kg/m3]
    double largest_density = 1e300;  ///< densities above are taken for this one [kg/m3]

    /// Q and Z at a density [Pa].
    struct Cold {
        double q, z;
    };

    /// Nothing at density zero: the exponentials win.
    [[nodiscard]] Cold cold_terms(double density) const
    {
        const double expansion = reference_density / density;
        const double y1 = expansion * r1, y2 = expansion * r2;
        const double near = y1 < 700.0 ? y1 : 700.0, far = y2 < 700.0 ? y2 : 700.0;
        const double first = a * fast_exp(-near), second = b * fast_exp(-far);
        return {first * (1 - omega / near) + second * (1 - omega / far), first * (near - 1 - omega) + second * (far - 1 - omega)};
    }
    /// The part of an isentrope's pressure that is the same on all of them, A exp(-R1 V) + B exp(-R2 V); the rest is in proportion to
    /// (density/X)^gamma [Pa].
    [[nodiscard]] double cold_isentrope(double density) const
    {
        if (!cold) return 0;
        const double expansion = reference_density / density;
        return omega * (a * fast_exp(-r1 * expansion) + b * fast_exp(-r2 * expansion));
    }
    [[nodiscard]] double inverse_gamma(double density) const { return x0 + x1 * density; }

    /// Specific energy [J/kg] at a density [kg/m3] and a pressure [Pa].
    [[nodiscard]] double energy(double density, double pressure) const
    {
        const double q = cold ? cold_terms(density).q : 0;
        return (inverse_gamma(density) * pressure - q) / density;
    }
};

/// The same law in this form.
[[nodiscard]] inline MieGrueneisen mie_grueneisen(const IdealGas& law)
{
    MieGrueneisen form;
    form.x0 = 1 / (law.gamma - 1);
    form.g = law.gamma / (law.gamma - 1);
    return form;
}
[[nodiscard]] inline MieGrueneisen mie_grueneisen(const NobleAbel& law)
{
    MieGrueneisen form = mie_grueneisen(IdealGas{law.gamma});
    form.x1 = -law.specific_co_volume() * form.x0;
    form.largest_density = NobleAbel::crowded * law.largest_density();
    return form;
}
[[nodiscard]] inline MieGrueneisen mie_grueneisen(const Jwl& law)
{
    MieGrueneisen form = mie_grueneisen(IdealGas{1 + law.omega});
    form.cold = true;
    form.a = law.a / law.omega, form.b = law.b / law.omega;
    form.r1 = law.r1, form.r2 = law.r2;
    form.omega = law.omega;
    form.reference_density = law.reference_density;
    form.largest_density = 4 * law.reference_density;
    return form;
}
[[nodiscard]] inline MieGrueneisen mie_grueneisen(const EquationOfState& law)
{
    return std::visit([](const auto& own) { return mie_grueneisen(own); }, law);
}

}  // namespace corpuscle
