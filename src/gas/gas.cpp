#include "gas/gas.hpp"

#include "gas/faces.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

double Charge::burn_time(const Vector3d& place) const
{
    double earliest = std::numeric_limits<double>::infinity();
    for (const DetonationPoint& lit : points) earliest = std::min(earliest, lit.time + norm(place - lit.point) / detonation_velocity);
    return earliest;
}

double Charge::first_time() const
{
    double earliest = std::numeric_limits<double>::infinity();
    for (const DetonationPoint& lit : points) earliest = std::min(earliest, lit.time);
    return earliest;
}

GasContents contents(const Gas& gas)
{
    const std::size_t awake = gas.sleeping.particles;
    GasContents total = sum_chunks<GasContents>(gas.particles.size() - awake, [&](std::size_t begin, std::size_t end) {
        GasContents part;
        for (std::size_t i = awake + begin; i < awake + end; ++i) {
            const Particle& particle = gas.particles[i];
            if (particle.tag & particle_tag::gone) continue;
            (particle.tag & particle_tag::unburnt ? part.explosive : part.gas) += carried(gas, particle);
        }
        return part;
    });
    total.gas += gas.sleeping.held;
    return total;
}

}  // namespace corpuscle
