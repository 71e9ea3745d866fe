#include "laws/eos/equation_of_state.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"

namespace corpuscle {
namespace {

const Jwl tnt{371.2e9, 3.231e9, 4.15, 0.95, 0.30, 1630};
const NobleAbel products{1.3, 0.3, 1630};

const std::array<EquationOfState, 4> laws{IdealGas{1.4}, products, NobleAbel{1.25, 0.911, 1630}, tnt};

/// Central difference of p by rho along the isentrope de = p/rho^2 drho: the square of the speed of sound.
double squared_sound_by_difference(const EquationOfState& law, double density, double e)
{
    const double step = 1e-5 * density;
    const auto moved = [&](double by) {
        const double half = e + pressure(law, density, e) / (density * density) * by / 2;
        const double middle = density + by / 2;
        return pressure(law, density + by, e + pressure(law, middle, half) / (middle * middle) * by);
    };
    return (moved(step) - moved(-step)) / (2 * step);
}

TEST(EquationOfState, ideal_gas_by_hand)
{
    const IdealGas air{1.4};
    EXPECT_DOUBLE_EQ(air.pressure(1.2, 0.253e6 / 1.2), 0.4 * 0.253e6);
    EXPECT_NEAR(air.pressure(1.2, 0.2533125e6 / 1.2), 101325, 1e-6);
    EXPECT_NEAR(air.sound_speed(1.2, 101325 / (0.4 * 1.2)), std::sqrt(1.4 * 101325 / 1.2), 1e-9);
    EXPECT_EQ(air.virial_pressure(1.2F, 1e5F), 0.0F);
}

TEST(EquationOfState, noble_abel_is_pressure_times_free_volume)
{
    // p (V - b) = (gamma - 1) E: V = 1.5, b = 0.3, E = 7 GJ/m3 of explosive.
    const double density = 1630 / 1.5;
    EXPECT_NEAR(products.pressure(density, 7e9 / 1630) * (1.5 - 0.3), 0.3 * 7e9, 1e-3);
    EXPECT_NEAR(products.filled_share(density), 0.2, 1e-15);
}

TEST(EquationOfState, jwl_at_reference_volume_by_hand)
{
    // V = 1, E = 7 GPa: A (1 - w/R1) exp(-R1) + B (1 - w/R2) exp(-R2) + w E, worked out with 30 digits.
    EXPECT_NEAR(tnt.pressure(1630, 7e9 / 1630), 8.38369549985708710e9, 1e-3);
}

TEST(EquationOfState, whole_pressure_is_kinetic_plus_virial)
{
    for (const EquationOfState& law : laws) {
        for (const double density : {0.5, 30.0, 600.0, 1500.0}) {
            const double e = 3e6, kinetic = (heat_capacity_ratio(law) - 1) * density * e;
            EXPECT_NEAR((kinetic + virial_pressure(law, density, kinetic)) / pressure(law, density, e), 1, 1e-14)
                << law_name(law) << " " << density;
        }
    }
}

TEST(EquationOfState, virial_pressure_in_single_precision_is_the_double_one)
{
    for (const float density : {0.01F, 1.0F, 100.0F, 1630.0F, 2000.0F}) {
        const double cold = tnt.virial_pressure(double{density}, 1e9), gap = products.virial_pressure(double{density}, 1e9);
        EXPECT_NEAR(tnt.virial_pressure(density, 1e9F), cold, 1e-5 * cold);
        EXPECT_NEAR(products.virial_pressure(density, 1e9F), gap, 1e-6 * gap);
    }
}

TEST(EquationOfState, empty_and_overfull_cells_are_finite)
{
    EXPECT_EQ(tnt.virial_pressure(0.0F, 0.0F), 0.0F);
    EXPECT_EQ(tnt.virial_pressure(0.0, 0.0), 0.0);
    EXPECT_EQ(products.virial_pressure(0.0F, 0.0F), 0.0F);
    EXPECT_TRUE(std::isfinite(products.virial_pressure(20000.0F, 1e9F)));
    EXPECT_GT(products.virial_pressure(20000.0F, 1e9F), 0.0F);
    EXPECT_TRUE(std::isfinite(tnt.virial_pressure(1e6F, 1e9F)));
}

TEST(EquationOfState, energy_undoes_pressure)
{
    for (const EquationOfState& law : laws) {
        for (const double density : {1.0, 200.0, 1700.0}) {
            EXPECT_NEAR(energy(law, density, pressure(law, density, 4e6)) / 4e6, 1, 1e-12) << law_name(law);
        }
    }
}

TEST(EquationOfState, sound_speed_is_the_slope_of_the_isentrope)
{
    for (const EquationOfState& law : laws) {
        for (const double density : {2.0, 80.0, 700.0, 1600.0}) {
            const double c = sound_speed(law, density, 4.3e6);
            EXPECT_NEAR(c * c / squared_sound_by_difference(law, density, 4.3e6), 1, 1e-7) << law_name(law) << " " << density;
        }
    }
}

TEST(EquationOfState, all_laws_are_ideal_when_thin)
{
    for (const EquationOfState& law : laws) {
        const double kinetic = (heat_capacity_ratio(law) - 1) * 0.01 * 4e6;
        EXPECT_NEAR(pressure(law, 0.01, 4e6) / kinetic, 1, 1e-5) << law_name(law);
    }
}

TEST(EquationOfState, refuses_constants_out_of_range_by_name)
{
    const auto message_of = [](const EquationOfState& law) {
        try {
            check(law, "gas 'odd'");
        } catch (const InputError& error) {
            return error.problem();
        }
        return std::string("accepted");
    };
    EXPECT_THAT(message_of(IdealGas{1.0}), testing::AllOf(testing::HasSubstr("gas 'odd'"), testing::HasSubstr("gamma = 1 ")));
    EXPECT_THAT(message_of(IdealGas{1.7}), testing::HasSubstr("gamma"));
    EXPECT_THAT(message_of(IdealGas{std::numeric_limits<double>::quiet_NaN()}), testing::HasSubstr("gamma"));
    EXPECT_THAT(message_of(NobleAbel{1.3, 1.0, 1630}), testing::HasSubstr("co_volume"));
    EXPECT_THAT(message_of(NobleAbel{1.3, 0.3, 0}), testing::HasSubstr("reference_density"));
    EXPECT_THAT(message_of(Jwl{371e9, 3e9, 4, 1, 0.7, 1630}), testing::HasSubstr("omega"));
    EXPECT_THAT(message_of(Jwl{371e9, 3e9, 0, 1, 0.3, 1630}), testing::HasSubstr("R1"));
    EXPECT_THAT(message_of(Jwl{-1, 3e9, 4, 1, 0.3, 1630}), testing::HasSubstr("A = -1"));
    EXPECT_EQ(message_of(IdealGas{5.0 / 3}), "accepted");
    EXPECT_EQ(message_of(tnt), "accepted");
}

TEST(EquationOfState, largest_densities)
{
    EXPECT_EQ(largest_density(IdealGas{}), std::numeric_limits<double>::infinity());
    EXPECT_NEAR(largest_density(products), 1630 / 0.3, 1e-9);
    EXPECT_EQ(largest_density(NobleAbel{1.4, 0, 1}), std::numeric_limits<double>::infinity());
    EXPECT_EQ(largest_density(tnt), 3260);
}

}  // namespace
}  // namespace corpuscle
