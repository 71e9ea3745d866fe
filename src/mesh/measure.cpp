#include "mesh/measure.hpp"

#include <fmt/format.h>

namespace corpuscle {

Box bounds(const Mesh& mesh)
{
    Box box;
    for (const Vector3d& node : mesh.nodes) box.include(node);
    return box;
}

double diagonal(const Mesh& mesh)
{
    return mesh.nodes.empty() ? 0.0 : norm(bounds(mesh).size());
}

Vector3d center(const Mesh& mesh, const MeshElement& element)
{
    Vector3d sum;
    const int count = node_count(element.shape);
    for (int i = 0; i < count; ++i) sum += mesh.nodes[element.node[i]];
    return sum / count;
}

Vector3d area_vector(const Mesh& mesh, const MeshElement& element)
{
    const auto at = [&](int i) { return mesh.nodes[element.node[i]]; };
    if (element.shape == ElementShape::triangle) return 0.5 * cross(at(1) - at(0), at(2) - at(0));
    if (element.shape == ElementShape::quadrilateral) return 0.5 * cross(at(2) - at(0), at(3) - at(1));
    return {};
}

double total_area(const Mesh& mesh)
{
    double area = 0.0;
    for (const MeshElement& element : mesh.elements) area += norm(area_vector(mesh, element));
    return area;
}

std::string point_text(const Vector3d& point)
{
    return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", point.x, point.y, point.z);
}

std::string element_place(const Mesh& mesh, std::size_t element)
{
    const std::int64_t number = mesh.elements[element].number;
    return fmt::format("element {} near {}", number != 0 ? number : static_cast<std::int64_t>(element) + 1,
                       point_text(center(mesh, mesh.elements[element])));
}

}  // namespace corpuscle
