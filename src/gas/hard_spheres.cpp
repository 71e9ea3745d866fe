#include "gas/hard_spheres.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include <fmt/format.h>

#include "base/error.hpp"
#include "gas/faces.hpp"
#include "gas/sphere_grid.hpp"
#include "laws/collision/hard_spheres.hpp"
#include "math/random.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

constexpr std::uint32_t meeting_limit = 1000;  ///< meetings of a sphere in a step; what comes after is left to the next step
constexpr std::size_t sphere_groups_per_chunk = 64;
constexpr std::size_t spheres_per_chunk = 1024;

bool takes_part(const Particle& particle)
{
    return !(particle.tag & (particle_tag::unburnt | particle_tag::gone));
}

/// Two spheres that touch if nothing comes between, and how often each had met others when that was foreseen.
struct Meeting {
    double time = 0;  ///< after the start of the step [s]
    std::uint32_t first = 0, second = 0;
    std::uint32_t met_first = 0, met_second = 0;

    /// For a heap whose top is the earliest; of equal times the lower particles.
    [[nodiscard]] bool later_than(const Meeting& other) const
    {
        if (time != other.time) return time > other.time;
        return first != other.first ? first > other.first : second > other.second;
    }
};
using Meetings = std::vector<Meeting>;

/// What a sphere's meetings in the step have done: it moves as if it had started `shift` from its place with its present velocity.
struct Course {
    Vector3f shift;  ///< [m]
    std::uint32_t met = 0;
};

/// What the shifts of a chunk of particles leave behind.
struct Shifted {
    FacePassages passages;
    std::vector<Displacement> displaced;

    Shifted& operator+=(const Shifted& other)
    {
        passages += other.passages;
        displaced.insert(displaced.end(), other.displaced.begin(), other.displaced.end());
        return *this;
    }
};

/// Lists of meetings put end to end.
struct MeetingList {
    Meetings meetings;
    MeetingList& operator+=(const MeetingList& other)
    {
        meetings.insert(meetings.end(), other.meetings.begin(), other.meetings.end());
        return *this;
    }
};

/// The meetings of one step.
class SphereCollider {
public:
    SphereCollider(Gas& gas, const Clock& clock, const FacetTree* walls)
        : gas_(gas), clock_(clock), walls_(walls), duration_(clock.duration())
    {
        for (const Species& species : gas.species) {
            masses_.push_back(species.particle_mass);
            radii_.push_back(species.radius);
            exchanges_.emplace_back(species.internal_freedoms);
        }
    }

    /// Lets the spheres meet, in the order of time.
    void run()
    {
        list_spheres();
        courses_.resize(gas_.particles.size());
        heap_ = foresee_all();
        std::make_heap(heap_.begin(), heap_.end(), later);
        while (!heap_.empty()) {
            std::pop_heap(heap_.begin(), heap_.end(), later);
            const Meeting next = heap_.back();
            heap_.pop_back();
            if (courses_[next.first].met != next.met_first || courses_[next.second].met != next.met_second) continue;
            if (between(next)) continue;
            meet(next);
            foresee(next.first, next.time);
            foresee(next.second, next.time);
        }
        shift();
    }

private:
    static bool later(const Meeting& a, const Meeting& b) { return a.later_than(b); }

    [[nodiscard]] std::uint32_t species_of(std::uint32_t i) const { return particle_tag::species(gas_.particles[i].tag); }

    /// Where a sphere is at a time after the start of the step, if it meets nothing more [m].
    [[nodiscard]] Vector3d place(std::uint32_t i, double time) const
    {
        const Particle& particle = gas_.particles[i];
        return Vector3d(particle.position) + Vector3d(courses_[i].shift) + time * Vector3d(particle.velocity);
    }

    /// One grid a species.
    void list_spheres()
    {
        std::vector<std::vector<std::uint32_t>> members(gas_.species.size());
        for (std::uint32_t i = 0; i < gas_.particles.size(); ++i)
            if (takes_part(gas_.particles[i])) members[species_of(i)].push_back(i);
        const double everywhere = typical_spacing();
        for (std::uint32_t s = 0; s < gas_.species.size(); ++s) {
            const std::vector<std::uint32_t>& own = members[s];
            const double fastest = -minimum(own.size(), 0, [&](std::size_t k) { return -norm(gas_.particles[own[k]].velocity); });
            const double travel = duration_ * fastest * (1 + 1e-6);
            const double side = std::max(2 * (radii_[s] + travel), std::min(everywhere, spacing_of(own)));
            grids_.emplace_back(gas_, std::move(members[s]), travel, side);
        }
    }

