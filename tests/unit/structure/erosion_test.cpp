#include "structure/erosion.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "blocks.hpp"

namespace corpuscle {
namespace {

/// Energy as the books have it after a step. [J]
double held(const Structure& s, double duration)
{
    const StructureEnergy e = energy(s);
    double work = 0;
    for (std::uint32_t i = 0; i < s.nodes.size(); ++i)
        work += 0.5 * duration * (dot(s.nodes.force[i], s.nodes.contact_velocity(i)) + dot(s.nodes.moment[i], s.nodes.angular_velocity[i]));
    return e.kinetic + e.internal + e.hourglass + work;
}

/// Momentum as the books have it: with the impulses that wait for the support of the pinned node 0.
Vector3d momentum_held(const Structure& s)
{
    return momentum(s) + s.nodes.impulse[0];
}

/// Takes `d` through some steps with some nodes thrown about, then through one more step with and without an erosion limit that a part
/// of its elements is beyond: what the two differ by is what the books say has left.
void expect_books_close(PartDescription d, double limit)
{
    Structure whole;
    d.velocity = {3.0, -2.0, 5.0};
    d.holds = {pin({0})};
    add_part(whole, d);
    Nodes& n = whole.nodes;
    for (std::size_t i = 0; i < n.size(); ++i)
        if (n.reference[i].x > 0.3) n.impulse[i] = n.mass[i] * Vector3d{150.0, 20.0, -30.0};
    Clock clock;
    for (int i = 0; i < 40; ++i) step(whole, clock, 0.5 * stable_step(whole));
    for (std::size_t i = 0; i < n.size(); ++i)
        n.impulse[i] = 0.1 * n.mass[i] * Vector3d{1.0 + static_cast<double>(i), -2.0, 0.5};  // uneven
    Structure torn = whole;
    torn.parts[0].erosion.plastic_strain = limit;
    torn.parts[0].erodes = true;
    const double duration = 0.5 * stable_step(whole);
    std::vector<Transfer> gone;
    for (Structure* s : {&whole, &torn}) {
        Clock own = clock;
        own.begin_step(duration);
        accelerate(*s, own);
        for (std::size_t i = 0; i < n.size(); ++i)
            s->nodes.impulse[i] += 0.05 * n.mass[i] * Vector3d{-1.0, 1.0 + static_cast<double>(i), 3.0};  // contacts push, then resist
        gone = resist(*s, own);
    }
    ASSERT_EQ(gone.size(), 1u);
    EXPECT_EQ(gone[0].to, "eroded");
    EXPECT_GT(torn.eroded.elements, 0);
    EXPECT_LT(torn.eroded.elements, torn.element_count());
    const auto mass = [](const Structure& s) {
        double sum = 0;
        for (const double m : s.nodes.mass) sum += m;
        return sum;
    };
    EXPECT_NEAR(mass(whole) - mass(torn), gone[0].mass, 1e-12 * mass(whole));
    const double energy_held = held(whole, duration);
    EXPECT_NEAR(held(whole, duration) - held(torn, duration), gone[0].energy, 1e-12 * energy_held);
    const Vector3d left = momentum_held(whole) - momentum_held(torn) - gone[0].momentum;
    EXPECT_LT(norm(left), 1e-12 * norm(momentum(whole)));
    EXPECT_NEAR(energy(torn).integration, energy(whole).integration, 1e-12 * energy_held);
    for (std::size_t i = 0; i < n.size(); ++i) {
        if (torn.nodes.mass[i] > 0) continue;
        EXPECT_EQ(norm(torn.nodes.velocity[i]) + norm(torn.nodes.force[i]) + norm(torn.nodes.impulse[i]), 0.0);
    }
    Clock later = clock;  // and it goes on, in balance
    const double total = energy(torn).total();
    for (int i = 0; i < 20; ++i) step(torn, later, duration);
    const double further = torn.eroded.mass > gone[0].mass ? energy_held : 0.0;  // what erodes later takes energy along
    EXPECT_NEAR(energy(torn).total(), total, 1e-9 * energy_held + further);
    EXPECT_TRUE(std::isfinite(energy(torn).total()));
}

Material soft_steel()
{
    return {"soft", 7838.0, 212e9, 0.28, BilinearPlastic{200e6, 500e6, 0.0, 1.0, 0.0}};
}

TEST(Erosion, BooksOfShellsClose)
{
    expect_books_close(plate(square_mesh(6, 0.6), soft_steel(), 0.01), 0.002);
}

TEST(Erosion, BooksOfTrianglesClose)
{
    expect_books_close(plate(triangle_mesh(6, 0.6), soft_steel(), 0.01), 0.002);
}

TEST(Erosion, BooksOfSolidsClose)
{
    expect_books_close(block(brick_mesh({6, 2, 2}, {0.6, 0.2, 0.2}), soft_steel()), 0.002);
    expect_books_close(block(tetrahedron_mesh({6, 2, 2}, {0.6, 0.2, 0.2}), soft_steel()), 0.002);
    PartDescription full = block(brick_mesh({6, 2, 2}, {0.6, 0.2, 0.2}), soft_steel());
    full.full_integration = true;
    expect_books_close(full, 0.001);
}

TEST(Erosion, FacesBehindAnErodedBrickAppear)
{
    Structure s;
    PartDescription d = block(brick_mesh({3, 3, 3}, {0.3, 0.3, 0.3}), elastic_steel());
    d.erosion.plastic_strain = 0.1;
    add_part(s, d);
    const auto shown = [&] { return std::count(s.surface.hidden.begin(), s.surface.hidden.end(), std::uint8_t{0}); };
    EXPECT_EQ(s.surface.facets.size(), 2u * (54 + 54));
    EXPECT_EQ(shown(), 2 * 54);
    auto& bricks = std::get<Bricks>(s.parts[0].elements);
    bricks.remove(4);  // the middle of a side: its one face goes, five behind it appear
    hide_facets(s);
    EXPECT_EQ(shown(), 2 * (54 - 1 + 5));
    bricks.remove(13);  // the brick in the middle, behind it: the face between goes, five appear
    hide_facets(s);
    EXPECT_EQ(shown(), 2 * (54 - 1 + 5 - 1 + 5));
}

TEST(Erosion, WithoutLimitsOnlyOuterFacesAreListed)
{
    Structure s;
    add_part(s, block(brick_mesh({3, 3, 3}, {0.3, 0.3, 0.3}), elastic_steel()));
    EXPECT_EQ(s.surface.facets.size(), 2u * 54);
    EXPECT_FALSE(s.parts[0].erodes);
}

TEST(Erosion, ATooSmallStepErodesInsteadOfStopping)
{
    Structure s;
    PartDescription d = block(brick_mesh({4, 1, 1}, {0.4, 0.1, 0.1}), soft_steel());
    add_part(s, d);
    s.parts[0].erosion.step = 0.7 * stable_step(s);
    s.parts[0].erodes = true;
    for (const std::uint32_t i : {4u, 9u, 14u, 19u}) s.nodes.velocity[i] = {-3000.0, 0.0, 0.0};  // the last brick is crushed
    Clock clock;
    while (clock.time() < 20e-6 && s.eroded.elements == 0) step(s, clock, std::min(1e-6, stable_step(s)));
    EXPECT_GT(s.eroded.elements, 0);
}

}  // namespace
}  // namespace corpuscle
