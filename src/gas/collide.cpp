#include "gas/collide.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>

#include "gas/dice.hpp"
#include "gas/faces.hpp"
#include "gas/hard_spheres.hpp"
#include "gas/sleep.hpp"
#include "laws/collision/hard_sphere.hpp"
#include "laws/collision/larsen_borgnakke.hpp"
#include "laws/collision/virial.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

constexpr std::size_t groups_per_chunk = 64;

/// n^(-1/3).
float inverse_cube_root(std::uint32_t n)
{
    static const auto table = [] {
        std::array<float, 128> values{};
        for (std::size_t k = 1; k < values.size(); ++k) values[k] = static_cast<float>(1 / std::cbrt(static_cast<double>(k)));
        return values;
    }();
    return n < table.size() ? table[n] : 1 / std::cbrt(static_cast<float>(n));
}

/// Where the virial pressure is more than this part of the kinetic one, a group collides as one cell: in cells of few particles
/// the law's convexity would turn the fluctuations of density into a false pressure.
constexpr float stiff_ratio = 0.1f;
/// Below this part it is left out.
constexpr float negligible_ratio = 1e-4f;

/// More collisions of a particle in a step, in the mean, would only cost: its velocity is forgotten already.
constexpr float most_collisions = 2;

/// How much the virial pressure of a group matters.
enum class Virial { none, slight, stiff };

/// What of a species the collisions need, in the kernel's precision.
struct SpeciesView {
    float mass;
    float stretch;  ///< of |g' - g| for what one particle's exchanges do to it
    const EquationOfState* law;
    bool virial;     ///< whether the law has any virial pressure
    bool exchanges;  ///< whether there is internal energy
};

/// What a pair's collision needs of the masses of two species.
struct PairView {
    float share_a, share_b;  ///< of the pair's mass
    float reduced;           ///< mass [kg]
};

/// The smaller share is what the larger leaves, without rounding: shares that do not add up to one would scale each pair's energy.
PairView pair_view(float mass_a, float mass_b)
{
    const float larger = std::max(mass_a, mass_b) / (mass_a + mass_b), smaller = 1 - larger;
    const float reduced = larger * std::min(mass_a, mass_b);
    return {mass_a >= mass_b ? larger : smaller, mass_a >= mass_b ? smaller : larger, reduced};
}

/// The particles of a cell that can collide: all but explosive that waits.
struct Members {
    Particle* first;             ///< of the cell
    const std::uint32_t* index;  ///< of each, from the cell's first
    std::uint32_t count;

    [[nodiscard]] Particle& operator[](std::uint32_t k) const { return first[index[k]]; }
};

/// Sums of one species in a cell; velocities relative to the cell's mean.
struct SpeciesSums {
    float count = 0;
    Vector3f velocity;
    float velocity_squared = 0;
};

/// What is known of a cell before its pairs are drawn.
struct CellState {
    float particles = 0;
    float volume = 0;            ///< [m3]
    float spacing = 0;           ///< (V/n)^(1/3) [m]
    float kinetic_pressure = 0;  ///< [Pa]
    float virial_pressure = 0;   ///< [Pa]
    float even_virial = 0;       ///< the same if its species shared the kinetic energy by their numbers [Pa]
    float thermal_speed = 0;     ///< root mean square [m/s]
    float fastest_pair = 0;      ///< no pair is faster [m/s]
    float pair_energy = 0;       ///< mean of mu g^2, stretched, over pairs [J]

    /// How much more often than in a thin gas its particles meet. From what collisions between species leave as it is: if the rate rose and
    /// fell with one species' energy, there would be no detailed balance, and energy would gather where it collides least.
    [[nodiscard]] float enskog() const { return kinetic_pressure > 0 ? 1 + even_virial / kinetic_pressure : 1; }
};

/// What a chunk of groups is worked on with.
struct Workspace {
    Dice dice;
    std::vector<std::uint32_t> everyone;  ///< 0, 1, 2, ...
    std::vector<std::uint32_t> active;    ///< members of a cell in which explosive waits
    std::vector<SpeciesSums> sums;        ///< of a cell
    std::vector<float> group_count;       ///< particles of each species in the group
    std::vector<float> density;           ///< of each species in the group [kg/m3]
    Virial virial = Virial::none;         ///< of the group
};

