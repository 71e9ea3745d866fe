#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "grid_walls.hpp"

namespace corpuscle {
namespace {

/// Three rooms behind one hull: one wall across the hull, and a second from it to the hull, which meets it in a T. In the block's own
/// coordinates the hull is the cube from -1 to 1, the first wall lies in x = 0, the second in y = 0 where x > 0. The motion is one linear
/// map for all, so the room of a place is known exactly, whatever the grid makes of it.
struct Rooms {
    static constexpr std::size_t outside = 3, count = 4;

    /// Where the own coordinates lie at a time: stretched, sheared, turned and displaced [m].
    struct Map {
        explicit Map(double t)
        {
            const double stretch = 1 + 0.15 * std::sin(200 * t), shear = 0.2 * std::sin(150 * t), angle = 0.3 + 40 * t;
            const std::array<Vector3d, 3> bent{0.24 * Vector3d{stretch, 0, 0}, 0.2 * Vector3d{shear, 1 / stretch, 0},
                                               0.21 * Vector3d{0, 0.5 * shear, 1}};
            const Vector3d axis = normalized(Vector3d{1, 2, 3});
            for (std::size_t i = 0; i < 3; ++i)
                column[i] =
                    std::cos(angle) * bent[i] + std::sin(angle) * cross(axis, bent[i]) + (1 - std::cos(angle)) * dot(axis, bent[i]) * axis;
            middle = Vector3d{0.47, 0.49, 0.52} + t * Vector3d{6, 4, -3};
            volume = dot(column[0], cross(column[1], column[2]));
        }
        [[nodiscard]] Vector3d place(const Vector3d& own) const
        {
            return middle + own.x * column[0] + own.y * column[1] + own.z * column[2];
        }
        [[nodiscard]] Vector3d back(const Vector3d& at) const
        {
            const Vector3d p = at - middle;
            return Vector3d{dot(p, cross(column[1], column[2])), dot(p, cross(column[2], column[0])), dot(p, cross(column[0], column[1]))} /
                   volume;
        }
        Vector3d middle;
        std::array<Vector3d, 3> column;
        double volume = 1;
    };

    static std::size_t room_of(const Vector3d& own)
    {
        if (std::max({std::abs(own.x), std::abs(own.y), std::abs(own.z)}) >= 1) return outside;
        return own.x < 0 ? 0 : own.y < 0 ? 1 : 2;
    }

    /// Adds a square from `corner` along `a` and `b` with nodes of its own.
    void add(const Vector3d& corner, const Vector3d& a, const Vector3d& b) { add_sheet(surface, corner, a, b); }

    /// With `joined`, walls that meet have their nodes in common; else each has its own, and their rims only touch.
    explicit Rooms(bool joined)
    {
        for (const double side : {-1.0, 1.0}) {
            for (const double low : {-1.0, 0.0}) {
                add({side, low, -1}, {0, 1, 0}, {0, 0, 2});
                for (const double left : {-1.0, 0.0}) add({left, low, side}, {1, 0, 0}, {0, 1, 0});
                add({low, side, -1}, {1, 0, 0}, {0, 0, 2});
            }
        }
        for (const double low : {-1.0, 0.0}) add({0, low, -1}, {0, 1, 0}, {0, 0, 2});
        add({0, 0, -1}, {1, 0, 0}, {0, 0, 2});
        if (joined) join();
        own = surface.start;
        for (Vector3d& p : surface.start) p = Map(0).place(p);
    }

    /// Nodes in one place become one.
    void join()
    {
        std::vector<Vector3d> places;
        std::vector<std::uint32_t> number;
        for (const Vector3d& p : surface.start) {
            std::uint32_t n = 0;
            while (n < places.size() && norm(places[n] - p) > 1e-9) ++n;
            if (n == places.size()) places.push_back(p);
            number.push_back(n);
        }
        for (Facet& facet : surface.surface.facets)
            for (std::uint32_t& node : facet.node) node = number[node];
        surface.start = places;
    }

