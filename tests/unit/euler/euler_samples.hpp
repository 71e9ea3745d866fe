#pragma once

#include "euler/fill.hpp"
#include "euler/flow.hpp"

namespace corpuscle {

/// Products of TNT, and its energy [J/kg].
inline const Jwl tnt_products{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630};
constexpr double tnt_energy = 7e9 / 1630;

/// Gases without explosive.
inline EulerMaterial plain(const char* name, const EquationOfState& law)
{
    return {name, law, {}};
}

/// A grid of equal cells in the unit cube, square or line (dims 1 are inert), all edges alike.
inline EulerGrid unit_grid(std::size_t nx, std::size_t ny, std::size_t nz, EulerEdge edge, std::vector<EulerMaterial> materials,
                           const EulerSettings& settings = {})
{
    std::array<EulerEdge, euler_face_count> edges;
    edges.fill(edge);
    return make_grid(EulerSpace::planar, {even_faces(0, 1, nx), even_faces(0, 1, ny), even_faces(0, 1, nz)}, edges, std::move(materials),
                     settings);
}

/// Steps to a time, the last step cut to reach it; returns what explosive gave.
inline EulerAmount run_until(EulerGrid& grid, Clock& clock, double end)
{
    EulerAmount released;
    while (clock.time() < end * (1 - 1e-12)) {
        clock.begin_step(std::min(stable_step(grid), end - clock.time()));
        released += flow(grid, clock);
        clock.end_step();
    }
    return released;
}

}  // namespace corpuscle
