#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "laws/riemann/general_riemann.hpp"
#include "unit/euler/euler_samples.hpp"

namespace corpuscle {
namespace {

using Errors = std::array<double, 3>;

/// Mean errors of density, velocity and pressure, each over the mean size of the exact value, of two gases that meet in the middle of the
/// unit line, after a time.
Errors tube(const GasSide& left, const GasSide& right, double time, std::size_t cells)
{
    const GeneralRiemannSolution exact(left, right);
    EulerGrid grid = unit_grid(cells, 1, 1, EulerEdge::open, {plain("left", left.law), plain("right", right.law)});
    fill(grid, [&](const Vector3d& x) {
        const bool first = x.x < 0.5;
        const GasSide& side = first ? left : right;
        return EulerSample{first ? 0u : 1u, side.density, side.pressure, {side.velocity, 0, 0}};
    });
    Clock clock;
    run_until(grid, clock, time);
    Errors error{}, scale{};
    for (std::size_t c = 0; c < cells; ++c) {
        const EulerCell cell = look(grid, c);
        const GasSide wanted = exact.at((grid.middle(c).x - 0.5) / time);
        const Errors found{cell.density, cell.velocity.x, cell.pressure}, right_one{wanted.density, wanted.velocity, wanted.pressure};
        for (int k = 0; k < 3; ++k) error[k] += std::abs(found[k] - right_one[k]), scale[k] += std::abs(right_one[k]);
    }
    for (int k = 0; k < 3; ++k) error[k] /= scale[k];
    return error;
}

/// With a shock and corners in the solution no scheme is of more than first order in the mean error; the step of density at the contact
/// costs no order as it stays a cell or two wide. Orders of 0.8 and more over two halvings (0.2 for where steps lie within a cell).
void expect_first_order(const char* name, const GasSide& left, const GasSide& right, double time)
{
    Errors first{}, last{};
    for (const std::size_t cells : {100u, 200u, 400u}) {
        const Errors now = tube(left, right, time, cells);
        std::printf("%s, %3zu cells: density %.2e, velocity %.2e, pressure %.2e", name, cells, now[0], now[1], now[2]);
        for (int k = 0; cells > 100 && k < 3; ++k) std::printf("%s %.2f", k == 0 ? "; orders" : ",", std::log2(last[k] / now[k]));
        std::printf("\n");
        if (cells == 100) first = now;
        last = now;
    }
    for (int k = 0; k < 3; ++k) EXPECT_GT(0.5 * std::log2(first[k] / last[k]), 0.8) << name << k;
}

TEST(EulerTube, Sod_converges_at_first_order)
{
    expect_first_order("Sod", {IdealGas{1.4}, 1, 0, 1}, {IdealGas{1.4}, 0.125, 0, 0.1}, 0.2);
}

/// Products at the explosive's density, all burnt at once, against air: density ratio 1358, pressure ratio 8e4. In the first steps, when
/// products and air fill a cell or two, the air is driven too hard: its shock starts some cells ahead of its place and keeps that lead,
/// which is most of the error of velocity (the layer of air is a tenth of the flow). The mean errors of density (contacts smear, at order
/// 1/2 at least) and of pressure (first order, 0.8 as above) are held to their orders, over four halvings.
TEST(EulerTube, products_against_air_converge)
{
    const GasSide left{tnt_products, 1630, 0, tnt_products.pressure(1630, tnt_energy)}, right{IdealGas{1.4}, 1.2, 0, 101325};
    const GeneralRiemannSolution exact(left, right);
    constexpr double time = 4e-5;
    Errors first{}, last{};
    for (const std::size_t cells : {100u, 200u, 400u, 800u, 1600u}) {
        last = tube(left, right, time, cells);
        std::printf("TNT-air, %4zu cells: density %.2e, velocity %.2e, pressure %.2e\n", cells, last[0], last[1], last[2]);
        if (cells == 100) first = last;
    }
    EXPECT_GT(std::log2(first[2] / last[2]) / 4, 0.8);
    EXPECT_GT(std::log2(first[0] / last[0]) / 4, 0.5);
}

}  // namespace
}  // namespace corpuscle
