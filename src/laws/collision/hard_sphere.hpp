#pragma once

#include <cmath>

#include "math/vector3.hpp"

namespace corpuscle {

/// Candidate pairs of a cell in a step, by the no-time-counter rule (Bird 1994, section 11.1): n (n - 1)/2 sigma g_max dt/V with
/// sigma = V/(sqrt 2 n lambda), so that the mean free path is lambda. A candidate collides with probability g/g_max.
template <class Real>
Real candidate_pairs(Real particles, Real fastest_pair, Real duration, Real mean_free_path)
{
    return (particles - 1) * fastest_pair * duration / (Real(2.8284271247) * mean_free_path);
}

}  // namespace corpuscle
