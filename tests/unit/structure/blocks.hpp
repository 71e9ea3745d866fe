#pragma once

#include <cmath>

#include "plates.hpp"

namespace corpuscle {

/// A box of nx by ny by nz bricks from the origin to `size`; inner nodes shifted by up to `crook` of an element, the same way each time.
inline Mesh brick_mesh(std::array<int, 3> n, const Vector3d& size, double crook = 0.0)
{
    Mesh mesh;
    const Vector3d h{size.x / n[0], size.y / n[1], size.z / n[2]};
    const auto at = [&n](int i, int j, int k) { return static_cast<std::uint32_t>((k * (n[1] + 1) + j) * (n[0] + 1) + i); };
    for (int k = 0; k <= n[2]; ++k) {
        for (int j = 0; j <= n[1]; ++j) {
            for (int i = 0; i <= n[0]; ++i) {
                const bool inside = i > 0 && i < n[0] && j > 0 && j < n[1] && k > 0 && k < n[2];
                const Vector3d shift{std::sin(7.0 * i + 3.0 * j - k), std::cos(5.0 * i - 4.0 * j + 2.0 * k),
                                     std::sin(1.0 + 3.0 * i + j - 6.0 * k)};
                mesh.nodes.push_back(Vector3d{i * h.x, j * h.y, k * h.z} + (inside ? crook : 0.0) * scaled(h, shift));
            }
        }
    }
    for (int k = 0; k < n[2]; ++k)
        for (int j = 0; j < n[1]; ++j)
            for (int i = 0; i < n[0]; ++i)
                mesh.elements.push_back({ElementShape::hexahedron,
                                         {at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k), at(i, j, k + 1),
                                          at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)}});
    return mesh;
}

/// A mesh with each brick cut into six tetrahedra around its diagonal.
inline Mesh cut_into_tetrahedra(Mesh mesh)
{
    std::vector<MeshElement> bricks;
    bricks.swap(mesh.elements);
    mesh.element_sets.clear();
    constexpr std::array<std::array<int, 2>, 6> around{{{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}}};
    for (const MeshElement& b : bricks)
        for (const auto& [p, q] : around)
            mesh.elements.push_back({ElementShape::tetrahedron, {b.node[0], b.node[p], b.node[q], b.node[6], 0, 0, 0, 0}});
    return mesh;
}

/// A box of bricks so cut.
inline Mesh tetrahedron_mesh(std::array<int, 3> n, const Vector3d& size, double crook = 0.0)
{
    return cut_into_tetrahedra(brick_mesh(n, size, crook));
}

/// The same with each quadrilateral cut into two triangles.
inline Mesh triangle_mesh(int n, double side, double crook = 0.0)
{
    Mesh mesh = square_mesh(n, side, crook);
    std::vector<MeshElement> squares;
    squares.swap(mesh.elements);
    for (const MeshElement& s : squares) {
        mesh.elements.push_back({ElementShape::triangle, {s.node[0], s.node[1], s.node[2], 0, 0, 0, 0, 0}});
        mesh.elements.push_back({ElementShape::triangle, {s.node[0], s.node[2], s.node[3], 0, 0, 0, 0, 0}});
    }
    return mesh;
}

inline PartDescription block(Mesh mesh, Material material)
{
    PartDescription d;
    d.name = "block";
    d.element = ElementKind::solid;
    d.mesh = std::move(mesh);
    d.material = std::move(material);
    return d;
}

}  // namespace corpuscle
