#include "gas/radial_fill.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "gas/thermal_draw.hpp"
#include "math/random.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

/// Particles whose thermal velocities and energies together have the mean and scale of their place.
constexpr std::size_t block_size = 64;

/// The flow at a place in it.
struct Local {
    double radius = 0;    ///< [m]
    double velocity = 0;  ///< outward [m/s]
    double density = 0;   ///< [kg/m3]
    double energy = 0;    ///< internal, specific [J/kg]
};

/// Where a share of the mass, counted from the center, ends.
class MassCoordinate {
public:
    explicit MassCoordinate(const std::vector<RadialLayer>& layers) : layers_(layers)
    {
        double sum = 0;
        for (const RadialLayer& layer : layers) {
            sum += layer.density * (cube(layer.outer) - cube(layer.inner));
            upto_.push_back(sum);
        }
    }

    [[nodiscard]] Local at(double share) const
    {
        const double wanted = share * upto_.back();
        const auto found = std::min(std::lower_bound(upto_.begin(), upto_.end(), wanted), upto_.end() - 1);
        const auto index = static_cast<std::size_t>(found - upto_.begin());
        const RadialLayer& layer = layers_[index];
        const double above = std::max(0.0, wanted - (index == 0 ? 0.0 : upto_[index - 1]));
        const double radius = std::min(layer.outer, std::cbrt(cube(layer.inner) + above / layer.density));
        const double way = (radius - layer.inner) / (layer.outer - layer.inner);
        return {radius, std::lerp(layer.inner_velocity, layer.outer_velocity, way), layer.density, layer.energy};
    }

private:
    static double cube(double x) { return x * x * x; }
    const std::vector<RadialLayer>& layers_;
    std::vector<double> upto_;
};

/// A sector in the coordinates that measure solid angle evenly: cosine to the z axis and angle round it.
struct Angles {
    double low_cosine = -1, high_cosine = 1;
    double low_angle = 0, high_angle = 2 * std::numbers::pi;

    explicit Angles(const Sector& sector)
    {
        constexpr double pi = std::numbers::pi;
        if (sector.side[2] > 0) low_cosine = 0;
        if (sector.side[2] < 0) high_cosine = 0;
        const int x = sector.side[0], y = sector.side[1];
        if (x != 0 && y != 0) {
            low_angle = x > 0 ? (y > 0 ? 0 : -0.5 * pi) : (y > 0 ? 0.5 * pi : pi);
            high_angle = low_angle + 0.5 * pi;
        } else if (x != 0) {
            low_angle = x > 0 ? -0.5 * pi : 0.5 * pi;
            high_angle = low_angle + pi;
        } else if (y != 0) {
            low_angle = y > 0 ? 0 : pi;
            high_angle = low_angle + pi;
        }
    }
    [[nodiscard]] double solid_angle() const { return (high_cosine - low_cosine) * (high_angle - low_angle); }

    /// The direction at shares of both coordinates.
    [[nodiscard]] Vector3d direction(double cosine_share, double angle_share) const
    {
        const double cosine = std::lerp(low_cosine, high_cosine, cosine_share);
        const double angle = std::lerp(low_angle, high_angle, angle_share);
        const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
        return {sine * std::cos(angle), sine * std::sin(angle), cosine};
    }
    /// Bands between circles round the z axis that cut the sector into `count` pieces about as wide as long: up to which piece each goes.
    [[nodiscard]] std::vector<std::size_t> bands(std::size_t count) const
    {
        const double low = std::acos(high_cosine), high = std::acos(low_cosine);
        const double side = std::sqrt(solid_angle() / static_cast<double>(count));
        const double bands = std::max(1.0, std::round((high - low) / side));
        std::vector<std::size_t> upto;
        for (double band = 1; band <= bands; ++band) {
            const double share = (high_cosine - std::cos(std::lerp(low, high, band / bands))) / (high_cosine - low_cosine);
            upto.push_back(static_cast<std::size_t>(std::llround(share * static_cast<double>(count))));
        }
        return upto;
    }
};

/// A particle to be.
struct Seedling {
    Vector3d direction;
    Local local;
};

/// One particle at random in each of equal pieces of the sector, all in the mass between two shares; neighbours follow each other.
void add_shell(std::vector<Seedling>& places, std::size_t count, std::size_t total, const MassCoordinate& mass, const Angles& angles,
               Random& random)
{
    const std::size_t first = places.size();
    std::size_t from = 0;
    for (const std::size_t upto : angles.bands(count)) {
        for (std::size_t i = from; i < upto; ++i) {
            const double round = (static_cast<double>(i - from) + random.uniform_double()) / static_cast<double>(upto - from);
            const double across = static_cast<double>(from) + random.uniform_double() * static_cast<double>(upto - from);
            const double depth = static_cast<double>(first) + random.uniform_double() * static_cast<double>(count);
            places.push_back(
                {angles.direction(1 - across / static_cast<double>(count), round), mass.at(depth / static_cast<double>(total))});
        }
        from = upto;
    }
}

/// Shell by shell outward, each a spacing thick.
std::vector<Seedling> place(const RadialFill& fill, const Sector& sector, std::size_t count, double particle_mass, std::uint64_t seed)
{
    const MassCoordinate mass(fill.layers);
    const Angles angles(sector);
    std::vector<Seedling> places;
    places.reserve(count);
    for (std::size_t shell = 0; places.size() < count; ++shell) {
        Random random(seed, Purpose::fill, 0, shell);
        const std::size_t left = count - places.size();
        double wanted = 1;
        for (int i = 0; i < 3; ++i) {
            const double middle = (static_cast<double>(places.size()) + 0.5 * wanted) / static_cast<double>(count);
            const Local here = mass.at(std::min(1.0, middle));
            const double spacing = std::cbrt(particle_mass / here.density);
            wanted = std::max(1.0, angles.solid_angle() * here.radius * here.radius / (spacing * spacing));
        }
        auto own = std::min(left, static_cast<std::size_t>(std::llround(wanted)));
        if (left < own + own / 2) own = left;
        add_shell(places, own, count, mass, angles, random);
    }
    return places;
}

