#include "input/solid_cuts.hpp"

#include "input/build_structure.hpp"
#include "input/placed.hpp"
#include "mesh/solid_faces.hpp"

namespace corpuscle {

namespace {

/// The outer faces of a mesh of solids, as a mesh of triangles and quadrilaterals.
Mesh outer_surface(const Mesh& solid)
{
    Mesh surface;
    surface.nodes = solid.nodes;
    for (const SolidFace& face : solid_faces(solid.elements)) {
        if (!face.is_outer()) continue;
        MeshElement element{face.corners == 3 ? ElementShape::triangle : ElementShape::quadrilateral, {}};
        std::copy_n(face.node.begin(), face.corners, element.node.begin());
        surface.elements.push_back(element);
    }
    return surface;
}

}  // namespace

void cut_by_solids(GasPlan& plan, const CaseDescription& description)
{
    for (const PartInput& part : description.parts) {
        if (!part.element.is_solid()) continue;
        const Mesh surface = outer_surface(make_mesh(part, description));
        if (surface.elements.empty()) continue;  // no solids: refused when the part is built
        const Shape shape = at_place(part.places.of("mesh"), [&] { return Shape::surface(surface, part.name); });
        if (!shape.bounds().overlaps(plan.gas.domain.box)) continue;
        for (Fill& fill : plan.fills)
            if (shape.bounds().overlaps(fill.shape.bounds())) fill.cut_by.push_back(shape);
    }
}

}  // namespace corpuscle
