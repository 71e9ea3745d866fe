#include <gtest/gtest.h>

#include <cmath>

#include "laws/eos/mie_grueneisen.hpp"

namespace corpuscle {
namespace {

/// The law's pressure and speed of sound from the form made for loops.
void expect_same_law(const EquationOfState& law, double density)
{
    const MieGrueneisen form = mie_grueneisen(law);
    for (const double e : {1e4, 1e6, 4.3e6}) {
        const double p = pressure(law, density, e), sound = sound_speed(law, density, e);
        const auto cold = form.cold ? form.cold_terms(density) : MieGrueneisen::Cold{0, 0};
        const double x = form.inverse_gamma(density);
        EXPECT_NEAR((density * e + cold.q) / x / p, 1, 1e-12) << density;
        EXPECT_NEAR(std::sqrt((cold.z + form.g * p) / (x * density)) / sound, 1, 1e-12) << density;
        EXPECT_NEAR(form.energy(density, p) / e, 1, 1e-9) << density;  // the cold part cancels at low energies
    }
}

/// All laws, from the explosive's density and beyond to an expansion of ten thousand, within the round-off of their formulas.
TEST(MieGrueneisen, is_the_same_law)
{
    const Jwl tnt{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630};
    for (const double expansion : {0.6, 0.9, 1.0, 1.7, 4.0, 10.0, 100.0, 1e3, 1e4}) {
        expect_same_law(IdealGas{1.4}, 1630 / expansion);
        expect_same_law(tnt, 1630 / expansion);
        expect_same_law(NobleAbel{1.3, 0.3, 1630}, 1630 / expansion);
    }
}

/// Far below every density that flows reach, JWL is the ideal gas with gamma 1 + w, and nothing overflows: the exponents stop at 700.
TEST(MieGrueneisen, thins_out_to_an_ideal_gas)
{
    const MieGrueneisen form = mie_grueneisen(Jwl{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630});
    const double nothing = 700 * (form.a + form.b) * std::exp(-700);
    for (const double density : {1.0, 1e-6, 1e-100, 0.0}) {
        const auto cold = form.cold_terms(density);
        EXPECT_LT(std::abs(cold.q), nothing);
        EXPECT_LT(std::abs(cold.z), nothing);
    }
}

}  // namespace
}  // namespace corpuscle
