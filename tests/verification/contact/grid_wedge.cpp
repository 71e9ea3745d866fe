#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "grid_walls.hpp"

namespace corpuscle {
namespace {

constexpr double gamma_air = 1.4, degree = std::numbers::pi / 180;

/// Pressure ratio of a shock with a normal Mach number.
double shock_pressure(double normal_mach)
{
    return 1 + 2 * gamma_air / (gamma_air + 1) * (normal_mach * normal_mach - 1);
}

/// Angle by which an oblique shock turns a stream.
double turning(double mach, double shock_angle)
{
    const double s = std::sin(shock_angle), m = mach * mach;
    return std::atan(2 / std::tan(shock_angle) * (m * s * s - 1) / (m * (gamma_air + std::cos(2 * shock_angle)) + 2));
}

/// The weak shock that turns a stream by an angle: the smaller root between the Mach angle and the angle of most turning.
double weak_shock_angle(double mach, double angle)
{
    double low = std::asin(1 / mach), high = low;
    while (turning(mach, high + 1e-4) > turning(mach, high)) high += 1e-4;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (turning(mach, middle) < angle ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// A sheet across the plane that rises from (foot, 0) at an angle.
MovingSurface wedge(double foot, double angle, double length)
{
    MovingSurface sheet;
    add_sheet(sheet, {foot, 0, -1}, {length * std::cos(angle), length * std::sin(angle), 0}, {0, 0, 3});
    return sheet;
}

/// A stream of Mach 3 over a plate at 20 degrees.
TEST(GridWedge, stream_of_mach_3_over_20_degrees)
{
    const double angle = 20 * degree, foot = 0.205, mach = 3, speed = mach * std::sqrt(gamma_air);
    const double expected = shock_pressure(mach * std::sin(weak_shock_angle(mach, angle)));
    for (const std::size_t n : {50u, 100u}) {
        std::array<EulerEdge, euler_face_count> edges;
        edges.fill(EulerEdge::open);
        edges[2] = EulerEdge::rigid;
        EulerGrid grid =
            make_grid(EulerSpace::planar, {even_faces(0, 1, n), even_faces(0, 1, n), {0, 1}}, edges, {plain("air", IdealGas{1.4})});
        fill(grid, [&](const Vector3d& x) {
            const bool below = x.y < (x.x - foot) * std::tan(angle);
            return EulerSample{0, below ? 1e-2 : 1.0, below ? 1e-2 : 1.0, {below ? 0.0 : speed, 0, 0}};
        });
        WalledGas gas(std::move(grid), wedge(foot, angle, 2), 0);
        gas.run_to(1.0);
        const auto [mean, scatter] = gas.pressure_on([](const Vector3d& x) { return x.x > 0.5 && x.x < 0.9; }, {0, 1, 0});
        std::printf("%zu cells: pressure %.4f of theory, scatter %.4f\n", n, mean / expected, scatter / expected);
        EXPECT_NEAR(mean / expected, 1, 0.03);
    }
}

/// Pressure behind the reflected shock where a shock of some Mach number meets a wall that rises at an angle, reflected regularly: seen
/// from the point where they meet the gas before the shock streams along the wall, is turned towards it by the shock and back by the
/// reflection, in its weak form (von Neumann's two-shock theory). In units of the pressure before the shock.
double reflected_pressure(double mach, double angle)
{
    const double stream = mach / std::cos(angle), shock = 90 * degree - angle;  // of the gas before the shock, and the shock's angle to it
    const double turned = turning(stream, shock), normal = stream * std::sin(shock);
    const double p1 = shock_pressure(normal), r1 = (gamma_air + 1) * normal * normal / ((gamma_air - 1) * normal * normal + 2);
    const double u_n = stream * std::sin(shock) / r1, u_t = stream * std::cos(shock), sound = std::sqrt(p1 / r1);
    const double mach1 = std::hypot(u_n, u_t) / sound;
    const double second = weak_shock_angle(mach1, turned);
    return p1 * shock_pressure(mach1 * std::sin(second));
}

/// A shock of Mach 2 meets a plate at 60 degrees, which reflects it regularly.
TEST(GridWedge, shock_of_mach_2_on_60_degrees)
{
    const double angle = 60 * degree, foot = 0.2, mach = 2, sound = std::sqrt(gamma_air), expected = reflected_pressure(mach, angle);
    const double behind_p = shock_pressure(mach), behind_r = (gamma_air + 1) * mach * mach / ((gamma_air - 1) * mach * mach + 2);
    const double behind_u = 2 / (gamma_air + 1) * (mach - 1 / mach) * sound;
    const std::size_t n = 100;
    std::array<EulerEdge, euler_face_count> edges;
    edges.fill(EulerEdge::open);
    edges[2] = EulerEdge::rigid;
    EulerGrid grid =
        make_grid(EulerSpace::planar, {even_faces(0, 1, n), even_faces(0, 1.2, 120), {0, 1}}, edges, {plain("air", IdealGas{gamma_air})});
    fill(grid, [&](const Vector3d& x) {
        const bool below = x.y < (x.x - foot) * std::tan(angle), shocked = x.x < 0.1;
        if (below) return EulerSample{0, 0.1, 0.1, {}};
        return EulerSample{0, shocked ? behind_r : 1.0, shocked ? behind_p : 1.0, {shocked ? behind_u : 0.0, 0, 0}};
    });
    WalledGas gas(std::move(grid), wedge(foot, angle, 2), 0);
    const double reach = 0.75;  // where the shock meets the wall at the end
    gas.run_to((reach - 0.1) / (mach * sound));
    const auto [mean, scatter] = gas.pressure_on([&](const Vector3d& x) { return x.x > 0.6 && x.x < reach - 0.05; }, {-1, 0, 0});
    std::printf("%zu cells: pressure %.4f of theory (%.3f), scatter %.4f\n", n, mean / expected, expected, scatter / expected);
    EXPECT_NEAR(mean / expected, 1, 0.03);
}

}  // namespace
}  // namespace corpuscle
