#include "input/grid_symmetry.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/error.hpp"

namespace corpuscle {

namespace {

/// A shape that a turn about one axis leaves as it is.
struct Revolved {
    Vector3d center;
    std::optional<Vector3d> axis;  ///< any, if none
};

std::optional<Revolved> revolved(const ShapeInput& shape)
{
    if (shape.sphere) return Revolved{shape.sphere->center, {}};
    if (shape.hemisphere) return Revolved{shape.hemisphere->center, shape.hemisphere->axis};
    if (shape.cylinder) return Revolved{shape.cylinder->center, shape.cylinder->axis};
    if (shape.ellipsoid && shape.ellipsoid->semi_axes.x == shape.ellipsoid->semi_axes.y)
        return Revolved{shape.ellipsoid->center, Vector3d{0, 0, 1}};
    return {};
}

bool fits(EulerSpace space, const std::optional<Revolved>& shape)
{
    if (space == EulerSpace::planar) return true;
    if (!shape || shape->center.x != 0 || shape->center.y != 0) return false;
    if (space == EulerSpace::spherical) return shape->center.z == 0 && !shape->axis;
    return !shape->axis || (shape->axis->x == 0 && shape->axis->y == 0);
}

void refuse_unless(bool good, EulerSpace space, const std::string& what, const Place& place)
{
    if (good) return;
    const bool axis = space == EulerSpace::axisymmetric;
    throw InputError(fmt::format("the {} is not symmetric about {}, as the grid of [euler] is", what, axis ? "the z axis" : "the point 0"),
                     axis ? "expected a sphere, or a hemisphere, cylinder or ellipsoid along z, with its center on the axis x = y = 0"
                          : "expected a sphere with its center at [0, 0, 0]",
                     place);
}

}  // namespace

void check_revolved(EulerSpace space, const ShapeInput& shape, const std::string& what)
{
    refuse_unless(fits(space, revolved(shape)), space, what, shape.places.own);
}

void check_revolved(EulerSpace space, const ChargeInput& charge)
{
    std::optional<Revolved> shape = revolved(charge.shape);
    if (charge.shape.form) {
        shape = Revolved{*charge.center, charge.axis};
        if (*charge.shape.form == ChargeForm::sphere) shape->axis.reset();
    }
    refuse_unless(fits(space, shape), space, "charge", charge.places.of(charge.center ? "center" : "shape"));
}

void check_on_axis(EulerSpace space, const Vector3d& point, const std::string& what, const Place& place)
{
    if (space == EulerSpace::planar) return;
    const bool good = point.x == 0 && point.y == 0 && (space == EulerSpace::axisymmetric || point.z == 0);
    if (!good)
        throw InputError(fmt::format("{} at ({:g}, {:g}, {:g}) m, off the axis of the grid's symmetry", what, point.x, point.y, point.z),
                         space == EulerSpace::axisymmetric ? "expected x = y = 0" : "expected [0, 0, 0]", place);
}

Vector3d grid_point(EulerSpace space, const Vector3d& point)
{
    if (space == EulerSpace::planar) return point;
    if (space == EulerSpace::axisymmetric) return {std::hypot(point.x, point.y), point.z, 0};
    return {norm(point), 0, 0};
}

Box grid_box(EulerSpace space, const Box& box)
{
    if (space == EulerSpace::planar) return box;
    const double radius = std::max(std::abs(box.lower.x), std::abs(box.upper.x));
    if (space == EulerSpace::axisymmetric) return {{0, box.lower.z, 0}, {radius, box.upper.z, 0}};
    return {{0, 0, 0}, {radius, 0, 0}};
}

Vector3d grid_velocity(EulerSpace space, const FillInput& fill)
{
    const Vector3d& velocity = fill.velocity;
    if (space == EulerSpace::planar) return velocity;
    if (velocity.x != 0 || velocity.y != 0 || (space == EulerSpace::spherical && velocity.z != 0))
        throw InputError("the fill moves across the axis of the grid's symmetry",
                         space == EulerSpace::axisymmetric ? "expected velocity = [0, 0, w]" : "expected no velocity",
                         fill.places.of("velocity"));
    return {0, velocity.z, 0};
}

}  // namespace corpuscle
