#include "structure/elements/quad_shell_strain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace corpuscle {
namespace {

using Corners = QuadCorners<double>;

/// A warped, distorted quadrilateral anywhere in space.
const Corners crooked{Vector3d{1.0, 2.0, 3.0}, Vector3d{2.1, 2.2, 3.1}, Vector3d{2.0, 3.3, 3.5}, Vector3d{0.8, 2.9, 2.9}};

Corners random_corners(std::mt19937& random)
{
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    Corners c;
    for (Vector3d& v : c) v = {value(random), value(random), value(random)};
    return c;
}

std::vector<double> numbers(const ShellStrain<double>& e)
{
    return {e.xx, e.yy, e.xy, e.bend_xx, e.bend_yy, e.bend_xy, e.zx, e.yz};
}

std::vector<double> numbers(const ShellHourglass<double>& h)
{
    return {h.stretch_x, h.stretch_y, h.turn_x, h.turn_y, h.shear_s, h.shear_t, h.drill};
}

TEST(QuadModes, SplitAndLoadAreTransposed)
{
    std::mt19937 random(1);
    const Corners values = random_corners(random), seed = random_corners(random);
    const QuadModes<double> modes = modes_of(values), load{seed[0], seed[1], seed[2], seed[3]};
    const Corners corner_loads = corners_of(load);
    double corner_work = 0;
    for (int c = 0; c < 4; ++c) corner_work += dot(corner_loads[c], values[c]);
    EXPECT_NEAR(corner_work, work(load, modes), 1e-14);
}

TEST(QuadFrame, IsOrthonormalAndKnowsTheShape)
{
    const QuadFrame<double> f = frame_of(modes_of(crooked));
    EXPECT_NEAR(norm(f.first), 1.0, 1e-15);
    EXPECT_NEAR(norm(f.second), 1.0, 1e-15);
    EXPECT_NEAR(dot(f.first, f.normal), 0.0, 1e-15);
    EXPECT_NEAR(f.sx * f.ty - f.sy * f.tx, f.area, 1e-14);
    EXPECT_NEAR(f.area, 0.5 * norm(cross(crooked[2] - crooked[0], crooked[3] - crooked[1])), 1e-14);
    EXPECT_GT(std::abs(f.warp), 0.01);
}

TEST(ShellStrain, RigidMotionOfAWarpedElementMakesNone)
{
    const QuadModes<double> places = modes_of(crooked);
    const QuadFrame<double> f = frame_of(places);
    std::mt19937 random(5);
    for (int i = 0; i < 20; ++i) {
        const Corners seed = random_corners(random);
        Corners move, turn;
        for (int c = 0; c < 4; ++c) {
            move[c] = seed[0] + cross(seed[1], crooked[c]);
            turn[c] = seed[1];
        }
        const QuadModes<double> m = f.to_local(modes_of(move)), t = f.to_local(modes_of(turn));
        for (const double e : numbers(strain_of(f, m, t))) EXPECT_NEAR(e, 0.0, 2e-14);
        for (const double h : numbers(hourglass_of(f, m, t))) EXPECT_NEAR(h, 0.0, 2e-14);
    }
}

TEST(ShellStrain, LoadsAreItsTranspose)
{
    const QuadFrame<double> f = frame_of(modes_of(crooked));
    std::mt19937 random(9);
    for (int i = 0; i < 20; ++i) {
        const QuadModes<double> move = modes_of(random_corners(random)), turn = modes_of(random_corners(random));
        const Corners a = random_corners(random), b = random_corners(random);
        const ShellResultant<double> r{a[0].x, a[0].y, a[0].z, a[1].x, a[1].y, a[1].z, a[2].x, a[2].y};
        const ShellHourglass<double> h{b[0].x, b[0].y, b[0].z, b[1].x, b[1].y, b[1].z, b[2].x};
        const ShellLoad<double> load = load_of(f, r, h);
        const ShellStrain<double> e = strain_of(f, move, turn);
        const ShellHourglass<double> q = hourglass_of(f, move, turn);
        double expected = r.xx * e.xx + r.yy * e.yy + r.xy * e.xy + r.bend_xx * e.bend_xx + r.bend_yy * e.bend_yy + r.bend_xy * e.bend_xy +
                          r.zx * e.zx + r.yz * e.yz;
        for (std::size_t k = 0; k < 7; ++k) expected += numbers(h)[k] * numbers(q)[k];
        EXPECT_NEAR(work(load.force, move) + work(load.moment, turn), expected, 1e-12);
    }
}

TEST(ShellStrain, LinearFieldGivesItsGradientAndNoHourglass)
{
    Corners flat = crooked;
    for (Vector3d& c : flat) c.z = 0;
    const QuadFrame<double> f = frame_of(modes_of(flat));
    Corners move, turn;
    for (int c = 0; c < 4; ++c) {
        const Vector3d& x = flat[c];
        move[c] = {0.3 * x.x + 0.2 * x.y, -0.1 * x.x + 0.7 * x.y, 0.5 * 0.4 * x.x * x.x + 0.5 * 0.6 * x.y * x.y + 0.3 * x.x * x.y};
        turn[c] = {0.6 * x.y + 0.3 * x.x, -0.4 * x.x - 0.3 * x.y,
                   -0.15};  // the slopes of w, so that there is no shear, and the plane's spin
    }
    const QuadModes<double> m = f.to_local(modes_of(move)), t = f.to_local(modes_of(turn));
    const ShellStrain<double> e = strain_of(f, m, t);
    EXPECT_NEAR(e.xx + e.yy, 1.0, 1e-14);
    EXPECT_NEAR(e.xx * e.yy - 0.25 * e.xy * e.xy, 0.3 * 0.7 - 0.05 * 0.05, 1e-14);
    EXPECT_NEAR(e.bend_xx + e.bend_yy, -1.0, 1e-14);
    EXPECT_NEAR(e.bend_xx * e.bend_yy - 0.25 * e.bend_xy * e.bend_xy, 0.4 * 0.6 - 0.3 * 0.3, 1e-14);
    EXPECT_NEAR(e.zx, 0.0, 1e-14);
    EXPECT_NEAR(e.yz, 0.0, 1e-14);
    for (const double h : numbers(hourglass_of(f, m, t))) EXPECT_NEAR(h, 0.0, 1e-14);
}

}  // namespace
}  // namespace corpuscle
