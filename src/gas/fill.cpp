#include "gas/fill.hpp"

#include <algorithm>
#include <numeric>

#include "base/error.hpp"
#include "gas/thermal_draw.hpp"
#include "math/random.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

bool belongs(const Fill& fill, const Domain& domain, const Vector3d& place)
{
    if (!domain.box.contains(place) || !fill.shape.contains(place)) return false;
    return std::none_of(fill.cut_by.begin(), fill.cut_by.end(), [&](const Shape& cut) { return cut.contains(place); });
}

/// The box common to both; empty sides are zero.
Box common_box(const Box& a, const Box& b)
{
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        box.lower[axis] = std::max(a.lower[axis], b.lower[axis]);
        box.upper[axis] = std::max(box.lower[axis], std::min(a.upper[axis], b.upper[axis]));
    }
    return box;
}

/// A lattice of nearly cubic cells over a box.
struct FillLattice {
    Box box;
    std::array<std::size_t, 3> cells{};

    FillLattice(const Box& region, double spacing) : box(region)
    {
        for (int a = 0; a < 3; ++a) cells[a] = std::max<std::size_t>(1, static_cast<std::size_t>(std::llround(region.size()[a] / spacing)));
    }
    [[nodiscard]] std::size_t size() const { return cells[0] * cells[1] * cells[2]; }
    [[nodiscard]] double cell_volume() const { return box.volume() / static_cast<double>(size()); }

    /// A place in cell c, at the given fractions of its sides.
    [[nodiscard]] Vector3d place(std::size_t c, const Vector3d& fraction) const
    {
        const std::array<std::size_t, 3> index{c % cells[0], c / cells[0] % cells[1], c / cells[0] / cells[1]};
        Vector3d p;
        for (int a = 0; a < 3; ++a) {
            p[a] = box.lower[a] + box.size()[a] * (static_cast<double>(index[a]) + fraction[a]) / static_cast<double>(cells[a]);
        }
        return p;
    }
};

Vector3d random_fraction(Random& random)
{
    const double x = random.uniform_double(), y = random.uniform_double();
    return {x, y, random.uniform_double()};
}

/// One random place in each lattice cell, those in the region; the same for any number of threads.
std::vector<Vector3d> scatter(const Fill& fill, const Domain& domain, const FillLattice& lattice, std::uint64_t seed)
{
    struct Places {
        std::vector<Vector3d> list;
        Places& operator+=(const Places& other)
        {
            list.insert(list.end(), other.list.begin(), other.list.end());
            return *this;
        }
    };
    return sum_chunks<Places>(lattice.size(),
                              [&](std::size_t begin, std::size_t end) {
                                  Places places;
                                  for (std::size_t c = begin; c < end; ++c) {
                                      Random random(seed, Purpose::fill, 0, c);
                                      const Vector3d place = lattice.place(c, random_fraction(random));
                                      if (belongs(fill, domain, place)) places.list.push_back(place);
                                  }
                                  return places;
                              })
        .list;
}

/// Drops or adds random places until there are exactly `count`.
void adjust(std::vector<Vector3d>& places, std::size_t count, const Fill& fill, const Domain& domain, std::uint64_t seed)
{
    Random random(seed, Purpose::fill, 1, places.size());
    while (places.size() > count) {
        const std::size_t drop = random.below(static_cast<std::uint32_t>(places.size()));
        places[drop] = places.back();
        places.pop_back();
    }
    const FillLattice whole(common_box(fill.shape.bounds(), domain.box), 1e30);
    for (std::size_t tries = 0; places.size() < count; ++tries) {
        if (tries > 1000 * count + 100000)
            throw InputError("a fill's region is too thin for its particles", "give it more volume or fewer particles");
        const Vector3d place = whole.place(0, random_fraction(random));
        if (belongs(fill, domain, place)) places.push_back(place);
    }
}

}  // namespace

double volume(const Fill& fill, const Domain& domain)
{
    const Box region = common_box(fill.shape.bounds(), domain.box);
    const bool fills_box = std::abs(fill.shape.volume_within(domain.box) - region.volume()) <= 1e-12 * region.volume();
    double whole = fill.shape.volume_within(domain.box);
    bool apart = true;
    for (std::size_t i = 0; i < fill.cut_by.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) apart = apart && !fill.cut_by[i].bounds().overlaps(fill.cut_by[j].bounds());
        whole -= fill.cut_by[i].volume_within(region);
    }
    if (fill.cut_by.empty() || (fills_box && apart)) return std::max(0.0, whole);
    const FillLattice lattice(region, std::cbrt(region.volume() / 1e7));
    return lattice.cell_volume() * static_cast<double>(scatter(fill, domain, lattice, 1).size());
}

void fill(Gas& gas, const Fill& fill, std::size_t count)
{
    if (count == 0) return;
    const std::size_t first = gas.particles.size();
    const std::uint64_t seed = gas.settings.seed + 0x9E3779B97F4A7C15u * (first + 1);
    const double room = volume(fill, gas.domain);
    if (!(room > 0)) throw InputError("a fill has particles but no room within the gas box", "move its shape, or what cuts it");
    const FillLattice lattice(common_box(fill.shape.bounds(), gas.domain.box), std::cbrt(room / static_cast<double>(count)));
    std::vector<Vector3d> places = scatter(fill, gas.domain, lattice, seed);
    adjust(places, count, fill, gas.domain, seed);

    const Species& species = gas.species[fill.species];
    const double gamma = heat_capacity_ratio(species.law);
    const double sigma = std::sqrt((gamma - 1) * fill.energy_per_mass);
    const double internal = species.particle_mass * fill.energy_per_mass * (1 - translational_share(gamma));
    const ThermalDraw thermal = draw_thermal(count, species.internal_freedoms, seed, 0);
    const bool waits = fill.charge >= 0;
    const std::uint32_t tag =
        particle_tag::make(fill.species, waits ? static_cast<std::uint32_t>(fill.charge) : 0, waits ? particle_tag::unburnt : 0);
    gas.particles.resize(first + count);
    for_each(count, [&](std::size_t i) {
        Particle& particle = gas.particles[first + i];
        particle.position = Vector3f(places[i]);
        particle.velocity = Vector3f(fill.velocity + sigma * thermal.velocity[i]);
        particle.energy = static_cast<float>(internal * thermal.energy[i]);
        particle.tag = tag;
    });
    if (waits) gas.charges[static_cast<std::size_t>(fill.charge)].unburnt += count;
}

std::vector<std::size_t> share_particles(const std::vector<double>& masses, std::size_t total)
{
    const double whole = std::accumulate(masses.begin(), masses.end(), 0.0);
    std::vector<std::size_t> counts;
    double seen = 0;
    std::size_t given = 0;
    for (const double mass : masses) {
        seen += mass;
        const auto upto = static_cast<std::size_t>(std::llround(static_cast<double>(total) * seen / whole));
        counts.push_back(upto - given);
        given = upto;
    }
    return counts;
}

}  // namespace corpuscle
