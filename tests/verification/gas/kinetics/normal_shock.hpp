#pragma once

#include <cmath>
#include <numbers>

#include "math/random.hpp"
#include "unit/gas/gas_samples.hpp"
#include "verification/gas/kinetics/line_fit.hpp"

namespace corpuscle {

/// A normal shock in a gas of hard spheres, gamma 5/3: gas streams along -x into a rigid wall, the shock runs away from it.
/// The spacing before the shock is 1 m, the density 1 kg/m3, sigma 1 m/s.
struct NormalShock {
    double mach = 2;
    double path = 10;    ///< mean free path before the shock [spacings]
    double width = 16;   ///< of the square tube [spacings]
    double formed = 14;  ///< where the shock stands when profiles are first taken [paths from the wall]
    double end = 30;     ///< where it stands at last [paths]
    std::uint64_t seed = 1;
};

/// What it shows.
struct ShockFound {
    double thickness_ratio = 0;  ///< mean free path before it over the density-slope thickness
    double error = 0;            ///< its standard error, from blocks of profiles
    double density_ratio = 0;    ///< behind to before
    double speed = 0;            ///< relative to the gas before it, over that gas's speed of sound
    double jitter = 0;           ///< deviation of the shock's place from even motion [paths]
    std::size_t profiles = 0;
    std::uint64_t steps = 0;
    std::vector<double> place, density;  ///< profile: distance from the middle [paths], (density - before)/(behind - before)
};

/// Rankine and Hugoniot for gamma 5/3, over the state before.
struct ShockJump {
    explicit ShockJump(double mach)
        : density((8.0 / 3) * mach * mach / ((2.0 / 3) * mach * mach + 2)), sound(std::sqrt(5.0 / 3)), shock(mach * sound)
    {
        piston = shock * (1 - 1 / density);
    }
    double density;  ///< behind [kg/m3]
    double sound;    ///< before [m/s]
    double shock;    ///< speed into the gas before it [m/s]
    double piston;   ///< speed of the gas behind it [m/s]
};

/// Gas that streams at -u into a wall at x = 0.
inline Gas stream(const NormalShock& set, double length, double speed)
{
    Gas gas;
    gas.domain = {{{0, 0, 0}, {length, set.width, set.width}},
                  {Edge::rigid, Edge::open, Edge::rigid, Edge::rigid, Edge::rigid, Edge::rigid}};
    gas.species.push_back(species_of(IdealGas{5.0 / 3}, 1));
    gas.settings.cross_section = 1 / (std::numbers::sqrt2 * set.path);
    gas.settings.seed = set.seed;
    gas.settings.cell_limit = 4;
    fill(gas, {Shape::box(gas.domain.box), {}, 0, 1, 1.5, {-speed, 0, 0}, -1}, static_cast<std::size_t>(gas.domain.box.volume()));
    return gas;
}

/// Lets the stream flow in through the upper end: a slab of gas beyond it flies freely, and what crosses is there.
inline void stream_in(Gas& gas, double speed, const Clock& clock)
{
    Random random(gas.settings.seed + 77, Purpose::inflow, clock.step(), 9);
    const Box& box = gas.domain.box;
    const double depth = (speed + 6) * clock.duration(), expected = depth * box.size().y * box.size().z;
    const auto count = static_cast<std::size_t>(expected + random.uniform_double());
    for (std::size_t i = 0; i < count; ++i) {
        Particle p;
        p.velocity = {static_cast<float>(random.normal() - speed), static_cast<float>(random.normal()),
                      static_cast<float>(random.normal())};
        p.position = {
            static_cast<float>(box.upper.x + depth * random.uniform_double() + clock.duration() * static_cast<double>(p.velocity.x)),
            static_cast<float>(box.upper.y * random.uniform_double()), static_cast<float>(box.upper.z * random.uniform_double())};
        p.tag = particle_tag::make(0);
        if (static_cast<double>(p.position.x) < box.upper.x) gas.particles.push_back(p);
    }
}

/// Density in slabs of equal depth along x.
class Profile {
public:
    Profile(double length, double area, std::size_t bins) : width_(length / static_cast<double>(bins)), slab_(width_ * area), density_(bins)
    {
    }