/// What a chunk of groups leaves behind.
struct Tally {
    FacePassages passages;
    std::vector<Displacement> displaced;
    double step_limit = std::numeric_limits<double>::infinity();
    std::uint64_t collisions = 0;
    std::vector<double> found;  ///< how far each disturbance was seen [m]

    Tally& operator+=(const Tally& other)
    {
        found.resize(std::max(found.size(), other.found.size()));
        for (std::size_t d = 0; d < other.found.size(); ++d) found[d] = std::max(found[d], other.found[d]);
        passages += other.passages;
        displaced.insert(displaced.end(), other.displaced.begin(), other.displaced.end());
        step_limit = std::min(step_limit, other.step_limit);
        collisions += other.collisions;
        return *this;
    }
};

/// The collisions of one step; a cell at a time.
class Collider {
public:
    Collider(Gas& gas, const Clock& clock, const FacetTree* walls)
        : gas_(gas), clock_(clock), walls_(walls), duration_(static_cast<float>(clock.duration()))
    {
        exchange_threshold_ = static_cast<std::uint32_t>(65536 / gas.settings.relaxation);
        const double rate = 1 / gas.settings.relaxation;
        for (const Species& species : gas.species) {
            exchanges_.emplace_back(species.internal_freedoms);
            species_.push_back({static_cast<float>(species.particle_mass),
                                static_cast<float>(rate * (exchange_stretch(species.internal_freedoms) - 1)), &species.law,
                                !std::holds_alternative<IdealGas>(species.law), exchanges_.back().exchanges()});
        }
        for (const SpeciesView& of_a : species_) {
            for (const SpeciesView& of_b : species_) pairs_.push_back(pair_view(of_a.mass, of_b.mass));
        }
        for (const Charge& charge : gas.charges) waiting_ = waiting_ || charge.unburnt > 0;
        has_virial_ = std::any_of(species_.begin(), species_.end(), [](const SpeciesView& s) { return s.virial; });
    }

    /// Collides the cells of groups [begin, end).
    Tally operator()(std::size_t begin, std::size_t end) const
    {
        Tally tally;
        const std::size_t kinds = species_.size();
        Workspace work{Dice(gas_.settings.seed, clock_.step(), begin, exchanges_),
                       std::vector<std::uint32_t>(gas_.settings.group_limit),
                       {},
                       std::vector<SpeciesSums>(kinds),
                       std::vector<float>(kinds),
                       std::vector<float>(kinds)};
        std::iota(work.everyone.begin(), work.everyone.end(), 0u);
        const auto& cells = gas_.cells.cells;
        const std::uint32_t first = gas_.cells.groups[begin].first;
        auto cell = std::lower_bound(cells.begin(), cells.end(), first, [](const Cell& c, std::uint32_t i) { return c.first < i; });
        for (std::size_t g = begin; g < end; ++g) {
            const auto from = cell;
            while (cell != cells.end() && cell->first < gas_.cells.groups[g].end()) ++cell;
            collide_group(gas_.cells.groups[g], {from, cell}, work, tally);
        }
        return tally;
    }

private:
    /// Collides a group: as one cell if its gas is stiff, else cell by cell.
    void collide_group(const Cell& group, std::span<const Cell> cells, Workspace& work, Tally& tally) const
    {
        work.virial = Virial::none;
        if (has_virial_) judge_virial(group, work);
        if (work.virial == Virial::stiff) cells = {&group, 1};
        float rate = 0, moving = 0;
        for (const Cell& cell : cells) {
            const float own = collide_cell(cell, work, tally);
            rate += own;
            moving += own > 0 ? 1.0f : 0.0f;
        }
        if (rate > 0) tally.step_limit = std::min(tally.step_limit, static_cast<double>(moving / rate));
        if (gas_.sleeping.any()) look_for_disturbance(group, tally);
    }

