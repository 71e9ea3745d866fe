#include "structure/rigid_body.hpp"

#include <array>
#include <cmath>

namespace corpuscle {

namespace {

/// A vector turned by the angle vector [rad].
Vector3d turned(const Vector3d& v, const Vector3d& angle)
{
    const double size = norm(angle);
    if (!(size > 0)) return v;
    const Vector3d axis = angle / size;
    const Vector3d along = dot(axis, v) * axis, out = v - along;
    return along + std::cos(size) * out + std::sin(size) * cross(axis, out);
}

}  // namespace

void Tensor3::add_mass(double mass, const Vector3d& at)
{
    xx += mass * (at.y * at.y + at.z * at.z);
    yy += mass * (at.z * at.z + at.x * at.x);
    zz += mass * (at.x * at.x + at.y * at.y);
    xy -= mass * at.x * at.y;
    yz -= mass * at.y * at.z;
    zx -= mass * at.z * at.x;
}

/// Held axes are cut out of the tensor (their rows made those of the unit tensor) and of the result.
Tensor3 inverse(const Tensor3& t, const Vector3d& free)
{
    const Tensor3 c{free.x != 0 ? t.xx : 1.0, free.y != 0 ? t.yy : 1.0, free.z != 0 ? t.zz : 1.0,
                    t.xy * free.x * free.y,   t.yz * free.y * free.z,   t.zx * free.z * free.x};
    const Tensor3 adjoint{c.yy * c.zz - c.yz * c.yz, c.zz * c.xx - c.zx * c.zx, c.xx * c.yy - c.xy * c.xy,
                          c.yz * c.zx - c.xy * c.zz, c.zx * c.xy - c.yz * c.xx, c.xy * c.yz - c.zx * c.yy};
    const double determinant = c.xx * adjoint.xx + c.xy * adjoint.xy + c.zx * adjoint.zx;
    const double scale = determinant > 0 ? 1.0 / determinant : 0.0;
    return {scale * adjoint.xx * free.x,          scale * adjoint.yy * free.y,          scale * adjoint.zz * free.z,
            scale * adjoint.xy * free.x * free.y, scale * adjoint.yz * free.y * free.z, scale * adjoint.zx * free.z * free.x};
}

/// R I R^T, the columns of R being the turned axes.
Tensor3 RigidBody::inertia() const
{
    const Tensor3& i = inertia_at_start;
    const auto component = [&](int a, int b) {
        const Vector3d row{axis_x[a], axis_y[a], axis_z[a]}, other{axis_x[b], axis_y[b], axis_z[b]};
        return dot(row, i * other);
    };
    return {component(0, 0), component(1, 1), component(2, 2), component(0, 1), component(1, 2), component(2, 0)};
}

Tensor3 RigidBody::inverse_inertia() const
{
    return inverse(inertia(), free_turn);
}

double RigidBody::inverse_mass_at(const Vector3d& place, const Vector3d& along) const
{
    const Vector3d arm = cross(place - center, along);
    return dot(scaled(along, along), free) / mass + dot(arm, inverse_inertia() * arm);
}

void RigidBody::push(const Vector3d& place, const Vector3d& given)
{
    impulse += given;
    twist += cross(place - center, given);
}

double RigidBody::kinetic_energy() const
{
    return 0.5 * mass * norm_squared(center_velocity()) + 0.5 * dot(spin_momentum + twist, spin());
}

Vector3d RigidBody::placed(const Vector3d& at_start) const
{
    const Vector3d r = at_start - center_at_start;
    return center + r.x * axis_x + r.y * axis_y + r.z * axis_z;
}

void RigidBody::turn(const Vector3d& angle)
{
    for (Vector3d* axis : {&axis_x, &axis_y, &axis_z}) *axis = turned(*axis, angle);
    axis_x = normalized(axis_x);  // rounding must not deform the body
    axis_y = normalized(axis_y - dot(axis_x, axis_y) * axis_x);
    axis_z = cross(axis_x, axis_y);
}

Vector3d RigidBody::advance(double duration)
{
    velocity = center_velocity();
    const Vector3d support = -(impulse - scaled(impulse, free));
    spin_momentum = scaled(spin_momentum + twist, free_turn);
    impulse = twist = {};
    const std::array<Vector3d, 3> axes{axis_x, axis_y, axis_z};
    Vector3d rate = spin();
    constexpr int sweeps = 8;  // of a fixed point whose error shrinks by the angle of a step each time
    for (int i = 0; i < sweeps; ++i) {
        axis_x = axes[0];
        axis_y = axes[1];
        axis_z = axes[2];
        turn(0.5 * duration * rate);
        rate = spin();
    }
    axis_x = axes[0];
    axis_y = axes[1];
    axis_z = axes[2];
    turn(duration * rate);
    center += duration * velocity;
    return support;
}

RigidBody rigid_body_of(std::span<const Vector3d> places, std::span<const double> masses)
{
    RigidBody body;
    Vector3d moment;
    for (std::size_t i = 0; i < places.size(); ++i) {
        body.mass += masses[i];
        moment += masses[i] * places[i];
    }
    body.center = body.center_at_start = moment / body.mass;
    for (std::size_t i = 0; i < places.size(); ++i) body.inertia_at_start.add_mass(masses[i], places[i] - body.center);
    return body;
}

}  // namespace corpuscle
