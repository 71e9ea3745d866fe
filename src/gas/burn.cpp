#include "gas/burn.hpp"

#include "gas/faces.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

/// What burnt in a chunk of particles.
struct Burnt {
    Passage released;
    std::vector<std::uint64_t> particles;  ///< by charge

    Burnt& operator+=(const Burnt& other)
    {
        released += other.released;
        particles.resize(std::max(particles.size(), other.particles.size()));
        for (std::size_t c = 0; c < other.particles.size(); ++c) particles[c] += other.particles[c];
        return *this;
    }
};

bool may_burn(const Gas& gas, double time)
{
    for (const Charge& charge : gas.charges) {
        if (charge.unburnt > 0 && charge.first_time() <= time) return true;
    }
    return false;
}

}  // namespace

Passage burn(Gas& gas, const Clock& clock)
{
    if (!may_burn(gas, clock.time())) return {};
    const std::size_t awake = gas.sleeping.particles;
    const Burnt burnt = sum_chunks<Burnt>(gas.particles.size() - awake, [&](std::size_t begin, std::size_t end) {
        Burnt part;
        part.particles.resize(gas.charges.size());
        for (std::size_t i = awake + begin; i < awake + end; ++i) {
            Particle& particle = gas.particles[i];
            if (!(particle.tag & particle_tag::unburnt)) continue;
            const std::uint32_t charge = particle_tag::charge(particle.tag);
            if (gas.charges[charge].burn_time(Vector3d(particle.position)) > clock.time()) continue;
            particle.tag &= ~particle_tag::unburnt;
            part.released += carried(gas, particle);
            ++part.particles[charge];
        }
        return part;
    });
    for (std::size_t c = 0; c < burnt.particles.size(); ++c) gas.charges[c].unburnt -= burnt.particles[c];
    return burnt.released;
}

}  // namespace corpuscle
