#include "gas/fill.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "base/error.hpp"
#include "gas/faces.hpp"
#include "gas_samples.hpp"
#include "mesh/shape.hpp"

namespace corpuscle {
namespace {

/// Half a unit of the last place of a float, relative.
constexpr double float_rounding = 0x1p-24;

/// A closed tetrahedron.
Shape tetrahedron()
{
    Mesh mesh;
    mesh.nodes = {{0.1, 0.1, 0.1}, {0.9, 0.1, 0.1}, {0.1, 0.9, 0.1}, {0.1, 0.1, 0.9}};
    constexpr ElementShape triangle = ElementShape::triangle;
    mesh.elements = {{triangle, {0, 2, 1}}, {triangle, {0, 1, 3}}, {triangle, {0, 3, 2}}, {triangle, {1, 2, 3}}};
    return Shape::surface(mesh, "tetrahedron");
}

struct Region {
    const char* name;
    Shape shape;
    std::vector<Shape> cut_by;
    double volume;  ///< of the part in the unit box, by geometry
};

std::vector<Region> regions()
{
    using std::numbers::pi;
    return {{"box", Shape::box({{0.2, 0.1, 0.3}, {0.7, 0.9, 0.5}}), {}, 0.5 * 0.8 * 0.2},
            {"box beyond the domain", Shape::box({{-1, 0.5, 0.25}, {0.5, 7, 0.75}}), {}, 0.125},
            {"sphere", Shape::sphere({0.5, 0.5, 0.5}, 0.3), {}, 4 * pi / 3 * 0.027},
            {"octant of a sphere", Shape::sphere({0, 0, 0}, 0.8), {}, pi / 6 * 0.512},
            {"hemisphere", Shape::hemisphere({0.5, 0.5, 0.5}, 0.4, {0, 0, 1}), {}, 2 * pi / 3 * 0.064},
            {"cylinder", Shape::cylinder({0.5, 0.5, 0.5}, 0.2, 0.6, {1, 0, 0}), {}, pi * 0.04 * 0.6},
            {"ellipsoid", Shape::ellipsoid({0.5, 0.5, 0.5}, {0.4, 0.2, 0.1}), {}, 4 * pi / 3 * 0.008},
            {"surface", tetrahedron(), {}, 0.512 / 6},
            {"box cut by a sphere", Shape::box(unit_box), {Shape::sphere({0.5, 0.5, 0.5}, 0.4)}, 1 - 4 * pi / 3 * 0.064},
            {"box cut by two",
             Shape::box(unit_box),
             {Shape::sphere({0, 0, 0}, 0.3), Shape::box({{0.6, 0.6, 0.6}, {2, 2, 2}})},
             1 - pi / 6 * 0.027 - 0.064}};
}

/// A gas with one fill of a region of the unit box.
Gas filled(const Region& region, std::size_t count, const Vector3d& velocity, const EquationOfState& law = IdealGas{1.3})
{
    Gas gas;
    gas.domain.box = unit_box;
    gas.species.push_back(species_of(law, 1e-3));
    fill(gas, {region.shape, region.cut_by, 0, 1e-3 * static_cast<double>(count) / region.volume, 3e5, velocity, -1}, count);
    return gas;
}

TEST(Fill, knows_the_volume_of_its_region)
{
    for (const Region& region : regions())
        EXPECT_NEAR(volume({region.shape, region.cut_by, 0, 1, 1, {}, -1}, {unit_box, {}}), region.volume, 1e-8 * region.volume)
            << region.name;
}

/// Two equal balls of radius r, d apart, share a lens of volume pi (4 r + d) (2 r - d)^2/12. Where cuts overlap the volume is counted
/// with one random point in each of 1e7 cells: those on the surface, 1e7^(2/3) an area of 1, leave a standard error of 1e-5 of the box.
TEST(Fill, counts_overlapping_cuts_once)
{
    const double r = 0.25, d = 0.2, lens = std::numbers::pi * (4 * r + d) * (2 * r - d) * (2 * r - d) / 12;
    const Fill air{Shape::box(unit_box), {Shape::sphere({0.4, 0.5, 0.5}, r), Shape::sphere({0.6, 0.5, 0.5}, r)}, 0, 1, 1, {}, -1};
    EXPECT_NEAR(volume(air, {unit_box, {}}), 1 - 2 * 4 * std::numbers::pi / 3 * r * r * r + lens, 4e-5);
}

TEST(Fill, puts_the_count_asked_for_into_its_region)
{
    for (const Region& region : regions()) {
        for (const std::size_t count : {1u, 777u, 5000u}) {
            const Gas gas = filled(region, count, {});
            ASSERT_EQ(gas.particles.size(), count) << region.name;
            for (const Particle& p : gas.particles) {
                // A float may round a place over the boundary: look for a place within its rounding that belongs.
                const Vector3d place(p.position), inward = 1e-6 * (region.shape.bounds().center() - place);
                ASSERT_TRUE(unit_box.contains(place)) << region.name;
                ASSERT_TRUE(region.shape.contains(place) || region.shape.contains(place + inward)) << region.name;
                for (const Shape& cut : region.cut_by)
                    ASSERT_FALSE(cut.contains(place) && cut.contains(place - 1e-6 * (cut.bounds().center() - place)));
            }
        }
    }
}

/// Momentum and both energies are those asked for, up to the rounding of each particle's floats.
TEST(Fill, has_exact_momentum_and_energies)
{
    for (const Vector3d& velocity : {Vector3d{}, Vector3d{300, -100, 50}}) {
        for (const Region& region : regions()) {
            const std::size_t count = 3001;
            const Gas gas = filled(region, count, velocity);
            const Passage held = contents(gas).gas;
            const double mass = 1e-3 * static_cast<double>(count), heat = mass * 3e5, motion = 0.5 * mass * norm_squared(velocity);
            EXPECT_NEAR(held.mass, mass, 1e-12 * mass);
            EXPECT_LE(norm(held.momentum - mass * velocity), float_rounding * std::sqrt(3.0) * speed_sum(gas)) << region.name;
            EXPECT_NEAR(held.energy, motion + heat, 4 * float_rounding * (motion + heat)) << region.name;
            double internal = 0;
            for (const Particle& p : gas.particles) internal += static_cast<double>(p.energy);
            EXPECT_NEAR(internal, heat * (1 - translational_share(1.3)), float_rounding * heat) << region.name;
        }
    }
}

/// Components are normal (kurtosis 3; twins of opposite velocity count once), internal energies follow Gamma(zeta/2): variance 2/zeta.
TEST(Fill, has_the_laws_of_equilibrium)
{
    for (const double gamma : {1.2, 1.3, 1.4, 5.0 / 3}) {
        const std::size_t count = 40000;
        const Gas gas = filled(regions()[0], count, {}, IdealGas{gamma});
        const double variance = (gamma - 1) * 3e5, number = static_cast<double>(count);
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<double> component;
            for (const Particle& p : gas.particles) component.push_back(static_cast<double>(p.velocity[axis]));
            EXPECT_NEAR(Statistics(component).variance, variance, 4 * variance * std::sqrt(4 / number));
            EXPECT_NEAR(Statistics(component).kurtosis, 3, 4 * std::sqrt(48 / number));
        }
        const double shape = 0.5 * gas.species[0].internal_freedoms;
        std::vector<double> internal;
        for (const Particle& p : gas.particles) internal.push_back(static_cast<double>(p.energy));
        const Statistics energy(internal);
        if (shape < 1e-9) {
            EXPECT_EQ(energy.mean, 0);
        } else {
            EXPECT_NEAR(energy.variance / (energy.mean * energy.mean), 1 / shape, 4 / shape * std::sqrt((2 + 6 / shape) / number)) << gamma;
        }
    }
}

/// Variance of the particle count over the mean, in boxes that do not fit the lattice.
double variance_of_counts(const Gas& gas, int boxes)
{
    std::vector<double> counts(boxes * boxes * boxes);
    for (const Particle& p : gas.particles) {
        std::array<int, 3> index{};
        for (int a = 0; a < 3; ++a) index[a] = std::min(boxes - 1, static_cast<int>(p.position[a] * static_cast<float>(boxes)));
        counts[(index[2] * boxes + index[1]) * boxes + index[0]] += 1;
    }
    const Statistics statistics(counts);
    return statistics.variance / statistics.mean;
}

/// In a lattice of spacing 1 a box of side s cuts 6 s^2 cells, which are in it with a chance p, even between 0 and 1: variance
/// mean p (1 - p) = 1/6 each, so s^2 where random places have s^3. Its estimate from n boxes is uncertain by sqrt(2/n).
TEST(Fill, starts_quietly)
{
    const Gas gas = filled({"box", Shape::box(unit_box), {}, 1}, 32768, {});
    const double side = 32.0 / 7;
    EXPECT_LT(variance_of_counts(gas, 7), 1 / side * (1 + 4 * std::sqrt(2 / 343.0)));
    // Aligned with the lattice: every box holds exactly its share.
    EXPECT_EQ(variance_of_counts(gas, 16), 0);
}

/// Where the region is round, a few random places make up the count: the density is even, to its noise, half against half.
TEST(Fill, is_even_over_round_regions)
{
    for (const Region& region : regions()) {
        const std::size_t count = 20000;
        const Gas gas = filled(region, count, {});
        const Box bounds = region.shape.bounds();
        for (int axis = 0; axis < 3; ++axis) {
            Box half = unit_box;
            half.upper[axis] = 0.5 * (std::max(0.0, bounds.lower[axis]) + std::min(1.0, bounds.upper[axis]));
            double share = volume({Shape::box(half), region.cut_by, 0, 1, 1, {}, -1}, {half, {}});
            if (region.cut_by.empty()) share = region.shape.volume_within(half);
            share /= region.volume;
            const auto below = std::count_if(gas.particles.begin(), gas.particles.end(),
                                             [&](const Particle& p) { return half.contains(Vector3d(p.position)); });
            const double number = static_cast<double>(count);
            // Never noisier than random places.
            EXPECT_NEAR(static_cast<double>(below) / number, share, 4 * std::sqrt(share * (1 - share) / number)) << region.name;
        }
    }
}

TEST(Fill, later_fills_have_numbers_of_their_own)
{
    Gas gas;
    gas.domain.box = unit_box;
    gas.species.push_back(species_of(IdealGas{1.4}, 1e-4));
    const Shape ball = Shape::sphere({0.5, 0.5, 0.5}, 0.2);
    fill(gas, {Shape::box(unit_box), {ball}, 0, 1.2, 2e5, {}, -1}, 1000);
    fill(gas, {ball, {}, 0, 2.4, 2e5, {}, -1}, 1000);
    for (std::size_t i = 0; i < 1000; ++i) ASSERT_FALSE(gas.particles[i].velocity == gas.particles[1000 + i].velocity);
    EXPECT_EQ(
        std::count_if(gas.particles.begin(), gas.particles.end(), [&](const Particle& p) { return ball.contains(Vector3d(p.position)); }),
        1000);
}

TEST(Fill, refuses_regions_without_room)
{
    Gas gas;
    gas.domain.box = unit_box;
    gas.species.push_back(species_of(IdealGas{1.4}, 1e-4));
    EXPECT_THROW(fill(gas, {Shape::sphere({0.5, 0.5, 0.5}, 0.1), {Shape::box({{-1, -1, -1}, {2, 2, 2}})}, 0, 1, 1, {}, -1}, 10),
                 InputError);
    EXPECT_THROW(fill(gas, {Shape::sphere({5, 5, 5}, 0.1), {}, 0, 1, 1, {}, -1}, 10), InputError);
    EXPECT_TRUE(gas.particles.empty());
}

TEST(ShareParticles, gives_all_and_to_each_its_share)
{
    for (const std::vector<double>& masses : {std::vector<double>{1, 1, 1}, {15, 1.2, 0.003}, {1e-9, 5}, {3}}) {
        double whole = 0;
        for (const double m : masses) whole += m;
        for (const std::size_t total : {1u, 10u, 99'999u}) {
            const std::vector<std::size_t> counts = share_particles(masses, total);
            ASSERT_EQ(counts.size(), masses.size());
            std::size_t given = 0;
            for (std::size_t i = 0; i < masses.size(); ++i) {
                given += counts[i];
                EXPECT_NEAR(static_cast<double>(counts[i]), static_cast<double>(total) * masses[i] / whole, 1.0 + 1e-9);
            }
            EXPECT_EQ(given, total);
        }
    }
}

}  // namespace
}  // namespace corpuscle
