#pragma once

#include <string>

#include "laws/strength/strength.hpp"

namespace corpuscle {

/// A solid material: its elasticity and its strength.
struct Material {
    std::string name;
    double density = 0;        ///< [kg/m3]
    double young_modulus = 0;  ///< [Pa]
    double poisson_ratio = 0;  ///< [1]
    Strength strength;
};

/// Throws InputError naming the material and the value that is not possible.
void check(const Material& material);

}  // namespace corpuscle
