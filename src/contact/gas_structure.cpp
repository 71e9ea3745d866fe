#include "contact/gas_structure.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "gas/faces.hpp"
#include "math/single.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {
namespace {

constexpr int meeting_limit = 64;   ///< bounces of a particle in a step; then a facet carries it to the end of the leg
constexpr std::size_t grain = 128;  ///< flights handed to a thread at a time

/// Parts that a surface's facets name.
std::size_t parts_of(const Surface& surface)
{
    std::size_t count = 0;
    for (const Facet& facet : surface.facets) count = std::max<std::size_t>(count, facet.part + 1);
    return count;
}

}  // namespace

GasStructureContact::GasStructureContact(Gas& gas, Structure& structure)
    : gas_(gas),
      structure_(structure),
      tree_(structure.surface),
      facet_impulse_(tree_.size()),
      facet_squares_(tree_.size()),
      facet_hits_(tree_.size()),
      press_{std::vector<double>(tree_.size()), std::vector<double>(tree_.size())},
      given_{std::vector<Vector3d>(parts_of(structure.surface)), std::vector<double>(parts_of(structure.surface))}
{
}

void GasStructureContact::follow()
{
    tree_.follow(structure_.nodes.path(), structure_.surface.hidden);
}

/// Rounds until no flight is left: first every flight finds what it meets next, which needs geometry alone and any number of
/// threads; then the meetings exchange impulse one after the other, each seeing what those before it have left.
std::vector<Transfer> GasStructureContact::apply(const Clock& clock)
{
    Transfer given{"gas", "structure", 0, {}, 0};
    const FlightPath path(tree_, gas_.domain, clock.duration());
    begin_flights();
    while (!flights_.empty()) {
        for_each_dynamic(flights_.size(), grain, [&](std::size_t i) { path.advance(flights_[i], gas_.particles[flights_[i].particle]); });
        for (Flight& flight : flights_) meet(flight, path, given);
        std::erase_if(flights_, [](const Flight& flight) { return flight.state == Flight::State::arrived; });
    }
    return {given};
}

/// Takes over the gas's pending particles.
void GasStructureContact::begin_flights()
{
    flights_.resize(gas_.pending.size());
    for_each(flights_.size(),
             [&](std::size_t i) { flights_[i] = FlightPath::begin(gas_.pending[i], gas_.particles[gas_.pending[i].particle]); });
    gas_.pending.clear();
}

/// Settles what a flight has come to: nothing, a face of the domain, or a facet.
void GasStructureContact::meet(Flight& flight, const FlightPath& path, Transfer& given)
{
    trapped_ += flight.trapped;
    flight.trapped = false;
    if (flight.state == Flight::State::arrived) return;
    if (flight.face < 0) return meet_facet(flight, path, given);
    if (flight.meetings > 100 * meeting_limit)
        throw SafetyStop("a gas particle bounces between faces of the domain without end", "look for gas of absurd speed");
    const bool stays = corpuscle::meet_face(gas_, gas_.particles[flight.particle], flight.face, gas_.passages);
    if (stays) {
        path.leave_face(flight);
    } else {
        flight.state = Flight::State::arrived;
    }
}

/// A bounce, unless facet and particle part already because of what came before in this step: then the facet carries it.
/// A displacement always bounces, together with the velocity: the displaced gas is its own mirror image in the facet.
void GasStructureContact::meet_facet(Flight& flight, const FlightPath& path, Transfer& given)
{
    const double closing = closing_velocity(flight);
    if (flight.meetings >= meeting_limit || (!flight.displaced && closing <= 0)) return path.settle_on_facet(flight);
    bounce(flight, closing, given);
    path.leave_facet(flight);
}

/// Speed at which the particle comes towards the facet, with all impulses so far [m/s].
double GasStructureContact::closing_velocity(const Flight& flight) const
{
    const std::array<std::uint32_t, 3>& node = tree_.nodes(flight.hit.facet);
    Vector3d relative(gas_.particles[flight.particle].velocity);
    for (int i = 0; i < 3; ++i) relative -= flight.hit.weight[i] * structure_.nodes.contact_velocity(node[i]);
    return -dot(relative, flight.hit.normal);
}

/// 1/M of the facet where it is hit, along its normal n: sum of N^2 n.m^-1.n over its nodes; 0 where held [1/kg].
double GasStructureContact::effective_inverse_mass(const Flight& flight) const
{
    const std::array<std::uint32_t, 3>& node = tree_.nodes(flight.hit.facet);
    const Nodes& nodes = structure_.nodes;
    if (const RigidBody* body = nodes.body_of(node[0])) {
        Vector3d place;
        for (int i = 0; i < 3; ++i) place += flight.hit.weight[i] * nodes.position[node[i]];
        return body->inverse_mass_at(place, flight.hit.normal);
    }
    const Vector3d squares = scaled(flight.hit.normal, flight.hit.normal);
    double inverse = 0;
    for (int i = 0; i < 3; ++i) inverse += flight.hit.weight[i] * flight.hit.weight[i] * dot(squares, nodes.inverse_mass[node[i]]);
    return inverse;
}

/// Elastic bounce: J = 2 closing / (1/m + 1/M) along the normal. What the particle's rounded velocity has really lost goes to the
/// nodes by the facet's weights, so no momentum is lost to rounding.
void GasStructureContact::bounce(Flight& flight, double closing, Transfer& given)
{
    Particle& particle = gas_.particles[flight.particle];
    const double mass = gas_.species[particle_tag::species(particle.tag)].particle_mass;
    const Vector3d before(particle.velocity);
    const double gain = 2 * closing / (1 + mass * effective_inverse_mass(flight));
    const Vector3d after = single(before + gain * flight.hit.normal);
    particle.velocity = Vector3f(after);
    const Vector3d impulse = mass * (before - after);
    const std::array<std::uint32_t, 3>& node = tree_.nodes(flight.hit.facet);
    for (int i = 0; i < 3; ++i) structure_.nodes.push(node[i], flight.hit.weight[i] * impulse);
    facet_impulse_[flight.hit.facet] += impulse;
    facet_squares_[flight.hit.facet] += scaled(impulse, impulse + 2 * flight.given);
    flight.given += impulse;
    ++facet_hits_[flight.hit.facet];
    (flight.hit.upper ? press_.upper : press_.lower)[flight.hit.facet] -= dot(impulse, flight.hit.normal);
    const double work = 0.5 * dot(impulse, before + after);
    given.momentum += impulse;
    given.energy += work;
    const std::uint32_t part = structure_.surface.facets[flight.hit.facet].part;
    given_.impulse[part] += impulse;
    given_.work[part] += work;
}

FieldSet GasStructureContact::state()
{
    FieldSet set = tree_.state();
    set.name = name();
    set.fields.push_back(stored_field("facet_impulse", "N s", "impulse of gas on each facet since the start", facet_impulse_));
    set.fields.push_back(stored_field("facet_squares", "N2 s2", "squared impulses of gas on each facet since the start", facet_squares_));
    set.fields.push_back(stored_field("facet_hits", "1", "particles that have hit each facet since the start", facet_hits_));
    set.fields.push_back(stored_field("upper_press", "N s", "normal impulse on each facet's upper side since the start", press_.upper));
    set.fields.push_back(stored_field("lower_press", "N s", "normal impulse on each facet's lower side since the start", press_.lower));
    set.fields.push_back(stored_field("part_impulse", "N s", "impulse of gas on each part since the start", given_.impulse));
    set.fields.push_back(stored_field("part_work", "J", "work of gas on each part since the start", given_.work));
    return set;
}

}  // namespace corpuscle
