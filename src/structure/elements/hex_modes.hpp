#pragma once

#include <array>

#include "laws/strength/solid_stress.hpp"
#include "math/vector3.hpp"

namespace corpuscle {

/// A vector at each corner of an eight-cornered element: the lower face round, then the upper one.
template <class Real>
using HexCorners = std::array<Vector3<Real>, 8>;

/// The same vectors as what a trilinear element sees of them:
///     corner value = mean + xi x + eta y + zeta z + eta zeta yz + zeta xi zx + xi eta xy + xi eta zeta twist,    xi, eta, zeta = +-1.
template <class Real>
struct HexModes {
    Vector3<Real> mean, x, y, z, yz, zx, xy, twist;
};

/// Splits corner values into modes, by sums and differences along each direction in turn.
template <class Real>
HexModes<Real> modes_of(const HexCorners<Real>& c)
{
    const Real eighth = 0.125;
    const Vector3<Real> s0 = c[0] + c[1], d0 = c[1] - c[0], s1 = c[3] + c[2], d1 = c[2] - c[3];
    const Vector3<Real> s2 = c[4] + c[5], d2 = c[5] - c[4], s3 = c[7] + c[6], d3 = c[6] - c[7];
    const Vector3<Real> ss0 = s0 + s1, sd0 = s1 - s0, ds0 = d0 + d1, dd0 = d1 - d0;
    const Vector3<Real> ss1 = s2 + s3, sd1 = s3 - s2, ds1 = d2 + d3, dd1 = d3 - d2;
    return {(ss0 + ss1) * eighth, (ds0 + ds1) * eighth, (sd0 + sd1) * eighth, (ss1 - ss0) * eighth,
            (sd1 - sd0) * eighth, (ds1 - ds0) * eighth, (dd0 + dd1) * eighth, (dd1 - dd0) * eighth};
}

/// The place in the middle of the step. [m]
template <class Real>
HexModes<Real> halfway(const HexModes<Real>& end, const HexModes<Real>& move)
{
    const Real half = 0.5;
    return {end.mean - move.mean * half, end.x - move.x * half,   end.y - move.y * half,   end.z - move.z * half,
            end.yz - move.yz * half,     end.zx - move.zx * half, end.xy - move.xy * half, end.twist - move.twist * half};
}

/// Corner loads that do the same work on corner values as `load` does on their modes.
template <class Real>
HexCorners<Real> corners_of(const HexModes<Real>& load)
{
    const Real eighth = 0.125;
    const auto along_x = [](const Vector3<Real>& even, const Vector3<Real>& odd, Vector3<Real>& low, Vector3<Real>& high) {
        low = even - odd;
        high = even + odd;
    };
    HexCorners<Real> c;
    for (int upper = 0; upper < 2; ++upper) {
        const Real sign = upper == 0 ? -1.0 : 1.0;
        const Vector3<Real> mean = (load.mean + load.z * sign) * eighth, y = (load.y + load.yz * sign) * eighth;
        const Vector3<Real> x = (load.x + load.zx * sign) * eighth, xy = (load.xy + load.twist * sign) * eighth;
        const int first = 4 * upper;
        along_x(mean - y, x - xy, c[first], c[first + 1]);
        along_x(mean + y, x + xy, c[first + 3], c[first + 2]);
    }
    return c;
}

/// Derivatives of an element's volume by the modes of its corners' places: mean gradient of anything = sum(mode of it * this) / volume.
/// Exact for trilinear elements, as Flanagan and Belytschko 1981 (Int. J. Numer. Methods Eng. 17, 679) have it.
template <class Real>
struct HexGradient {
    Vector3<Real> x, y, z, yz, zx, xy;  ///< [m2]
    Real volume;                        ///< [m3]
};

template <class Real>
HexGradient<Real> gradient_of(const HexModes<Real>& p)
{
    const Real eight = 8.0, third = 8.0 / 3.0;
    HexGradient<Real> g;
    g.x = cross(p.y, p.z) * eight + cross(p.xy, p.zx) * third;
    g.y = cross(p.z, p.x) * eight + cross(p.yz, p.xy) * third;
    g.z = cross(p.x, p.y) * eight + cross(p.zx, p.yz) * third;
    g.yz = (cross(p.z, p.zx) + cross(p.xy, p.y)) * third;
    g.zx = (cross(p.yz, p.z) + cross(p.x, p.xy)) * third;
    g.xy = (cross(p.y, p.yz) + cross(p.zx, p.x)) * third;
    g.volume = (dot(p.x, g.x) + dot(p.y, g.y) + dot(p.z, g.z) + dot(p.yz, g.yz) + dot(p.zx, g.zx) + dot(p.xy, g.xy)) * Real(1.0 / 3.0);
    return g;
}

/// Rows of a gradient: x.y is the derivative of the x component along y.
template <class Real>
struct Gradient3 {
    Vector3<Real> x, y, z;

    /// Its part without rotation.
    [[nodiscard]] SolidStrain<Real> strain() const { return {x.x, y.y, z.z, x.y + y.x, y.z + z.y, z.x + x.z}; }
    /// Its rotation: the axial vector of the rest. [rad]
    [[nodiscard]] Vector3<Real> spin() const { return {(z.y - y.z) * Real(0.5), (x.z - z.x) * Real(0.5), (y.x - x.y) * Real(0.5)}; }
    [[nodiscard]] Vector3<Real> operator*(const Vector3<Real>& v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
    void add(const Vector3<Real>& value, const Vector3<Real>& along)
    {
        x += along * value.x;
        y += along * value.y;
        z += along * value.z;
    }
};

/// Mean gradient over the element of what has the modes `u`.
template <class Real>
Gradient3<Real> mean_gradient(const HexGradient<Real>& g, const HexModes<Real>& u)
{
    Gradient3<Real> sum;
    const Real zero = 0.0, inverse = 1.0 / g.volume;
    sum.x = sum.y = sum.z = {zero, zero, zero};
    sum.add(u.x, g.x * inverse);
    sum.add(u.y, g.y * inverse);
    sum.add(u.z, g.z * inverse);
    sum.add(u.yz, g.yz * inverse);
    sum.add(u.zx, g.zx * inverse);
    sum.add(u.xy, g.xy * inverse);
    return sum;
}

/// A stress times an area vector: the force on it. [N]
template <class Real>
Vector3<Real> traction(const SolidStress<Real>& s, const Vector3<Real>& area)
{
    return {s.xx * area.x + s.xy * area.y + s.zx * area.z, s.xy * area.x + s.yy * area.y + s.yz * area.z,
            s.zx * area.x + s.yz * area.y + s.zz * area.z};
}

}  // namespace corpuscle
