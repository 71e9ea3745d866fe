#pragma once

#include <string>
#include <vector>

#include "math/box.hpp"
#include "mesh/mesh.hpp"
#include "mesh/triangles.hpp"

namespace corpuscle {

/// The body inside a closed surface: tells inside from outside with a ray, in a time that hardly depends on the number of triangles.
class ClosedSurface {
public:
    /// Takes a surface of triangles and quadrilaterals, repairs its orientation; refuses (InputError naming `name`) holes.
    ClosedSurface(Mesh mesh, const std::string& name);

    /// By the signed crossings of the line through the point along x. Both triangles at an edge judge it by the same number, so
    /// no line slips between them; where round-off still spoils the count, the winding number decides.
    [[nodiscard]] bool contains(const Vector3d& point) const;
    [[nodiscard]] const Box& bounds() const { return bounds_; }  ///< [m]
    [[nodiscard]] double volume() const { return volume_; }      ///< [m3]
    /// Exact but for round-off: the surface's columns along z are cut by the box. [m3]
    [[nodiscard]] double volume_within(const Box& box) const;

private:
    /// Columns along x over a grid in y and z, each with the triangles that may cross it.
    struct Columns {
        int rows_y = 1, rows_z = 1;
        std::vector<std::uint32_t> first;  ///< where each column's triangles begin
        std::vector<std::uint32_t> triangle;
    };

    explicit ClosedSurface(const Mesh& mesh);  ///< of an oriented mesh: all but bounds and columns
    void make_columns();
    [[nodiscard]] int row(double value, int axis, int rows) const;

    std::vector<Vector3d> nodes_;      ///< [m]
    std::vector<Triangle> triangles_;  ///< normals out of the body
    Box bounds_;
    double volume_ = 0;
    Columns columns_;
};

}  // namespace corpuscle
