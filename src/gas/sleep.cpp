#include "gas/sleep.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "gas/faces.hpp"
#include "parallel/sort.hpp"

namespace corpuscle {

namespace {

/// How far ahead of what is seen gas is woken: a shock in particles is a few mean free paths thick [spacings of the ambient gas].
constexpr double margin_spacings = 10;
/// A disturbance is seen where the kinetic energy density is more than this, over the ambient gas's: by no chance in a group.
constexpr double seen_ratio = 2;
/// Weaker ones travel slower than this, over the ambient speed of sound: behind a shock of Mach 1.4 in air the ratio is 2.1 by its
/// pressure alone.
constexpr double least_speed = 1.5;

double spacing(const Gas& gas)
{
    return std::cbrt(gas.species[gas.ambient.species].particle_mass / gas.ambient.density);
}

double margin(const Gas& gas)
{
    return margin_spacings * spacing(gas);
}

Box zone_box(const Gas& gas, std::uint32_t number)
{
    return gas.cells.curve.cell(number * CellCurve::keys_of(gas.sleeping.depth), gas.sleeping.depth);
}

bool is_reached(const SleepingGas& sleeping, const Box& box)
{
    return std::any_of(sleeping.disturbances.begin(), sleeping.disturbances.end(),
                       [&](const Disturbance& d) { return distance(d.box, box) <= d.reach; });
}

double nearest_disturbance(const SleepingGas& sleeping, const Box& box)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const Disturbance& d : sleeping.disturbances) nearest = std::min(nearest, distance(d.box, box));
    return nearest;
}

/// A facet that is so near could stand between a particle in the zone and its mirror image.
bool is_near_facet(const Gas& gas, const Box& box, const FacetTree& walls)
{
    return walls.size() > 0 && walls.clearance(Vector3f(box.center())) <= 0.5 * norm(box.size()) + margin(gas);
}

/// Zones of a few hundred particles of ambient gas.
int zone_depth(const Gas& gas)
{
    const double number = gas.domain.box.volume() / std::pow(spacing(gas), 3);
    return std::clamp(static_cast<int>(std::bit_width(static_cast<std::uint64_t>(number / 512))), 1, 16);
}

/// The zones that no disturbance reaches at the start, the furthest first: those that wake first then come last.
std::vector<SleepingZone> choose_zones(const Gas& gas)
{
    struct Candidate {
        SleepingZone zone;
        double way;
    };
    std::vector<Candidate> candidates;
    for (std::uint32_t number = 0; number < 1u << gas.sleeping.depth; ++number) {
        const Box box = zone_box(gas, number);
        if (is_reached(gas.sleeping, box)) continue;
        candidates.push_back({{number, 0}, nearest_disturbance(gas.sleeping, box)});
    }
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) { return a.way > b.way; });
    std::vector<SleepingZone> zones;
    for (const Candidate& candidate : candidates) zones.push_back(candidate.zone);
    return zones;
}

/// Brings the particles of the zones to the front, zone after zone, and counts them.
void bring_to_front(Gas& gas)
{
    SleepingGas& sleeping = gas.sleeping;
    const auto awake = static_cast<std::uint32_t>(sleeping.zones.size());
    std::vector<std::uint32_t> rank(std::size_t{1} << sleeping.depth, awake);
    for (std::uint32_t z = 0; z < awake; ++z) rank[sleeping.zones[z].number] = z;
    const std::vector<Particle> old = gas.particles;
    const std::vector<std::uint32_t> start = stable_counting_sort(
        old.size(), awake + 1, [&](std::size_t i) { return rank[sleeping.zone_of(gas.cells.curve.key(old[i].position))]; },
        [&](std::size_t i, std::uint32_t position) { gas.particles[position] = old[i]; });
    for (std::uint32_t z = 0; z < awake; ++z) sleeping.zones[z].particles = start[z + 1] - start[z];
    sleeping.particles = start[awake];
}

/// What the zones hold and which faces of the domain they touch.
void weigh(Gas& gas)
{
    SleepingGas& sleeping = gas.sleeping;
    sleeping.held = sum<Passage>(sleeping.particles, [&](std::size_t i) { return carried(gas, gas.particles[i]); });
    sleeping.area.fill(0);
    for (const SleepingZone& zone : sleeping.zones) {
        const Box box = zone_box(gas, zone.number);
        const Vector3d size = box.size();
        for (int axis = 0; axis < 3; ++axis) {
            const double side = size[(axis + 1) % 3] * size[(axis + 2) % 3], close = 0.5 * size[axis];
            if (box.lower[axis] < gas.domain.box.lower[axis] + close) sleeping.area[2 * axis] += side;
            if (box.upper[axis] > gas.domain.box.upper[axis] - close) sleeping.area[2 * axis + 1] += side;
        }
    }
}

