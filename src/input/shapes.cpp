#include "input/shapes.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "input/meshes/read_mesh.hpp"
#include "input/placed.hpp"
#include "schema/units.hpp"

namespace corpuscle {

namespace {

using std::numbers::pi;

void require_ordered(const BoxRanges& box, const Place& place)
{
    for (const auto& [low, high] : box)
        if (!(low < high))
            throw InputError(fmt::format("the box runs from {} m to {} m along an axis", low, high),
                             "expected the lower end first, and some length", place);
}

/// The shape of a charge of which form and center are given, and mass or radius, or both of a cylinder.
Shape shape_of_form(const ChargeInput& charge)
{
    const double volume = charge.mass.value_or(0) / charge.explosive.values->density;
    const Vector3d center = *charge.center;
    switch (*charge.shape.form) {
        case ChargeForm::sphere: return Shape::sphere(center, charge.radius.value_or(std::cbrt(3 * volume / (4 * pi))));
        case ChargeForm::hemisphere:
            return Shape::hemisphere(center, charge.radius.value_or(std::cbrt(3 * volume / (2 * pi))), charge.axis);
        case ChargeForm::cylinder: break;
    }
    const double radius = charge.radius.value_or(std::cbrt(volume / (2 * pi * charge.length_over_diameter)));
    const bool both = charge.mass && charge.radius;
    return Shape::cylinder(center, radius, both ? volume / (pi * radius * radius) : 2 * radius * charge.length_over_diameter, charge.axis);
}

}  // namespace

std::string file_beside(const std::string& file, const CaseDescription& description)
{
    const std::filesystem::path path(file);
    return path.is_absolute() || description.folder.empty() ? path.string() : (description.folder / path).lexically_normal().string();
}

Mesh mesh_from_file(const std::string& file, const std::string& unit, const CaseDescription& description, const Place& place)
{
    return at_place(place, [&] {
        const std::string full = file_beside(file, description);
        if (!std::filesystem::exists(full))
            throw InputError(fmt::format("there is no mesh file '{}'", full), "expected a file beside the case, or its full path", place);
        return read_mesh(full, convert("1 " + unit, "m"));
    });
}

Shape make_shape(const ShapeInput& input, const CaseDescription& description)
{
    const Place& place = input.places.own;
    return at_place(place, [&] {
        if (input.box) {
            require_ordered(*input.box, place);
            return Shape::box(box_of(*input.box));
        }
        if (input.sphere) return Shape::sphere(input.sphere->center, input.sphere->radius);
        if (input.hemisphere) return Shape::hemisphere(input.hemisphere->center, input.hemisphere->radius, input.hemisphere->axis);
        if (input.cylinder)
            return Shape::cylinder(input.cylinder->center, input.cylinder->radius, input.cylinder->length, input.cylinder->axis);
        if (input.ellipsoid) return Shape::ellipsoid(input.ellipsoid->center, input.ellipsoid->semi_axes);
        if (input.surface)
            return Shape::surface(mesh_from_file(input.surface->file, input.surface->unit, description, place), input.surface->file);
        throw InputError("the shape has a form but no size",
                         "expected a shape with its size, such as shape = { sphere = { center = [0, 0, 0], radius = \"0.1 m\" } }", place);
    });
}

void check_form(const ChargeInput& charge)
{
    const char* remedy = "expected center and mass or radius, such as mass = \"15 kg\" and center = [0, 0, \"700 mm\"]";
    if (!charge.mass && !charge.radius) throw InputError("the charge has a form but neither mass nor radius", remedy, charge.places.own);
    if (!charge.center) throw InputError("the charge has a form but no center", remedy, charge.places.own);
    if (!charge.mass || !charge.radius) return;
    if (*charge.shape.form != ChargeForm::cylinder)
        throw InputError("the charge has both a mass and a radius", "leave one out: the explosive's density joins them",
                         charge.places.of("radius"));
    if (charge.places.keys.contains("length_over_diameter"))
        throw InputError("the charge has a mass, a radius and length_over_diameter", "leave one out: the explosive's density joins them",
                         charge.places.of("length_over_diameter"));
}

Shape make_charge_shape(const ChargeInput& charge, const CaseDescription& description)
{
    if (!charge.shape.form) {
        if (charge.mass || charge.radius)
            throw InputError(fmt::format("the charge has both a {} and a shape with its size", charge.mass ? "mass" : "radius"),
                             "leave one out: the explosive's density joins them", charge.places.of(charge.mass ? "mass" : "radius"));
        return make_shape(charge.shape, description);
    }
    check_form(charge);
    return at_place(charge.places.own, [&] { return shape_of_form(charge); });
}

}  // namespace corpuscle
