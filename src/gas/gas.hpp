#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fields/field.hpp"
#include "gas/cells.hpp"
#include "gas/domain.hpp"
#include "gas/particle.hpp"
#include "gas/sleeping_gas.hpp"
#include "gas/species.hpp"

namespace corpuscle {

/// Ways to let particles collide.
enum class CollisionRule {
    displaced,     ///< pairs drawn within cells, displaced for co-volume and cold pressure
    hard_spheres,  ///< spheres of finite radius that bounce along their line of centres
};

/// How the gas is computed; the defaults are what the theory manual justifies.
struct GasSettings {
    std::uint64_t seed = 1;
    std::uint32_t cell_limit = 16;   ///< most particles in a collision cell
    std::uint32_t group_limit = 64;  ///< most particles in the group whose density gives the virial pressure
    std::uint32_t partners = 1;      ///< drawn for each collision: the nearest of them is taken
    double mean_free_path = 1.0;     ///< in local particle spacings (V/n)^(1/3)
    double cross_section = 0;        ///< of every pair [m2]; 0: what gives that path. Fixed, the path goes as 1/n: hard spheres
    double relaxation = 2.0;         ///< collisions between two exchanges of translational and internal energy of a particle
    double cfl = 0.4;                ///< of the time step, in local spacings over 1.8 thermal speeds
    CollisionRule rule = CollisionRule::displaced;
};

/// A particle near a surface, whose flight in this step is left to the contact that knows the surface.
struct Pending {
    std::uint32_t particle = 0;
    float start = 0;        ///< fraction of the step at which the flight begins (0; later for gas that flows in)
    Vector3f displacement;  ///< [m] of the particle's collisions, gone along before the flight, at the step's start
};

/// A displacement by collisions that may meet a surface.
struct Displacement {
    std::uint32_t particle = 0;
    Vector3f path;  ///< [m]
};

/// Points where a charge is lit, and when.
struct DetonationPoint {
    Vector3d point;   ///< [m]
    double time = 0;  ///< [s]
};

/// A charge burns outward from its points at its detonation velocity.
struct Charge {
    std::string name;
    std::uint32_t species = 0;
    double detonation_velocity = 0;  ///< [m/s]
    double energy_per_mass = 0;      ///< [J/kg]
    double density = 0;              ///< unreacted [kg/m3]
    std::vector<DetonationPoint> points;
    std::uint64_t unburnt = 0;  ///< particles that wait

    /// When the detonation reaches `place`, straight from the nearest point in time [s].
    [[nodiscard]] double burn_time(const Vector3d& place) const;
    /// When the first point is lit [s].
    [[nodiscard]] double first_time() const;
};

/// The gas that surrounds the domain, and flows in through `ambient` edges.
struct AmbientGas {
    std::uint32_t species = 0;
    double density = 0;            ///< [kg/m3]; 0: vacuum
    double pressure = 0;           ///< [Pa]
    double velocity_variance = 0;  ///< of one component [m2/s2]
};

/// The particle gas: state and settings. Its verbs are functions: see fill.hpp, sort.hpp, collide.hpp, fly.hpp, burn.hpp.
struct Gas {
    GasSettings settings;
    Domain domain;
    std::vector<Species> species;
    std::vector<Charge> charges;
    AmbientGas ambient;

    std::vector<Particle> particles;  ///< those asleep, then the others in the order of the cell curve; newcomers at the end
    SleepingGas sleeping;
    Cells cells;  ///< as cut by the last sort
    std::vector<Displacement> displaced;
    std::vector<Pending> pending;                  ///< flights of this step that end near a surface
    FacePassages passages;                         ///< given to the faces since the start of the run
    std::array<double, face_count> inflow_debt{};  ///< fractions of particles owed by ambient edges
    double step_limit = 0;                         ///< stable step found by the last survey [s]
    std::uint64_t collisions = 0;                  ///< accepted pairs since the start
};

/// Mass, momentum and energy held [kg, kg m/s, J]; explosive that waits counts as "explosive", apart.
struct GasContents {
    Passage gas;
    Passage explosive;
    GasContents& operator+=(const GasContents& other)
    {
        gas += other.gas;
        explosive += other.explosive;
        return *this;
    }
};
[[nodiscard]] GasContents contents(const Gas& gas);

}  // namespace corpuscle