    /// Spacing where most particles are: the mean over particles of that of their cell [m].
    [[nodiscard]] double typical_spacing() const
    {
        double total = 0;
        for (const Cell& cell : gas_.cells.cells)
            total += cell.count * std::cbrt(gas_.cells.curve.volume(static_cast<int>(cell.depth)) / cell.count);
        return total / static_cast<double>(gas_.particles.size());
    }

    /// Spacing of spheres spread evenly over the box they are in [m].
    [[nodiscard]] double spacing_of(const std::vector<std::uint32_t>& spheres) const
    {
        if (spheres.empty()) return 0;
        Box bounds;
        for (const std::uint32_t i : spheres) bounds.include(Vector3d(gas_.particles[i].position));
        return std::cbrt(bounds.volume() / static_cast<double>(spheres.size()));
    }

    /// The meetings that the courses at the start of the step lead to. A pair of unlike species is found by the one whose cubes are
    /// smaller in the other's grid; a pair of one species by its lower particle.
    [[nodiscard]] Meetings foresee_all() const
    {
        Meetings all;
        for (std::uint32_t a = 0; a < grids_.size(); ++a) {
            const std::vector<std::uint32_t>& own = grids_[a].particles();
            for (std::uint32_t b = 0; b < grids_.size(); ++b) {
                if (grids_[b].side() < grids_[a].side() || (grids_[b].side() == grids_[a].side() && b < a)) continue;
                MeetingList found = sum_chunks<MeetingList>(
                    own.size(),
                    [&](std::size_t begin, std::size_t end) {
                        MeetingList part;
                        for (std::size_t k = begin; k < end; ++k) foresee_with(own[k], b, 0, a == b, part.meetings);
                        return part;
                    },
                    spheres_per_chunk);
                all.insert(all.end(), found.meetings.begin(), found.meetings.end());
            }
        }
        return all;
    }

    /// Puts what a sphere comes to on its new course into the heap.
    void foresee(std::uint32_t i, double now)
    {
        if (courses_[i].met >= meeting_limit) return;
        Meetings found;
        for (std::uint32_t s = 0; s < grids_.size(); ++s) foresee_with(i, s, now, false, found);
        for (const Meeting& meeting : found) {
            heap_.push_back(meeting);
            std::push_heap(heap_.begin(), heap_.end(), later);
        }
    }

    /// Adds the meetings of a sphere with those of a species from `now` to the end of the step, or only with those after it.
    void foresee_with(std::uint32_t i, std::uint32_t other, double now, bool only_after, Meetings& found) const
    {
        const SphereGrid& grid = grids_[other];
        const double contact = radii_[species_of(i)] + radii_[other], reach = contact + grid.travel();
        const Vector3d start = place(i, now), velocity(gas_.particles[i].velocity), end = start + (duration_ - now) * velocity;
        Box path;
        path.include(start);
        path.include(end);
        path.grow(reach);
        grid.visit(path.lower, path.upper, [&](std::uint32_t j) {
            if (j == i || (only_after && j < i)) return;
            const Vector3d relative = Vector3d(gas_.particles[j].velocity) - velocity;
            const double time = now + meeting_time(place(j, now) - start, relative, contact);
            if (!(time < duration_)) return;
            const std::uint32_t first = std::min(i, j), second = std::max(i, j);
            found.push_back({time, first, second, courses_[first].met, courses_[second].met});
        });
    }

    /// Whether a face of the domain or a facet stands between two spheres where they start or where they meet.
    [[nodiscard]] bool between(const Meeting& meeting) const
    {
        const Vector3d a = place(meeting.first, meeting.time), b = place(meeting.second, meeting.time);
        if (gas_.domain.box.contains(a) != gas_.domain.box.contains(b)) return true;
        if (!walls_) return false;
        const Vector3f& from_a = gas_.particles[meeting.first].position;
        const Vector3d start_a(from_a), start_b(gas_.particles[meeting.second].position);
        if (walls_->clearance(from_a) > norm(start_b - start_a) + norm(a - start_a) + norm(b - start_a)) return false;
        return walls_->separates(start_a, start_b) || walls_->separates(a, b);
    }

