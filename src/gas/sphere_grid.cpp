#include "gas/sphere_grid.hpp"

#include <bit>

#include "parallel/sort.hpp"

namespace corpuscle {

SphereGrid::SphereGrid(const Gas& gas, std::vector<std::uint32_t> particles, double travel, double side)
    : travel_(travel), lower_(gas.domain.box.lower), particles_(particles.size()), keys_(particles.size())
{
    const Vector3d size = gas.domain.box.size();
    side_ = std::max(side, std::max({size.x, size.y, size.z}) / static_cast<double>(most_cubes));
    inverse_side_ = 1 / side_;
    slot_bits_ = std::max(1, static_cast<int>(std::bit_width(particles.size())));
    std::vector<std::uint64_t> keys(particles.size());
    for_each(particles.size(), [&](std::size_t i) { keys[i] = key_of(cube_of(Vector3d(gas.particles[particles[i]].position))); });
    start_ = stable_counting_sort(
        particles.size(), std::size_t{1} << slot_bits_, [&](std::size_t i) { return slot_of(keys[i]); },
        [&](std::size_t i, std::uint32_t position) {
            particles_[position] = particles[i];
            keys_[position] = keys[i];
        });
}

}  // namespace corpuscle