/// Gas asleep presses on rigid faces like any other, but evenly.
void press_on_faces(Gas& gas, double duration)
{
    for (int face = 0; face < face_count; ++face) {
        if (gas.domain.edges[face] != Edge::rigid) continue;
        const double impulse = (face % 2 == 0 ? -1 : 1) * gas.ambient.pressure * gas.sleeping.area[face] * duration;
        gas.passages.face[face].momentum[face / 2] += impulse;
        gas.sleeping.turned.momentum[face / 2] -= impulse;
    }
}

/// Once anything near the structure wakes, the structure may move, and with it all the gas around it.
void wake_structure(Gas& gas)
{
    SleepingGas& sleeping = gas.sleeping;
    if (sleeping.movable_woken || !sleeping.movable) return;
    const bool touched = std::any_of(sleeping.zones.begin(), sleeping.zones.end(), [&](const SleepingZone& zone) {
        return sleeping.state[zone.number] == zone_state::asleep_near_facet && is_reached(sleeping, zone_box(gas, zone.number));
    });
    if (!touched) return;
    sleeping.disturbances.push_back({*sleeping.movable, margin(gas)});
    sleeping.movable_woken = true;
}

/// Takes the zones that are reached from those asleep; their particles then stand between these and the awake ones.
void wake_reached(Gas& gas)
{
    SleepingGas& sleeping = gas.sleeping;
    std::vector<SleepingZone> still;
    std::vector<Particle> woken;
    std::uint32_t from = 0, kept = 0;
    for (const SleepingZone& zone : sleeping.zones) {
        const auto first = gas.particles.begin() + from, end = first + zone.particles;
        from += zone.particles;
        std::uint8_t& state = sleeping.state[zone.number];
        if ((state == zone_state::asleep_near_facet && sleeping.movable_woken) || is_reached(sleeping, zone_box(gas, zone.number))) {
            woken.insert(woken.end(), first, end);
            state = zone_state::awake;
            continue;
        }
        if (kept != from - zone.particles) std::move(first, end, gas.particles.begin() + kept);
        kept += zone.particles;
        still.push_back(zone);
    }
    if (still.size() == sleeping.zones.size()) return;
    std::copy(woken.begin(), woken.end(), gas.particles.begin() + kept);
    sleeping.zones = std::move(still);
    sleeping.particles = kept;
    weigh(gas);
}

}  // namespace

void lay_to_sleep(Gas& gas, const FacetTree& walls)
{
    SleepingGas& sleeping = gas.sleeping;
    if (sleeping.disturbances.empty() || !(gas.ambient.density > 0) || gas.settings.rule == CollisionRule::hard_spheres) return;
    gas.cells.curve = CellCurve(gas.domain.box);
    sleeping.depth = zone_depth(gas);
    for (Disturbance& disturbance : sleeping.disturbances) disturbance.reach = margin(gas);
    sleeping.zones = choose_zones(gas);
    sleeping.state.assign(std::size_t{1} << sleeping.depth, zone_state::awake);
    for (const SleepingZone& zone : sleeping.zones)
        sleeping.state[zone.number] =
            is_near_facet(gas, zone_box(gas, zone.number), walls) ? zone_state::asleep_near_facet : zone_state::asleep;
    bring_to_front(gas);
    weigh(gas);
}

void wake(Gas& gas, const Clock& clock)
{
    SleepingGas& sleeping = gas.sleeping;
    if (!sleeping.any()) return;
    const AmbientGas& ambient = gas.ambient;
    const EquationOfState& law = gas.species[ambient.species].law;
    const double speed = least_speed * sound_speed(law, ambient.density, ambient.velocity_variance / (heat_capacity_ratio(law) - 1));
    for (std::size_t d = 0; d < sleeping.disturbances.size(); ++d) {
        double& reach = sleeping.disturbances[d].reach;
        if (d < sleeping.found.size()) reach = std::max(reach, sleeping.found[d] + margin(gas));
        reach += speed * clock.duration();
    }
    wake_structure(gas);
    wake_reached(gas);
    press_on_faces(gas, clock.duration());
}

void note_disturbance(const Gas& gas, const Vector3d& place, double energy, std::vector<double>& found)
{
    const AmbientGas& ambient = gas.ambient;
    if (energy <= seen_ratio * 1.5 * ambient.density * ambient.velocity_variance) return;
    const std::vector<Disturbance>& disturbances = gas.sleeping.disturbances;
    found.resize(disturbances.size());
    std::size_t nearest = 0;
    double way = std::numeric_limits<double>::infinity();
    for (std::size_t d = 0; d < disturbances.size(); ++d) {
        const double own = distance(disturbances[d].box, place);
        if (own < way) nearest = d;
        way = std::min(way, own);
    }
    found[nearest] = std::max(found[nearest], way);
}

