#pragma once

namespace corpuscle {

/// Where the charge bursts: a sphere in free air, or a hemisphere on a rigid ground, whose reflection the curves contain.
enum class Burst { spherical, hemispherical };

/// Scaled distances Z that the curves cover, from the surface of the charge outwards [m/kg^(1/3)].
struct ScaledDistanceRange {
    double nearest = 0;
    double farthest = 0;
};

[[nodiscard]] ScaledDistanceRange scaled_distance_range(Burst burst);

/// The blast wave of a bare TNT charge at one distance, at sea level. Pressures are over the ambient one.
struct BlastWave {
    double arrival = 0;             ///< of the shock after detonation [s]
    double duration = 0;            ///< of the positive phase [s]
    double incident_pressure = 0;   ///< peak, side-on [Pa]
    double incident_impulse = 0;    ///< of the positive phase, side-on [Pa s]
    double reflected_pressure = 0;  ///< peak on a wall that the wave meets head-on [Pa]
    double reflected_impulse = 0;   ///< of the positive phase on that wall [Pa s]
};

/// Distance over the cube root of the mass [m/kg^(1/3)]; mass is of TNT [kg], distance from its centre [m].
[[nodiscard]] double scaled_distance(double mass, double distance);

/// The curves of Kingery and Bulmash for a mass of TNT [kg] at a distance from its centre [m].
/// Nearer than the curve of duration begins (Z 0.147 spherical, 0.178 hemispherical) its first value, per cube root of mass, is kept: the
/// impulses are then still those of their curves. Throws InputError, naming Z and the range, outside `scaled_distance_range`, or for a mass
/// not positive.
[[nodiscard]] BlastWave kingery_bulmash(Burst burst, double mass, double distance);

}  // namespace corpuscle
