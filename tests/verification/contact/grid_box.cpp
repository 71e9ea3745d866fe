#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "grid_walls.hpp"

namespace corpuscle {
namespace {

/// Where a point of a box is that goes straight and turns about its middle [m].
Vector3d carried(const Vector3d& from_middle, const Vector3d& middle, const Vector3d& axis, double angle)
{
    const Vector3d n = normalized(axis);
    return middle + std::cos(angle) * from_middle + std::sin(angle) * cross(n, from_middle) +
           (1 - std::cos(angle)) * dot(n, from_middle) * n;
}

MovingSurface box_surface(const Vector3d& half)
{
    MovingSurface box;
    for (int c = 0; c < 8; ++c) box.start.push_back({c & 1 ? half.x : -half.x, c & 2 ? half.y : -half.y, c & 4 ? half.z : -half.z});
    for (const std::array<std::uint32_t, 4>& q :
         {std::array<std::uint32_t, 4>{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
        box.surface.facets.push_back({{q[0], q[1], q[2]}, 0, 0});
        box.surface.facets.push_back({{q[0], q[2], q[3]}, 0, 0});
    }
    return box;
}

/// Cells that gas can reach from the one around a place.
std::vector<std::size_t> reached_from(const EulerGrid& grid, const Vector3d& place)
{
    std::array<std::size_t, 3> at{};
    for (std::size_t d = 0; d < 3; ++d)
        while (grid.axes[d].faces[at[d] + 1] < place[static_cast<int>(d)]) ++at[d];
    std::vector<std::size_t> found{grid.cell(at[0], at[1], at[2])};
    std::vector<bool> seen(grid.cells());
    seen[found[0]] = true;
    for (std::size_t n = 0; n < found.size(); ++n) {
        for (std::size_t d = 0; d < 3; ++d) {
            for (const int side : {0, 1}) {
                auto next = grid.place(found[n]), face = next;
                if (side == 0 ? next[d] == 0 : next[d] + 1 == grid.axes[d].cells()) continue;
                face[d] += static_cast<std::size_t>(side);
                if (grid.walls.shut[d][grid.face_number(static_cast<int>(d), face)] >= 0) continue;
                next[d] += side == 1 ? 1u : static_cast<std::size_t>(-1);
                const std::size_t cell = grid.cell(next[0], next[1], next[2]);
                if (!seen[cell]) seen[cell] = true, found.push_back(cell);
            }
        }
    }
    return found;
}

/// A closed box of thin walls, with a million times the pressure inside, goes and turns through the grid: what is inside stays inside.
TEST(GridBox, keeps_its_gas_while_it_moves_and_turns)
{
    const std::size_t n = 20;
    EulerGrid grid = unit_grid(n, n, n, EulerEdge::rigid, {plain("inside", IdealGas{1.4}), plain("outside", IdealGas{1.4})});
    const Vector3d middle{0.4, 0.45, 0.5}, velocity{12, 4, -3}, axis{1, 2, 3};
    const double spin = 40, end = 0.015;
    const MovingSurface box = box_surface({0.22, 0.17, 0.19});
    MovingSurface placed = box;
    for (Vector3d& p : placed.start) p = carried(p, middle, axis, 0.3);
    fill(grid, [&](const Vector3d& x) {
        const Vector3d own = carried(x - middle, {}, axis, -0.3);
        const bool in = std::abs(own.x) < 0.22 && std::abs(own.y) < 0.17 && std::abs(own.z) < 0.19;
        return in ? EulerSample{0, 10, 1e6, {}} : EulerSample{1, 1e-3, 1, {}};
    });
    WalledGas gas(std::move(grid), placed, 0);
    const auto mass_in = [&](const std::vector<std::size_t>& cells, std::size_t m) {
        double mass = 0;
        for (const std::size_t c : cells) mass += gas.grid.volume(c) * gas.grid.now.mass[m][c];
        return mass;
    };
    const EulerAmount first = contents(gas.grid).gas;
    EXPECT_NEAR(mass_in(reached_from(gas.grid, middle), 0), first.mass[0], 1e-13 * first.mass[0]);
    while (gas.clock.time() < end) {  // the box is led: its nodes go on straight lines from place to place
        const double limit = std::min(stable_step(gas.grid), gas.walls.stable_step()), time = gas.clock.time() + limit;
        for (std::size_t c = 0; c < 8; ++c) {
            const Vector3d to = carried(box.start[c], middle + time * velocity, axis, 0.3 + spin * time);
            gas.structure.nodes.velocity[c] = (to - gas.structure.nodes.position[c]) / limit;
        }
        gas.step(limit);
    }
    const EulerAmount last = contents(gas.grid).gas;
    const auto cells = reached_from(gas.grid, middle + gas.clock.time() * velocity);
    std::printf("%llu steps to %.4f: inside %zu cells, mass %.3e off, other gas inside %.3e, squeezed %llu, energy %.3e off\n",
                static_cast<unsigned long long>(gas.clock.step()), gas.clock.time(), cells.size(), mass_in(cells, 0) / first.mass[0] - 1,
                mass_in(cells, 1), static_cast<unsigned long long>(gas.grid.walls.squeezed),
                (last.energy + gas.to_structure.energy) / first.energy - 1);
    EXPECT_NEAR(mass_in(cells, 0), first.mass[0], 1e-12 * first.mass[0]);
    EXPECT_EQ(mass_in(cells, 1), 0);
    EXPECT_NEAR(last.mass[1], first.mass[1], 1e-12 * first.mass[1]);
    EXPECT_NEAR(last.energy + gas.to_structure.energy, first.energy, 1e-11 * first.energy);
    EXPECT_EQ(gas.grid.walls.squeezed, 0u);
}

/// Gas at rest around and in a box at rest, at any angle to the grid, stays at rest, and presses on the box with no force in sum.
TEST(GridBox, gas_at_rest_stays_at_rest)
{
    EulerGrid grid = unit_grid(20, 22, 18, EulerEdge::rigid, {plain("air", IdealGas{1.4})});
    fill(grid, [](const Vector3d&) { return EulerSample{0, 1, 1e5, {}}; });
    MovingSurface box = box_surface({0.22, 0.17, 0.19});
    for (Vector3d& p : box.start) p = carried(p, {0.5, 0.5, 0.5}, {1, 2, 3}, 0.5);
    WalledGas gas(std::move(grid), box, 0);
    const double whole = contents(gas.grid).gas.energy, force_of_a_face = 1e5 * 0.44 * 0.34;
    for (int i = 0; i < 20; ++i) gas.step(1);
    double fastest = 0;
    for (std::size_t c = 0; c < gas.grid.cells(); ++c) fastest = std::max(fastest, norm(look(gas.grid, c).velocity));
    const double force = norm(gas.to_structure.momentum) / gas.clock.time();
    std::printf("fastest %.3e of sound, force %.3e of a face's\n", fastest / std::sqrt(1.4e5), force / force_of_a_face);
    EXPECT_LT(fastest, 1e-12 * std::sqrt(1.4e5));
    EXPECT_LT(force, 1e-12 * force_of_a_face);
    EXPECT_NEAR(contents(gas.grid).gas.energy, whole, 1e-13 * whole);
}

/// A solid block goes and turns through gas at rest: the gas keeps its mass, and gives the block what it loses; none is within.
TEST(GridBox, a_solid_block_drives_gas_out_of_its_way)
{
    EulerGrid grid = unit_grid(20, 20, 20, EulerEdge::rigid, {plain("air", IdealGas{1.4})});
    fill(grid, [](const Vector3d&) { return EulerSample{0, 1, 1, {}}; });
    const Vector3d middle{0.4, 0.45, 0.5}, velocity{0.4, 0.2, -0.1}, axis{1, 2, 3}, half{0.22, 0.17, 0.19};
    const double spin = 1, end = 0.4;
    const MovingSurface box = box_surface(half);
    MovingSurface placed = box;
    for (Vector3d& p : placed.start) p = carried(p, middle, axis, 0.3);
    for (Facet& facet : placed.surface.facets) facet.solid = true;
    WalledGas gas(std::move(grid), placed, 0);
    const auto room = [&] {
        double volume = 0;
        for (std::size_t c = 0; c < gas.grid.cells(); ++c) volume += gas.grid.volume(c);
        return volume;
    };
    const EulerAmount first = contents(gas.grid).gas;
    const double block = 8 * half.x * half.y * half.z;
    EXPECT_NEAR(1 - room(), block, 0.05 * block);  // planes are exact in sum; edges and corners miss some cells' parts
    while (gas.clock.time() < end) {
        const double limit = std::min(stable_step(gas.grid), gas.walls.stable_step()), time = gas.clock.time() + limit;
        for (std::size_t c = 0; c < 8; ++c) {
            const Vector3d to = carried(box.start[c], middle + time * velocity, axis, 0.3 + spin * time);
            gas.structure.nodes.velocity[c] = (to - gas.structure.nodes.position[c]) / limit;
        }
        gas.step(limit);
    }
    const EulerAmount last = contents(gas.grid).gas;
    std::printf("block %.4f, of the grid %.4f; mass %.3e off, energy %.3e off, squeezed %d\n", block, 1 - room(),
                last.whole_mass() / first.whole_mass() - 1, (last.energy + gas.to_structure.energy) / first.energy - 1,
                int(gas.grid.walls.squeezed));
    EXPECT_NEAR(1 - room(), block, 0.05 * block);
    EXPECT_NEAR(last.whole_mass(), first.whole_mass(), 1e-12 * first.whole_mass());
    EXPECT_NEAR(last.energy + gas.to_structure.energy, first.energy, 1e-12 * first.energy);
    EXPECT_GT(last.energy, first.energy);
    EXPECT_EQ(gas.grid.walls.squeezed, 0u);
}

}  // namespace
}  // namespace corpuscle
