#pragma once

#include "structure/elements/quad_frame.hpp"

namespace corpuscle {

/// How a one-point shell deforms in a step, or how fast; engineering shears. Belytschko, Lin, Tsay 1984, with two changes of
/// Belytschko, Wong, Chiang 1992: curvature feels the warp, and transverse shear is read along the edges, so that constant curvature
/// is free of shear in any convex shape (as in MITC4, Bathe and Dvorkin 1985).
template <class Real>
struct ShellStrain {
    Real xx, yy, xy;                 ///< of the middle surface [1]
    Real bend_xx, bend_yy, bend_xy;  ///< its change along the normal [1/m]
    Real zx, yz;                     ///< transverse shear [1]
};

/// The modes a one-point shell does not see, made blind to rigid motion and to linear fields. Also used for the forces against them.
template <class Real>
struct ShellHourglass {
    Real stretch_x, stretch_y;  ///< in-plane [m], force [N]
    Real turn_x, turn_y;        ///< rotations [rad], moment [N m]
    Real shear_s, shear_t;      ///< half the difference of opposite edges' shear [m], force [N]
    Real drill;                 ///< corners' mean rotation about the normal beyond the spin of the plane [rad], moment [N m]
};

/// Forces and moments over the element's area: what does work on ShellStrain.
template <class Real>
struct ShellResultant {
    Real xx, yy, xy;                 ///< [N m]
    Real bend_xx, bend_yy, bend_xy;  ///< [N m2]
    Real zx, yz;                     ///< [N m]
};

/// Strain that local motion `move` [m] with rotation `turn` [rad] of the corners makes.
template <class Real>
ShellStrain<Real> strain_of(const QuadFrame<Real>& f, const QuadModes<Real>& move, const QuadModes<Real>& turn)
{
    const Real ux = f.along_x(move.s.x, move.t.x), uy = f.along_y(move.s.x, move.t.x);
    const Real vx = f.along_x(move.s.y, move.t.y), vy = f.along_y(move.s.y, move.t.y);
    const Real spin = 0.5 * (vx - uy);
    const Real us = move.s.x + spin * f.sy, ut = move.t.x + spin * f.ty;  // in-plane motion without the spin
    const Real vs = move.s.y - spin * f.sx, vt = move.t.y - spin * f.tx;
    const Real twist = 4.0 * f.warp * f.inverse_area * f.inverse_area;
    const Real shear_s = move.s.z + turn.mean.y * f.sx - turn.mean.x * f.sy + turn.t.y * f.gx - turn.t.x * f.gy;
    const Real shear_t = move.t.z + turn.mean.y * f.tx - turn.mean.x * f.ty + turn.s.y * f.gx - turn.s.x * f.gy;
    ShellStrain<Real> e;
    e.xx = ux;
    e.yy = vy;
    e.xy = uy + vx;
    e.bend_xx = f.along_x(turn.s.y, turn.t.y) + twist * (f.sx * ut + f.tx * us);
    e.bend_yy = -f.along_y(turn.s.x, turn.t.x) + twist * (f.sy * vt + f.ty * vs);
    e.bend_xy = f.along_y(turn.s.y, turn.t.y) - f.along_x(turn.s.x, turn.t.x) + twist * (f.sx * vt + f.tx * vs + f.sy * ut + f.ty * us);
    e.zx = f.along_x(shear_s, shear_t);
    e.yz = f.along_y(shear_s, shear_t);
    return e;
}

/// Hourglass modes that the same motion makes.
template <class Real>
ShellHourglass<Real> hourglass_of(const QuadFrame<Real>& f, const QuadModes<Real>& move, const QuadModes<Real>& turn)
{
    const Real wx = f.along_x(move.s.z, move.t.z), wy = f.along_y(move.s.z, move.t.z);
    const auto beyond_linear = [&f](const Real& twist, const Real& s, const Real& t) {
        return twist - f.gx * f.along_x(s, t) - f.gy * f.along_y(s, t);
    };
    const Real common = 2.0 * (move.twist.z + turn.mean.y * f.gx - turn.mean.x * f.gy);
    return {beyond_linear(move.twist.x, move.s.x, move.t.x) + f.warp * wx,
            beyond_linear(move.twist.y, move.s.y, move.t.y) + f.warp * wy,
            beyond_linear(turn.twist.x, turn.s.x, turn.t.x),
            beyond_linear(turn.twist.y, turn.s.y, turn.t.y),
            common + 0.5 * (turn.t.y * f.sx - turn.t.x * f.sy),
            common + 0.5 * (turn.s.y * f.tx - turn.s.x * f.ty),
            turn.mean.z - 0.5 * (f.along_x(move.s.y, move.t.y) - f.along_y(move.s.x, move.t.x))};
}

/// Loads on the corners' motion and rotation, in the element's axes, as modes.
template <class Real>
struct ShellLoad {
    QuadModes<Real> force, moment;
};

/// The transpose of `strain_of` and `hourglass_of`: loads whose work on any motion is that of the resultants and hourglass
/// forces on its strain. Sums of forces and of moments about any axis vanish, as rigid motion makes no strain.
template <class Real>
ShellLoad<Real> load_of(const QuadFrame<Real>& f, const ShellResultant<Real>& r, const ShellHourglass<Real>& h)
{
    const Real twist = 4.0 * f.warp * f.inverse_area * f.inverse_area, zero = 0.0;
    const Real us = twist * (r.bend_xx * f.tx + r.bend_xy * f.ty), ut = twist * (r.bend_xx * f.sx + r.bend_xy * f.sy);
    const Real vs = twist * (r.bend_yy * f.ty + r.bend_xy * f.tx), vt = twist * (r.bend_yy * f.sy + r.bend_xy * f.sx);
    const Real half_spin = 0.5 * (us * f.sy + ut * f.ty - vs * f.sx - vt * f.tx);
    // loads on the gradients, x and y derivative of each component
    const Real plane_spin = half_spin - 0.5 * h.drill;
    const Real ux = r.xx - f.gx * h.stretch_x, uy = r.xy - plane_spin - f.gy * h.stretch_x;
    const Real vx = r.xy + plane_spin - f.gx * h.stretch_y, vy = r.yy - f.gy * h.stretch_y;
    const Real wx = f.warp * h.stretch_x, wy = f.warp * h.stretch_y;
    const Real ax = -r.bend_xy - f.gx * h.turn_x, ay = -r.bend_yy - f.gy * h.turn_x;
    const Real bx = r.bend_xx - f.gx * h.turn_y, by = r.bend_xy - f.gy * h.turn_y;
    const auto on_s = [&f](const Real& x, const Real& y) { return (x * f.ty - y * f.tx) * f.inverse_area; };
    const auto on_t = [&f](const Real& x, const Real& y) { return (y * f.sx - x * f.sy) * f.inverse_area; };
    const Real shear_s = on_s(r.zx, r.yz), shear_t = on_t(r.zx, r.yz), both = 2.0 * (h.shear_s + h.shear_t);

    ShellLoad<Real> load;
    load.force.mean = {zero, zero, zero};
    load.force.s = {on_s(ux, uy) + us, on_s(vx, vy) + vs, on_s(wx, wy) + shear_s};
    load.force.t = {on_t(ux, uy) + ut, on_t(vx, vy) + vt, on_t(wx, wy) + shear_t};
    load.force.twist = {h.stretch_x, h.stretch_y, both};
    load.moment.mean = {-shear_s * f.sy - shear_t * f.ty - both * f.gy, shear_s * f.sx + shear_t * f.tx + both * f.gx, h.drill};
    load.moment.s = {on_s(ax, ay) - shear_t * f.gy - 0.5 * h.shear_t * f.ty, on_s(bx, by) + shear_t * f.gx + 0.5 * h.shear_t * f.tx, zero};
    load.moment.t = {on_t(ax, ay) - shear_s * f.gy - 0.5 * h.shear_s * f.sy, on_t(bx, by) + shear_s * f.gx + 0.5 * h.shear_s * f.sx, zero};
    load.moment.twist = {h.turn_x, h.turn_y, zero};
    return load;
}

/// Squared gradients of the shape functions of an element, summed over its corners: what sets its highest frequencies.
template <class Real>
struct GradientSum {
    Real xx, yy, xy;  ///< [1/m2]
};

template <class Real>
GradientSum<Real> gradient_sum(const QuadFrame<Real>& f)
{
    const Real scale = f.inverse_area * f.inverse_area;
    return {(f.sy * f.sy + f.ty * f.ty) * scale, (f.sx * f.sx + f.tx * f.tx) * scale, -(f.sx * f.sy + f.tx * f.ty) * scale};
}

/// Square of the highest membrane frequency over (corners * plane modulus * area * thickness / mass): exact for a one-point
/// element, in the axes in which the gradient sum has no xy. [1/m2]
template <class Real>
Real membrane_eigenvalue(const GradientSum<Real>& g, double poisson)
{
    const Real half = 0.5 * (g.xx + g.yy), gap = 0.5 * (g.xx - g.yy);
    const Real spread = gap * gap + g.xy * g.xy;
    return half + square_root(spread + poisson * poisson * (half * half - spread));
}

/// Largest principal value of the gradient sum. [1/m2]
template <class Real>
Real largest_gradient(const GradientSum<Real>& g)
{
    const Real half = 0.5 * (g.xx + g.yy), gap = 0.5 * (g.xx - g.yy);
    return half + square_root(gap * gap + g.xy * g.xy);
}

}  // namespace corpuscle
