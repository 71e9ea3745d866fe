#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "../../unit/structure/blocks.hpp"
#include "parallel/loops.hpp"

// Bending waves and spinning bars of every element, against exact elasticity.

namespace corpuscle {
namespace {

constexpr double length = 0.4, height = 0.04, pi = std::numbers::pi;

/// A strip along x, `n` elements long and one wide, of solids (n/10 through its height) or of shells.
struct Strip {
    const char* name;
    std::function<PartDescription(int n)> part;
};

/// Solids from z = 0 to `height`, with elements as wide as long.
PartDescription solid_strip(int n, bool cut, bool full)
{
    const std::array<int, 3> counts{n, 1, n / 10};
    const Vector3d size{length, length / n, height};
    PartDescription d = block(cut ? tetrahedron_mesh(counts, size) : brick_mesh(counts, size), elastic_steel());
    d.full_integration = full;
    return d;
}

PartDescription shell_strip(int n, bool cut)
{
    Mesh mesh;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j < 2; ++j) mesh.nodes.push_back({i * length / n, j * length / n, 0});
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(n); ++i) {
        const std::uint32_t a = 2 * i, b = a + 2, c = a + 3, d = a + 1;
        if (cut) {
            mesh.elements.push_back({ElementShape::triangle, {a, b, c}});
            mesh.elements.push_back({ElementShape::triangle, {a, c, d}});
        } else {
            mesh.elements.push_back({ElementShape::quadrilateral, {a, b, c, d}});
        }
    }
    return plate(std::move(mesh), elastic_steel(), height);
}

const std::vector<Strip> strips{
    {"FourNodeShell", [](int n) { return shell_strip(n, false); }},        {"ThreeNodeShell", [](int n) { return shell_strip(n, true); }},
    {"OnePointBrick", [](int n) { return solid_strip(n, false, false); }}, {"FullBrick", [](int n) { return solid_strip(n, false, true); }},
    {"Tetrahedron", [](int n) { return solid_strip(n, true, false); }},
};

/// So few elements do not repay the threads' meeting.
class Strips : public testing::TestWithParam<Strip> {
protected:
    Strips() { set_thread_count(1); }
    ~Strips() override { set_thread_count(threads_); }

private:
    int threads_ = thread_count();
};

/// Angular frequency of the lowest bending wave of wave number k in a layer: the first root of Rayleigh's and Lamb's antisymmetric
/// relation,
///     tanh(a h) (b^2 + k^2)^2 = 4 k^2 a b tanh(b h),     a^2 = k^2 - (omega/c_l)^2,     b^2 = k^2 - (omega/c_s)^2,     h half the height.
/// A strip held across at both ends (and of no strain along its width) has it exactly, with k = pi / length.
double rayleigh_lamb(double k)
{
    const Material steel = elastic_steel();
    const double shear = steel.young_modulus / (2 * (1 + steel.poisson_ratio)), h = 0.5 * height;
    const double slow = std::sqrt(shear / steel.density),
                 fast = slow * std::sqrt(2 * (1 - steel.poisson_ratio) / (1 - 2 * steel.poisson_ratio));
    const auto mismatch = [&](double omega) {
        const double a = std::sqrt(k * k - omega * omega / (fast * fast)), b = std::sqrt(k * k - omega * omega / (slow * slow));
        return std::tanh(a * h) * std::pow(b * b + k * k, 2) - 4 * k * k * a * b * std::tanh(b * h);
    };
    const double kirchhoff =
        k * k * h * std::sqrt(steel.young_modulus / (3 * (1 - steel.poisson_ratio * steel.poisson_ratio) * steel.density));
    double low = 0.5 * kirchhoff, high = kirchhoff;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        ((mismatch(middle) > 0) == (mismatch(low) > 0) ? low : high) = middle;
    }
    return low;
}

