#pragma once

#include <cstddef>
#include <variant>

#include "structure/elements/bricks.hpp"
#include "structure/elements/full_bricks.hpp"
#include "structure/elements/quadrilateral_shells.hpp"
#include "structure/elements/rigid_facets.hpp"
#include "structure/elements/tetrahedra.hpp"
#include "structure/elements/triangle_shells.hpp"

namespace corpuscle {

/// The list of element kinds. Each kind is a class over many elements of one part, with
///     kind(), size(), shape(), corner_count(), node(element, corner)      who they are
///     corner_mass(element)                  what an element gives to each of its corners
///     resist(nodes, duration, loads)        stress and corner loads; returns the first element gone wrong, or size()
///     stable_step(), transit(element)       longest step at present, of all and of one, without safety factor [s]
///     is_left(element), remove(element)     whether it is still there; takes it out
///     values(element), energy(element)      what can be shown, and where its energy is
///     state(prefix)                         fields for a restart
/// To add one: a header and source like quadrilateral_shells, a name here, and its tests.
using Elements = std::variant<RigidFacets, QuadrilateralShells, Bricks, FullBricks, Tetrahedra, TriangleShells>;

inline std::size_t element_count(const Elements& elements)
{
    return std::visit([](const auto& e) { return e.size(); }, elements);
}

}  // namespace corpuscle
