#pragma once

#include <cmath>
#include <string>

#include "structure/builder.hpp"
#include "structure/energy.hpp"

namespace corpuscle {

inline Material elastic_steel()
{
    return {"elastic steel", 7838.0, 212e9, 0.28, Elastic{}};
}

inline Material armour_steel()
{
    return {"rha", 7838.0, 212e9, 0.28, BilinearPlastic{1200e6, 6500e6, 300.0, 5.0, 0.0}};
}

/// n by n squares over [0, side]^2 in z = 0; inner nodes shifted by up to `crook` of an element, the same way each time.
inline Mesh square_mesh(int n, double side, double crook = 0.0)
{
    Mesh mesh;
    const double h = side / n;
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const bool inside = i > 0 && i < n && j > 0 && j < n;
            const double shift = inside ? crook * h : 0.0;
            mesh.nodes.push_back({i * h + shift * std::sin(7.0 * i + 3.0 * j), j * h + shift * std::cos(5.0 * i - 4.0 * j), 0.0});
        }
    }
    const auto at = [n](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            mesh.elements.push_back({ElementShape::quadrilateral, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}});
    return mesh;
}

inline PartDescription plate(Mesh mesh, Material material, double thickness)
{
    PartDescription d;
    d.name = "plate";
    d.mesh = std::move(mesh);
    d.material = std::move(material);
    d.thickness = thickness;
    return d;
}

/// Half a step's work of the nodal forces: what `integration` is but for the change of the step. [J]
inline double work_in_transit(const Structure& structure, double duration)
{
    const Nodes& n = structure.nodes;
    double work = 0;
    for (std::size_t i = 0; i < n.size(); ++i)
        work += 0.5 * duration * (dot(n.force[i], n.velocity[i]) + dot(n.moment[i], n.angular_velocity[i]));
    return work;
}

/// One step in the order of a simulation.
inline void step(Structure& structure, Clock& clock, double duration)
{
    clock.begin_step(duration);
    accelerate(structure, clock);
    resist(structure, clock);
    clock.end_step();
}

}  // namespace corpuscle
