#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "gas/burn.hpp"
#include "gas/collide.hpp"
#include "gas/fill.hpp"
#include "gas/fly.hpp"
#include "gas/sleep.hpp"
#include "gas/sort.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

inline constexpr Box unit_box{{0, 0, 0}, {1, 1, 1}};

/// A kind of gas whose particles weigh this much [kg].
inline Species species_of(const EquationOfState& law, double particle_mass)
{
    return {"gas", law, particle_mass, internal_freedoms(heat_capacity_ratio(law))};
}

/// A box full of one gas at rest: density [kg/m3], specific energy [J/kg].
inline Gas filled_box(const Box& box, const EquationOfState& law, double density, double energy, std::size_t count)
{
    Gas gas;
    gas.domain.box = box;
    gas.species.push_back(species_of(law, density * box.volume() / static_cast<double>(count)));
    fill(gas, {Shape::box(box), {}, 0, density, energy, {}, -1}, count);
    return gas;
}

/// The ambient gas that a filled box would be at peace with.
inline AmbientGas ambient_like(const Species& species, double density, double energy)
{
    const double variance = (heat_capacity_ratio(species.law) - 1) * energy;
    return {0, density, density * variance, variance};
}

/// A step of gas alone, in the order of a run.
inline void advance(Gas& gas, Clock& clock, double longest = std::numeric_limits<double>::infinity())
{
    const FacetTree none{Surface{}};
    if (clock.step() == 0) {
        lay_to_sleep(gas, none);
        sort(gas);
        survey(gas);
    }
    clock.begin_step(std::min(longest, stable_step(gas, clock.time())));
    burn(gas, clock);
    wake(gas, clock);
    sort(gas);
    collide(gas, clock, none);
    fly(gas, clock, none);
    clock.end_step();
}

/// Sets the number of threads while it lives.
class WithThreads {
public:
    explicit WithThreads(int count) { set_thread_count(count); }
    ~WithThreads() { set_thread_count(before_); }
    WithThreads(const WithThreads&) = delete;
    WithThreads& operator=(const WithThreads&) = delete;

private:
    int before_ = thread_count();
};

/// A particle's 32 bytes, for comparing to the last bit.
inline std::array<std::uint32_t, 8> bits(const Particle& particle)
{
    return std::bit_cast<std::array<std::uint32_t, 8>>(particle);
}

inline bool same_bits(const std::vector<Particle>& a, const std::vector<Particle>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Particle& p, const Particle& q) { return bits(p) == bits(q); });
}

inline bool same_bits(const Passage& a, const Passage& b)
{
    return a.mass == b.mass && a.momentum == b.momentum && a.energy == b.energy;
}

/// Sum of speeds times masses: the measure of rounding in momentum [kg m/s].
inline double speed_sum(const Gas& gas)
{
    double total = 0;
    for (const Particle& p : gas.particles) total += gas.species[particle_tag::species(p.tag)].particle_mass * norm(Vector3d(p.velocity));
    return total;
}

/// Mean, variance and scaled fourth moment of numbers.
struct Statistics {
    double count = 0, mean = 0, variance = 0, kurtosis = 0;

    explicit Statistics(const std::vector<double>& values) : count(static_cast<double>(values.size()))
    {
        for (const double v : values) mean += v / count;
        double fourth = 0;
        for (const double v : values) {
            variance += (v - mean) * (v - mean) / count;
            fourth += std::pow(v - mean, 4) / count;
        }
        kurtosis = fourth / (variance * variance);
    }
    /// Standard error of the mean.
    [[nodiscard]] double error() const { return std::sqrt(variance / count); }
};

}  // namespace corpuscle
