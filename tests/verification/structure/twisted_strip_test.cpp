#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>
#include <numeric>

#include "../../unit/structure/plates.hpp"

// A strip that is meshed with a quarter turn from end to end, of warped elements alone: its neighbours' normals differ, so that a node's
// free turning about one normal bends the next element.

namespace corpuscle {
namespace {

constexpr double length = 12, width = 1.1, thickness = 0.32;  // [m]

Mesh twisted_mesh(int n, int across, bool triangles)
{
    Mesh mesh;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= across; ++j) {
            const double turn = 0.5 * std::numbers::pi * i / n, y = width * (static_cast<double>(j) / across - 0.5);
            mesh.nodes.emplace_back(length * i / n, y * std::cos(turn), y * std::sin(turn));
        }
    const auto row = static_cast<std::uint32_t>(across + 1);
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(n); ++i)
        for (std::uint32_t j = 0; j + 1 < row; ++j) {
            const std::uint32_t a = i * row + j;
            if (!triangles) {
                mesh.elements.push_back({ElementShape::quadrilateral, {a, a + row, a + row + 1, a + 1}});
                continue;
            }
            mesh.elements.push_back({ElementShape::triangle, {a, a + row, a + row + 1}});
            mesh.elements.push_back({ElementShape::triangle, {a, a + row + 1, a + 1}});
        }
    return mesh;
}

/// Deflection of the free end along an axis under a force of 1 N there, the other end clamped: the mean over whole periods of the swing
/// that a sudden force makes about the place of rest. `across` the strip an even number of elements. [m]
double deflection(int axis, bool triangles, std::uint32_t across = 4)
{
    constexpr double period = 0.5;  // [s]
    PartDescription d = plate(twisted_mesh(6 * static_cast<int>(across), static_cast<int>(across), triangles),
                              {"strip", 1.0, 29e6, 0.22, Elastic{}}, thickness);
    std::vector<std::uint32_t> row(across + 1);
    std::iota(row.begin(), row.end(), 0u);
    d.holds = {clamp(row)};
    Structure s;
    add_part(s, d);
    const auto last = static_cast<std::uint32_t>(s.nodes.size() - 1), middle = last - across / 2;
    Vector3d push;
    push[axis] = 1.0 / static_cast<double>(row.size());
    Clock clock;
    const double duration = 0.9 * stable_step(s), end = 8 * period;
    double sum = 0, weights = 0;
    while (clock.time() < end) {
        for (const std::uint32_t n : row) s.nodes.push(last - n, duration * push);
        step(s, clock, duration);
        const double weight = 1 - std::cos(2 * std::numbers::pi * clock.time() / end);  // blind to what swings several times
        sum += weight * (s.nodes.position[middle][axis] - s.nodes.reference[middle][axis]);
        weights += weight;
    }
    return sum / weights;
}

/// MacNeal and Harder 1985 (Finite Elem. Anal. Des. 1, 3). [m]
constexpr double along_width = 5.424e-3, across_width = 1.754e-3;

/// Without the stiffness against turning about the normal the strip was tens of times too soft. Elements of half a metre are coarse and the
/// mean keeps 1e-3 of the swing, so 4 %, which the reference's own coarse meshes need.
TEST(TwistedStrip, IsAsStiffAsTheory)
{
    EXPECT_NEAR(deflection(2, false) / along_width, 1, 0.04);
    EXPECT_NEAR(deflection(1, false) / across_width, 1, 0.04);
}

/// Triangles were 17 and 27 % too soft. In their plane their strain is constant, which is too stiff in bending: along y 16 % with two pairs
/// across, 6.7 % with four and 1.6 % with eight (2026-11-22), the square of their size in the end. Here the first step is asked to halve
/// it.
TEST(TwistedStrip, OfTrianglesComesToTheory)
{
    for (const auto& [axis, theory] : {std::pair{2, along_width}, std::pair{1, across_width}}) {
        const double coarse = deflection(axis, true, 2) / theory, fine = deflection(axis, true) / theory;
        std::printf("along %c: %.4f with 12 x 2 pairs, %.4f with 24 x 4\n", "xyz"[axis], coarse, fine);
        EXPECT_NEAR(fine, 1, std::max(0.04, std::abs(coarse - 1) / 2));
    }
}

}  // namespace
}  // namespace corpuscle
