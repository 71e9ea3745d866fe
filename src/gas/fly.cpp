#include "gas/fly.hpp"

#include <algorithm>

#include "gas/faces.hpp"
#include "gas/inflow.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

/// What a chunk of flights leaves behind.
struct Flown {
    FacePassages passages;
    std::vector<Pending> pending;

    Flown& operator+=(const Flown& other)
    {
        passages += other.passages;
        pending.insert(pending.end(), other.pending.begin(), other.pending.end());
        return *this;
    }
};

/// Displacements by particle, those of one particle added up, in the particles' order.
void gather_displacements(std::vector<Displacement>& displaced)
{
    std::stable_sort(displaced.begin(), displaced.end(),
                     [](const Displacement& a, const Displacement& b) { return a.particle < b.particle; });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < displaced.size(); ++i) {
        if (kept > 0 && displaced[kept - 1].particle == displaced[i].particle) {
            displaced[kept - 1].path += displaced[i].path;
        } else {
            displaced[kept++] = displaced[i];
        }
    }
    displaced.resize(kept);
}

/// Flies particles [begin, end), or lists them as pending.
Flown fly_chunk(Gas& gas, float duration, const FacetTree* walls, std::size_t begin, std::size_t end)
{
    Flown flown;
    auto displaced = std::lower_bound(gas.displaced.begin(), gas.displaced.end(), begin,
                                      [](const Displacement& d, std::size_t i) { return d.particle < i; });
    for (std::size_t i = begin; i < end; ++i) {
        Particle& particle = gas.particles[i];
        if (particle.tag & (particle_tag::unburnt | particle_tag::gone)) continue;
        const Vector3f path = duration * particle.velocity;
        if (walls) {
            while (displaced != gas.displaced.end() && displaced->particle < i) ++displaced;
            const bool also_displaced = displaced != gas.displaced.end() && displaced->particle == i;
            if (also_displaced || walls->clearance(particle.position) <= norm(path)) {
                flown.pending.push_back({static_cast<std::uint32_t>(i), 0.0f, also_displaced ? displaced->path : Vector3f{}});
                continue;
            }
        }
        particle.position += path;
        keep_in_domain(gas, particle, flown.passages);
    }
    return flown;
}

}  // namespace

void fly(Gas& gas, const Clock& clock, const FacetTree& walls)
{
    const FacetTree* facets = walls.size() == 0 ? nullptr : &walls;
    const auto duration = static_cast<float>(clock.duration());
    gather_displacements(gas.displaced);
    const std::size_t awake = gas.sleeping.particles;
    Flown flown = sum_chunks<Flown>(gas.particles.size() - awake, [&](std::size_t begin, std::size_t end) {
        return fly_chunk(gas, duration, facets, awake + begin, awake + end);
    });
    gas.passages += flown.passages;
    gas.pending = std::move(flown.pending);
    gas.displaced.clear();
    flow_in(gas, clock, facets);
}

}  // namespace corpuscle