    /// Notes where gas moves faster than undisturbed gas does.
    void look_for_disturbance(const Cell& group, Tally& tally) const
    {
        float energy = 0;
        for (std::uint32_t i = group.first; i < group.end(); ++i) {
            const Particle& particle = gas_.particles[i];
            energy += 0.5f * mass_of(particle) * norm_squared(particle.velocity);
        }
        const double volume = gas_.cells.curve.volume(static_cast<int>(group.depth));
        note_disturbance(gas_, Vector3d(gas_.particles[group.first].position), static_cast<double>(energy) / volume, tally.found);
    }

    /// Measures a group's densities and how much their virial pressure matters beside the kinetic one.
    void judge_virial(const Cell& group, Workspace& work) const
    {
        measure_densities(group, work);
        bool any = false;
        for (std::size_t s = 0; s < species_.size(); ++s) any = any || (species_[s].virial && work.group_count[s] > 1);
        if (!any) return;
        const Members members = gather(group, work);
        if (members.count < 2) return;
        work.virial = Virial::slight;
        const CellState state = measure(group, members, work);
        const float ratio = state.enskog() - 1;
        work.virial = ratio > stiff_ratio ? Virial::stiff : ratio > negligible_ratio ? Virial::slight : Virial::none;
    }

    /// What can collide in a cell.
    Members gather(const Cell& cell, Workspace& work) const
    {
        Particle* const first = &gas_.particles[cell.first];
        if (!waiting_) {
            if (work.everyone.size() < cell.count) {
                work.everyone.resize(cell.count);
                std::iota(work.everyone.begin(), work.everyone.end(), 0u);
            }
            return {first, work.everyone.data(), cell.count};
        }
        work.active.clear();
        for (std::uint32_t k = 0; k < cell.count; ++k) {
            if (!(first[k].tag & particle_tag::unburnt)) work.active.push_back(k);
        }
        return {first, work.active.data(), static_cast<std::uint32_t>(work.active.size())};
    }

    /// Counts and partial densities of the species in a group, explosive that waits included: it fills its space.
    void measure_densities(const Cell& group, Workspace& work) const
    {
        std::fill(work.group_count.begin(), work.group_count.end(), 0.0f);
        for (std::uint32_t i = group.first; i < group.end(); ++i) work.group_count[particle_tag::species(gas_.particles[i].tag)] += 1;
        const auto inverse_volume = static_cast<float>(1 / gas_.cells.curve.volume(static_cast<int>(group.depth)));
        for (std::size_t s = 0; s < species_.size(); ++s) work.density[s] = work.group_count[s] * species_[s].mass * inverse_volume;
    }

    /// Collides one cell. Returns how often per second a thermal particle crosses the local spacing, 0 if nothing moves [1/s].
    float collide_cell(const Cell& cell, Workspace& work, Tally& tally) const
    {
        const Members members = gather(cell, work);
        if (members.count < 2) return 0;
        const CellState state = measure(cell, members, work);
        if (!(state.thermal_speed > 0)) return 0;
        if (duration_ > 0) draw_pairs(cell, members, state, work.dice, tally);
        return 1.8f * state.thermal_speed * std::sqrt(state.enskog()) / state.spacing;
    }

    /// Moments of a cell's members and the pressures that follow. Explosive that waits takes its share of the cell's volume.
    CellState measure(const Cell& cell, const Members& members, Workspace& work) const
    {
        CellState state;
        const auto depth = static_cast<int>(cell.depth);
        state.particles = static_cast<float>(members.count);
        state.volume = static_cast<float>(gas_.cells.curve.volume(depth)) * (state.particles / static_cast<float>(cell.count));
        state.spacing = gas_.cells.curve.side(depth) * inverse_cube_root(cell.count);
        float mass = 0;
        Vector3f momentum;
        for (std::uint32_t k = 0; k < members.count; ++k) {
            const float m = mass_of(members[k]);
            mass += m;
            momentum += m * members[k].velocity;
        }
        const Vector3f mean = momentum / mass;

        float fastest = 0, second = 0, energy_twice = 0;  // squared speeds; sum of m c^2
        for (std::uint32_t k = 0; k < members.count; ++k) {
            const float squared = norm_squared(members[k].velocity - mean);
            energy_twice += mass_of(members[k]) * squared;
            const float lesser = squared < fastest ? squared : fastest;
            second = lesser > second ? lesser : second;
            fastest = squared > fastest ? squared : fastest;
        }
        state.fastest_pair = std::sqrt(fastest) + std::sqrt(second);

        // Of n particles seen from their own mean, n - 1 are free to move.
        const float bias = state.particles / (state.particles - 1);
        state.kinetic_pressure = bias * energy_twice / (3 * state.volume);
        state.thermal_speed = std::sqrt(bias * energy_twice / mass);
        if (work.virial != Virial::none) {
            sum_species(members, mean, work);
            add_virial(state, work);
        }
        return state;
    }

