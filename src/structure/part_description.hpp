#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "laws/strength/material.hpp"
#include "math/vector3.hpp"
#include "mesh/mesh.hpp"
#include "structure/drive.hpp"
#include "structure/elements/hourglass_control.hpp"
#include "structure/elements/solids.hpp"
#include "structure/erosion.hpp"

namespace corpuscle {

/// What a part is made of: deforming shells, membranes (shells that do not bend), solids, or a rigid body: fully held, or
/// with a mass and moving.
enum class ElementKind { shell, membrane, solid, rigid };

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

/// Mass put on nodes besides that of the elements, in equal parts.
struct PointMass {
    std::vector<std::uint32_t> nodes;
    double mass = 0;  ///< of all of them together [kg]
};

/// Nodes (of the mesh) that move at the start otherwise than their part.
struct StartVelocity {
    std::vector<std::uint32_t> nodes;
    Vector3d velocity;  ///< [m/s]
};

/// What a rigid part that moves weighs: its elements with the material's density (solids, or surfaces of a thickness), or given numbers.
struct RigidMass {
    std::optional<double> mass;       ///< [kg]
    std::optional<Vector3d> inertia;  ///< about the center along x, y, z [kg m2]
    std::optional<Vector3d> center;   ///< [m]
};

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
    bool full_integration = false;  ///< of bricks: eight points instead of one and hourglass control
    double brick_hourglass = 0.02;  ///< stiffness against a one-point brick's hourglass modes [1]
    BulkViscosity viscosity;        ///< of solids
    Erosion erosion;
    std::vector<Hold> holds;
    std::vector<PointMass> point_masses;
    RigidMass rigid;    ///< of a rigid part
    Vector3d spin;      ///< angular velocity at the start, about the center of mass [rad/s]
    Vector3d velocity;  ///< at the start, where not held [m/s]
    std::vector<StartVelocity> starts;
    std::vector<Drive> drives;  ///< prescribed motions, of nodes of the mesh
    Place place;                ///< where the part was read, for messages
    Place material_place;       ///< where its material was, if that is known
};

}  // namespace corpuscle
