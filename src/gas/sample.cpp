#include "gas/sample.hpp"

#include <cmath>
#include <limits>

#include "gas/hard_spheres.hpp"
#include "gas/sleep.hpp"
#include "parallel/sort.hpp"

namespace corpuscle {

namespace {

/// Sums over particles of one region, from which its averages follow.
struct Moments {
    std::vector<double> count;       ///< by species
    std::vector<double> squared;     ///< sum of velocity squared by species [m2/s2]
    std::vector<Vector3d> velocity;  ///< sum by species [m/s]
    double internal = 0;             ///< [J]

    explicit Moments(std::size_t species = 0) : count(species), squared(species), velocity(species) {}

    void add(const Particle& particle)
    {
        const std::uint32_t s = particle_tag::species(particle.tag);
        const Vector3d v(particle.velocity);
        count[s] += 1;
        squared[s] += norm_squared(v);
        velocity[s] += v;
        internal += static_cast<double>(particle.energy);
    }
    Moments& operator+=(const Moments& other)
    {
        if (count.empty()) *this = Moments(other.count.size());
        for (std::size_t s = 0; s < other.count.size(); ++s) {
            count[s] += other.count[s];
            squared[s] += other.squared[s];
            velocity[s] += other.velocity[s];
        }
        internal += other.internal;
        return *this;
    }
};

bool is_gas(const Particle& particle)
{
    return !(particle.tag & (particle_tag::unburnt | particle_tag::gone));
}

/// Averages of a region of known volume.
GasSample evaluate(const Gas& gas, const Moments& moments, double volume)
{
    GasSample result;
    double mass = 0, number = 0;
    Vector3d momentum;
    for (std::size_t s = 0; s < moments.count.size(); ++s) {
        const double m = gas.species[s].particle_mass;
        number += moments.count[s];
        mass += m * moments.count[s];
        momentum += m * moments.velocity[s];
    }
    result.particles = static_cast<std::size_t>(number);
    if (number == 0) return result;
    result.density = mass / volume;
    result.velocity = momentum / mass;
    double thermal = 0;
    for (std::size_t s = 0; s < moments.count.size(); ++s) {
        if (moments.count[s] == 0) continue;
        const double m = gas.species[s].particle_mass;
        const double own =
            0.5 * m *
            (moments.squared[s] - 2 * dot(result.velocity, moments.velocity[s]) + moments.count[s] * norm_squared(result.velocity));
        thermal += own;
        const double kinetic = 2.0 / 3.0 * own / volume;
        result.pressure += kinetic + virial_pressure(gas, s, m * moments.count[s] / volume, kinetic);
        result.kinetic_pressure += kinetic;
    }
    result.energy = (thermal + moments.internal) / mass;
    return result;
}

}  // namespace

namespace {

/// Particles of a chunk that lie in a region, in their order.
struct Found {
    std::vector<std::uint32_t> particles;

