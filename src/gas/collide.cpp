#include "gas/collide.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include "gas/faces.hpp"
#include "gas/hard_spheres.hpp"
#include "laws/collision/hard_sphere.hpp"
#include "laws/collision/larsen_borgnakke.hpp"
#include "laws/collision/virial.hpp"
#include "math/random.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

constexpr std::size_t groups_per_chunk = 64;

/// Where the virial pressure is more than this part of the kinetic one, a group collides as one cell: in cells of few particles
/// the law's convexity would turn the fluctuations of density into a false pressure.
constexpr float stiff_ratio = 0.1f;
/// Below this part it is left out.
constexpr float negligible_ratio = 1e-4f;

/// How much the virial pressure of a group matters.
enum class Virial { none, slight, stiff };

/// What of a species the collisions need, in the kernel's precision.
struct SpeciesView {
    float mass;
    LarsenBorgnakke exchange;
    float stretch;  ///< of |g' - g| for what one particle's exchanges do to it
    const EquationOfState* law;
    bool virial;  ///< whether the law has any virial pressure
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
    float kinetic_pressure = 0;  ///< [Pa]
    float virial_pressure = 0;   ///< [Pa]
    float thermal_speed = 0;     ///< root mean square [m/s]
    float fastest_pair = 0;      ///< no pair is faster [m/s]
    float pair_energy = 0;       ///< mean of mu g^2, stretched, over pairs [J]

    [[nodiscard]] float spacing() const { return std::cbrt(volume / particles); }
    [[nodiscard]] float enskog() const { return kinetic_pressure > 0 ? 1 + virial_pressure / kinetic_pressure : 1; }
};

/// Space that a thread works in.
struct Workspace {
    std::vector<Particle*> active;   ///< of a cell: all but explosive that waits
    std::vector<SpeciesSums> sums;   ///< of a cell
    std::vector<float> group_count;  ///< particles of each species in the group
    std::vector<float> density;      ///< of each species in the group [kg/m3]
    Virial virial = Virial::none;    ///< of the group

    explicit Workspace(std::size_t species) : sums(species), group_count(species), density(species) {}
};

/// What a chunk of groups leaves behind.
struct Tally {
    FacePassages passages;
    std::vector<Displacement> displaced;
    double step_limit = std::numeric_limits<double>::infinity();
    std::uint64_t collisions = 0;

    Tally& operator+=(const Tally& other)
    {
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
        for (const Species& species : gas.species) {
            const double rate = 1 / gas.settings.relaxation;
            species_.push_back({static_cast<float>(species.particle_mass), LarsenBorgnakke(species.internal_freedoms),
                                static_cast<float>(rate * (exchange_stretch(species.internal_freedoms) - 1)), &species.law,
                                !std::holds_alternative<IdealGas>(species.law)});
        }
        has_virial_ = std::any_of(species_.begin(), species_.end(), [](const SpeciesView& s) { return s.virial; });
    }

    /// Collides the cells of groups [begin, end).
    Tally operator()(std::size_t begin, std::size_t end) const
    {
        Tally tally;
        Workspace work(species_.size());
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
    }

    /// Measures a group's densities and how much their virial pressure matters beside the kinetic one.
    void judge_virial(const Cell& group, Workspace& work) const
    {
        measure_densities(group, work);
        bool any = false;
        for (std::size_t s = 0; s < species_.size(); ++s) any = any || (species_[s].virial && work.group_count[s] > 1);
        if (!any || !gather(group, work)) return;
        work.virial = Virial::slight;
        const CellState state = measure(work.active, volume_of(group, work), work);
        const float ratio = state.enskog() - 1;
        work.virial = ratio > stiff_ratio ? Virial::stiff : ratio > negligible_ratio ? Virial::slight : Virial::none;
    }

    /// Lists what can collide in a cell; false if nothing can.
    bool gather(const Cell& cell, Workspace& work) const
    {
        work.active.clear();
        for (std::uint32_t i = cell.first; i < cell.end(); ++i) {
            if (!(gas_.particles[i].tag & particle_tag::unburnt)) work.active.push_back(&gas_.particles[i]);
        }
        return work.active.size() >= 2;
    }

    /// Volume that the listed particles of a cell fill, explosive that waits taking its share [m3].
    float volume_of(const Cell& cell, const Workspace& work) const
    {
        const double share = static_cast<double>(work.active.size()) / cell.count;
        return static_cast<float>(gas_.cells.curve.volume(static_cast<int>(cell.depth)) * share);
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
        if (!gather(cell, work)) return 0;
        const CellState state = measure(work.active, volume_of(cell, work), work);
        if (!(state.thermal_speed > 0)) return 0;
        if (duration_ > 0) draw_pairs(cell, work.active, state, tally);
        return 1.8f * state.thermal_speed * std::sqrt(state.enskog()) / state.spacing();
    }