    [[nodiscard]] float mass_of(const Particle& particle) const { return species_[particle_tag::species(particle.tag)].mass; }

    /// Sums of each species of a cell whose particles move at `mean` together.
    void sum_species(const Members& members, const Vector3f& mean, Workspace& work) const
    {
        std::fill(work.sums.begin(), work.sums.end(), SpeciesSums{});
        for (std::uint32_t k = 0; k < members.count; ++k) {
            const Vector3f c = members[k].velocity - mean;
            SpeciesSums& own = work.sums[particle_tag::species(members[k].tag)];
            own.count += 1;
            own.velocity += c;
            own.velocity_squared += norm_squared(c);
        }
    }

    /// Virial pressure of the cell's species, each by its own law and partial density, and the pairs' mean energy.
    void add_virial(CellState& state, const Workspace& work) const
    {
        const std::vector<SpeciesSums>& sums = work.sums;
        const float bias = state.particles / (state.particles - 1);
        float energy = 0;
        for (std::size_t s = 0; s < sums.size(); ++s) {
            const SpeciesSums& own = sums[s];
            if (own.count == 0) continue;
            const SpeciesView& view = species_[s];
            const float kinetic = bias * view.mass * own.velocity_squared / (3 * state.volume);
            if (view.virial) {
                const auto virial = [&](float own_kinetic) {
                    return std::visit(
                        [&](const auto& law) { return mean_virial_pressure(law, work.density[s], own_kinetic, work.group_count[s]); },
                        *view.law);
                };
                const float own_virial = virial(kinetic), share = own.count / state.particles;
                state.virial_pressure += own_virial;
                state.even_virial += share < 1 ? virial(share * state.kinetic_pressure) : own_virial;
            }
            energy += 0.5f * view.mass * (own.count * own.velocity_squared - norm_squared(own.velocity)) * (1 + 2 * view.stretch);
            for (std::size_t t = 0; t < s; ++t) {
                const SpeciesSums& other = sums[t];
                if (other.count == 0) continue;
                const float reduced = view.mass * species_[t].mass / (view.mass + species_[t].mass);
                energy +=
                    reduced *
                    (own.count * other.velocity_squared + other.count * own.velocity_squared - 2 * dot(own.velocity, other.velocity)) *
                    (1 + view.stretch + species_[t].stretch);
            }
        }
        state.pair_energy = energy / (0.5f * state.particles * (state.particles - 1));
    }

    /// Draws candidate pairs and collides those that are accepted.
    void draw_pairs(const Cell& cell, const Members& members, const CellState& state, Dice& dice, Tally& tally) const
    {
        const float candidates = candidate_pairs(state.particles, state.fastest_pair, duration_, mean_free_path(state));
        float length = 0;
        if (state.virial_pressure != 0) {
            const float rate = candidates / state.fastest_pair;
            const float meetings = 2 * rate * mean_relative_speed(state.thermal_speed) / state.particles;
            const float changes = rate * (4.0f / 3.0f) * state.pair_energy * surviving_displacement(meetings);
            length = displacement_length(state.virial_pressure, state.volume, duration_, changes);
        }
        const bool near_wall = walls_ && is_near_wall(cell);
        const float scale = state.fastest_pair * state.fastest_pair;
        // Where displacements carry much of the pressure, near partners would make too much of it: JWL at V = 1 had 5 % more.
        const std::uint32_t partners = state.enskog() > 1 + stiff_ratio ? 1 : gas_.settings.partners;
        for (auto left = static_cast<std::uint32_t>(candidates + unit_float(dice.word())); left > 0; --left) {
            const std::uint32_t word = dice.word();
            const std::uint32_t i = ((word >> 16) * members.count) >> 16;
            Particle &a = members[i], &b = members[draw_partner(members, i, word & 0xFFFFu, partners, dice)];
            const Vector3f relative = a.velocity - b.velocity;
            const float speed_squared = norm_squared(relative), bar = unit_float(dice.word());
            if (bar * bar * scale >= speed_squared) continue;
            if (near_wall && walls_->separates(Vector3d(a.position), Vector3d(b.position))) continue;
            const Vector3f change = scatter(a, b, relative, speed_squared, dice);
            ++tally.collisions;
            if (length != 0) displace(a, b, change, length, tally);
        }
    }

