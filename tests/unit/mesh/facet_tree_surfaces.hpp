#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "math/random.hpp"
#include "mesh/surface.hpp"

namespace corpuscle {

/// A surface and where its nodes are at the start and the end of a step.
struct MovingSurface {
    Surface surface;
    std::vector<Vector3d> start, end;

    [[nodiscard]] NodePath path() const { return {start, end}; }
};

/// Triangulated sphere: an octahedron whose facets are cut in four `levels` times, normals outward.
inline MovingSurface sphere_surface(double radius, int levels)
{
    std::vector<Vector3d> nodes{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<std::array<std::uint32_t, 3>> facets{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                     {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [entry, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(nodes.size()));
            if (is_new) nodes.push_back(normalized(nodes[a] + nodes[b]));
            return entry->second;
        };
        std::vector<std::array<std::uint32_t, 3>> finer;
        for (const auto& [a, b, c] : facets) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (const std::array<std::uint32_t, 3>& f : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
                finer.push_back(f);
        }
        facets = std::move(finer);
    }
    MovingSurface sphere;
    for (const Vector3d& n : nodes) sphere.start.push_back(radius * n);
    sphere.end = sphere.start;
    for (const auto& f : facets) sphere.surface.facets.push_back({f, 0, 0});
    return sphere;
}

/// A vector uniform in the cube [-1, 1]^3.
inline Vector3d uniform_vector(Random& random)
{
    const double x = random.uniform_double(), y = random.uniform_double(), z = random.uniform_double();
    return 2 * Vector3d{x, y, z} - Vector3d{1, 1, 1};
}

/// Triangles thrown at random, sizes over two decades, each corner moving its own way.
inline MovingSurface random_surface(std::uint32_t facets, double movement, std::uint64_t seed)
{
    Random random(seed, Purpose::contact, 0, 0);
    MovingSurface thrown;
    for (std::uint32_t f = 0; f < facets; ++f) {
        const Vector3d center = uniform_vector(random);
        const double size = std::pow(10.0, -2 * random.uniform_double());
        for (int i = 0; i < 3; ++i) {
            thrown.start.push_back(center + size * uniform_vector(random));
            thrown.end.push_back(thrown.start.back() + movement * uniform_vector(random));
        }
        thrown.surface.facets.push_back({{3 * f, 3 * f + 1, 3 * f + 2}, 0, 0});
    }
    return thrown;
}

}  // namespace corpuscle