/// Angular frequency of the strip's bending between its held ends: from the zeros of what its motion has in common with sin(k x).
double measured_frequency(const Strip& strip, int n)
{
    const double k = pi / length;
    PartDescription d = strip.part(n);
    Hold ends, sides;
    for (std::uint32_t i = 0; i < d.mesh.nodes.size(); ++i) {
        const double x = d.mesh.nodes[i].x;
        sides.nodes.push_back(i);
        if (x == 0 || std::abs(x - length) < 1e-12) ends.nodes.push_back(i);
    }
    ends.translation.z = true;
    sides.translation.y = sides.rotation.x = sides.rotation.z = true;
    d.holds = {ends, sides};
    Structure s;
    add_part(s, d);
    Nodes& nodes = s.nodes;
    const double middle = d.element == ElementKind::solid ? 0.5 * height : 0.0, speed = 0.01;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Vector3d& at = nodes.reference[i];
        const double slope = speed * k * std::cos(k * at.x);
        const bool end = nodes.inverse_mass[i].z == 0;
        nodes.velocity[i] = {-(at.z - middle) * slope, 0, end ? 0.0 : speed * std::sin(k * at.x)};
        nodes.angular_velocity[i] = {0, -slope, 0};
    }
    const auto shape = [&] {
        double sum = 0;
        for (std::size_t i = 0; i < nodes.size(); ++i) sum += nodes.mass[i] * nodes.velocity[i].z * std::sin(k * nodes.reference[i].x);
        return sum;
    };
    Clock clock;
    std::vector<double> zeros;
    double before = shape();
    const double duration = 0.9 * stable_step(s);
    while (zeros.size() < 7) {
        step(s, clock, duration);
        const double now = shape();
        if ((now > 0) != (before > 0)) zeros.push_back(clock.time() - duration * now / (now - before));
        before = now;
    }
    return 6 * pi / (zeros.back() - zeros.front());
}

/// Frequencies are of second order in the elements' size, so those of two meshes tell that of none. Left are fourth order, (1/10)^4 of
/// order one, what central difference adds, (omega dt)^2/24 < 1e-5, and of shells what theory of plates is off: the shear factor 5/6 for a
/// layer that shears, of order (k h)^2/100 = 2e-3 and less.
TEST_P(Strips, BendAsRayleighAndLambSay)
{
    const double exact = rayleigh_lamb(pi / length);
    const double coarse = measured_frequency(GetParam(), 20), fine = measured_frequency(GetParam(), 40);
    const double extrapolated = (4 * fine - coarse) / 3;
    std::printf("%s: %.5f %.5f of the exact frequency, extrapolated %.5f\n", GetParam().name, coarse / exact, fine / exact,
                extrapolated / exact);
    EXPECT_NEAR(extrapolated / exact, 1.0, 3e-3);
    EXPECT_LT(std::abs(fine / exact - 1), std::max(3e-3, 0.4 * std::abs(coarse / exact - 1)));
}

/// A bar set spinning about its middle, unstretched: it swings about the stretch (rho omega^2 length^2 / (12 E)) in which every part is
/// held on its circle. Its mean over whole periods is that stretch, to the share of lateral inertia and of the second order in the
/// elements' size (1/20)^2; angular momentum lost to stretch is 1e-4. With a steady step no energy is made.
TEST_P(Strips, SpinningBarIsStretchedAndGainsNoEnergy)
{
    const Material steel = elastic_steel();
    const double spin = 400, exact = steel.density * spin * spin * length * length / (12 * steel.young_modulus);
    Structure s;
    add_part(s, GetParam().part(20));
    Nodes& nodes = s.nodes;
    Vector3d center;
    for (const Vector3d& place : nodes.reference) center += place / static_cast<double>(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        nodes.angular_velocity[i] = {0, 0, spin};
        nodes.velocity[i] = cross(nodes.angular_velocity[i], nodes.reference[i] - center);
    }
    std::uint32_t first = 0, last = 0;
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        const Vector3d& at = nodes.reference[i];
        if (at.x + at.y + at.z < nodes.reference[first].x + nodes.reference[first].y + nodes.reference[first].z) first = i;
        if (at.x - at.y - at.z > nodes.reference[last].x - nodes.reference[last].y - nodes.reference[last].z) last = i;
    }
    const double start = energy(s).kinetic, duration = 0.9 * stable_step(s),
                 period = 2 * length / std::sqrt(steel.young_modulus / steel.density);
    const int steps = static_cast<int>(20 * period / duration);
    double sum = 0, weights = 0, made = 0;
    Clock clock;
    for (int i = 0; i < steps; ++i) {
        step(s, clock, duration);
        const double weight = 1 - std::cos(2 * pi * (i + 0.5) / steps);  // fades in and out, so that no part of a period counts
        sum += weight * (norm(nodes.position[last] - nodes.position[first]) / length - 1);
        weights += weight;
        if (i % 50 == 0) made = std::max(made, std::abs(energy(s).integration - work_in_transit(s, duration)) / start);
    }
    std::printf("%s: %.4f of the stretch, %.1e of the energy made\n", GetParam().name, sum / weights / exact, made);
    EXPECT_NEAR(sum / weights / exact, 1.0, 0.02);
    EXPECT_NEAR(energy(s).total(), start, 1e-10 * start);
    EXPECT_LT(made, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Elements, Strips, testing::ValuesIn(strips), [](const auto& chosen) { return chosen.param.name; });

}  // namespace
}  // namespace corpuscle
