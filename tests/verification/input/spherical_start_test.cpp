#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>

#include "../../unit/gas/gas_samples.hpp"
#include "../../unit/scratch_folder.hpp"
#include "input/build.hpp"
#include "input/case/read_case.hpp"
#include "input/presets.hpp"

namespace corpuscle {
namespace {

/// An octant of 15 kg of an explosive whose products are an ideal gas, in a small cube of air.
const char* const case_text = R"(end_time = "1 ms"
[[charge]]
explosive = { name = "ideal", density = 1630.0, energy_density = 7.0e9, detonation_velocity = 6930.0, law = { ideal = { gamma = 1.3 } } }
shape = "sphere"
mass = "15 kg"
center = [0, 0, 0]
[gas]
box = [[0, 0.33], [0, 0.33], [0, 0.33]]
edges = { x = ["rigid", "ambient"], y = ["rigid", "ambient"], z = ["rigid", "ambient"] }
particles = { products = 30_000, air = 5_000 }
fill = "air"
)";

struct Motion {
    double momentum = 0;  ///< outward [kg m/s]
    double radius = 0;    ///< mean over the mass [m]
};

Motion motion_of_products(const Gas& gas)
{
    Motion motion;
    double mass = 0;
    for (const Particle& p : gas.particles) {
        if (particle_tag::species(p.tag) != gas.charges[0].species) continue;
        const double own = gas.species[gas.charges[0].species].particle_mass, r = norm(Vector3d(p.position));
        motion.momentum += own * dot(Vector3d(p.velocity), Vector3d(p.position)) / r;
        motion.radius += own * r;
        mass += own;
    }
    motion.radius /= mass;
    return motion;
}

/// The same blast by particles from the start and by particles that begin from one dimension, at the time these begin and a fifth later.
/// Products are an ideal gas, so that the particles' dense phase is as right as their laws: momentum outward within 4 sigma of the thermal
/// motion of n particles, m s sqrt(n), s a component's speed before expansion (which cools), and 1 % for the viscosity of a mean free path
/// of 3 mm in a ball of 130 mm that expands threefold.
TEST(SphericalStart, goes_on_as_particles_from_the_start_would)
{
    const ScratchFolder folder;
    std::ofstream(folder.path() / "case.toml") << case_text;
    const auto read = [&](const char* start) {
        CaseDescription description = read_case(folder.path() / "case.toml", {std::string("gas.start=\"") + start + "\""});
        resolve_presets(description, {std::filesystem::path(CORPUSCLE_SOURCE_DIR) / "share"});
        return description;
    };
    const auto whole = build(read("detonation")), late = build(read("spherical"));
    Gas &all = whole->gas, &rest = late->gas;
    const double particle_mass = all.species[1].particle_mass;
    const double chance = 4 * particle_mass * std::sqrt(0.3 * 7e9 / 1630) * std::sqrt(30000.0);
    Clock clock, late_clock;
    late_clock.restore(late->start_time, 0, 0, 0);
    for (const double factor : {1.0, 1.2}) {
        const double time = factor * late->start_time;
        while (clock.time() < time * (1 - 1e-12)) advance(all, clock, time - clock.time());
        while (late_clock.time() < time * (1 - 1e-12)) advance(rest, late_clock, time - late_clock.time());
        const Motion first = motion_of_products(all), second = motion_of_products(rest);
        std::printf("%.4f ms: momentum %.1f and %.1f (chance %.1f) N s, mean radius %.4f and %.4f m\n", 1e3 * time, first.momentum,
                    second.momentum, chance, first.radius, second.radius);
        EXPECT_NEAR(first.momentum, second.momentum, chance + 0.01 * second.momentum);
        EXPECT_NEAR(first.radius / second.radius, 1, 0.01);
    }
}

}  // namespace
}  // namespace corpuscle
