#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "laws/strength/material.hpp"
#include "math/vector3.hpp"
#include "mesh/mesh.hpp"
#include "structure/elements/hourglass_control.hpp"

namespace corpuscle {

/// What a part is made of: deforming shells, or a rigid surface that must be fully held.
enum class ElementKind { shell, rigid };

/// How points lie through a shell's thickness: Lobatto has points on both faces, Gauss is exact to higher order.
enum class PointRule { gauss, lobatto };

/// Some of the three directions.
struct Directions {
    bool x = false, y = false, z = false;
};

/// Nodes (of the mesh) that are held, and in which directions.
struct Hold {
    std::vector<std::uint32_t> nodes;
    Directions translation;
    Directions rotation;
};

/// Holds nodes wholly: translation and rotation in every direction.
[[nodiscard]] Hold clamp(std::vector<std::uint32_t> nodes);

/// Holds nodes in place, free to turn.
[[nodiscard]] Hold pin(std::vector<std::uint32_t> nodes);

/// Holds nodes on a plane of symmetry normal to `axis` (0, 1, 2): no way along the axis, no turning about the other two.
[[nodiscard]] Hold symmetry(std::vector<std::uint32_t> nodes, int axis);

/// All there is to say about a part before it is built.
struct PartDescription {
    std::string name;
    ElementKind element = ElementKind::shell;
    Mesh mesh;
    Material material;                ///< not read for rigid parts
    double thickness = 0;             ///< of shells [m]
    std::vector<double> thicknesses;  ///< of each element instead, if not empty [m]
    int points = 5;                   ///< through the thickness, 2..10
    PointRule rule = PointRule::gauss;
    double shear_factor = 5.0 / 6.0;  ///< of transverse shear [1]
    HourglassControl hourglass;
    std::vector<Hold> holds;
    Vector3d velocity;  ///< at the start, where not held [m/s]
    Place place;        ///< where the part was read, for messages
};

}  // namespace corpuscle
