#include "laws/riemann/general_riemann.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "laws/eos/chapman_jouguet.hpp"
#include "laws/riemann/riemann.hpp"

namespace corpuscle {
namespace {

const Jwl tnt{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630};
constexpr double tnt_energy = 7e9 / 1630;

GasSide air(double velocity = 0)
{
    return {IdealGas{1.4}, 1.2, velocity, 101325};
}

/// TNT burnt at constant volume.
GasSide products(double velocity = 0)
{
    return {tnt, 1630, velocity, tnt.pressure(1630, tnt_energy)};
}

struct Pair {
    GasSide left, right;
};

/// Products against air and against themselves: every wave pattern.
std::vector<Pair> products_and_air()
{
    const GasSide thin{tnt, 40, 0, tnt.pressure(40, 0.5 * tnt_energy)};
    return {{products(), air()}, {air(-100), products(50)}, {products(500), products(-500)}, {thin, products()}, {air(3000), thin}};
}

std::array<double, 3> conserved(const GasSide& s)
{
    return {s.density, s.density * s.velocity, s.density * (s.energy() + 0.5 * s.velocity * s.velocity)};
}

std::array<double, 3> flux(const GasSide& s)
{
    const auto q = conserved(s);
    return {q[1], q[1] * s.velocity + s.pressure, (q[2] + s.pressure) * s.velocity};
}

/// Jump of flux less speed times jump of content, each over the largest term of its own row.
double jump_error(const GasSide& a, const GasSide& b, double speed)
{
    double worst = 0;
    for (int k = 0; k < 3; ++k) {
        const std::array<double, 4> terms{flux(a)[k], flux(b)[k], speed * conserved(a)[k], speed * conserved(b)[k]};
        double scale = 0;
        for (const double term : terms) scale = std::fmax(scale, std::abs(term));
        worst = std::fmax(worst, std::abs(terms[1] - terms[0] - terms[3] + terms[2]) / scale);
    }
    return worst;
}

/// C of the JWL isentrope p = A exp(-R1 V) + B exp(-R2 V) + C V^-(1 + w), which a rarefaction keeps [Pa].
double jwl_constant(const GasSide& s)
{
    const double v = tnt.reference_density / s.density;
    return (s.pressure - tnt.a * std::exp(-tnt.r1 * v) - tnt.b * std::exp(-tnt.r2 * v)) * std::pow(v, 1 + tnt.omega);
}

/// A wave is a shock that obeys the jump conditions, or a fan that keeps the constant of its isentrope.
void expect_wave(const GasSide& ahead, const GasSide& behind, double speed)
{
    if (behind.pressure > ahead.pressure) {
        EXPECT_LT(jump_error(ahead, behind, speed), 1e-10);
    } else if (std::holds_alternative<Jwl>(ahead.law)) {
        EXPECT_NEAR(jwl_constant(behind) / jwl_constant(ahead), 1, 1e-8);
    }
}

TEST(GeneralRiemann, equals_the_closed_form_for_ideal_and_Noble_Abel_gases)
{
    const NobleAbel dense{1.3, 0.3, 1630}, light{1.4, 0.2, 1};
    const IdealGas ideal{1.4}, other{1.2};
    const std::vector<Pair> pairs{{{ideal, 1, 0, 1}, {ideal, 0.125, 0, 0.1}},       {{light, 1, 0, 1}, {other, 0.125, 0, 0.1}},
                                  {{ideal, 1, -2, 0.4}, {ideal, 1, 2, 0.4}},        {{ideal, 1, 0, 1000}, {light, 1, 0, 0.01}},
                                  {{dense, 1630, 0, 8e9}, {ideal, 1.2, 0, 101325}}, {{light, 1, 2, 1}, {light, 0.8, -3, 2}}};
    const auto closed = [](const GasSide& side) {
        const double b = std::holds_alternative<NobleAbel>(side.law) ? std::get<NobleAbel>(side.law).specific_co_volume() : 0;
        return RiemannSide{side.density, side.velocity, side.pressure, heat_capacity_ratio(side.law), b};
    };
    for (const Pair& pair : pairs) {
        const GeneralRiemannSolution solution(pair.left, pair.right);
        const RiemannSolution exact(closed(pair.left), closed(pair.right));
        EXPECT_NEAR(solution.star_pressure() / exact.star_pressure(), 1, 1e-8);
        const double scale = pair.left.sound_speed() + std::abs(exact.star_velocity());
        EXPECT_NEAR(solution.star_velocity(), exact.star_velocity(), 1e-8 * scale);
        EXPECT_NEAR(solution.left_wave_speed(), exact.left_wave_speed(), 1e-8 * scale);
        EXPECT_NEAR(solution.right_wave_speed(), exact.right_wave_speed(), 1e-8 * scale);
        for (int i = 0; i < 40; ++i) {
            const double width = exact.right_wave_speed() - exact.left_wave_speed();
            const double ray = exact.left_wave_speed() + width * (1.1 * (i + 0.5) / 40 - 0.05);
            const GasSide state = solution.at(ray);
            EXPECT_NEAR(state.density / exact.at(ray).density, 1, 1e-7);
            EXPECT_NEAR(state.pressure / exact.at(ray).pressure, 1, 1e-7);
            EXPECT_NEAR(state.velocity, exact.at(ray).velocity, 1e-8 * scale);
        }
    }
}

TEST(GeneralRiemann, waves_of_products_and_air_obey_jump_conditions_or_keep_their_isentrope)
{
    for (const Pair& pair : products_and_air()) {
        const GeneralRiemannSolution solution(pair.left, pair.right);
        const double gap = 1e-9 * (solution.right_wave_speed() - solution.left_wave_speed());
        const GasSide left = solution.at(solution.star_velocity() - gap), right = solution.at(solution.star_velocity() + gap);
        const double scale = std::abs(left.velocity) + left.sound_speed();
        EXPECT_NEAR(left.pressure / right.pressure, 1, 1e-9);
        EXPECT_NEAR(left.velocity, right.velocity, 1e-9 * scale);
        expect_wave(pair.left, left, solution.left_wave_speed());
        expect_wave(pair.right, right, solution.right_wave_speed());
    }
}

TEST(GeneralRiemann, whole_profile_keeps_mass_momentum_and_energy)
{
    for (const Pair& pair : products_and_air()) {
        const GeneralRiemannSolution solution(pair.left, pair.right);
        const double reach = 1.1 * std::fmax(std::abs(solution.left_wave_speed()), std::abs(solution.right_wave_speed()));
        constexpr int pieces = 4000;
        std::array<double, 3> content{};
        for (int i = 0; i < pieces; ++i) {
            const auto q = conserved(solution.at(reach * (2 * (i + 0.5) / pieces - 1)));
            for (int k = 0; k < 3; ++k) content[k] += q[k] * 2 * reach / pieces;
        }
        for (int k = 0; k < 3; ++k) {
            const double before = reach * (conserved(pair.left)[k] + conserved(pair.right)[k]);
            const double expected = before + flux(pair.left)[k] - flux(pair.right)[k];
            const double scale = reach * (std::abs(conserved(pair.left)[k]) + std::abs(conserved(pair.right)[k])) +
                                 std::abs(flux(pair.left)[k]) + std::abs(flux(pair.right)[k]);
            // Two discontinuities, each within one of the 4000 pieces: 2/4000 of the larger state, and as much again.
            EXPECT_NEAR((content[k] - expected) / scale, 0, 1e-3) << k;
        }
    }
}

TEST(GeneralRiemann, rays_of_a_fan_of_products_are_characteristics_on_one_isentrope)
{
    const GeneralRiemannSolution solution(products(), air());
    const GasSide tail = solution.at(solution.star_velocity() - 1e-6);
    const double first = solution.left_wave_speed(), last = tail.velocity - tail.sound_speed();
    for (const double share : {0.001, 0.2, 0.5, 0.8, 0.999}) {
        const double ray = first + share * (last - first);
        const GasSide state = solution.at(ray);
        EXPECT_NEAR(state.velocity - state.sound_speed(), ray, 1e-6);
        EXPECT_NEAR(jwl_constant(state) / jwl_constant(products()), 1, 1e-8);
    }
}

TEST(GeneralRiemann, mirrored_problem_has_the_mirrored_solution)
{
    const GeneralRiemannSolution solution(products(30), air()), mirror(air(), products(-30));
    EXPECT_NEAR(solution.star_pressure() / mirror.star_pressure(), 1, 1e-12);
    EXPECT_NEAR(solution.star_velocity() / -mirror.star_velocity(), 1, 1e-12);
    for (const double ray : {-6000.0, -1000.0, 3000.0, 7000.0})
        EXPECT_NEAR(solution.at(ray).density / mirror.at(-ray).density, 1, 1e-9) << ray;
}

TEST(GeneralRiemann, products_escape_into_vacuum_as_their_isentrope_says)
{
    const GeneralRiemannSolution solution(products(), {IdealGas{}, 0, 0, 0});
    ASSERT_TRUE(solution.has_vacuum());
    // The same integral of c dlog(rho) by the midpoint rule along the isentrope in closed form, down to V = 1e12, and the ideal rest.
    const double constant = jwl_constant(products());
    const auto sound = [&](double v) {
        const double slope = tnt.a * tnt.r1 * std::exp(-tnt.r1 * v) + tnt.b * tnt.r2 * std::exp(-tnt.r2 * v) +
                             (1 + tnt.omega) * constant * std::pow(v, -2 - tnt.omega);
        return v * std::sqrt(slope / tnt.reference_density);
    };
    constexpr int pieces = 100000;
    const double length = std::log(1e12);
    double speed = 2 * sound(1e12) / tnt.omega;
    for (int i = 0; i < pieces; ++i) speed += sound(std::exp(length * (i + 0.5) / pieces)) * length / pieces;
    EXPECT_NEAR(solution.star_velocity() / speed, 1, 1e-7);
    EXPECT_EQ(solution.at(1.001 * speed).density, 0);
    EXPECT_GT(solution.at(0.999 * speed).density, 0);
    const GeneralRiemannSolution other({IdealGas{}, 0, 0, 0}, products());
    EXPECT_NEAR(other.star_velocity() / -speed, 1, 1e-7);
}

TEST(GeneralRiemann, gases_torn_apart_leave_a_gap)
{
    const GeneralRiemannSolution solution({IdealGas{1.4}, 1, -10, 1}, {NobleAbel{1.4, 0.2, 1}, 1, 10, 1});
    EXPECT_TRUE(solution.has_vacuum());
    EXPECT_EQ(solution.at(0).density, 0);
    EXPECT_EQ(solution.at(-20).density, 1);
    EXPECT_EQ(solution.at(20).density, 1);
    EXPECT_GT(solution.at(-9).density, 0);
    EXPECT_GT(solution.at(9).density, 0);
}

TEST(GeneralRiemann, still_gas_stays_still)
{
    const GeneralRiemannSolution solution(air(30), air(30));
    EXPECT_NEAR(solution.star_pressure() / 101325, 1, 1e-10);
    EXPECT_NEAR(solution.star_velocity(), 30, 1e-7);
    EXPECT_NEAR(solution.at(0).density, 1.2, 1e-9);
}

TEST(GeneralRiemann, refuses_what_is_no_gas)
{
    EXPECT_THROW(GeneralRiemannSolution(air(), {IdealGas{1.4}, 1, 0, 0}), InputError);
    EXPECT_THROW(GeneralRiemannSolution(air(), {IdealGas{1.0}, 1, 0, 1}), InputError);
    EXPECT_THROW(GeneralRiemannSolution({tnt, 1630, 0, 1e5}, air()), InputError);
    EXPECT_THROW(GeneralRiemannSolution({tnt, 4000, 0, 1e12}, air()), InputError);
}

}  // namespace
}  // namespace corpuscle
