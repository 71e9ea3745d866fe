#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "../../unit/gas/gas_samples.hpp"
#include "gas/sample.hpp"
#include "laws/riemann/riemann.hpp"

namespace corpuscle {
namespace {

constexpr int bins = 20;
constexpr double end_time = 0.2;
constexpr double gamma_of_air = 1.4;
constexpr RiemannSide left{1, 0, 1, gamma_of_air, 0}, right{0.125, 0, 0.1, gamma_of_air, 0};

/// Sod's tube (J. Comput. Phys. 27 (1978) 1) as a slab: 1 m long, membrane in the middle, so wide that the left half holds
/// particles of the given spacing [m].
Gas tube(double spacing, std::size_t particles)
{
    const double section =
        static_cast<double>(particles) / (left.density + right.density) * left.density * spacing * spacing * spacing / 0.5;
    const double width = std::sqrt(section);
    Gas gas;
    gas.domain.box = {{0, 0, 0}, {1, width, width}};
    gas.species.push_back(species_of(IdealGas{gamma_of_air}, left.density * spacing * spacing * spacing));
    const std::vector<std::size_t> counts = share_particles({left.density, right.density}, particles);
    fill(gas, {Shape::box({{0, 0, 0}, {0.5, width, width}}), {}, 0, left.density, left.energy(), {}, -1}, counts[0]);
    fill(gas, {Shape::box({{0.5, 0, 0}, {1, width, width}}), {}, 0, right.density, right.energy(), {}, -1}, counts[1]);
    return gas;
}

/// Mean absolute error over the tube of density, velocity and pressure [in the units of the left state].
struct Errors {
    std::array<double, 3> sum{};
    std::array<double, 3> noise{};    ///< at most this part of it is from the finite number of particles
    std::array<double, 3> scatter{};  ///< standard deviation of it

    /// Takes up a bin: its mean absolute error and that of the particles in it, sqrt(2/pi) sigma.
    void add(const GasSample& found, const std::array<double, 3>& exact)
    {
        const double speck = 1 / std::sqrt(static_cast<double>(found.particles));
        const std::array<double, 3> values{found.density, found.velocity.x, found.pressure};
        const std::array<double, 3> sigma{found.density * speck, std::sqrt(found.pressure / found.density) * speck,
                                          found.pressure * std::sqrt(5.0 / 3) * speck};
        for (int q = 0; q < 3; ++q) {
            sum[q] += std::abs(values[q] - exact[q]) / bins;
            noise[q] += std::sqrt(2 / std::numbers::pi) * sigma[q] / bins;
            scatter[q] = std::hypot(scatter[q], sigma[q] / bins);
        }
    }
    /// Lower bound of what is not noise.
    [[nodiscard]] double rest(int q) const { return sum[q] - noise[q]; }
};

/// Exact mean of density, velocity of the mass, and pressure over a bin.
std::array<double, 3> exact_mean(const RiemannSolution& solution, double lower, double upper)
{
    constexpr int points = 64;
    double mass = 0, momentum = 0, pressure = 0;
    for (int k = 0; k < points; ++k) {
        const RiemannSide at = solution.at((lower + (upper - lower) * (k + 0.5) / points - 0.5) / end_time);
        mass += at.density / points;
        momentum += at.density * at.velocity / points;
        pressure += at.pressure / points;
    }
    return {mass, momentum / mass, pressure};
}

Errors errors_at(double spacing)
{
    Gas gas = tube(spacing, 400000);
    const Box whole = gas.domain.box;
    Clock clock;
    while (clock.time() < end_time * (1 - 1e-12)) advance(gas, clock, end_time - clock.time());
    const RiemannSolution solution(left, right);
    Errors errors;
    for (int b = 0; b < bins; ++b) {
        Box bin = whole;
        bin.lower.x = static_cast<double>(b) / bins;
        bin.upper.x = static_cast<double>(b + 1) / bins;
        const GasSample found = sample(gas, Shape::box(bin), bin.volume());
        const std::array<double, 3> exact = exact_mean(solution, bin.lower.x, bin.upper.x);
        errors.add(found, exact);
    }
    std::printf("spacing 1/%.0f, %llu steps: L1 of density %.5f, velocity %.5f, pressure %.5f (of which noise at most %.5f %.5f %.5f)\n",
                1 / spacing, static_cast<unsigned long long>(clock.step()), errors.sum[0], errors.sum[1], errors.sum[2], errors.noise[0],
                errors.noise[1], errors.noise[2]);
    return errors;
}

/// The mean free path, kappa spacings, is the only length that separates this gas from Euler's. A shock is a number of them wide and
/// the rarefaction's corners spread over areas (path c t): their L1 errors fall with the first power of the spacing; a contact spreads by
/// diffusion, (path c t)^1/2: its error falls with the power 1/2, once it is narrower than its distance to the shock. All together: an
/// order between 1/2 and 1. It is taken over two halvings from what is not noise, and uncertain by the scatter of both ends.
TEST(SodTube, comes_to_eulers_solution_with_the_order_of_diffusion)
{
    const std::array<double, 3> spacings{1.0 / 64, 1.0 / 128, 1.0 / 256};
    std::array<Errors, 3> errors;
    for (std::size_t i = 0; i < spacings.size(); ++i) errors[i] = errors_at(spacings[i]);
    const std::array<const char*, 3> names{"density", "velocity", "pressure"};
    for (int q = 0; q < 3; ++q) {
        const auto order = [&](int coarse, int fine) { return std::log2(errors[coarse].rest(q) / errors[fine].rest(q)) / (fine - coarse); };
        const double sigma =
            std::hypot(errors[0].scatter[q] / errors[0].rest(q), errors[2].scatter[q] / errors[2].rest(q)) / (2 * std::numbers::ln2);
        std::printf("order of %s: %.2f, %.2f; over both %.2f, sigma %.2f\n", names[q], order(0, 1), order(1, 2), order(0, 2), sigma);
        EXPECT_LT(errors[1].sum[q], errors[0].sum[q]) << names[q];
        EXPECT_LT(errors[2].sum[q], errors[1].sum[q]) << names[q];
        EXPECT_GT(order(0, 2), 0.5 - 4 * sigma) << names[q];
        EXPECT_LT(order(0, 2), 1 + 4 * sigma) << names[q];
        EXPECT_LT(sigma, 0.06) << names[q];  // or the order would say nothing
    }
}

}  // namespace
}  // namespace corpuscle