    /// Moments of a cell's particles and the pressures that follow.
    CellState measure(const std::vector<Particle*>& active, float volume, Workspace& work) const
    {
        CellState state;
        std::vector<SpeciesSums>& sums = work.sums;
        state.particles = static_cast<float>(active.size());
        state.volume = volume;
        float mass = 0;
        Vector3f momentum;
        for (const Particle* p : active) {
            const float m = species_[particle_tag::species(p->tag)].mass;
            mass += m;
            momentum += m * p->velocity;
        }
        const Vector3f mean = momentum / mass;

        std::fill(sums.begin(), sums.end(), SpeciesSums{});
        float fastest = 0, second = 0;  // squared speeds
        for (const Particle* p : active) {
            const Vector3f c = p->velocity - mean;
            const float squared = norm_squared(c);
            SpeciesSums& own = sums[particle_tag::species(p->tag)];
            own.count += 1;
            own.velocity += c;
            own.velocity_squared += squared;
            second = std::max(second, std::min(squared, fastest));
            fastest = std::max(fastest, squared);
        }
        state.fastest_pair = std::sqrt(fastest) + std::sqrt(second);

        // Of n particles seen from their own mean, n - 1 are free to move.
        const float bias = state.particles / (state.particles - 1);
        float energy_twice = 0;
        for (std::size_t s = 0; s < sums.size(); ++s) energy_twice += species_[s].mass * sums[s].velocity_squared;
        state.kinetic_pressure = bias * energy_twice / (3 * volume);
        state.thermal_speed = std::sqrt(bias * energy_twice / mass);
        if (work.virial != Virial::none) add_virial(state, work);
        return state;
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
            if (view.virial)
                state.virial_pressure += std::visit(
                    [&](const auto& law) { return mean_virial_pressure(law, work.density[s], kinetic, work.group_count[s]); }, *view.law);
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
    void draw_pairs(const Cell& cell, const std::vector<Particle*>& active, const CellState& state, Tally& tally) const
    {
        const float path = static_cast<float>(gas_.settings.mean_free_path) * state.spacing() / state.enskog();
        const float wanted = candidate_pairs(state.particles, state.fastest_pair, duration_, path);
        const float candidates = std::min(wanted, 2 * state.particles);
        float length = 0;
        if (state.virial_pressure != 0) {
            const float rate = candidates / state.fastest_pair;
            const float meetings = 2 * rate * mean_relative_speed(state.thermal_speed) / state.particles;
            const float changes = rate * (4.0f / 3.0f) * state.pair_energy * surviving_displacement(meetings);
            length = displacement_length(state.virial_pressure, state.volume, duration_, changes);
        }
        Random random(gas_.settings.seed, Purpose::collide, clock_.step(), cell.first);
        const bool near_wall = walls_ && is_near_wall(cell);
        const auto count = static_cast<std::uint32_t>(active.size());
        auto left = static_cast<std::uint32_t>(candidates + random.uniform());
        for (; left > 0; --left) {
            const std::uint32_t word = random.word();
            const std::uint32_t i = ((word >> 16) * count) >> 16;
            std::uint32_t j = ((word & 0xFFFFu) * (count - 1)) >> 16;
            j += j >= i;
            Particle &a = *active[i], &b = *active[j];
            const Vector3f relative = a.velocity - b.velocity;
            const float speed = norm(relative);
            if (random.uniform() * state.fastest_pair >= speed) continue;
            if (near_wall && walls_->separates(Vector3d(a.position), Vector3d(b.position))) continue;
            const Vector3f change = scatter(a, b, relative, speed, random);
            ++tally.collisions;
            if (length != 0) displace(a, b, change, length, tally);
        }
    }

    /// Whether a facet may stand between particles of the cell.
    bool is_near_wall(const Cell& cell) const
    {
        const Vector3f middle(gas_.cells.curve.cell(gas_.cells.keys[cell.first], static_cast<int>(cell.depth)).center());
        return walls_->clearance(middle) <= gas_.cells.curve.radius(static_cast<int>(cell.depth));
    }

    /// One collision: energy shared with the internal freedoms of those that exchange, then a new direction of the relative
    /// velocity. Returns the change of the relative velocity g' - g.
    Vector3f scatter(Particle& a, Particle& b, const Vector3f& relative, float speed, Random& random) const
    {
        const SpeciesView &of_a = species_[particle_tag::species(a.tag)], &of_b = species_[particle_tag::species(b.tag)];
        const float mass = of_a.mass + of_b.mass;
        const float share_a = of_a.mass / mass, share_b = of_b.mass / mass;
        const float reduced = of_a.mass * share_b;
        const std::uint32_t word = random.word();
        float energy = 0.5f * reduced * speed * speed;
        const float before = energy;
        if (of_a.exchange.exchanges() && (word >> 16) < exchange_threshold_) exchange(a, of_a.exchange, energy, random);
        if (of_b.exchange.exchanges() && (word & 0xFFFFu) < exchange_threshold_) exchange(b, of_b.exchange, energy, random);
        const float new_speed = energy == before ? speed : std::sqrt(2 * energy / reduced);
        const Vector3f mean = share_a * a.velocity + share_b * b.velocity;
        const Vector3f new_relative = new_speed * random.direction();
        a.velocity = mean + share_b * new_relative;
        b.velocity = mean - share_a * new_relative;
        return new_relative - relative;
    }

    /// Shares `energy`, the pair's relative motion, with the particle's internal energy.
    static void exchange(Particle& particle, const LarsenBorgnakke& law, float& energy, Random& random)
    {
        const float pool = energy + particle.energy;
        const float first = random.uniform();
        particle.energy = pool * law.internal_share(first, random.uniform());
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
    std::vector<SpeciesView> species_;
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
