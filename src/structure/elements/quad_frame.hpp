#pragma once

#include "math/lanes.hpp"
#include "structure/elements/quad_modes.hpp"

namespace corpuscle {

/// The axes that move with a four-cornered element, and its shape in them. The third axis is normal to both midlines; the
/// first two lie evenly to both midlines, so that the axes turn as the element's middle does and do not depend on where its
/// corners are counted from (but for quarter turns).
template <class Real>
struct QuadFrame {
    Vector3<Real> first, second, normal;
    Real sx, sy;  ///< midline s, from edge 4-1 to edge 2-3 [m]
    Real tx, ty;  ///< midline t, from edge 1-2 to edge 3-4 [m]
    Real gx, gy;  ///< twist of the corners in the plane [m]
    Real warp;    ///< and out of it [m]
    Real area;    ///< of the projection [m2]
    Real inverse_area;

    [[nodiscard]] Vector3<Real> to_local(const Vector3<Real>& v) const { return {dot(v, first), dot(v, second), dot(v, normal)}; }
    [[nodiscard]] Vector3<Real> to_global(const Vector3<Real>& v) const { return first * v.x + second * v.y + normal * v.z; }
    [[nodiscard]] QuadModes<Real> to_local(const QuadModes<Real>& m) const
    {
        return {to_local(m.mean), to_local(m.s), to_local(m.t), to_local(m.twist)};
    }
    [[nodiscard]] QuadModes<Real> to_global(const QuadModes<Real>& m) const
    {
        return {to_global(m.mean), to_global(m.s), to_global(m.t), to_global(m.twist)};
    }

    /// Gradient at the middle of a value given by its s and t modes.
    [[nodiscard]] Real along_x(const Real& s, const Real& t) const { return (ty * s - sy * t) * inverse_area; }
    [[nodiscard]] Real along_y(const Real& s, const Real& t) const { return (sx * t - tx * s) * inverse_area; }
};

template <class Real>
Vector3<Real> unit(const Vector3<Real>& v)
{
    return v * (1.0 / square_root(dot(v, v)));
}

/// Axes and shape of the element whose corners' modes are `places` [m].
template <class Real>
QuadFrame<Real> frame_of(const QuadModes<Real>& places)
{
    QuadFrame<Real> f;
    const Vector3<Real> across = cross(places.s, places.t);
    f.area = square_root(dot(across, across));
    f.inverse_area = 1.0 / f.area;
    f.normal = across * f.inverse_area;
    f.first = unit(unit(places.s) + cross(unit(places.t), f.normal));
    f.second = cross(f.normal, f.first);
    f.sx = dot(places.s, f.first);
    f.sy = dot(places.s, f.second);
    f.tx = dot(places.t, f.first);
    f.ty = dot(places.t, f.second);
    f.gx = dot(places.twist, f.first);
    f.gy = dot(places.twist, f.second);
    f.warp = dot(places.twist, f.normal);
    return f;
}

}  // namespace corpuscle
