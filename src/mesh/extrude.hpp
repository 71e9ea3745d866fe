#pragma once

#include "mesh/mesh.hpp"

namespace corpuscle {

/// The solid that a surface of quadrilaterals sweeps on its `way` [m], in so many layers of hexahedra. Node sets of the surface go along;
/// "start" and "end" are the nodes where the way begins and ends. Refuses (InputError) triangles, no layers, and a way that does not leave
/// the surface.
[[nodiscard]] Mesh extruded(const Mesh& surface, const Vector3d& way, int layers);

}  // namespace corpuscle
