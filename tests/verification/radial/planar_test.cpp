#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>

#include "laws/eos/chapman_jouguet.hpp"
#include "laws/riemann/general_riemann.hpp"
#include "math/root.hpp"
#include "radial/flow.hpp"
#include "radial/zoning.hpp"

namespace corpuscle {
namespace {

const Jwl tnt{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630};
constexpr double tnt_energy = 7e9 / 1630;

RadialZone zone(const GasSide& side, std::vector<double> edges)
{
    return {std::move(edges), side.law, side.density, side.energy(), side.velocity};
}

/// Mean difference to an exact solution over the volume: density, velocity and pressure.
using Errors = std::array<double, 3>;

/// `exact(r)` gives density, velocity, pressure; each error is over the mean of the exact value's size.
Errors errors(const RadialFlow& flow, const std::function<std::array<double, 3>(double)>& exact)
{
    Errors error{}, scale{};
    for (std::size_t i = 0; i < flow.cells(); ++i) {
        const double width = flow.edges()[i + 1] - flow.edges()[i];
        const double velocity = 0.5 * (flow.velocities()[i] + flow.velocities()[i + 1]);
        const std::array<double, 3> found{flow.densities()[i], velocity, flow.pressures()[i]}, wanted = exact(flow.middle(i));
        for (int k = 0; k < 3; ++k) {
            error[k] += width * std::abs(found[k] - wanted[k]);
            scale[k] += width * std::abs(wanted[k]);
        }
    }
    for (int k = 0; k < 3; ++k) error[k] /= scale[k];
    return error;
}

/// Prints a row of the table of errors, with the orders observed against the row of half as many cells, if there is one.
void row(const char* name, int cells, const Errors& error, const Errors& coarser)
{
    std::printf("%s, %5d cells: density %.2e, velocity %.2e, pressure %.2e", name, cells, error[0], error[1], error[2]);
    for (int k = 0; coarser[0] > 0 && k < 3; ++k) std::printf("%s %.2f", k == 0 ? "; orders" : ",", std::log2(coarser[k] / error[k]));
    std::printf("\n");
}

/// Two gases that meet at 0, each in a tube of length 1, after a time; `ratio`: how much wider cells of the left gas are far from the face.
Errors tube(const GasSide& left, const GasSide& right, double time, int cells, double ratio)
{
    const GeneralRiemannSolution exact(left, right);
    const double width = 1.0 / cells;
    RadialFlow flow(Symmetry::planar, {zone(left, graded_edges(-1, 0, width, width / ratio)), zone(right, growing_edges(0, 1, width, 0))});
    const RadialContents before = flow.contents();
    flow.run(time);
    const RadialContents after = flow.contents();
    EXPECT_EQ(after.mass, before.mass);
    EXPECT_NEAR(after.energy() / before.energy(), 1, 1e-12);
    const double pushed = time * (left.pressure - right.pressure);
    EXPECT_NEAR(after.momentum / pushed, 1, 1e-9);
    return errors(flow, [&](double r) {
        const GasSide state = exact.at(r / time);
        return std::array<double, 3>{state.density, state.velocity, state.pressure};
    });
}

/// With a shock and corners in the solution no scheme is of more than first order in the mean error, and a contact that moves with the gas
/// does not spoil it: orders of 0.8 and more over two halvings (0.2 for the places of steps within a cell, and corners: order 2/3..1).
void expect_first_order(const char* name, const GasSide& left, const GasSide& right, double time, double ratio)
{
    Errors last{}, first{};
    for (const int cells : {100, 200, 400}) {
        const Errors now = tube(left, right, time, cells, ratio);
        row(name, cells, now, last);
        if (cells == 100) first = now;
        last = now;
    }
    for (int k = 0; k < 3; ++k) EXPECT_GT(0.5 * std::log2(first[k] / last[k]), 0.8) << name << k;
}

TEST(RadialPlanar, Sod_tube_converges_at_first_order)
{
    expect_first_order("Sod", {IdealGas{1.4}, 1, 0, 1}, {IdealGas{1.4}, 0.125, 0, 0.1}, 0.4, 1);
}

TEST(RadialPlanar, products_against_air_converge_at_first_order)
{
    expect_first_order("TNT-air", {tnt, 1630, 0, tnt.pressure(1630, tnt_energy)}, {IdealGas{1.4}, 1.2, 0, 101325}, 1e-4, 100);
}

/// A simple wave to the right in an ideal gas: on each characteristic dx/dt = u + c the state is kept, and u = 2 (c - c0)/(gamma - 1).
struct SimpleWave {
    static constexpr double gamma = 1.4, amplitude = 0.1;

