#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "math/fast.hpp"

namespace corpuscle {

/// Exchange of energy between the relative motion of a pair and the internal freedoms of one of its particles
/// (Borgnakke and Larsen 1975). Of the energy they share, the internal part after it is Beta(zeta/2, 2) distributed: 2 is the
/// shape of the energy of the pairs that hard spheres choose to collide. Beta(b, 2) is the product of a Beta(b, 1) and a
/// Beta(b + 1, 1) variate, and those are powers of uniform ones: no rejection, any zeta > 0.
struct LarsenBorgnakke {
    float inverse_shape = 0;       ///< 2/zeta
    float inverse_shape_next = 0;  ///< 1/(zeta/2 + 1)

    LarsenBorgnakke() = default;
    explicit LarsenBorgnakke(double internal_freedoms)
        : inverse_shape(internal_freedoms > 0 ? static_cast<float>(2 / internal_freedoms) : 0.0f),
          inverse_shape_next(static_cast<float>(1 / (0.5 * internal_freedoms + 1)))
    {
    }

    [[nodiscard]] bool exchanges() const { return inverse_shape > 0; }

    /// Internal share of the common energy from two uniform numbers in (0, 1).
    [[nodiscard]] float internal_share(float uniform_1, float uniform_2) const
    {
        return fast_exp2(fast_log2(uniform_1) * inverse_shape + fast_log2(uniform_2) * inverse_shape_next);
    }
};

/// Mean of |g' - g| over isotropic directions, for speeds g and g' before and after: a + b^2/(3 a) with a the larger, b the smaller.
inline double mean_velocity_change(double speed_before, double speed_after)
{
    const double larger = std::max(speed_before, speed_after), smaller = std::min(speed_before, speed_after);
    return larger > 0 ? larger + smaller * smaller / (3 * larger) : 0.0;
}

/// How much larger the mean of |g' - g| is, at equilibrium, for pairs that exchange internal energy than for pairs that keep their
/// speed (4 g/3). Before and after, the translational share of the common energy is the same Beta(2, zeta/2) variate, drawn twice.
/// Midpoint sum over both, 1e-4.
inline double exchange_stretch(double internal_freedoms)
{
    if (internal_freedoms <= 0) return 1;
    constexpr int points = 64;
    std::array<double, points> share{}, speed{};
    for (int k = 0; k < points; ++k) {
        share[k] = 1 - std::pow((k + 0.5) / points, 2 / internal_freedoms);
        speed[k] = std::sqrt(share[k]);
    }
    double changed = 0, kept = 0;
    for (int i = 0; i < points; ++i) {
        for (int j = 0; j < points; ++j) {
            const double weight = share[i] * share[j];
            changed += weight * mean_velocity_change(speed[i], speed[j]);
            kept += weight * (4.0 / 3.0) * speed[i];
        }
    }
    return changed / kept;
}

}  // namespace corpuscle
