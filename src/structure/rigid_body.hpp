#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/vector3.hpp"

namespace corpuscle {

/// A symmetric tensor. [kg m2] or its inverse
struct Tensor3 {
    double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;

    [[nodiscard]] Vector3d operator*(const Vector3d& v) const
    {
        return {xx * v.x + xy * v.y + zx * v.z, xy * v.x + yy * v.y + yz * v.z, zx * v.x + yz * v.y + zz * v.z};
    }
    /// Adds the inertia about the origin of a mass [kg] at a place [m].
    void add_mass(double mass, const Vector3d& at);
};

/// Its inverse on the axes that are free; nothing on the others.
[[nodiscard]] Tensor3 inverse(const Tensor3& t, const Vector3d& free);

/// A body that moves without deforming: six degrees of freedom, some of which may be held. What pushes in a step waits in `impulse` and
/// `twist` until `advance`, but shows in its velocity at once.
struct RigidBody {
    double mass = 0;                                             ///< [kg]
    Tensor3 inertia_at_start;                                    ///< about the center, as placed [kg m2]
    Vector3d free{1, 1, 1};                                      ///< 1 where it may move along an axis, 0 where held
    Vector3d free_turn{1, 1, 1};                                 ///< and turn about it
    Vector3d center;                                             ///< of mass, at the end of the step [m]
    Vector3d center_at_start;                                    ///< [m]
    Vector3d velocity;                                           ///< of the center in the middle of the step [m/s]
    Vector3d spin_momentum;                                      ///< angular momentum about the center in the middle of the step [kg m2/s]
    Vector3d impulse;                                            ///< waiting [N s]
    Vector3d twist;                                              ///< waiting, about the center [N m s]
    Vector3d axis_x{1, 0, 0}, axis_y{0, 1, 0}, axis_z{0, 0, 1};  ///< where the axes of the start have turned to
    std::uint32_t first_node = 0, node_count = 0;

    /// Inverse inertia about the center as it stands now, on the free axes. [1/(kg m2)]
    [[nodiscard]] Tensor3 inverse_inertia() const;
    /// Angular velocity with the waiting twist. [rad/s]
    [[nodiscard]] Vector3d spin() const { return inverse_inertia() * (spin_momentum + twist); }
    /// Velocity of the center with the waiting impulse. [m/s]
    [[nodiscard]] Vector3d center_velocity() const { return velocity + scaled(impulse, free) / mass; }
    /// Velocity of a point of the body with what waits. [m/s]
    [[nodiscard]] Vector3d velocity_at(const Vector3d& place) const { return center_velocity() + cross(spin(), place - center); }
    /// 1/M that a push along the unit vector `along` at `place` meets. [1/kg]
    [[nodiscard]] double inverse_mass_at(const Vector3d& place, const Vector3d& along) const;
    /// Takes an impulse [N s] at a place [m].
    void push(const Vector3d& place, const Vector3d& given);
    [[nodiscard]] double kinetic_energy() const;  ///< with what waits [J]
    [[nodiscard]] Vector3d momentum() const { return mass * center_velocity(); }

    /// Moves the body through a step of `duration` [s]: takes up what waits, turns it about its momentum by the implicit midpoint rule.
    /// Returns the impulse that the supports gave.
    Vector3d advance(double duration);
    /// Where a point of the start is now. [m]
    [[nodiscard]] Vector3d placed(const Vector3d& at_start) const;

private:
    void turn(const Vector3d& angle);
    [[nodiscard]] Tensor3 inertia() const;
};

/// A body of point masses [kg] at places [m] about their center.
[[nodiscard]] RigidBody rigid_body_of(std::span<const Vector3d> places, std::span<const double> masses);

}  // namespace corpuscle