    void measure(const Gas& gas)
    {
        std::fill(density_.begin(), density_.end(), 0.0);
        for (const Particle& p : gas.particles) {
            const auto bin = static_cast<std::size_t>(static_cast<double>(p.position.x) / width_);
            if (bin < density_.size()) density_[bin] += 1 / slab_;
        }
    }
    /// Number of particles an area between two places, over bins cut by them in proportion.
    [[nodiscard]] double column(double from, double to) const
    {
        double sum = 0;
        for (std::size_t b = 0; b < density_.size(); ++b) {
            const double lower = std::max(from, static_cast<double>(b) * width_), upper = std::min(to, static_cast<double>(b + 1) * width_);
            if (upper > lower) sum += (upper - lower) * density_[b];
        }
        return sum;
    }

private:
    double width_, slab_;
    std::vector<double> density_;
};

/// The place that parts the same number of particles into gas before and gas behind, within `reach` on either side of a guess.
inline double shock_place(const Profile& profile, double guess, double reach, double behind)
{
    for (int i = 0; i < 3; ++i) {
        const double from = std::max(0.0, guess - reach), to = guess + reach;
        guess = from + (profile.column(from, to) - (to - from)) / (behind - 1);
    }
    return guess;
}

/// Greatest slope of a profile: of the cubic through the middle part of it, by least squares within `reach`.
inline double steepest(const std::vector<double>& place, const std::vector<double>& value, double reach)
{
    // Odd and even parts of a + b x + c x^2 + d x^3 separate only for even places: solve the 4 x 4 system.
    std::array<std::array<double, 5>, 4> m{};
    for (std::size_t i = 0; i < place.size(); ++i) {
        if (std::abs(place[i]) > reach) continue;
        const std::array<double, 4> power{1, place[i], place[i] * place[i], place[i] * place[i] * place[i]};
        for (int r = 0; r < 4; ++r) {
            for (int c = 0; c < 4; ++c) m[r][c] += power[r] * power[c];
            m[r][4] += power[r] * value[i];
        }
    }
    for (int p = 0; p < 4; ++p) {
        for (int r = 0; r < 4; ++r) {
            if (r == p) continue;
            const double factor = m[r][p] / m[p][p];
            for (int c = p; c < 5; ++c) m[r][c] -= factor * m[p][c];
        }
    }
    const double b = m[1][4] / m[1][1], c = m[2][4] / m[2][2], d = m[3][4] / m[3][3];
    return std::abs(d != 0 ? b - c * c / (3 * d) : b);  // the slope where its own slope vanishes
}

/// Mean free path over the thickness, from a profile that is read within 0.35 of the thickness about its middle: there a cubic's slope is
/// within 0.7 % of that of tanh.
inline double thickness_ratio(const std::vector<double>& place, const std::vector<double>& density)
{
    double thickness = 4;
    for (int i = 0; i < 6; ++i) thickness = std::clamp(1 / steepest(place, density, 0.35 * thickness), 1.0, 10.0);
    return 1 / thickness;
}

/// Collects profiles in the shock's frame, in blocks that follow one another.
class ShockProfiles {
public:
    static constexpr int bins_a_path = 10, half = 100, blocks = 4;

    ShockProfiles(const NormalShock& set, const ShockJump& jump) : set_(set), jump_(jump), sum_(blocks, std::vector<double>(2 * half)) {}

    void add(const Profile& profile, double time, double guess)
    {
        const double place = shock_place(profile, guess, 10 * set_.path, jump_.density);
        const double done = (guess / set_.path - set_.formed) / (set_.end - set_.formed);
        std::vector<double>& block = sum_[static_cast<std::size_t>(std::clamp(done, 0.0, 0.999) * blocks)];
        for (int b = 0; b < 2 * half; ++b) {
            const double from = place + (b - half) * set_.path / bins_a_path, to = from + set_.path / bins_a_path;
            block[b] += profile.column(from, to) / (to - from) - 1;
        }
        behind_ += profile.column(place - 10 * set_.path, place - 6 * set_.path) / (4 * set_.path);
        track_.add(time, place);
        ++count_;
    }

    [[nodiscard]] ShockFound read() const
    {
        ShockFound found;
        found.profiles = count_;
        found.density_ratio = behind_ / static_cast<double>(count_);
        found.speed = (track_.slope() + jump_.piston) / jump_.sound;
        found.jitter = track_.scatter() / set_.path;
        for (int b = 0; b < 2 * half; ++b) found.place.push_back((b - half + 0.5) / bins_a_path);
        found.density.assign(2 * half, 0.0);
        std::vector<double> ratios;
        for (const std::vector<double>& block : sum_) {
            std::vector<double> own = block;
            const double share = blocks / static_cast<double>(count_) / (jump_.density - 1);  // blocks hold equal numbers, but for one
            for (int b = 0; b < 2 * half; ++b) found.density[b] += (own[b] *= share) / blocks;
            ratios.push_back(thickness_ratio(found.place, own));
        }
        found.thickness_ratio = thickness_ratio(found.place, found.density);
        found.error = Statistics(ratios).error() * std::sqrt(blocks / (blocks - 1.0));
        return found;
    }

private:
    const NormalShock& set_;
    const ShockJump& jump_;
    std::vector<std::vector<double>> sum_;
    LineFit track_;
    double behind_ = 0;
    std::size_t count_ = 0;
};

/// Runs the shock and takes profiles in its own frame.
inline ShockFound run(const NormalShock& set)
{
    const ShockJump jump(set.mach);
    const double length = (set.end + 12) * set.path, lab = jump.shock - jump.piston;
    Gas gas = stream(set, length, jump.piston);
    Profile profile(length, set.width * set.width, static_cast<std::size_t>(length));
    ShockProfiles profiles(set, jump);
    Clock clock;
    for (double next = set.formed * set.path; lab * clock.time() < set.end * set.path;) {
        advance(gas, clock);
        stream_in(gas, jump.piston, clock);
        const double place = lab * clock.time();
        if (place < next) continue;
        next += 0.1 * set.path;
        profile.measure(gas);
        profiles.add(profile, clock.time(), place);
    }
    ShockFound found = profiles.read();
    found.steps = clock.step();
    return found;
}

}  // namespace corpuscle