    /// Speed of the gas (over c0) that starts at a place: a bump with continuous third derivatives, between 0.5 and 1.5.
    static double start(double x)
    {
        const double s = x - 1;
        return std::abs(s) < 0.5 ? amplitude * std::pow(1 - 4 * s * s, 4) : 0;
    }
    static double sound(double velocity) { return 1 + 0.5 * (gamma - 1) * velocity; }
    /// Density, velocity and pressure for a velocity of the gas; still gas has density 1 and speed of sound 1.
    static std::array<double, 3> state(double velocity)
    {
        const double density = std::pow(sound(velocity), 2 / (gamma - 1));
        return {density, velocity, std::pow(density, gamma) / gamma};
    }
    /// At a place and time: the velocity on the characteristic that is there, by Newton's rule.
    static double velocity(double x, double time)
    {
        double from = x - time;
        for (int i = 0; i < 60; ++i) {
            const double u = start(from), slope = (start(from + 1e-7) - start(from - 1e-7)) / 2e-7;
            from -= (from + (u + sound(u)) * time - x) / (1 + 0.5 * (gamma + 1) * slope * time);
        }
        return start(from);
    }
};

/// A smooth wave: second order. The mean error is second order but for the viscous pressure at the one place where the wave's strain rate
/// changes sign; 1.8 over two halvings leaves room for that.
TEST(RadialPlanar, smooth_wave_converges_at_second_order)
{
    constexpr double time = 1.0;
    Errors last{}, first{};
    for (const int cells : {100, 200, 400}) {
        std::vector<RadialZone> zones;
        for (int i = 0; i < 3 * cells; ++i) {
            const double low = 1.0 * i / cells, high = 1.0 * (i + 1) / cells;
            const auto state = SimpleWave::state(SimpleWave::velocity(0.5 * (low + high), 0));
            const double energy = state[2] / (0.4 * state[0]);
            zones.push_back({{low, high}, IdealGas{1.4}, state[0], energy, state[1]});
        }
        RadialFlow flow(Symmetry::planar, zones);
        flow.run(time);
        const Errors now = errors(flow, [&](double r) {
            auto state = SimpleWave::state(SimpleWave::velocity(r, time));
            return state;
        });
        row("simple wave", cells, now, last);
        if (cells == 100) first = now;
        last = now;
    }
    for (int k = 0; k < 3; ++k) EXPECT_GT(0.5 * std::log2(first[k] / last[k]), 1.8) << k;
}

/// A charge lit at a plane wall: behind the front, at x = D t, a centred simple wave leads from the Chapman-Jouguet state to rest. The
/// prescribed speed is that of the law, so front, pressure and wave follow. First order: the front is spread over a few cells.
TEST(RadialPlanar, detonation_leaves_the_wave_of_Taylor_behind)
{
    const ChapmanJouguet front = chapman_jouguet(tnt, 1630, tnt_energy);
    const double time = 0.9 / front.detonation_velocity;
    const Isentrope isentrope(tnt, front.density, front.energy);
    const auto exact = [&](double x) -> std::array<double, 3> {
        const double speed = x / time;
        if (speed > front.detonation_velocity) return {1630, 0, 0};
        // To the right: u = u_CJ - gain, and u + c = x/t; mirrored, gain - sound = u_CJ - x/t. At rest where gain = u_CJ.
        auto point = isentrope.on_ray(front.particle_velocity - speed, 1);
        if (point.gain < front.particle_velocity) return {point.density, front.particle_velocity - point.gain, point.pressure};
        const double rest =
            find_root([&](double rho) { return isentrope.at_density(rho).gain - front.particle_velocity; }, 100, front.density);
        point = isentrope.at_density(rest);
        return {point.density, 0, point.pressure};
    };
    Errors last{}, first{};
    for (const int cells : {100, 200, 400}) {
        RadialZone charge{growing_edges(0, 1, 1.0 / cells, 0), tnt, 1630, tnt_energy};
        charge.detonation_velocity = front.detonation_velocity;
        RadialFlow flow(Symmetry::planar, {charge});
        const double before = flow.contents().energy();
        flow.run(time);
        EXPECT_NEAR(flow.contents().energy() / before, 1, 1e-12);
        const Errors now = errors(flow, exact);
        row("detonation", cells, now, last);
        if (cells == 100) first = now;
        last = now;
    }
    for (int k = 0; k < 3; ++k) EXPECT_GT(0.5 * std::log2(first[k] / last[k]), 0.8) << k;
}

}  // namespace
}  // namespace corpuscle
