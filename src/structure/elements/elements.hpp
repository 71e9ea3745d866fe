#pragma once

#include <cstddef>
#include <variant>

#include "structure/elements/quadrilateral_shells.hpp"
#include "structure/elements/rigid_facets.hpp"

namespace corpuscle {

/// The list of element kinds. Each kind is a class over many elements of one part, with
///     size(), shape(), corner_count(), node(element, corner)      who they are
///     add_masses(nodes)                     mass and inertia to their nodes
///     resist(nodes, duration, loads)        stress and corner loads; returns the first element gone wrong, or size()
///     stable_step()                         longest step at present, without safety factor [s]
///     values(element), energy(element)      what can be shown, and where its energy is
///     state(prefix)                         fields for a restart
/// To add one: a header and source like quadrilateral_shells, a name here, and its tests.
using Elements = std::variant<RigidFacets, QuadrilateralShells>;

inline std::size_t element_count(const Elements& elements)
{
    return std::visit([](const auto& e) { return e.size(); }, elements);
}

}  // namespace corpuscle
