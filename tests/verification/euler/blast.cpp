#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "laws/blast/sedov.hpp"
#include "unit/euler/euler_samples.hpp"

namespace corpuscle {
namespace {

constexpr double pi = std::numbers::pi;

/// The point blast of energy 1 in gas of density 1, 1.5 wide, as a ball of hot gas of radius two cells. Energy outside: 1e-6 of it.
EulerGrid point_blast(EulerSpace space, std::size_t cells)
{
    constexpr double reach = 1.2;
    std::array<EulerEdge, euler_face_count> edges;
    edges.fill(EulerEdge::rigid);
    const std::vector<double> faces = even_faces(0, reach, cells);
    EulerGrid grid = make_grid(space,
                               {faces, space == EulerSpace::spherical ? std::vector<double>{0, 1} : faces,
                                space == EulerSpace::planar ? faces : std::vector<double>{0, 1}},
                               edges, {plain("gas", IdealGas{1.4})});
    const double parts = space == EulerSpace::planar ? 8 : space == EulerSpace::axisymmetric ? 2 : 1;  // of the ball that the grid holds
    const double cold = 1e-6, radius = 2 * reach / static_cast<double>(cells);
    fill(
        grid,
        [&](const Vector3d& x) {
            const double r = space == EulerSpace::spherical ? x.x : space == EulerSpace::axisymmetric ? std::hypot(x.x, x.y) : norm(x);
            return EulerSample{0, 1, r < radius ? 1.0 : cold};
        },
        4);
    // All of the energy over the hot cells, exactly.
    double hot = 0;
    for (std::size_t c = 0; c < grid.cells(); ++c) hot += grid.volume(c) * (grid.now.energy[c] - 2.5 * cold);
    for (double& energy : grid.now.energy) energy = 2.5 * cold + (energy - 2.5 * cold) / hot / parts;
    prepare(grid);
    return grid;
}

/// Radius at which the mean density over shells, a cell thick, has half of its rise, from outside.
double front(const EulerGrid& grid)
{
    const std::size_t shells = grid.axes[0].cells();
    const double width = grid.axes[0].width(0);
    std::vector<double> mass(2 * shells), volume(2 * shells), density;
    for (std::size_t c = 0; c < grid.cells(); ++c) {
        const Vector3d x = grid.middle(c);
        const double r = grid.space == EulerSpace::spherical      ? x.x
                         : grid.space == EulerSpace::axisymmetric ? std::hypot(x.x, x.y)
                                                                  : norm(x);
        const auto shell = static_cast<std::size_t>(r / width);
        mass[shell] += grid.now.mass[0][c] * grid.volume(c);
        volume[shell] += grid.volume(c);
    }
    for (std::size_t s = 0; s < shells; ++s) density.push_back(mass[s] / volume[s]);
    const double half = 0.5 * (1 + *std::max_element(density.begin(), density.end()));
    for (std::size_t s = shells - 1; s-- > 0;) {
        if (density[s] > half) return (static_cast<double>(s) + 0.5 + (density[s] - half) / (density[s] - density[s + 1])) * width;
    }
    return 0;
}

/// The front runs as Sedov's, in every space. Bound: a captured shock is some three cells
/// wide, and its middle within half of that, a cell and a half, of the true place. Along the axes of boxes it is blunter than across.
void expect_front(const char* name, EulerSpace space, std::size_t cells)
{
    const SedovBlast exact(1.4, 1, 1);
    EulerGrid grid = point_blast(space, cells);
    const double before = contents(grid).gas.energy, width = grid.axes[0].width(0);
    Clock clock;
    run_until(grid, clock, 0.5);
    double peak = 0;
    for (std::size_t c = 0; c < grid.cells(); ++c) peak = std::max(peak, look(grid, c).density);
    std::printf("Sedov, %s, %zu cells: front %.4f for %.4f, peak density %.2f for 6\n", name, cells, front(grid), exact.radius(0.5), peak);
    EXPECT_NEAR(front(grid), exact.radius(0.5), 1.5 * width);
    EXPECT_NEAR(contents(grid).gas.energy / before, 1, 1e-12);
}

TEST(EulerBlast, of_Sedov_in_shells)
{
    expect_front("shells", EulerSpace::spherical, 100);
    expect_front("shells", EulerSpace::spherical, 200);
}

TEST(EulerBlast, of_Sedov_in_rings)
{
    expect_front("rings", EulerSpace::axisymmetric, 64);
}

TEST(EulerBlast, of_Sedov_in_boxes)
{
    expect_front("boxes", EulerSpace::planar, 32);
}

}  // namespace
}  // namespace corpuscle