    /// A partner for member `i`, by 16 random bits: any other member, or the nearest of several. Where they are says nothing of how they
    /// move.
    static std::uint32_t draw_partner(const Members& members, std::uint32_t i, std::uint32_t bits, std::uint32_t partners, Dice& dice)
    {
        const auto other = [&](std::uint32_t random) {
            const std::uint32_t j = (random * (members.count - 1)) >> 16;
            return j + (j >= i);
        };
        std::uint32_t best = other(bits);
        if (partners == 1) return best;
        float least = norm_squared(members[best].position - members[i].position);
        for (std::uint32_t drawn = 1; drawn < partners; ++drawn) {
            const std::uint32_t j = other(dice.word() >> 16);
            const float way = norm_squared(members[j].position - members[i].position);
            if (way < least) best = j;
            least = std::min(least, way);
        }
        return best;
    }

    /// Mean free path in a cell [m]. A dense gas keeps at least one spacing over 1 + p_v/p_k: with more collisions in a step than that the
    /// displacements would no longer add up to the virial pressure.
    float mean_free_path(const CellState& state) const
    {
        // A limit on the candidates themselves would let the fastest pair, which collisions change, set the rate: no detailed balance.
        const float shortest = mean_relative_speed(state.thermal_speed) * duration_ / (std::numbers::sqrt2_v<float> * most_collisions);
        return std::max(shortest, wanted_path(state));
    }

    float wanted_path(const CellState& state) const
    {
        const auto cross_section = static_cast<float>(gas_.settings.cross_section);
        if (cross_section > 0) return state.volume / (std::numbers::sqrt2_v<float> * state.particles * cross_section * state.enskog());
        const auto thin = static_cast<float>(gas_.settings.mean_free_path);
        const float dense = std::min(1.0f, (state.enskog() - 1) / stiff_ratio);
        return (thin + std::max(0.0f, 1 - thin) * dense) * state.spacing / state.enskog();
    }

    /// Whether a facet may stand between particles of the cell.
    bool is_near_wall(const Cell& cell) const
    {
        const std::uint64_t key = gas_.cells.curve.key(gas_.particles[cell.first].position);
        const Vector3f middle(gas_.cells.curve.cell(key, static_cast<int>(cell.depth)).center());
        return walls_->clearance(middle) <= gas_.cells.curve.radius(static_cast<int>(cell.depth));
    }

    /// One collision: energy shared with the internal freedoms of those that exchange, then a new direction of the relative
    /// velocity. Returns the change of the relative velocity g' - g.
    Vector3f scatter(Particle& a, Particle& b, const Vector3f& relative, float speed_squared, Dice& dice) const
    {
        const std::uint32_t kind_a = particle_tag::species(a.tag), kind_b = particle_tag::species(b.tag);
        const PairView& pair = pairs_[kind_a * species_.size() + kind_b];
        const std::uint32_t word = dice.word();
        const bool exchange_a = (word >> 16) < exchange_threshold_ && species_[kind_a].exchanges;
        const bool exchange_b = (word & 0xFFFFu) < exchange_threshold_ && species_[kind_b].exchanges;
        if (exchange_a || exchange_b) {
            float energy = 0.5f * pair.reduced * speed_squared;
            if (exchange_a) exchange(a, dice.internal_share(kind_a), energy);
            if (exchange_b) exchange(b, dice.internal_share(kind_b), energy);
            speed_squared = 2 * energy / pair.reduced;  // not times a rounded inverse: that would scale the energy of every exchange alike
        }
        const Vector3f mean = pair.share_a * a.velocity + pair.share_b * b.velocity;
        const Vector3f new_relative = std::sqrt(speed_squared) * dice.direction();
        a.velocity = mean + pair.share_b * new_relative;
        b.velocity = mean - pair.share_a * new_relative;
        return new_relative - relative;
    }

