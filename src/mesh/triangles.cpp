#include "mesh/triangles.hpp"

#include <cmath>
#include <numbers>

namespace corpuscle {

void append_triangles(const MeshElement& element, std::vector<Triangle>& triangles)
{
    const auto& node = element.node;
    if (element.shape == ElementShape::triangle) triangles.push_back({node[0], node[1], node[2]});
    if (element.shape != ElementShape::quadrilateral) return;
    triangles.push_back({node[0], node[1], node[2]});
    triangles.push_back({node[0], node[2], node[3]});
}

std::vector<Triangle> triangles_of(const Mesh& mesh)
{
    std::vector<Triangle> triangles;
    triangles.reserve(2 * mesh.elements.size());
    for (const MeshElement& element : mesh.elements) append_triangles(element, triangles);
    return triangles;
}

double signed_volume(std::span<const Vector3d> nodes, std::span<const Triangle> triangles)
{
    if (triangles.empty()) return 0.0;
    const Vector3d origin = nodes[triangles.front()[0]];  // near the body: no loss of digits far from zero
    double six_volumes = 0.0;
    for (const auto& [a, b, c] : triangles) six_volumes += dot(cross(nodes[a] - origin, nodes[b] - origin), nodes[c] - origin);
    return six_volumes / 6.0;
}

double winding_number(std::span<const Vector3d> nodes, std::span<const Triangle> triangles, const Vector3d& point)
{
    double half_angles = 0.0;
    for (const auto& triangle : triangles) {
        const Vector3d a = nodes[triangle[0]] - point, b = nodes[triangle[1]] - point, c = nodes[triangle[2]] - point;
        const double la = norm(a), lb = norm(b), lc = norm(c);
        half_angles += std::atan2(dot(cross(a, b), c), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return half_angles / (2.0 * std::numbers::pi);
}

}  // namespace corpuscle