    /// Bounces two spheres that touch: the impulse is along the line of centres, from their normal energy as it is or as it is shared.
    void meet(const Meeting& meeting)
    {
        const std::uint32_t i = meeting.first, j = meeting.second;
        Particle &a = gas_.particles[i], &b = gas_.particles[j];
        const std::uint32_t of_a = species_of(i), of_b = species_of(j);
        const Vector3d normal = normalized(place(j, meeting.time) - place(i, meeting.time));
        const double mass = masses_[of_a] + masses_[of_b], reduced = masses_[of_a] * masses_[of_b] / mass;
        const double approach = dot(Vector3d(a.velocity) - Vector3d(b.velocity), normal);
        double energy = 0.5 * reduced * approach * approach;
        const double before = energy;
        share_energy(a, b, energy);
        const double recede = energy == before ? approach : std::sqrt(2 * energy / reduced);
        const Vector3d change = (approach + recede) * normal;
        turn(i, -(masses_[of_b] / mass) * change, meeting.time);
        turn(j, (masses_[of_a] / mass) * change, meeting.time);
        ++gas_.collisions;
        ++met_;
    }

    /// Shares the pair's normal energy with the internal freedoms of those that exchange, in an order drawn at random, so that the
    /// whole is as reversible as each part.
    void share_energy(Particle& a, Particle& b, double& energy) const
    {
        const NormalExchange &of_a = exchanges_[particle_tag::species(a.tag)], &of_b = exchanges_[particle_tag::species(b.tag)];
        if (!of_a.exchanges() && !of_b.exchanges()) return;
        Random random(gas_.settings.seed, Purpose::collide, clock_.step(), met_);
        const bool a_shares = random.uniform() * gas_.settings.relaxation < 1 && of_a.exchanges();
        const bool b_shares = random.uniform() * gas_.settings.relaxation < 1 && of_b.exchanges();
        const bool b_first = random.word() >> 31;
        if (b_shares && b_first) share(b, of_b, energy, random);
        if (a_shares) share(a, of_a, energy, random);
        if (b_shares && !b_first) share(b, of_b, energy, random);
    }

    static void share(Particle& particle, const NormalExchange& law, double& energy, Random& random)
    {
        const double pool = energy + static_cast<double>(particle.energy);
        particle.energy = static_cast<float>(pool * law.internal_share(random.uniform_double()));
        energy = std::max(0.0, pool - static_cast<double>(particle.energy));
    }

    /// Gives a sphere a new velocity at a time of the step; its course bends where it is.
    void turn(std::uint32_t i, const Vector3d& change, double time)
    {
        Particle& particle = gas_.particles[i];
        const Vector3d old(particle.velocity);
        particle.velocity = Vector3f(old + change);
        courses_[i].shift += Vector3f(time * (old - Vector3d(particle.velocity)));
        ++courses_[i].met;
    }

    /// Moves those that have met to where their new courses start; where a facet may be met that is left to the flight.
    void shift()
    {
        Shifted shifted = sum_chunks<Shifted>(courses_.size(), [&](std::size_t begin, std::size_t end) {
            Shifted part;
            for (std::size_t i = begin; i < end; ++i) {
                const Vector3f& path = courses_[i].shift;
                if (path == Vector3f{}) continue;
                Particle& particle = gas_.particles[i];
                if (walls_ && walls_->clearance(particle.position) <= norm(path)) {
                    part.displaced.push_back({static_cast<std::uint32_t>(i), path});
                    continue;
                }
                particle.position += path;
                mirror_at_rigid_faces(gas_, particle, part.passages);
            }
            return part;
        });
        gas_.passages += shifted.passages;
        gas_.displaced = std::move(shifted.displaced);
    }

    Gas& gas_;
    const Clock& clock_;
    const FacetTree* walls_;
    double duration_;  ///< of the step [s]
    std::vector<double> masses_, radii_;
    std::vector<NormalExchange> exchanges_;
    std::vector<SphereGrid> grids_;
    std::vector<Course> courses_;
    Meetings heap_;
    std::uint64_t met_ = 0;  ///< meetings so far in this step
};

/// Sums over the spheres of a cell that take part.
struct CellSums {
    double count = 0, mass = 0, radius = 0, radius_squared = 0, radius_cubed = 0;
    Vector3d momentum, velocity;
    double energy_twice = 0, speed_squared = 0;
};

CellSums sum_cell(const Gas& gas, const Cell& cell)
{
    CellSums sums;
    for (std::uint32_t i = cell.first; i < cell.end(); ++i) {
        const Particle& particle = gas.particles[i];
        if (!takes_part(particle)) continue;
        const Species& species = gas.species[particle_tag::species(particle.tag)];
        const Vector3d velocity(particle.velocity);
        const double r = species.radius, squared = norm_squared(velocity);
        sums.count += 1;
        sums.mass += species.particle_mass;
        sums.radius += r;
        sums.radius_squared += r * r;
        sums.radius_cubed += r * r * r;
        sums.momentum += species.particle_mass * velocity;
        sums.energy_twice += species.particle_mass * squared;
        sums.speed_squared += squared;
    }
    return sums;
}

