#include "mesh/extrude.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "mesh/measure.hpp"

namespace corpuscle {

namespace {

constexpr double max_solids = 2e7;

void require_sweepable(const Mesh& surface, const Vector3d& way, int layers)
{
    if (layers < 1) throw InputError(fmt::format("{} layers were asked for", layers), "give at least 1 layer");
    if (!(norm(way) > 0) || !std::isfinite(norm(way))) throw InputError("the height of an extruded mesh is 0", "give a length above 0");
    if (static_cast<double>(surface.elements.size()) * layers > max_solids)
        throw InputError(fmt::format("a mesh of {} layers of {} elements was asked for", layers, surface.elements.size()),
                         "give fewer layers or a larger element_size");
    for (std::size_t e = 0; e < surface.elements.size(); ++e)
        if (surface.elements[e].shape != ElementShape::quadrilateral)
            throw InputError(element_place(surface, e) + " is no quadrilateral, so it sweeps no hexahedron",
                             "extrude a mesh of quadrilaterals");
}

/// The hexahedron over a quadrilateral between two sheets of nodes, its corners as gmsh orders them whichever way the surface faces.
MeshElement hexahedron(const MeshElement& quad, std::uint32_t low, std::uint32_t high, bool along)
{
    MeshElement solid{ElementShape::hexahedron, {}};
    for (int c = 0; c < 4; ++c) {
        const std::uint32_t node = quad.node[along ? c : 3 - c];
        solid.node[c] = node + low;
        solid.node[c + 4] = node + high;
    }
    return solid;
}

}  // namespace

Mesh extruded(const Mesh& surface, const Vector3d& way, int layers)
{
    require_sweepable(surface, way, layers);
    const auto sheet = static_cast<std::uint32_t>(surface.nodes.size());
    Mesh solid;
    for (int layer = 0; layer <= layers; ++layer)
        for (const Vector3d& node : surface.nodes) solid.nodes.push_back(node + (static_cast<double>(layer) / layers) * way);
    for (int layer = 0; layer < layers; ++layer)
        for (const MeshElement& quad : surface.elements)
            solid.elements.push_back(hexahedron(quad, layer * sheet, (layer + 1) * sheet, dot(area_vector(surface, quad), way) > 0));
    for (const auto& [name, nodes] : surface.node_sets)
        for (int layer = 0; layer <= layers; ++layer)
            for (const std::uint32_t node : nodes) solid.node_sets[name].push_back(node + layer * sheet);
    for (const auto& [name, elements] : surface.element_sets)
        for (int layer = 0; layer < layers; ++layer)
            for (const std::uint32_t element : elements)
                solid.element_sets[name].push_back(element + layer * static_cast<std::uint32_t>(surface.elements.size()));
    for (std::uint32_t node = 0; node < sheet; ++node) {
        solid.node_sets["start"].push_back(node);
        solid.node_sets["end"].push_back(node + layers * sheet);
    }
    return solid;
}

}  // namespace corpuscle
