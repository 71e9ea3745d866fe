#include "laws/collision/larsen_borgnakke.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "math/random.hpp"

namespace corpuscle {
namespace {

constexpr int draws = 200000;
const std::vector<double> freedoms{0.5, 2, 11.0 / 3, 10};

/// Moments of Beta(b, 2), b = zeta/2: E[x^k] = b (b + 1)/((b + k) (b + k + 1)).
TEST(LarsenBorgnakke, internal_share_has_the_moments_of_its_beta_law)
{
    for (const double zeta : freedoms) {
        const LarsenBorgnakke law(zeta);
        const double b = 0.5 * zeta;
        const auto moment = [b](int k) { return b * (b + 1) / ((b + k) * (b + k + 1)); };
        Random random(8, Purpose::collide, 0, 0);
        std::array<double, 3> sum{};
        for (int i = 0; i < draws; ++i) {
            const float first = random.uniform();
            const double share = static_cast<double>(law.internal_share(first, random.uniform()));
            ASSERT_GE(share, 0);
            ASSERT_LE(share, 1);
            for (int k = 1; k <= 3; ++k) sum[k - 1] += std::pow(share, k) / draws;
        }
        for (int k = 1; k <= 3; ++k) {
            const double sigma = std::sqrt((moment(2 * k) - moment(k) * moment(k)) / draws);
            EXPECT_NEAR(sum[k - 1], moment(k), 4 * sigma + 1e-6) << "zeta " << zeta << ", moment " << k;  // 1e-6: floats
        }
    }
}

TEST(LarsenBorgnakke, atoms_exchange_nothing)
{
    EXPECT_FALSE(LarsenBorgnakke(0).exchanges());
    EXPECT_FALSE(LarsenBorgnakke().exchanges());
    EXPECT_TRUE(LarsenBorgnakke(0.01).exchanges());
    EXPECT_EQ(exchange_stretch(0), 1);
}

/// The relative energy of pairs that collide is Gamma(2) distributed at equilibrium and the internal energy Gamma(zeta/2), in kT:
/// an exchange keeps both laws.
TEST(LarsenBorgnakke, keeps_equilibrium)
{
    for (const double zeta : freedoms) {
        const LarsenBorgnakke law(zeta);
        Random random(9, Purpose::collide, 0, 0);
        double mean = 0, squared = 0;
        for (int i = 0; i < draws; ++i) {
            const double pool = random.gamma(2) + random.gamma(0.5 * zeta);
            const float first = random.uniform();
            const double after = pool * static_cast<double>(law.internal_share(first, random.uniform()));
            mean += after / draws;
            squared += after * after / draws;
        }
        const double k = 0.5 * zeta, fourth = k * (k + 1) * (k + 2) * (k + 3);
        EXPECT_NEAR(mean, k, 4 * std::sqrt(k / draws)) << "zeta " << zeta;
        EXPECT_NEAR(squared, k * (k + 1), 4 * std::sqrt((fourth - k * k * (k + 1) * (k + 1)) / draws)) << "zeta " << zeta;
    }
}

/// |g' - g| averaged over the angle between them: midpoint rule over its cosine, error of order 1/n^2 (n^-3/2 where both are equal).
TEST(LarsenBorgnakke, mean_velocity_change_is_the_mean_over_directions)
{
    for (const double after : {0.0, 0.3, 1.0, 2.7}) {
        double mean = 0;
        constexpr int points = 20000;
        for (int i = 0; i < points; ++i) {
            const double cosine = 2 * (i + 0.5) / points - 1;
            mean += std::sqrt(1 + after * after - 2 * after * cosine) / points;
        }
        EXPECT_NEAR(mean_velocity_change(1, after), mean, 1e-6);
        EXPECT_NEAR(mean_velocity_change(after, 1), mean, 1e-6);
    }
    EXPECT_EQ(mean_velocity_change(0, 0), 0);
}

/// The same by drawing pairs, energies, shares and directions; beside 4 sigma the 1e-3 of the sum's 64 points at small zeta.
TEST(LarsenBorgnakke, exchange_stretch_is_that_of_drawn_exchanges)
{
    for (const double zeta : {1.0, 2.0, 11.0 / 3, 7.0}) {
        const LarsenBorgnakke law(zeta);
        Random random(10, Purpose::collide, 0, 0);
        double changed = 0, kept = 0, squared = 0;
        const double expected = exchange_stretch(zeta);
        for (int i = 0; i < draws; ++i) {
            const double before = random.gamma(2), pool = before + random.gamma(0.5 * zeta);
            const float first = random.uniform();
            const double after = pool * (1 - static_cast<double>(law.internal_share(first, random.uniform())));
            const double cosine = 2 * random.uniform_double() - 1;
            const double change = std::sqrt(std::max(0.0, before + after - 2 * std::sqrt(before * after) * cosine));
            const double plain = 4.0 / 3 * std::sqrt(before);
            changed += change / draws;
            kept += plain / draws;
            squared += (change - expected * plain) * (change - expected * plain) / draws;
        }
        const double sigma = std::sqrt(squared / draws) / kept;
        EXPECT_NEAR(changed / kept, expected, 4 * sigma + 1e-3) << "zeta " << zeta;
    }
}

}  // namespace
}  // namespace corpuscle
