#pragma once

#include <functional>
#include <memory>

#include "../../unit/contact/gas_structure_bodies.hpp"
#include "../../unit/euler/euler_samples.hpp"
#include "contact/grid_walls.hpp"
#include "euler/wall_flux.hpp"

namespace corpuscle {

/// Adds a flat sheet of n by m cells, each cut in two facets, from `corner` along `a` and `b` [m]; returns the number of its first facet.
inline std::size_t add_sheet(MovingSurface& to, const Vector3d& corner, const Vector3d& a, const Vector3d& b, std::uint32_t n = 1,
                             std::uint32_t m = 1)
{
    const auto first = static_cast<std::uint32_t>(to.start.size());
    const std::size_t facet = to.surface.facets.size();
    for (std::uint32_t j = 0; j <= m; ++j)
        for (std::uint32_t i = 0; i <= n; ++i) to.start.push_back(corner + (double(i) / n) * a + (double(j) / m) * b);
    for (std::uint32_t j = 0; j < m; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t q = first + i + (n + 1) * j;
            to.surface.facets.push_back({{q, q + 1, q + n + 2}, 0, 0});
            to.surface.facets.push_back({{q, q + n + 2, q + n + 1}, 0, 0});
        }
    }
    return facet;
}

/// A grid of gas with walls of bare facets in it, stepped as in a run.
struct WalledGas {
    WalledGas(EulerGrid grid_, const MovingSurface& surface, double node_mass)
        : grid(std::move(grid_)), structure(bare_structure(surface.surface, surface.start, node_mass)), walls(grid, structure)
    {
        structure.nodes.previous = structure.nodes.position;
        walls.begin();
        prepare(grid);
    }
    WalledGas(const WalledGas&) = delete;

    void step(double left)
    {
        clock.begin_step(std::min({stable_step(grid), walls.stable_step(), left}));
        move_freely(structure.nodes, clock.duration());
        for (const Transfer& given : walls.apply(clock)) to_structure += {given.mass, given.momentum, given.energy};
        flow(grid, clock);
        clock.end_step();
    }
    void run_to(double end)
    {
        while (clock.time() < end * (1 - 1e-12)) step(end - clock.time());
    }

    /// Mean pressure of the gas on the walls beside the cells that `seen` picks, and its scatter; the gas lies on the side of the walls
    /// that `towards` points to.
    [[nodiscard]] std::pair<double, double> pressure_on(const std::function<bool(const Vector3d&)>& seen, const Vector3d& towards) const
    {
        double area = 0, push = 0, square = 0;
        for (const WallFace& face : grid.walls.faces) {
            const bool upper = dot(face.area, towards) > 0;
            const std::size_t cell = upper ? face.upper : face.lower;
            if (cell == no_cell || !seen(grid.middle(cell))) continue;
            const EulerCell state = look(grid, cell);
            const Vector3d out = (upper ? -1.0 : 1.0) * normalized(face.area);
            const double p = wall_pressure(state, dot(state.velocity, out)), size = norm(face.area);
            area += size, push += size * p, square += size * p * p;
        }
        const double mean = push / area;
        return {mean, std::sqrt(std::max(0.0, square / area - mean * mean))};
    }

    EulerGrid grid;
    Structure structure;
    GridWalls walls;
    Clock clock;
    struct Sum {
        double mass = 0;
        Vector3d momentum;
        double energy = 0;
        Sum& operator+=(const Sum& b)
        {
            mass += b.mass, momentum += b.momentum, energy += b.energy;
            return *this;
        }
    } to_structure;
};

}  // namespace corpuscle
