#include "gas/inflow.hpp"

#include <numbers>

#include "gas/faces.hpp"
#include "math/random.hpp"

namespace corpuscle {

namespace {

/// A particle of ambient gas that crosses a face inward, at the face.
Particle newcomer(const Gas& gas, int face, Random& random)
{
    const int axis = face / 2;
    const bool upper = face % 2 == 1;
    const Species& species = gas.species[gas.ambient.species];
    const double sigma = std::sqrt(gas.ambient.velocity_variance);
    Particle particle;
    for (int a = 0; a < 3; ++a) {
        const double lower = gas.domain.box.lower[a], size = gas.domain.box.size()[a];
        particle.position[a] = static_cast<float>(a == axis ? (upper ? lower + size : lower) : lower + size * random.uniform_double());
        particle.velocity[a] = static_cast<float>(a == axis ? (upper ? -1 : 1) * sigma * std::sqrt(-2 * std::log(random.uniform_double()))
                                                            : sigma * random.normal());
    }
    const double temperature = species.particle_mass * gas.ambient.velocity_variance;  // k T of a particle
    if (species.internal_freedoms > 0) particle.energy = static_cast<float>(temperature * random.gamma(0.5 * species.internal_freedoms));
    particle.tag = particle_tag::make(gas.ambient.species);
    return particle;
}

/// Particles that enter through a face in this step; fractions are kept for the next.
int entering(Gas& gas, int face, double duration, Random& random)
{
    const int axis = face / 2;
    const Vector3d size = gas.domain.box.size();
    const double area = size[(axis + 1) % 3] * size[(axis + 2) % 3];
    const double number_density = gas.ambient.density / gas.species[gas.ambient.species].particle_mass;
    const double flux = number_density * std::sqrt(gas.ambient.velocity_variance / (2 * std::numbers::pi));
    gas.inflow_debt[face] += flux * area * duration;
    const int count = std::max(0, static_cast<int>(std::floor(gas.inflow_debt[face] + random.uniform_double())));
    gas.inflow_debt[face] -= count;
    return count;
}

}  // namespace

void flow_in(Gas& gas, const Clock& clock, const FacetTree* walls)
{
    if (!(gas.ambient.density > 0)) return;
    for (int face = 0; face < face_count; ++face) {
        if (gas.domain.edges[face] != Edge::ambient) continue;
        Random random(gas.settings.seed, Purpose::inflow, clock.step(), static_cast<std::uint64_t>(face));
        for (int left = entering(gas, face, clock.duration(), random); left > 0; --left) {
            Particle particle = newcomer(gas, face, random);
            const double start = random.uniform_double();
            if (gas.sleeping.holds(gas.cells.curve.key(particle.position))) continue;
            const Passage brought = carried(gas, particle);
            gas.passages.face[face] += {-brought.mass, -1.0 * brought.momentum, -brought.energy};
            const Vector3f path = static_cast<float>(clock.duration() * (1 - start)) * particle.velocity;
            if (walls && walls->clearance(particle.position) <= norm(path)) {
                gas.pending.push_back({static_cast<std::uint32_t>(gas.particles.size()), static_cast<float>(start), {}});
            } else {
                particle.position += path;
                keep_in_domain(gas, particle, gas.passages);
            }
            gas.particles.push_back(particle);
        }
    }
}

}  // namespace corpuscle
