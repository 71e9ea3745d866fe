#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "euler_samples.hpp"
#include "laws/riemann/general_riemann.hpp"

namespace corpuscle {
namespace {

TEST(EulerTube, Sod)
{
    const GasSide left{IdealGas{1.4}, 1, 0, 1}, right{IdealGas{1.4}, 0.125, 0, 0.1};
    const GeneralRiemannSolution exact(left, right);
    double before = 0;
    for (const std::size_t n : {100u, 200u, 400u}) {
        EulerGrid grid = unit_grid(n, 1, 1, EulerEdge::rigid, {{"a", IdealGas{1.4}, {}}, {"b", IdealGas{1.4}, {}}});
        fill(grid, [&](const Vector3d& x) {
            return x.x < 0.5 ? EulerSample{0, 1, 1} : EulerSample{1, 0.125, 0.1};
        });
        Clock clock;
        run_until(grid, clock, 0.2);
        double error = 0;
        for (std::size_t c = 0; c < n; ++c) {
            const EulerCell cell = look(grid, c);
            error += std::abs(cell.density - exact.at((grid.middle(c).x - 0.5) / 0.2).density) / static_cast<double>(n);
            if (n == 100) std::printf("%g %g %g %g %g\n", grid.middle(c).x, cell.density, cell.velocity.x, cell.pressure, cell.share[0]);
        }
        std::printf("n %zu error %g order %g steps %d\n", n, error, std::log2(before / error), int(clock.step()));
        before = error;
    }
}

}  // namespace
}  // namespace corpuscle
