#pragma once

#include "blocks.hpp"
#include "mesh/extrude.hpp"
#include "mesh/generators.hpp"
#include "mesh/selection.hpp"

namespace corpuscle {

/// The copper bar of the Taylor test: 32.4 mm long, 3.2 mm in radius, 227 m/s.
struct TaylorBar {
    double length = 0.0324, radius = 0.0032, speed = 227.0, time = 80e-6;
    Material copper{"copper", 8930.0, 117e9, 0.35, BilinearPlastic{400e6, 100e6, 0.0, 1.0, 0.0}};

    /// A quarter of it with elements of about `size` [m], standing on a frictionless wall at z = 0, moving towards it.
    [[nodiscard]] PartDescription part(double size) const
    {
        Mesh mesh = extruded(disk_mesh(radius, size, true), {0, 0, length}, static_cast<int>(std::lround(length / size)));
        PartDescription d = block(std::move(mesh), copper);
        d.holds = {symmetry(select_nodes(d.mesh, "x=0"), 0), symmetry(select_nodes(d.mesh, "y=0"), 1),
                   symmetry(select_nodes(d.mesh, "z=0"), 2)};
        d.velocity = {0, 0, -speed};
        return d;
    }
};

/// What the bar looks like at the end.
struct TaylorResult {
    double length = 0, foot = 0;  ///< [m]
    double plastic_strain = 0;
    double energy_error = 0, hourglass = 0;  ///< over the energy at the start
    int steps = 0;
};

inline TaylorResult run_taylor(const TaylorBar& bar, const PartDescription& d)
{
    Structure s;
    add_part(s, d);
    const double start = energy(s).kinetic;
    Clock clock;
    TaylorResult result;
    double duration = 0.95 * stable_step(s);
    while (clock.time() < bar.time) {
        if (duration > stable_step(s) || duration < 0.8 * stable_step(s)) duration = 0.95 * stable_step(s);
        step(s, clock, std::min(duration, std::max(1e-15, bar.time - clock.time())));
        ++result.steps;
    }
    for (std::size_t i = 0; i < s.nodes.size(); ++i) {
        const Vector3d& x = s.nodes.position[i];
        result.length = std::max(result.length, x.z);
        if (x.z < 1e-9) result.foot = std::max(result.foot, std::hypot(x.x, x.y));
    }
    const StructureEnergy e = energy(s);
    result.plastic_strain = max_plastic_strain(s.parts[0]);
    result.energy_error = std::abs(e.integration - work_in_transit(s, clock.duration())) / start;
    result.hourglass = e.hourglass / start;
    return result;
}

}  // namespace corpuscle