/// Of the mirror images in the zone's faces, and in two or three of them at once where it came in by an edge or a corner, the nearest that
/// is not asleep. Near facets the particle is put at the face itself, so that none can stand between.
Vector3d turn_back(const Gas& gas, Particle& particle)
{
    const SleepingGas& sleeping = gas.sleeping;
    const std::uint32_t number = sleeping.zone_of(gas.cells.curve.key(particle.position));
    const Box box = zone_box(gas, number);
    const bool near_facet = sleeping.state[number] == zone_state::asleep_near_facet;
    const Vector3d place(particle.position);
    Vector3d image, cost;
    for (int a = 0; a < 3; ++a) {
        const bool upper = 2 * place[a] > box.lower[a] + box.upper[a];
        const double face = upper ? box.upper[a] : box.lower[a];
        const double rounding =
            1e-6 * std::max({gas.domain.box.size()[a], std::abs(gas.domain.box.lower[a]), std::abs(gas.domain.box.upper[a])});
        const double depth = std::max(std::abs(place[a] - face), rounding);
        cost[a] = depth;
        image[a] = face + (upper ? 1 : -1) * (near_facet ? rounding : depth);
    }
    Vector3f best = particle.position;
    int turned = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int axes = 1; axes < 8; ++axes) {
        Vector3d other = place;
        double way = 0;
        for (int a = 0; a < 3; ++a) {
            if (!(axes >> a & 1)) continue;
            other[a] = image[a];
            way += cost[a];
        }
        if (way >= least || !gas.domain.box.contains(other) || sleeping.holds(gas.cells.curve.key(Vector3f(other)))) continue;
        best = Vector3f(other);
        turned = axes;
        least = way;
    }
    particle.position = best;
    const double mass = gas.species[particle_tag::species(particle.tag)].particle_mass;
    Vector3d impulse;
    for (int a = 0; a < 3; ++a) {
        const bool inward = image[a] > place[a] ? particle.velocity[a] < 0 : particle.velocity[a] > 0;
        if (!(turned >> a & 1) || !inward) continue;
        impulse[a] = 2 * mass * static_cast<double>(particle.velocity[a]);
        particle.velocity[a] = -particle.velocity[a];
    }
    return impulse;
}

namespace {

/// A field of one number of each item of a list, which is sized when it is restored.
template <class T, class Item, class Get>
Field item_field(std::string name, std::string unit, std::string meaning, std::vector<Item>& items, Get get)
{
    Field field = derived_field<T>(std::move(name), std::move(unit), std::move(meaning), items.size(),
                                   [&items, get](std::size_t i) { return get(items[i]); });
    field.restore = [&items, get](const void* values, std::size_t count) {
        items.resize(count);
        for (std::size_t i = 0; i < count; ++i) get(items[i]) = static_cast<const T*>(values)[i];
    };
    return field;
}

/// What follows from the fields restored before.
void take_up(Gas& gas, std::size_t disturbances_at_start)
{
    SleepingGas& sleeping = gas.sleeping;
    sleeping.depth = static_cast<int>(std::bit_width(sleeping.state.size())) - 1;
    sleeping.particles = 0;
    for (const SleepingZone& zone : sleeping.zones) sleeping.particles += zone.particles;
    sleeping.movable_woken = sleeping.disturbances.size() > disturbances_at_start;
    weigh(gas);
}

}  // namespace

void add_sleep_state(FieldSet& set, Gas& gas)
{
    SleepingGas& sleeping = gas.sleeping;
    const auto add = [&](Field field) { set.fields.push_back(std::move(field)); };
    add(item_field<std::uint8_t>("zone_state", "1", "0 awake, 1 asleep, 2 asleep near a facet", sleeping.state,
                                 [](auto& state) -> auto& { return state; }));
    add(item_field<std::uint32_t>("zone_number", "1", "zones asleep, by their place along the curve", sleeping.zones,
                                  [](auto& zone) -> auto& { return zone.number; }));
    add(item_field<std::uint32_t>("zone_particles", "1", "in each zone asleep", sleeping.zones,
                                  [](auto& zone) -> auto& { return zone.particles; }));
    add(item_field<Vector3d>("disturbance_lower", "m", "box about each disturbance", sleeping.disturbances,
                             [](auto& d) -> auto& { return d.box.lower; }));
    add(item_field<Vector3d>("disturbance_upper", "m", "box about each disturbance", sleeping.disturbances,
                             [](auto& d) -> auto& { return d.box.upper; }));
    add(item_field<double>("disturbance_reach", "m", "how far each may have come", sleeping.disturbances,
                           [](auto& d) -> auto& { return d.reach; }));
    add(stored_field("disturbance_found", "m", "how far each was seen in the last step", sleeping.found));
    Field turned = derived_field<Vector3d>("sleep_impulse", "N s", "of awake gas on gas asleep since the start", 1,
                                           [&sleeping](std::size_t) { return sleeping.turned.momentum; });
    turned.restore = [&gas, at_start = sleeping.disturbances.size()](const void* value, std::size_t) {
        gas.sleeping.turned.momentum = *static_cast<const Vector3d*>(value);
        take_up(gas, at_start);
    };
    add(std::move(turned));
}

}  // namespace corpuscle
