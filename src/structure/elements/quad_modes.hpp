#pragma once

#include <array>

#include "math/vector3.hpp"

namespace corpuscle {

/// A vector at each corner of a four-cornered element, numbered round it.
template <class Real>
using QuadCorners = std::array<Vector3<Real>, 4>;

/// The same four vectors as what a bilinear element sees of them, with xi = (-1, 1, 1, -1), eta = (-1, -1, 1, 1),
/// h = xi eta = (1, -1, 1, -1):     corner i = mean + xi_i s / 2 + eta_i t / 2 + h_i twist.
template <class Real>
struct QuadModes {
    Vector3<Real> mean, s, t, twist;
};

/// Splits corner values into modes.
template <class Real>
QuadModes<Real> modes_of(const QuadCorners<Real>& c)
{
    const Vector3<Real> odd = c[0] + c[2], even = c[1] + c[3], first = c[2] - c[0], second = c[1] - c[3];
    return {(odd + even) * Real(0.25), (first + second) * Real(0.5), (first - second) * Real(0.5), (odd - even) * Real(0.25)};
}

/// Corner loads that do the same work on corner values as `load` does on their modes.
template <class Real>
QuadCorners<Real> corners_of(const QuadModes<Real>& load)
{
    const Vector3<Real> mean = load.mean * Real(0.25), twist = load.twist * Real(0.25);
    const Vector3<Real> sum = (load.s + load.t) * Real(0.5), gap = (load.s - load.t) * Real(0.5);
    return {mean + twist - sum, mean - twist + gap, mean + twist + sum, mean - twist - gap};
}

/// Work of modal loads on modal values.
template <class Real>
Real work(const QuadModes<Real>& load, const QuadModes<Real>& value)
{
    return dot(load.mean, value.mean) + dot(load.s, value.s) + dot(load.t, value.t) + dot(load.twist, value.twist);
}

}  // namespace corpuscle
