// Figures of the Eulerian solver for docs/validation.md: one JSON object a line.
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>

#include "laws/riemann/general_riemann.hpp"
#include "unit/euler/euler_samples.hpp"

namespace corpuscle {
namespace {

double cpu_seconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Mean errors of density, velocity and pressure over the mean size of the exact values.
std::array<double, 3> tube_errors(const GasSide& left, const GasSide& right, double time, std::size_t cells)
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
    std::array<double, 3> error{}, scale{};
    for (std::size_t c = 0; c < cells; ++c) {
        const EulerCell cell = look(grid, c);
        const GasSide wanted = exact.at((grid.middle(c).x - 0.5) / time);
        const std::array<double, 3> found{cell.density, cell.velocity.x, cell.pressure};
        const std::array<double, 3> right_one{wanted.density, wanted.velocity, wanted.pressure};
        for (std::size_t k = 0; k < 3; ++k) error[k] += std::abs(found[k] - right_one[k]), scale[k] += std::abs(right_one[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) error[k] /= scale[k];
    return error;
}

void tubes()
{
    const GasSide products{tnt_products, 1630, 0, tnt_products.pressure(1630, tnt_energy)}, air{IdealGas{1.4}, 1.2, 0, 101325};
    for (const std::size_t cells : {100u, 200u, 400u, 800u, 1600u}) {
        const auto sod = tube_errors({IdealGas{1.4}, 1, 0, 1}, {IdealGas{1.4}, 0.125, 0, 0.1}, 0.2, cells);
        const auto tnt = tube_errors(products, air, 4e-5, cells);
        std::printf("{\"kind\": \"tube\", \"name\": \"Sod\", \"cells\": %zu, \"errors\": [%.4g, %.4g, %.4g]}\n", cells, sod[0], sod[1],
                    sod[2]);
        std::printf("{\"kind\": \"tube\", \"name\": \"TNT against air\", \"cells\": %zu, \"errors\": [%.4g, %.4g, %.4g]}\n", cells, tnt[0],
                    tnt[1], tnt[2]);
    }
}

/// 15 kg of TNT, lit at the centre, in air, to 0.2 ms.
EulerGrid charge_in_air(EulerSpace space, std::size_t cells)
{
    constexpr double reach = 1.2, density = 1630;
    const std::vector<double> faces = even_faces(0, reach, cells), none{0, 1};
    const std::array<EulerEdge, euler_face_count> edges{EulerEdge::rigid, EulerEdge::open,  EulerEdge::rigid,
                                                        EulerEdge::open,  EulerEdge::rigid, EulerEdge::open};
    EulerMaterial tnt = plain("tnt", tnt_products);
    tnt.explosive = {tnt_energy, 0, 6930, {{{0, 0, 0}, 0}}, 0};
    const bool shells = space == EulerSpace::spherical, boxes = space == EulerSpace::planar;
    EulerGrid grid = make_grid(space, {faces, shells ? none : faces, boxes ? faces : none}, edges, {tnt, plain("air", IdealGas{1.4})});
    const double radius = std::cbrt(15 / density * 3 / (4 * 3.14159265358979323846));
    fill(grid, {{Shape::box({{-2, -2, -2}, {2, 2, 2}}), {1, 1.2, 101325}},
                {Shape::sphere({0, 0, 0}, radius), {0, density, 101325, {}, 0, true}}});
    return grid;
}

/// Where the density along a line of cells last passes through 3 kg/m3, between the air's 1.2 and the shock's, from outside [m].
template <class At>
double front(const EulerGrid& grid, const At& at)
{
    for (std::size_t i = grid.axes[0].cells() - 1; i-- > 0;) {
        const EulerCell inner = look(grid, at(i)), outer = look(grid, at(i + 1));
        if (inner.density > 3 && outer.density <= 3) {
            const double share = (inner.density - 3) / (inner.density - outer.density);
            return norm(grid.middle(at(i))) + share * norm(grid.middle(at(i + 1)) - grid.middle(at(i)));
        }
    }
    return 0;
}

void charge(const char* name, EulerSpace space, std::size_t cells)
{
    EulerGrid grid = charge_in_air(space, cells);
    const EulerContents before = contents(grid);
    const double start = cpu_seconds();
    Clock clock;
    run_until(grid, clock, 2e-4);
    const double seconds = cpu_seconds() - start;
    const EulerContents after = contents(grid);
    const double drift = (after.gas.energy + after.explosive.energy) / (before.gas.energy + before.explosive.energy) - 1;
    const double along = front(grid, [&](std::size_t i) { return grid.cell(i, 0, 0); });
    const bool two = space != EulerSpace::spherical, three = space == EulerSpace::planar;
    const double across = two ? front(grid, [&](std::size_t i) { return grid.cell(i, i, three ? i : 0); }) : along;
    const double corner = three ? front(grid, [&](std::size_t i) { return grid.cell(i, i, 0); }) : across;
    const double upward = two ? front(grid, [&](std::size_t i) { return grid.cell(0, i, 0); }) : along;
    std::printf(
        "{\"kind\": \"charge\", \"space\": \"%s\", \"cells\": %zu, \"in_radius\": %.1f, \"fronts\": [%.4f, %.4f, %.4f, %.4f], \"steps\": "
        "%llu, \"cpu_s\": %.2f, \"ns\": %.0f, \"energy_drift\": %.1e}\n",
        name, cells, 0.13 / 1.2 * static_cast<double>(cells), along, upward, corner, across, static_cast<unsigned long long>(clock.step()),
        seconds, 1e9 * seconds / static_cast<double>(grid.worked), drift);
    std::fflush(stdout);
}

}  // namespace
}  // namespace corpuscle

int main()
{
    using namespace corpuscle;
    tubes();
    for (const std::size_t cells : {50u, 100u, 200u, 400u, 800u, 1600u}) charge("shells", EulerSpace::spherical, cells);
    for (const std::size_t cells : {48u, 96u, 192u}) charge("rings", EulerSpace::axisymmetric, cells);
    for (const std::size_t cells : {32u, 48u, 72u}) charge("boxes", EulerSpace::planar, cells);
    return 0;
}