    /// Shares `energy`, the pair's relative motion, with the particle's internal energy, which gets `share` of both.
    static void exchange(Particle& particle, float share, float& energy)
    {
        const float pool = energy + particle.energy;
        particle.energy = pool * share;
        energy = pool - particle.energy;
    }

    /// Moves the pair apart along the change of its relative velocity, its centre of mass staying.
    void displace(Particle& a, Particle& b, const Vector3f& change, float length, Tally& tally) const
    {
        const float size = norm(change);
        if (!(size > 0)) return;
        const float mass_a = species_[particle_tag::species(a.tag)].mass, mass_b = species_[particle_tag::species(b.tag)].mass;
        const Vector3f path = (length / (size * (mass_a + mass_b))) * change;
        move(a, mass_b * path, tally);
        move(b, -(mass_a * path), tally);
    }

    /// Displaces one particle at once if no facet can be met, else leaves it to the flight.
    void move(Particle& particle, const Vector3f& path, Tally& tally) const
    {
        if (walls_ && walls_->clearance(particle.position) <= norm(path)) {
            tally.displaced.push_back({static_cast<std::uint32_t>(&particle - gas_.particles.data()), path});
            return;
        }
        particle.position += path;
        mirror_at_rigid_faces(gas_, particle, tally.passages);
    }

    Gas& gas_;
    const Clock& clock_;
    const FacetTree* walls_;
    float duration_;
    std::uint32_t exchange_threshold_ = 0;
    bool has_virial_ = false;
    bool waiting_ = false;  ///< some explosive waits
    std::vector<LarsenBorgnakke> exchanges_;
    std::vector<SpeciesView> species_;
    std::vector<PairView> pairs_;  ///< by species of the one times the number of species plus that of the other
};

void run(Gas& gas, const Clock& clock, const FacetTree* walls)
{
    const Collider collider(gas, clock, walls);
    Tally tally = sum_chunks<Tally>(
        gas.cells.groups.size(), [&](std::size_t begin, std::size_t end) { return collider(begin, end); }, groups_per_chunk);
    gas.passages += tally.passages;
    gas.displaced = std::move(tally.displaced);
    gas.step_limit = gas.settings.cfl * tally.step_limit;
    gas.collisions += tally.collisions;
    gas.sleeping.found = std::move(tally.found);
}

}  // namespace

void collide(Gas& gas, const Clock& clock, const FacetTree& walls)
{
    if (gas.settings.rule == CollisionRule::hard_spheres) return collide_hard_spheres(gas, clock, walls);
    run(gas, clock, walls.size() == 0 ? nullptr : &walls);
}

void survey(Gas& gas)
{
    if (gas.settings.rule == CollisionRule::hard_spheres) return survey_hard_spheres(gas);
    run(gas, Clock{}, nullptr);
}

double stable_step(const Gas& gas, double time)
{
    double step = gas.step_limit > 0 ? gas.step_limit : std::numeric_limits<double>::infinity();
    for (const Charge& charge : gas.charges) {
        if (charge.unburnt == 0 || charge.first_time() > time + step) continue;
        const Species& species = gas.species[charge.species];
        const double thermal = std::sqrt(2 * translational_share(heat_capacity_ratio(species.law)) * charge.energy_per_mass);
        const double kinetic = charge.density * thermal * thermal / 3;
        const double enskog = 1 + std::max(0.0, virial_pressure(species.law, charge.density, kinetic)) / kinetic;
        step = std::min(step, gas.settings.cfl * std::cbrt(species.particle_mass / charge.density) / (1.8 * thermal * std::sqrt(enskog)));
    }
    return step;
}

}  // namespace corpuscle
