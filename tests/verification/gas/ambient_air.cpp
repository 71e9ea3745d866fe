#include <gtest/gtest.h>

#include <cstdio>

#include "../../unit/gas/gas_samples.hpp"
#include "gas/sample.hpp"

namespace corpuscle {
namespace {

/// Still air in a cube of 1 m with six ambient edges, 10 ms: its pressure and mass must stay. Energy 0.253 MJ/m3, so 101.2 kPa.
///
/// Noise: the number N of particles in the open box fluctuates by sqrt(N), the kinetic pressure by sqrt(5/3/N) (number and speeds):
/// 0.53 % at 6e4. Fluctuations leave as sound within a crossing time, 1 m/343 m/s = 2.9 ms, so the mean of 10 ms averages about 4
/// of them: 0.26 %, and 1 % is 4 sigma. A moment's values are held to 1 % and 3 sigma more.
TEST(AmbientAir, holds_its_pressure_and_mass)
{
    constexpr double density = 1.2, energy = 0.253e6 / density, pressure = 0.4 * 0.253e6, end = 0.01;
    constexpr std::size_t count = 60000;
    Gas gas = filled_box(unit_box, IdealGas{1.4}, density, energy, count);
    gas.domain.edges.fill(Edge::ambient);
    gas.ambient = ambient_like(gas.species[0], density, energy);
    const double speck = 1 / std::sqrt(static_cast<double>(count)), initial = contents(gas).gas.energy;
    const Shape whole = Shape::box(unit_box);
    double mean_pressure = 0, mean_mass = 0, least = 2, most = 0;
    Clock clock;
    while (clock.time() < end) {
        advance(gas, clock, end - clock.time() + 1e-12);
        const GasSample now = sample(gas, whole, 1);
        mean_pressure += now.pressure / pressure * clock.duration() / end;
        mean_mass += now.density / density * clock.duration() / end;
        least = std::min(least, now.pressure / pressure);
        most = std::max(most, now.pressure / pressure);
        ASSERT_NEAR(now.density / density, 1, 0.01 + 3 * speck) << "at " << clock.time();
        ASSERT_NEAR(now.pressure / pressure, 1, 0.01 + 3 * std::sqrt(5.0 / 3) * speck) << "at " << clock.time();
        ASSERT_LT(norm(now.velocity), 4 * std::sqrt(pressure / density) * std::sqrt(3.0) * speck) << "at " << clock.time();
    }
    std::printf("%llu steps: mean pressure %.4f of 101.2 kPa (%.4f to %.4f), mean mass %.4f\n",
                static_cast<unsigned long long>(clock.step()), mean_pressure, least, most, mean_mass);
    EXPECT_NEAR(mean_pressure, 1, 0.01);
    EXPECT_NEAR(mean_mass, 1, 0.01);

    // What is there is what was there, less what the faces took: a face has turned the whole gas over several times by now.
    Passage given;
    for (const Passage& passage : gas.passages.face) given += passage;
    const Passage held = contents(gas).gas;
    EXPECT_NEAR(held.mass + given.mass, density, 1e-9 * density);
    EXPECT_NEAR(held.energy + given.energy, initial, 1e-5 * initial);
}

}  // namespace
}  // namespace corpuscle
