#include "input/spherical_start.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../../unit/input/spherical_plate.hpp"
#include "input/build.hpp"
#include "laws/blast/kingery_bulmash.hpp"

using namespace corpuscle;

namespace {

/// What a species holds, momentum outward from the charge.
struct Content {
    double mass = 0, outward = 0, energy = 0;
};

Content content_of(const Gas& gas, std::uint32_t species, const Vector3d& center)
{
    Content sum;
    for (const Particle& p : gas.particles) {
        if (particle_tag::species(p.tag) != species) continue;
        const double mass = gas.species[species].particle_mass;
        const Vector3d velocity(p.velocity);
        sum.mass += mass;
        sum.outward += mass * dot(velocity, normalized(Vector3d(p.position) - center));
        sum.energy += 0.5 * mass * norm_squared(velocity) + p.energy;
    }
    return sum;
}

}  // namespace

TEST(SphericalStart, BeginsBeforeThePlateWithMassMomentumAndEnergyOfTheFlow)
{
    const CaseDescription description = spherical_plate();
    CaseSurvey survey = survey_case(description);
    ASSERT_TRUE(survey.gas->start.has_value());
    const SphericalStart start = *survey.gas->start;
    const double ambient_energy = survey.gas->gas.ambient.pressure / (0.4 * 1.2), share = 0.25;
    EXPECT_DOUBLE_EQ(start.obstacle, 0.7);
    EXPECT_LT(start.front, 0.7);
    EXPECT_GT(start.front, 0.9 * 0.7);
    // The empirical curves carry 15 to 25 % themselves so near the charge.
    EXPECT_NEAR(start.time / kingery_bulmash(Burst::spherical, 15, start.front).arrival, 1, 0.2);
    const auto air_particles = static_cast<double>(survey.gas->counts[0]);
    const auto model = build(description, survey);
    EXPECT_DOUBLE_EQ(model->start_time, start.time);
    const Gas& gas = model->gas;
    EXPECT_EQ(contents(gas).explosive.mass, 0);
    EXPECT_EQ(gas.charges[0].unburnt, 0u);
    const Vector3d center{0, 0, 0.7};
    const Content products = content_of(gas, 1, center), air = content_of(gas, 0, center);
    // Velocities and energies of particles are single: 6e-8 each, at random.
    EXPECT_NEAR(products.mass / (15 * share), 1, 1e-9);
    EXPECT_NEAR(products.outward / (share * start.gas[0].momentum), 1, 1e-6);
    EXPECT_NEAR(products.energy / (share * start.gas[0].energy), 1, 1e-7);
    const double particle_mass = gas.species[0].particle_mass;
    EXPECT_NEAR(air.mass / particle_mass, air_particles, 1e-6);
    const double still = air.mass - particle_mass * static_cast<double>(start.inner_particles);
    EXPECT_NEAR(air.energy / (share * start.gas[1].energy + still * ambient_energy), 1, 1e-7);
    // Air from outside the blast has no mean velocity, but its outward part is only so by chance: 4 sigma.
    const double chance = 4 * std::sqrt(0.4 * ambient_energy * still * particle_mass);
    EXPECT_NEAR(air.outward, share * start.gas[1].momentum, chance);
    // Nothing was made: the explosive's energy and that of the air it has taken up.
    const double all = start.gas[0].energy + start.gas[1].energy;
    EXPECT_NEAR(all / (15 * 7e9 / 1630 + start.gas[1].mass * ambient_energy), 1, 1e-9);
}

TEST(SphericalStart, StartsLaterWhereTheChargeIsLitLater)
{
    const double first = survey_case(spherical_plate()).gas->start->time;
    const CaseSurvey late = survey_case(spherical_plate({"charge.0.detonation.0.time=\"1 ms\""}));
    EXPECT_NEAR(late.gas->start->time, first + 1e-3, 1e-12);
}
