#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "../../unit/contact/gas_structure_bodies.hpp"
#include "mesh/generators.hpp"

namespace corpuscle {

/// A closed surface about the origin, every point of which the origin sees, and how much each node swings of its own accord.
struct ClosedWalls {
    std::string name;
    Surface surface;
    std::vector<Vector3d> nodes;  ///< at rest [m]
    double swing = 0;             ///< share of a node's distance from the origin
};

/// Cuts the quadrilaterals of a box's mesh in two.
inline ClosedWalls box_walls(std::string name, double side, double element_size)
{
    const Mesh mesh = box_mesh({{-side / 2, -side / 2, -side / 2}, {side / 2, side / 2, side / 2}}, element_size);
    ClosedWalls walls{std::move(name), {}, mesh.nodes, 0};
    for (const MeshElement& e : mesh.elements) {
        walls.surface.facets.push_back({{e.node[0], e.node[1], e.node[2]}, 0, 0});
        walls.surface.facets.push_back({{e.node[0], e.node[2], e.node[3]}, 0, 0});
    }
    return walls;
}

inline ClosedWalls cube()
{
    return box_walls("cube", 0.8, 0.2);
}

/// A box so skewed that faces meet at 7 degrees.
inline ClosedWalls wedge()
{
    ClosedWalls walls = box_walls("wedge", 1, 0.5);
    for (Vector3d& p : walls.nodes) p = {0.4 * p.x + 1.2 * p.z, 0.5 * p.y, 0.15 * p.z};
    return walls;
}

inline ClosedWalls ball()
{
    const MovingSurface sphere = sphere_surface(0.5, 2);
    return {"ball", sphere.surface, sphere.start, 0};
}

/// A ball whose nodes lie at very unequal distances and swing each at its own pace: creases inward and outward that open and shut.
inline ClosedWalls star()
{
    MovingSurface sphere = sphere_surface(1, 2);
    Random random(11, Purpose::contact, 0, 0);
    for (Vector3d& p : sphere.start) p *= 0.3 + 0.4 * random.uniform_double();
    return {"star", sphere.surface, sphere.start, 0.15};
}

/// Where the middle of the walls is at time t [m]: it swings at up to 500 m/s.
inline Vector3d middle_at(double t)
{
    return {0.5 * std::sin(1000 * t), 0.3 * std::cos(700 * t), 0.2 * std::sin(900 * t)};
}

/// Where node n is at time t [m]: swinging with the middle, turning at 400 rad/s about (1, 1, 1), breathing.
inline Vector3d node_at(const ClosedWalls& walls, std::size_t n, double t)
{
    const Vector3d p = walls.nodes[n], axis = Vector3d{1, 1, 1} / std::sqrt(3.0);
    const double angle = 400 * t, own = static_cast<double>(n);
    const double breath = (1 + 0.1 * std::sin(1500 * t)) * (1 + walls.swing * std::sin((1000 + 37 * std::fmod(own, 31)) * t + own));
    const Vector3d turned = std::cos(angle) * p + std::sin(angle) * cross(axis, p) + (1 - std::cos(angle)) * dot(axis, p) * axis;
    return middle_at(t) + breath * turned;
}

/// Whether a point is strictly within walls of which `middle` sees everything: in the cone of a facet and in front of it.
inline bool within(const ClosedWalls& walls, const std::vector<Vector3d>& nodes, const Vector3d& middle, const Vector3d& point)
{
    const Vector3d p = point - middle;
    for (const Facet& facet : walls.surface.facets) {
        const Vector3d a = nodes[facet.node[0]] - middle, b = nodes[facet.node[1]] - middle, c = nodes[facet.node[2]] - middle;
        const double volume = dot(a, cross(b, c)), rounding = -1e-13 * std::abs(volume);
        if (dot(p, cross(a, b)) < rounding || dot(p, cross(b, c)) < rounding || dot(p, cross(c, a)) < rounding) continue;
        if (dot(p - a, cross(b - a, c - a)) * (volume < 0 ? -1 : 1) < 0) return true;
    }
    return false;
}

/// Distance from the middle within which a point is surely within the walls: that of the nearest facet's plane [m].
inline double sure_radius(const ClosedWalls& walls, const std::vector<Vector3d>& nodes, const Vector3d& middle)
{
    double least = 1e30;
    for (const Facet& facet : walls.surface.facets) {
        const Vector3d a = nodes[facet.node[0]], n = cross(nodes[facet.node[1]] - a, nodes[facet.node[2]] - a);
        least = std::min(least, std::abs(dot(a - middle, n)) / norm(n));
    }
    return least;
}

}  // namespace corpuscle