    Found& operator+=(const Found& other)
    {
        particles.insert(particles.end(), other.particles.begin(), other.particles.end());
        return *this;
    }
};

std::vector<std::uint32_t> find(const Gas& gas, const Shape& shape)
{
    const Box bounds = shape.bounds();
    const auto in_chunk = [&](std::size_t begin, std::size_t end) {
        Found found;
        for (std::size_t i = begin; i < end; ++i) {
            const Vector3d place(gas.particles[i].position);
            if (is_gas(gas.particles[i]) && bounds.contains(place) && shape.contains(place))
                found.particles.push_back(static_cast<std::uint32_t>(i));
        }
        return found;
    };
    return sum_chunks<Found>(gas.particles.size(), in_chunk).particles;
}

constexpr double gas_constant = 8.31446261815324;  // [J/(mol K)], CODATA 2018

/// What one particle of a species adds to a sample: its mass to the density, its amount of substance to the temperature, and to the
/// pressure, by the law's slopes at the species' own state, shares of both its mass and its motion.
struct SpeciesShares {
    double mass = 0;        ///< of a particle [kg]
    double amount = 0;      ///< of substance of a particle [mol]
    double by_density = 0;  ///< d(virial pressure)/d(density) [m2/s2]
    double by_kinetic = 1;  ///< 1 + d(virial pressure)/d(kinetic pressure)
};

/// Central differences of the law over a thousandth of the state.
SpeciesShares shares_of(const Gas& gas, std::size_t s, double density, double kinetic)
{
    const Species& species = gas.species[s];
    constexpr double step = 1e-3;
    SpeciesShares shares{species.particle_mass, species.molar_mass > 0 ? species.particle_mass / species.molar_mass : 0, 0, 1};
    const auto virial = [&](double d, double k) { return virial_pressure(gas, s, d, k); };
    if (density > 0)
        shares.by_density = (virial(density * (1 + step), kinetic) - virial(density * (1 - step), kinetic)) / (2 * step * density);
    if (kinetic > 0)
        shares.by_kinetic += (virial(density, kinetic * (1 + step)) - virial(density, kinetic * (1 - step))) / (2 * step * kinetic);
    return shares;
}

/// Shares of each species at its own density and kinetic pressure in the region.
std::vector<SpeciesShares> shares_of(const Gas& gas, const std::vector<std::uint32_t>& inside, const Vector3d& velocity, double volume)
{
    std::vector<double> density(gas.species.size()), kinetic(gas.species.size());
    for (const std::uint32_t i : inside) {
        const std::uint32_t s = particle_tag::species(gas.particles[i].tag);
        const double mass = gas.species[s].particle_mass;
        density[s] += mass / volume;
        kinetic[s] += mass * norm_squared(Vector3d(gas.particles[i].velocity) - velocity) / (3 * volume);
    }
    std::vector<SpeciesShares> shares;
    for (std::size_t s = 0; s < gas.species.size(); ++s) shares.push_back(shares_of(gas, s, density[s], kinetic[s]));
    return shares;
}

/// T = sum(m c^2/3)/(R sum of amounts); nothing where an amount is not known.
double temperature_of(const Gas& gas, const std::vector<std::uint32_t>& inside, const std::vector<SpeciesShares>& shares, double energy)
{
    double amount = 0;
    for (const std::uint32_t i : inside) {
        const SpeciesShares& own = shares[particle_tag::species(gas.particles[i].tag)];
        if (!(own.amount > 0)) return std::numeric_limits<double>::quiet_NaN();
        amount += own.amount;
    }
    return energy / (gas_constant * amount);
}

/// Adds each particle's squared share of every sum; of a ratio (velocity, temperature) the share of what is left of it.
void add_errors(const Gas& gas, const std::vector<std::uint32_t>& inside, double volume, GasSample& result)
{
    const std::vector<SpeciesShares> shares = shares_of(gas, inside, result.velocity, volume);
    result.temperature = temperature_of(gas, inside, shares, result.kinetic_pressure * volume);
    double density = 0, kinetic = 0, pressure = 0, heat = 0, amount = 0;
    Vector3d velocity;
    for (const std::uint32_t i : inside) {
        const SpeciesShares& own = shares[particle_tag::species(gas.particles[i].tag)];
        const Vector3d relative = Vector3d(gas.particles[i].velocity) - result.velocity;
        const double motion = own.mass * norm_squared(relative) / 3;
        density += own.mass * own.mass;
        velocity += own.mass * own.mass * scaled(relative, relative);
        kinetic += motion * motion;
        const double pushed = own.by_kinetic * motion + own.by_density * own.mass;
        pressure += pushed * pushed;
        const double excess = motion - gas_constant * own.amount * result.temperature;
        heat += excess * excess;
        amount += gas_constant * own.amount;
    }
    const double mass = result.density * volume;
    result.error.density = std::sqrt(density) / volume;
    for (int axis = 0; axis < 3; ++axis) result.error.velocity[axis] = std::sqrt(velocity[axis]) / mass;
    result.error.kinetic_pressure = std::sqrt(kinetic) / volume;
    result.error.pressure = std::sqrt(pressure) / volume;
    result.error.temperature = std::sqrt(heat) / amount;
}

}  // namespace

GasSample sample(const Gas& gas, const Shape& shape, double volume)
{
    const std::vector<std::uint32_t> inside = find(gas, shape);
    Moments moments(gas.species.size());
    for (const std::uint32_t i : inside) moments.add(gas.particles[i]);
    GasSample result = evaluate(gas, moments, volume);
    if (!inside.empty()) add_errors(gas, inside, volume, result);
    return result;
}

GasGrid average(const Gas& gas, double cell_size)
{
    GasGrid grid;
    grid.box = gas.domain.box;
    const Vector3d size = grid.box.size();
    for (int a = 0; a < 3; ++a) grid.cells[a] = std::max<std::size_t>(1, static_cast<std::size_t>(std::llround(size[a] / cell_size)));
    const std::size_t cells = grid.size();
    const auto cell_of = [&](std::size_t i) -> std::size_t {
        const Particle& particle = gas.particles[i];
        if (!is_gas(particle)) return cells;
        std::array<std::size_t, 3> index{};
        for (int a = 0; a < 3; ++a) {
            const double q = (static_cast<double>(particle.position[a]) - grid.box.lower[a]) / size[a] * static_cast<double>(grid.cells[a]);
            index[a] = std::min(grid.cells[a] - 1, static_cast<std::size_t>(std::max(0.0, q)));
        }
        return (index[2] * grid.cells[1] + index[1]) * grid.cells[0] + index[0];
    };
    std::vector<std::uint32_t> order(gas.particles.size());
    const std::vector<std::uint32_t> start =
        stable_counting_sort(gas.particles.size(), cells + 1, cell_of,
                             [&](std::size_t i, std::uint32_t position) { order[position] = static_cast<std::uint32_t>(i); });

    grid.density.resize(cells);
    grid.velocity.resize(cells);
    grid.pressure.resize(cells);
    grid.product_share.resize(cells);
    const double volume = grid.box.volume() / static_cast<double>(cells);
    for_each(cells, [&](std::size_t c) {
        Moments moments(gas.species.size());
        for (std::uint32_t k = start[c]; k < start[c + 1]; ++k) moments.add(gas.particles[order[k]]);
        const GasSample average = evaluate(gas, moments, volume);
        double products = 0;
        for (const Charge& charge : gas.charges)
            products = std::max(products, moments.count[charge.species] * gas.species[charge.species].particle_mass);
        grid.density[c] = static_cast<float>(average.density);
        grid.velocity[c] = Vector3f(average.velocity);
        grid.pressure[c] = static_cast<float>(average.pressure);
        grid.product_share[c] = average.density > 0 ? static_cast<float>(products / (average.density * volume)) : 0.0f;
    });
    return grid;
}

FieldSet fields(const GasGrid& grid)
{
    const std::size_t cells = grid.size();
    FieldSet set{"gas averages", {}};
    set.fields.push_back(
        derived_field<float>("density", "kg/m3", "mass of gas per volume", cells, [&grid](std::size_t i) { return grid.density[i]; }));
    set.fields.push_back(
        derived_field<Vector3f>("velocity", "m/s", "velocity of the mass", cells, [&grid](std::size_t i) { return grid.velocity[i]; }));
    set.fields.push_back(
        derived_field<float>("pressure", "Pa", "kinetic and virial pressure", cells, [&grid](std::size_t i) { return grid.pressure[i]; }));
    set.fields.push_back(derived_field<float>("product_share", "1", "mass share of detonation products", cells,
                                              [&grid](std::size_t i) { return grid.product_share[i]; }));
    return set;
}

FieldSet particle_fields(const Gas& gas)
{
    const std::vector<Particle>& particles = gas.particles;
    const std::size_t count = particles.size();
    FieldSet set{"gas", {}};
    set.fields.push_back(derived_field<Vector3f>("velocity", "m/s", "velocity", count, [&particles](std::size_t i) {
        return particles[i].tag & particle_tag::unburnt ? Vector3f{} : particles[i].velocity;
    }));
    set.fields.push_back(derived_field<float>("speed", "m/s", "magnitude of the velocity", count, [&particles](std::size_t i) {
        return particles[i].tag & particle_tag::unburnt ? 0.0f : norm(particles[i].velocity);
    }));
    set.fields.push_back(derived_field<float>("internal_energy", "J/kg", "spin energy per mass", count, [&gas](std::size_t i) {
        const Particle& particle = gas.particles[i];
        return static_cast<float>(static_cast<double>(particle.energy) / gas.species[particle_tag::species(particle.tag)].particle_mass);
    }));
    set.fields.push_back(derived_field<std::uint8_t>("species", "1", "number of the species", count, [&particles](std::size_t i) {
        return static_cast<std::uint8_t>(particle_tag::species(particles[i].tag));
    }));
    set.fields.push_back(derived_field<std::uint8_t>(
        "burnt", "1", "0 for explosive that waits for its detonation", count,
        [&particles](std::size_t i) { return static_cast<std::uint8_t>(particles[i].tag & particle_tag::unburnt ? 0 : 1); }));
    return set;
}

namespace {

/// A field of the particles' own records; the first restored one sizes them.
template <class T, class Get, class Set>
Field particle_field(Gas& gas, std::string name, std::string unit, Get get, Set put)
{
    Field field = derived_field<T>(std::move(name), std::move(unit), "particle state", gas.particles.size(),
                                   [&gas, get](std::size_t i) { return get(gas.particles[i]); });
    field.restore = [&gas, put](const void* values, std::size_t count) {
        gas.particles.resize(count);
        const T* first = static_cast<const T*>(values);
        for (std::size_t i = 0; i < count; ++i) put(gas.particles[i], first[i]);
    };
    return field;
}

/// A field of a few numbers kept in place.
Field array_field(std::string name, std::string unit, std::string meaning, double* values, std::size_t count)
{
    Field field =
        derived_field<double>(std::move(name), std::move(unit), std::move(meaning), count, [values](std::size_t i) { return values[i]; });
    field.restore = [values](const void* saved, std::size_t saved_count) {
        const double* first = static_cast<const double*>(saved);
        std::copy(first, first + saved_count, values);
    };
    return field;
}

static_assert(sizeof(Passage) == 5 * sizeof(double));

/// The buckets of the last sort: the order within a cell is that of the past, so the next sort must begin where it left off. Their depths
/// say where they are, for they fill the domain in the order of the curve.
void add_buckets(FieldSet& set, Cells& cells, const Box& box)
{
    const std::size_t count = cells.buckets.size();
    Field depth = derived_field<std::uint32_t>("bucket_depth", "1", "how often the domain was halved", count,
                                               [&cells](std::size_t b) { return cells.buckets[b].depth; });
    depth.restore = [&cells, box](const void* values, std::size_t saved) {
        cells.curve = CellCurve(box);
        cells.buckets.assign(saved, {});
        std::uint64_t key = 0;
        for (std::size_t b = 0; b < saved; ++b) {
            cells.buckets[b].depth = static_cast<const std::uint32_t*>(values)[b];
            cells.buckets[b].start_key = key;
            key += CellCurve::keys_of(static_cast<int>(cells.buckets[b].depth));
        }
    };
    Field first = derived_field<std::uint32_t>("bucket_first", "1", "first particle", count,
                                               [&cells](std::size_t b) { return cells.buckets[b].first; });
    first.restore = [&cells](const void* values, std::size_t saved) {
        for (std::size_t b = 0; b < saved; ++b) cells.buckets[b].first = static_cast<const std::uint32_t*>(values)[b];
    };
    set.fields.push_back(std::move(depth));
    set.fields.push_back(std::move(first));
}

}  // namespace

FieldSet state(Gas& gas)
{
    FieldSet set{"gas", {}};
    const auto add = [&](Field field) { set.fields.push_back(std::move(field)); };
    add(particle_field<Vector3f>(
        gas, "position", "m", [](const Particle& p) { return p.position; }, [](Particle& p, const Vector3f& v) { p.position = v; }));
    add(particle_field<Vector3f>(
        gas, "velocity", "m/s", [](const Particle& p) { return p.velocity; }, [](Particle& p, const Vector3f& v) { p.velocity = v; }));
    add(particle_field<float>(gas, "energy", "J", [](const Particle& p) { return p.energy; }, [](Particle& p, float v) { p.energy = v; }));
    add(particle_field<std::uint32_t>(
        gas, "tag", "1", [](const Particle& p) { return p.tag; }, [](Particle& p, std::uint32_t v) { p.tag = v; }));
    set.fields.push_back(
        array_field("inflow_debt", "1", "particles owed by ambient edges", gas.inflow_debt.data(), gas.inflow_debt.size()));
    set.fields.push_back(
        array_field("passages", "SI", "mass, momentum and energy given to each face", &gas.passages.face[0].mass, 5 * face_count));
    set.fields.push_back(
        array_field("passage_squares", "N2 s2", "squared impulses of bounces off each face", gas.passages.squares.data(), face_count));
    const Field tags = set.fields[3];
    set.fields[3].restore = [&gas, tags](const void* values, std::size_t count) {
        tags.restore(values, count);
        for (Charge& charge : gas.charges) charge.unburnt = 0;
        for (const Particle& particle : gas.particles) {
            if (particle.tag & particle_tag::unburnt) ++gas.charges[particle_tag::charge(particle.tag)].unburnt;
        }
    };
    add_buckets(set, gas.cells, gas.domain.box);
    add_sleep_state(set, gas);
    return set;
}

}  // namespace corpuscle
