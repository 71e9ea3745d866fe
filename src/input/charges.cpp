#include "input/charges.hpp"

#include <array>

#include <fmt/format.h>

#include "base/error.hpp"

namespace corpuscle {

namespace {

constexpr std::array<const char*, face_count> box_faces{"x-", "x+", "y-", "y+", "z-", "z+"};

}  // namespace

void check_ascends(double lower, double upper, const std::string& axis, const Place& place)
{
    if (lower < upper) return;
    throw InputError(fmt::format("the gas box runs from {} m to {} m along {}", lower, upper, axis),
                     "expected the lower end first, and some length", place);
}

void check_within(const Shape& shape, const Domain& domain, const ChargeInput& charge, const std::string& owner)
{
    const Place& place = charge.places.of(charge.center ? "center" : "shape");
    const Box bounds = shape.bounds();
    if (!(shape.volume_within(domain.box) > 1e-9 * shape.volume()))
        throw InputError(fmt::format("the charge, around ({}, {}, {}) m, lies outside the gas box", bounds.center().x, bounds.center().y,
                                     bounds.center().z),
                         fmt::format("expected it within the box of {}: move the charge or enlarge the box", owner), place);
    for (int face = 0; face < face_count; ++face) {
        const int axis = face / 2;
        const double out = face % 2 == 0 ? domain.box.lower[axis] - bounds.lower[axis] : bounds.upper[axis] - domain.box.upper[axis];
        if (domain.edges[static_cast<std::size_t>(face)] != Edge::rigid && out > 1e-9 * bounds.size()[axis])
            throw InputError(
                fmt::format("the charge sticks {:.4g} m out of the gas box at {}", out, box_faces[static_cast<std::size_t>(face)]),
                "expected it within the box, or that edge \"rigid\" if it is a plane of symmetry", place);
    }
}

}  // namespace corpuscle
