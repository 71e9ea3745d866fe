#include "gas/thermal_draw.hpp"

#include <algorithm>
#include <cmath>

#include "math/random.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

ThermalDraw draw_thermal(std::size_t count, double internal_freedoms, std::uint64_t seed, std::uint64_t stream)
{
    ThermalDraw draw{std::vector<Vector3d>(count), std::vector<double>(count, 0.0)};
    for_each((count + 1) / 2, [&](std::size_t pair) {
        Random random(seed, Purpose::fill, 2 + stream, pair);
        Vector3d velocity;
        for (int a = 0; a < 3; ++a) velocity[a] = random.normal();
        for (std::size_t i = 2 * pair; i < std::min(count, 2 * pair + 2); ++i) {
            draw.velocity[i] = i % 2 == 0 ? velocity : -velocity;
            if (internal_freedoms > 0) draw.energy[i] = random.gamma(0.5 * internal_freedoms);
        }
    });
    const auto mean_velocity = (1.0 / static_cast<double>(count)) * sum<Vector3d>(count, [&](std::size_t i) { return draw.velocity[i]; });
    for_each(count, [&](std::size_t i) { draw.velocity[i] -= mean_velocity; });
    const double squared = sum<double>(count, [&](std::size_t i) { return norm_squared(draw.velocity[i]); });
    const double energy = sum<double>(count, [&](std::size_t i) { return draw.energy[i]; });
    const double velocity_scale = squared > 0 ? std::sqrt(3.0 * static_cast<double>(count) / squared) : 0.0;
    const double energy_scale = energy > 0 ? static_cast<double>(count) / energy : 0.0;
    for_each(count, [&](std::size_t i) {
        draw.velocity[i] *= velocity_scale;
        draw.energy[i] *= energy_scale;
    });
    return draw;
}

}  // namespace corpuscle
