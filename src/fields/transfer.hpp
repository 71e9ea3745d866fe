#pragma once

#include <string>

#include "math/vector3.hpp"

namespace corpuscle {

/// What one holder gave to another in a step: the ledger's entry. Holders are bodies ("gas", "structure", "explosive")
/// or the world around them ("ambient", "support", "open edge", "conwep").
struct Transfer {
    std::string from;
    std::string to;
    double mass = 0;    ///< [kg]
    Vector3d momentum;  ///< [kg m/s]
    double energy = 0;  ///< [J]
};

}  // namespace corpuscle
