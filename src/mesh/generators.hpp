#pragma once

#include "math/box.hpp"
#include "mesh/mesh.hpp"

// Meshes made from a few numbers: disk, ring, rectangle, box. All are of quadrilaterals, lengths in m.
// A quarter lies in x >= 0, y >= 0, its nodes on the planes x = 0 and y = 0 exactly there. Disks and rings lie in z = 0 about the
// origin, normals along +z. Nonsense (a radius or size not above 0, or more than 20 million elements) is refused with InputError.

namespace corpuscle {

/// Number of edges that disk_mesh puts on its rim (a quarter of them if `quarter`); even, at least 2 a quarter.
[[nodiscard]] int rim_divisions(double radius, double element_size, bool quarter);

/// Disk or quarter disk of well-shaped quadrilaterals: a core of squares that bulges into rings of quadrilaterals.
/// For radii above 4 element sizes edges are 0.57 to 1.55 element_size (0.67 to 1.24 above 20), aspects below 1.85, scaled Jacobians above
/// 0.8. Node set "rim"; its nodes lie on the circle.
[[nodiscard]] Mesh disk_mesh(double radius, double element_size, bool quarter);

/// Ring or quarter ring of quadrilaterals in rows of equal count. Node sets "inner" and "outer".
/// `inner_divisions` edges lie on the inner rim: give rim_divisions(radius, size, quarter) of a disk of the same radius, and the ring's
/// inner nodes are bit for bit the disk's rim nodes, so that nothing slips between them. 0: edges of element_size at the mean radius.
[[nodiscard]] Mesh ring_mesh(double inner_radius, double outer_radius, double element_size, bool quarter, int inner_divisions = 0);

/// Parallelogram from `origin` along two edge vectors, normal along edge_1 x edge_2.
/// Node sets "rim" (all four edges), "start_1", "end_1" (where edge_1 starts and ends), "start_2", "end_2".
[[nodiscard]] Mesh rectangle_mesh(const Vector3d& origin, const Vector3d& edge_1, const Vector3d& edge_2, double element_size);

/// Hollow closed box with outward normals, nodes shared along its edges. Element sets "x_min", "x_max", "y_min", ... "z_max".
[[nodiscard]] Mesh box_mesh(const Box& box, double element_size);

}  // namespace corpuscle
