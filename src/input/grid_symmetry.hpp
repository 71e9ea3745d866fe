#pragma once

#include <string>

#include "euler/axis.hpp"
#include "input/case/gas_input.hpp"

// What a grid's symmetry allows of shapes, points and velocities, and how they look in its coordinates.

namespace corpuscle {

/// Refuses a shape that a turn about the z axis (axisymmetric) or the point 0 (spherical) does not leave as it is. `what` it is for.
void check_revolved(EulerSpace space, const ShapeInput& shape, const std::string& what);

/// As above, of a charge, whose shape may be given by form and center.
void check_revolved(EulerSpace space, const ChargeInput& charge);

/// Refuses a point off the axis, or the center; `what` happens there.
void check_on_axis(EulerSpace space, const Vector3d& point, const std::string& what, const Place& place);

/// A point of space in the grid's coordinates: radius and height, or radius alone, in round grids.
[[nodiscard]] Vector3d grid_point(EulerSpace space, const Vector3d& point);

/// What a box of space spans in the grid's coordinates.
[[nodiscard]] Box grid_box(EulerSpace space, const Box& box);

/// A fill's velocity in the grid's coordinates; refuses one that the symmetry cannot have.
[[nodiscard]] Vector3d grid_velocity(EulerSpace space, const FillInput& fill);

}  // namespace corpuscle
