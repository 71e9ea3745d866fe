#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "grid_walls.hpp"

namespace corpuscle {
namespace {

/// A block of bricks, some a side, that can be taken out one by one; bare facets, turned in the room.
struct Bricks {
    explicit Bricks(int side_) : side(side_), left(static_cast<std::size_t>(side_ * side_ * side_), 1)
    {
        const Vector3d a = 0.5 * normalized(Vector3d{1, 0.3, 0.2}), b = 0.45 * normalized(cross(Vector3d{0, 0.1, 1}, a)),
                       c = 0.4 * normalized(cross(a, b));
        const Vector3d corner = Vector3d{0.503, 0.497, 0.505} - 0.5 * (a + b + c);
        for (int k = 0; k <= side; ++k)
            for (int j = 0; j <= side; ++j)
                for (int i = 0; i <= side; ++i)
                    surface.start.push_back(corner + (double(i) / side) * a + (double(j) / side) * b + (double(k) / side) * c);
        for (int axis = 0; axis < 3; ++axis) add_planes(axis);
        update(surface.surface);
    }

    /// All faces across one axis; those on the lower side of the block look down it.
    void add_planes(int axis)
    {
        std::array<int, 3> at{};
        const int e = (axis + 1) % 3, f = (axis + 2) % 3;
        for (at[static_cast<std::size_t>(f)] = 0; at[static_cast<std::size_t>(f)] < side; ++at[static_cast<std::size_t>(f)])
            for (at[static_cast<std::size_t>(e)] = 0; at[static_cast<std::size_t>(e)] < side; ++at[static_cast<std::size_t>(e)])
                for (at[static_cast<std::size_t>(axis)] = 0; at[static_cast<std::size_t>(axis)] <= side;
                     ++at[static_cast<std::size_t>(axis)])
                    add_face(axis, at);
    }
    void add_face(int axis, const std::array<int, 3>& at)
    {
        const auto d = static_cast<std::size_t>(axis), e = (d + 1) % 3, f = (d + 2) % 3;
        const auto node = [&](int de, int df) {
            std::array<int, 3> p = at;
            p[e] += de, p[f] += df;
            return static_cast<std::uint32_t>((p[2] * (side + 1) + p[1]) * (side + 1) + p[0]);
        };
        std::array<int, 3> below = at;
        --below[d];
        const std::uint32_t lower = at[d] > 0 ? brick(below) : Facet::no_element, upper = at[d] < side ? brick(at) : Facet::no_element;
        const bool down = at[d] == 0;
        for (std::array<std::uint32_t, 3> n : {std::array<std::uint32_t, 3>{node(0, 0), node(1, 0), node(1, 1)},
                                               std::array<std::uint32_t, 3>{node(0, 0), node(1, 1), node(0, 1)}}) {
            if (down) std::swap(n[1], n[2]);
            surface.surface.facets.push_back({n, down ? upper : lower, 0, down ? lower : upper, true});
        }
    }
    [[nodiscard]] std::uint32_t brick(const std::array<int, 3>& at) const
    {
        return static_cast<std::uint32_t>((at[2] * side + at[1]) * side + at[0]);
    }

    /// Hides the faces between bricks and between gas and gas; turns those whose other brick is left.
    void update(Surface& seen) const
    {
        const auto is_left = [&](std::uint32_t element) { return element != Facet::no_element && left[element] != 0; };
        seen.hidden.resize(seen.facets.size());
        seen.turned.resize(seen.facets.size());
        for (std::size_t f = 0; f < seen.facets.size(); ++f) {
            const bool own = is_left(seen.facets[f].element), other = is_left(seen.facets[f].other);
            seen.hidden[f] = own == other ? 1 : 0;
            seen.turned[f] = other && !own ? 1 : 0;
        }
    }

    int side;
    std::vector<std::uint8_t> left;
    MovingSurface surface;
};

double room_of(const EulerGrid& grid)
{
    double room = 0;
    for (std::size_t c = 0; c < grid.cells(); ++c) room += grid.volume(c);
    return room;
}

/// Bricks vanish one by one, first those within, which leave a hollow that no gas can come to: the gas keeps its mass and, as standing
/// walls do no work, its energy; it fills what opens to it, at the end the whole room.
TEST(GridBricks, gas_fills_the_room_of_bricks_that_erode)
{
    EulerGrid grid = unit_grid(24, 24, 24, EulerEdge::rigid, {plain("air", IdealGas{1.4})});
    fill(grid, [](const Vector3d&) { return EulerSample{0, 1, 1, {}}; });
    Bricks bricks(3);
    WalledGas gas(std::move(grid), bricks.surface, 0);
    const EulerAmount first = contents(gas.grid).gas;
    const double block = 0.5 * 0.45 * 0.4, before = room_of(gas.grid);
    EXPECT_NEAR(1 - before, block, 0.05 * block);
    const auto take_out = [&](std::size_t brick, int steps) {
        bricks.left[brick] = 0;
        bricks.update(gas.structure.surface);
        for (int i = 0; i < steps; ++i) gas.step(1);
    };
    take_out(13, 3);  // the one in the middle
    EXPECT_NEAR(room_of(gas.grid), before, 1e-12);
    EXPECT_TRUE(gas.grid.walls.voids);
    take_out(10, 12);  // one outside it: the way to the hollow
    EXPECT_FALSE(gas.grid.walls.voids);
    EXPECT_NEAR(1 - room_of(gas.grid), 25.0 / 27 * block, 0.08 * block);
    for (std::size_t brick = 0; brick < bricks.left.size(); ++brick)
        if (bricks.left[brick] != 0) take_out(brick, 6);
    EXPECT_NEAR(room_of(gas.grid), 1, 1e-12);  // round-off of 14 000 cells
    const EulerAmount last = contents(gas.grid).gas;
    std::printf("%d steps: mass %.1e off, energy %.1e off, squeezed %d\n", int(gas.clock.step()),
                last.whole_mass() / first.whole_mass() - 1, last.energy / first.energy - 1, int(gas.grid.walls.squeezed));
    EXPECT_NEAR(last.whole_mass(), first.whole_mass(), 1e-13 * first.whole_mass());
    EXPECT_NEAR(last.energy, first.energy, 1e-13 * first.energy);
    EXPECT_EQ(gas.to_structure.energy, 0);
    EXPECT_EQ(gas.grid.walls.squeezed, 0u);
}

}  // namespace
}  // namespace corpuscle
