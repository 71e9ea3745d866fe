#pragma once

#include "math/vector3.hpp"

namespace corpuscle {

/// What can be shown of any element, whatever its kind.
struct ElementValues {
    double von_mises = 0;             ///< largest over its points [Pa]
    double von_mises_lower = 0;       ///< at its lowest point [Pa]
    double von_mises_middle = 0;      ///< at its middle point (the upper of two) [Pa]
    double von_mises_upper = 0;       ///< at its uppermost point [Pa]
    double plastic_strain = 0;        ///< largest over its points [1]
    double thickness = 0;             ///< of shells [m]
    double pressure = 0;              ///< mean of its points, compression positive [Pa]
    double damage = 0;                ///< smallest over its points, failed at 1 [1]
    double least_plastic_strain = 0;  ///< smallest over its points [1]
    double principal_stress = 0;      ///< smallest over its points of the largest principal stress [Pa]
    double heat = 0;                  ///< largest rise of temperature by plastic work [K]
};

/// Where an element's energy is. [J]
struct ElementEnergy {
    double internal = 0;   ///< strain energy and plastic work
    double plastic = 0;    ///< the plastic work in it
    double hourglass = 0;  ///< beside it

    ElementEnergy& operator+=(const ElementEnergy& b)
    {
        internal += b.internal;
        plastic += b.plastic;
        hourglass += b.hourglass;
        return *this;
    }
};

/// What an element gives to each of its corners.
struct CornerMass {
    double mass = 0;     ///< [kg]
    double inertia = 0;  ///< [kg m2]
};

/// What an element does to one of its corners: force [N] and moment [N m] on the node.
struct CornerLoad {
    Vector3d force;
    Vector3d moment;
};

}  // namespace corpuscle