    MovingSurface surface;
    std::vector<Vector3d> own;  ///< of the nodes
};

/// Masses of each gas in the room where it belongs, and elsewhere [kg].
struct Kept {
    std::array<double, Rooms::count> at_home{};
    double astray = 0;
};
Kept masses(const EulerGrid& grid, const Rooms::Map& map)
{
    Kept kept;
    for (std::size_t c = 0; c < grid.cells(); ++c) {
        const std::size_t room = Rooms::room_of(map.back(grid.middle(c)));
        for (std::size_t m = 0; m < Rooms::count; ++m) {
            const double mass = grid.volume(c) * grid.now.mass[m][c];
            (m == room ? kept.at_home[m] : kept.astray) += mass;
        }
    }
    return kept;
}

/// Rooms at a hundred thousand times each other's pressures, with walls in T joints that go, turn, stretch and shear through the grid: no
/// gas is ever in a room where it does not belong, exactly; each room's mass is kept, and the energy that the gas loses is the walls',
/// to round-off.
void expect_tight(bool joined)
{
    EulerGrid grid = unit_grid(
        20, 20, 20, EulerEdge::rigid,
        {plain("left", IdealGas{1.4}), plain("below", IdealGas{1.4}), plain("above", IdealGas{1.4}), plain("outside", IdealGas{1.4})});
    Rooms rooms(joined);
    const std::array<EulerSample, Rooms::count> filling{EulerSample{0, 10, 1e6, {}}, EulerSample{1, 1e-3, 10, {}},
                                                        EulerSample{2, 1, 1e5, {}}, EulerSample{3, 0.1, 1e3, {}}};
    fill(grid, [&](const Vector3d& x) { return filling[Rooms::room_of(Rooms::Map(0).back(x))]; });
    WalledGas gas(std::move(grid), rooms.surface, 0);
    // The filling shares cells by their volumes on both sides of a wall: what lies on the wrong side of the middle is taken out.
    for (std::size_t c = 0; c < gas.grid.cells(); ++c) {
        const std::size_t room = Rooms::room_of(Rooms::Map(0).back(gas.grid.middle(c)));
        for (std::size_t m = 0; m < Rooms::count; ++m) {
            gas.grid.now.mass[m][c] = m == room ? filling[room].density : 0.0;
            if (m + 1 < Rooms::count) gas.grid.now.share[m][c] = m == room ? 1.0 : 0.0;
        }
        gas.grid.now.energy[c] = filling[room].pressure / 0.4;
    }
    prepare(gas.grid);
    const EulerAmount first = contents(gas.grid).gas;
    while (gas.clock.time() < 0.006) {
        const double limit = std::min(stable_step(gas.grid), gas.walls.stable_step());
        const Rooms::Map to(gas.clock.time() + limit);
        for (std::size_t n = 0; n < rooms.own.size(); ++n)
            gas.structure.nodes.velocity[n] = (to.place(rooms.own[n]) - gas.structure.nodes.position[n]) / limit;
        gas.step(limit);
        ASSERT_EQ(masses(gas.grid, Rooms::Map(gas.clock.time())).astray, 0)
            << "step " << gas.clock.step() << ", squeezed " << gas.grid.walls.squeezed;
    }
    const EulerAmount last = contents(gas.grid).gas;
    const Kept kept = masses(gas.grid, Rooms::Map(gas.clock.time()));
    std::printf("%s: %llu steps, squeezed %llu, masses off", joined ? "nodes in common" : "rims that touch",
                static_cast<unsigned long long>(gas.clock.step()), static_cast<unsigned long long>(gas.grid.walls.squeezed));
    for (std::size_t m = 0; m < Rooms::count; ++m) {
        std::printf(" %.1e", kept.at_home[m] / first.mass[m] - 1);
        EXPECT_NEAR(kept.at_home[m], first.mass[m], 1e-12 * first.mass[m]);
    }
    std::printf(", energy %.1e\n", (last.energy + gas.to_structure.energy) / first.energy - 1);
    EXPECT_NEAR(last.energy + gas.to_structure.energy, first.energy, 1e-11 * first.energy);
    EXPECT_EQ(gas.grid.walls.squeezed, 0u);
}

TEST(GridJoints, rooms_that_have_nodes_in_common_keep_their_gas)
{
    expect_tight(true);
}

TEST(GridJoints, rooms_whose_rims_only_touch_keep_their_gas)
{
    expect_tight(false);
}

}  // namespace
}  // namespace corpuscle