/// How often per second a sphere of the cell meets another, or flies over the local spacing, whichever is more often; 0 if nothing
/// moves [1/s].
double step_rate(const Gas& gas, const Cell& cell)
{
    constexpr double crowded = 0.45, mean_over_rms = 0.92131773;  // sqrt(8/(3 pi))
    const CellSums sums = sum_cell(gas, cell);
    if (sums.count < 2) return 0;
    const double volume = gas.cells.curve.volume(static_cast<int>(cell.depth)) * sums.count / cell.count;
    const double number_density = sums.count / volume, mean_radius = sums.radius / sums.count;
    const double thermal_twice = std::max(0.0, sums.energy_twice - norm_squared(sums.momentum) / sums.mass);
    const double thermal = std::sqrt(thermal_twice / sums.mass * sums.count / (sums.count - 1));
    const double squared_contact = 2 * (sums.radius_squared / sums.count + mean_radius * mean_radius);
    const double packing = std::min(crowded, sphere_packing(1 / volume, std::cbrt(sums.radius_cubed)));
    const double meetings = meeting_rate(number_density, squared_contact, mean_over_rms * thermal, packing);
    const double transits = std::sqrt(sums.speed_squared / sums.count) * std::cbrt(number_density);
    return std::max(meetings, transits);
}

/// Longest step of the groups [begin, end) for cfl 1 [s]. The rates of a group's cells are averaged: a cell alone is too noisy.
double group_step(const Gas& gas, std::size_t begin, std::size_t end)
{
    double longest = std::numeric_limits<double>::infinity();
    const std::vector<Cell>& cells = gas.cells.cells;
    const std::uint32_t first = gas.cells.groups[begin].first;
    auto cell = std::lower_bound(cells.begin(), cells.end(), first, [](const Cell& c, std::uint32_t i) { return c.first < i; });
    for (std::size_t g = begin; g < end; ++g) {
        double rate = 0, moving = 0;
        for (; cell != cells.end() && cell->first < gas.cells.groups[g].end(); ++cell) {
            const double own = step_rate(gas, *cell);
            rate += own;
            moving += own > 0 ? 1 : 0;
        }
        if (rate > 0) longest = std::min(longest, moving / rate);
    }
    return longest;
}

}  // namespace

double sphere_radius(const Species& species, double packing, double density)
{
    if (std::holds_alternative<Jwl>(species.law))
        throw InputError(fmt::format("hard spheres have no cold pressure, so '{}' with its JWL law cannot be made of them", species.name),
                         "expected an ideal or Noble-Abel gas: explosive = \"tnt_paper\", or collision = \"displaced\"");
    if (const auto* law = std::get_if<NobleAbel>(&species.law); law && law->co_volume > 0) {
        packing = packing_of(1 / (1 - law->co_volume));
        density = law->reference_density;
        if (packing > largest_packing)
            throw InputError(
                fmt::format("hard spheres for the co-volume {:.4g} of '{}' would fill more than {:.3g} of the unreacted volume",
                            law->co_volume, species.name, largest_packing),
                fmt::format("expected a co-volume of at most {:.3f}, or collision = \"displaced\"",
                            1 - 1 / carnahan_starling(largest_packing)));
    }
    return std::cbrt(packing * species.particle_mass / density / (4 * std::numbers::pi / 3));
}

double virial_pressure(const Gas& gas, std::size_t species, double density, double kinetic_pressure)
{
    constexpr double freezing = 0.49;
    const Species& of = gas.species[species];
    if (gas.settings.rule == CollisionRule::displaced) return virial_pressure(of.law, density, kinetic_pressure);
    const double packing = std::min(freezing, sphere_packing(density / of.particle_mass, of.radius));
    return kinetic_pressure * (carnahan_starling(packing) - 1);
}

void survey_hard_spheres(Gas& gas)
{
    const std::size_t groups = gas.cells.groups.size(), chunks = (groups + sphere_groups_per_chunk - 1) / sphere_groups_per_chunk;
    const double longest = minimum(chunks, std::numeric_limits<double>::infinity(), [&](std::size_t c) {
        return group_step(gas, c * sphere_groups_per_chunk, std::min(groups, (c + 1) * sphere_groups_per_chunk));
    });
    gas.step_limit = gas.settings.cfl * longest;
}

void collide_hard_spheres(Gas& gas, const Clock& clock, const FacetTree& walls)
{
    survey_hard_spheres(gas);
    gas.displaced.clear();
    if (clock.duration() > 0) SphereCollider(gas, clock, walls.size() == 0 ? nullptr : &walls).run();
}

}  // namespace corpuscle
