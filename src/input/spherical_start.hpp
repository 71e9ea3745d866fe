#pragma once

#include <array>

#include "gas/radial_fill.hpp"
#include "input/case/case_description.hpp"
#include "radial/charge.hpp"
#include "structure/structure.hpp"

namespace corpuscle {

struct GasPlan;

/// A case's one ball of explosive and the gas around it.
struct LoneCharge {
    RadialCharge charge;
    Vector3d center;  ///< [m]
    double lit = 0;   ///< [s]
};

/// Finds it. `who` wants it, at a place in the case: both are told in the InputError that refuses anything but one ball of explosive, lit
/// at its center, in a uniform gas.
[[nodiscard]] LoneCharge lone_charge(const CaseDescription& description, const std::string& who, const Place& place);

/// A blast that was solved in one dimension while it was a free sphere.
struct FreeBlast {
    double time = 0;                ///< [s]
    double front = 0;               ///< nothing beyond this radius has felt the blast [m]
    double obstacle = 0;            ///< distance of the nearest thing the blast will meet [m]
    std::array<RadialFill, 2> gas;  ///< products, surrounding gas: within `front`
};

/// Solves it until its front nears an obstacle at that distance [m]. Errors: InputError at the place of `start`: it is too near, or the
/// blast does not get there before the end time [s].
[[nodiscard]] FreeBlast solve_free_blast(const LoneCharge& lone, double obstacle, double end_time, const Place& place);

/// Distance from a blast's center to the nearest face of a domain that is no plane of symmetry through it [m].
[[nodiscard]] double distance_to_faces(const Domain& domain, const Vector3d& center);

/// Distance from a point to the nearest facet of a structure; infinity if it shows none [m].
[[nodiscard]] double distance_to_structure(const Structure& structure, const Vector3d& center);

/// Distance between a point and a box, 0 within [m].
[[nodiscard]] double distance_to_box(const Vector3d& point, const Box& box);

/// Where the particles of such a blast begin; their surrounding gas reaches from the front on to `edge`.
struct SphericalStart : FreeBlast {
    double edge = 0;                  ///< radius that holds whole particles of the surrounding gas [m]
    std::size_t inner_particles = 0;  ///< of the surrounding gas, within `edge`
};

/// Solves the case's charge in one dimension until its front nears the nearest facet, face of the box that is no plane of symmetry through
/// the charge, or other fill. Needs the plan's particle masses. Errors: InputError where the start does not apply: no single ball of
/// explosive lit at its center in a uniform gas, empirical loads beside it, obstacles too near, nothing to meet before the end.
[[nodiscard]] SphericalStart solve_spherical_start(const GasPlan& plan, const Structure& structure, const CaseDescription& description);

}  // namespace corpuscle