/// Shifts velocities by one vector and one speed outward so that their mean, and their mean outward part, are the ones wanted.
void shift(std::vector<Vector3d>& velocities, const std::vector<Seedling>& places, const Vector3d& mean, double mean_radial)
{
    const auto n = static_cast<double>(places.size());
    const auto sums = (1 / n) * sum<Vector3d>(places.size(), [&](std::size_t i) { return places[i].direction; });
    const auto velocity = (1 / n) * sum<Vector3d>(places.size(), [&](std::size_t i) { return velocities[i]; });
    const double radial = sum<double>(places.size(), [&](std::size_t i) { return dot(velocities[i], places[i].direction); }) / n;
    const Vector3d missing = mean - velocity;
    const double room = 1 - norm_squared(sums);
    const double outward = room > 1e-6 ? (mean_radial - radial - dot(sums, missing)) / room : 0.0;
    const Vector3d along = missing - outward * sums;
    for_each(places.size(), [&](std::size_t i) { velocities[i] += along + outward * places[i].direction; });
}

/// Thermal velocities and internal energies of particles at their places [m/s, J], neighbours in blocks that have the mean of theirs.
ThermalDraw thermal_of(const Species& species, const std::vector<Seedling>& places, std::uint64_t seed)
{
    const double gamma = heat_capacity_ratio(species.law);
    const double internal_share = 1 - translational_share(gamma);
    ThermalDraw all;
    for (std::size_t begin = 0; begin < places.size();) {
        const std::size_t left = places.size() - begin, count = left < 2 * block_size ? left : block_size;
        const ThermalDraw own = draw_thermal(count, species.internal_freedoms, seed, begin / block_size);
        for (std::size_t i = 0; i < count; ++i) {
            const double energy = places[begin + i].local.energy;
            all.velocity.push_back(std::sqrt((gamma - 1) * energy) * own.velocity[i]);
            all.energy.push_back(species.particle_mass * energy * internal_share * own.energy[i]);
        }
        begin += count;
    }
    return all;
}

/// Factor on thermal velocities (and, squared, on internal energies) that gives all particles together an energy [J]: the larger root of a
/// quadratic. Refuses a flow that has less than its motion carries.
double thermal_scale(const std::vector<Vector3d>& flow, const ThermalDraw& thermal, double particle_mass, double energy)
{
    const std::size_t n = flow.size();
    const double half = 0.5 * particle_mass;
    const double moving = half * sum<double>(n, [&](std::size_t i) { return norm_squared(flow[i]); });
    const double mixed = half * sum<double>(n, [&](std::size_t i) { return dot(flow[i], thermal.velocity[i]); });
    const double heat = sum<double>(n, [&](std::size_t i) { return half * norm_squared(thermal.velocity[i]) + thermal.energy[i]; });
    const double root = mixed * mixed + heat * (energy - moving);
    if (!(root > 0) || !(heat > 0))
        throw InputError("a radial flow is too coarse for its particles: its motion alone has more than its energy",
                         "give it more particles, or start from a time 0");
    return (std::sqrt(root) - mixed) / heat;
}

}  // namespace

double Sector::share() const
{
    double share = 1;
    for (const int s : side) share *= s == 0 ? 1.0 : 0.5;
    return share;
}

Sector sector_of(const Domain& domain, const Vector3d& center)
{
    Sector sector;
    for (int axis = 0; axis < 3; ++axis) {
        const double near = 1e-9 * domain.box.size()[axis];
        if (std::abs(center[axis] - domain.box.lower[axis]) <= near) sector.side[static_cast<std::size_t>(axis)] = 1;
        if (std::abs(center[axis] - domain.box.upper[axis]) <= near) sector.side[static_cast<std::size_t>(axis)] = -1;
    }
    return sector;
}

void fill_radial(Gas& gas, const RadialFill& fill, std::size_t count)
{
    if (count == 0) return;
    const std::size_t first = gas.particles.size();
    const std::uint64_t seed = gas.settings.seed + 0x9E3779B97F4A7C15u * (first + 1);
    const Species& species = gas.species[fill.species];
    const Sector sector = sector_of(gas.domain, fill.center);
    const std::vector<Seedling> places = place(fill, sector, count, species.particle_mass, seed);
    ThermalDraw thermal = thermal_of(species, places, seed);
    shift(thermal.velocity, places, {}, 0);
    std::vector<Vector3d> flow;
    for (const Seedling& here : places) flow.push_back(here.local.velocity * here.direction);
    const double outward = fill.momentum / fill.mass;
    shift(flow, places, outward * sector.mean_direction(), outward);
    const double scale = thermal_scale(flow, thermal, species.particle_mass, sector.share() * fill.energy);
    gas.particles.resize(first + count);
    for_each(count, [&](std::size_t i) {
        Particle& particle = gas.particles[first + i];
        particle.position = Vector3f(fill.center + places[i].local.radius * places[i].direction);
        particle.velocity = Vector3f(flow[i] + scale * thermal.velocity[i]);
        particle.energy = static_cast<float>(scale * scale * thermal.energy[i]);
        particle.tag = particle_tag::make(fill.species);
    });
}

}  // namespace corpuscle
