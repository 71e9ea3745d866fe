#include "laws/collision/hard_spheres.hpp"

#include <gtest/gtest.h>

#include "math/random.hpp"

namespace corpuscle {
namespace {

TEST(HardSpheres, pressure_has_the_known_virial_coefficients)
{
    // Z = 1 + 4 f + 10 f^2 + 18 f^3 + ...: the first two are exact for spheres, the third is 18.365 there.
    const double f = 1e-3;
    EXPECT_NEAR(carnahan_starling(f), 1 + 4 * f + 10 * f * f + 18 * f * f * f, 40 * f * f * f * f);
    EXPECT_NEAR(carnahan_starling(0.3), 3.973760933, 1e-9);  // 1.363/0.343
}

TEST(HardSpheres, contact_value_gives_the_pressure)
{
    for (const double f : {0.01, 0.1, 0.3, 0.45}) EXPECT_NEAR(1 + 4 * f * contact_value(f), carnahan_starling(f), 1e-12) << f;
}

TEST(HardSpheres, packing_of_a_pressure_is_its_inverse)
{
    for (const double f : {0.01, 0.1, 0.3, 0.45}) EXPECT_NEAR(packing_of(carnahan_starling(f)), f, 1e-12) << f;
    EXPECT_NEAR(packing_of(1 / (1 - 0.3)), 0.086, 5e-4);  // the particle blast method's co-volume
    EXPECT_NEAR(packing_of(1), 0, 1e-12);
}

TEST(HardSpheres, meeting_time)
{
    constexpr double never = std::numeric_limits<double>::infinity();
    EXPECT_DOUBLE_EQ(meeting_time({3, 0, 0}, {-2, 0, 0}, 1), 1);
    EXPECT_DOUBLE_EQ(meeting_time({3, 0.6, 0}, {-2, 0, 0}, 1), 1.1);  // touches at x = 0.8
    EXPECT_EQ(meeting_time({3, 1.001, 0}, {-2, 0, 0}, 1), never);
    EXPECT_EQ(meeting_time({3, 0, 0}, {2, 0, 0}, 1), never);
    EXPECT_EQ(meeting_time({3, 0, 0}, {0, 0, 0}, 1), never);
    EXPECT_EQ(meeting_time({0.9, 0, 0}, {-1, 0, 0}, 1), 0);
    EXPECT_EQ(meeting_time({0.9, 0, 0}, {1, 0, 0}, 1), never);
}

TEST(HardSpheres, meeting_rate_is_the_mean_free_path_of_thin_gas)
{
    const double number = 2.0, contact = 0.1, speed = 3.0;  // lambda = 1/(sqrt2 pi n D^2)
    EXPECT_NEAR(meeting_rate(number, contact * contact, speed, 0.0), speed * std::sqrt(2.0) * std::numbers::pi * number * 0.01, 1e-8);
    EXPECT_NEAR(meeting_rate(number, 0.01, speed, 0.2) / meeting_rate(number, 0.01, speed, 0.0), contact_value(0.2), 1e-12);
}

/// Pairs that meet at equilibrium, kT = 1: normal energy exponential, internal energy Gamma(zeta/2). After an exchange both are
/// distributed as before, and (before, after) as likely as (after, before): detailed balance. The moments' own standard errors
/// decide, 4 sigma.
TEST(HardSpheres, exchange_keeps_equilibrium_and_is_its_own_reverse)
{
    Random random(7, Purpose::collide, 0, 0);
    constexpr int pairs = 200000;
    for (const double zeta : {0.5, 2.0, 11.0 / 3, 5.0}) {
        const NormalExchange exchange(zeta);
        double mean = 0, square = 0, normal = 0, skew = 0, skew_square = 0;
        for (int i = 0; i < pairs; ++i) {
            const double before = random.gamma(0.5 * zeta), pool = before - std::log(random.uniform_double());
            const double after = pool * exchange.internal_share(random.uniform_double());
            const double odd = before * after * (before - after);
            mean += after / pairs, square += after * after / pairs, normal += (pool - after) / pairs;
            skew += odd / pairs, skew_square += odd * odd / pairs;
        }
        const double shape = 0.5 * zeta, second = shape * (shape + 1), fourth = second * (shape + 2) * (shape + 3);
        EXPECT_NEAR(mean, shape, 4 * std::sqrt(shape / pairs)) << zeta;
        EXPECT_NEAR(square, second, 4 * std::sqrt((fourth - second * second) / pairs)) << zeta;
        EXPECT_NEAR(normal, 1, 4 * std::sqrt(1.0 / pairs)) << zeta;
        EXPECT_NEAR(skew, 0, 4 * std::sqrt(skew_square / pairs)) << zeta;
    }
    EXPECT_FALSE(NormalExchange(0).exchanges());
}

}  // namespace
}  // namespace corpuscle
