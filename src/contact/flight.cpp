#include "contact/flight.hpp"

#include <cmath>
#include <limits>

#include "math/single.hpp"

namespace corpuscle {
namespace {

constexpr double float_steps = 4;      ///< that a particle is put off a facet
constexpr double stepped_back = 1e-6;  ///< share of a leg by which the next begins before the meeting, where all sides are certain

/// The float nearest to a coordinate that is not below it (upward) or not above it.
double float_beyond(double coordinate, bool upward)
{
    const double nearest = single(coordinate);
    if (upward ? nearest >= coordinate : nearest <= coordinate) return nearest;
    const float limit = upward ? std::numeric_limits<float>::infinity() : -std::numeric_limits<float>::infinity();
    return static_cast<double>(std::nextafter(static_cast<float>(nearest), limit));
}

/// Mirror image of a way in a plane of the given unit normal.
Vector3d mirrored(const Vector3d& way, const Vector3d& normal)
{
    return way - 2 * dot(way, normal) * normal;
}

/// The place of given weights on a facet.
Vector3d weighted(const std::array<Vector3d, 3>& corners, const std::array<double, 3>& weight)
{
    return weight[0] * corners[0] + weight[1] * corners[1] + weight[2] * corners[2];
}

/// A facet's unit normal by the right hand over its corners.
Vector3d unit_normal(const std::array<Vector3d, 3>& corners)
{
    return normalized(cross(corners[1] - corners[0], corners[2] - corners[0]));
}

}  // namespace

FlightPath::FlightPath(const FacetTree& tree, const Domain& domain, double duration) : tree_(tree), domain_(domain), duration_(duration)
{
    double farthest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        inside_.lower[axis] = float_beyond(domain.box.lower[axis], true);
        inside_.upper[axis] = float_beyond(domain.box.upper[axis], false);
        farthest = std::max({farthest, std::abs(domain.box.lower[axis]), std::abs(domain.box.upper[axis])});
    }
    push_ = float_steps * farthest * static_cast<double>(std::numeric_limits<float>::epsilon());
}

Flight FlightPath::begin(const Pending& pending, const Particle& particle)
{
    Flight flight;
    flight.particle = pending.particle;
    flight.start = pending.start;
    flight.displacement = Vector3d(pending.displacement);
    flight.displaced = pending.displacement != Vector3f{};
    flight.fraction = flight.displaced ? 0.0 : static_cast<double>(pending.start);
    flight.place = Vector3d(particle.position);
    return flight;
}

void FlightPath::advance(Flight& flight, Particle& particle) const
{
    while (flight.state != Flight::State::arrived) {
        if (flight.state == Flight::State::settling) {
            settle(flight, particle);
            continue;
        }
        flight.goal = goal_of(flight, particle);
        if (flight.facet >= 0 && !parts_from_facet(flight)) {
            flight.state = Flight::State::settling;
            continue;
        }
        flight.hit = tree_.first_hit(flight.place, flight.goal, flight.fraction, end_of_leg(flight), flight.facet);
        const Domain::Exit exit = domain_.first_exit(flight.place, flight.goal);
        const bool at_facet = flight.hit.facet >= 0 && !(exit.face >= 0 && exit.fraction < flight.hit.fraction);
        flight.face = at_facet ? -1 : exit.face;
        flight.met_at = at_facet ? flight.hit.fraction : exit.fraction;
        if (at_facet || exit.face >= 0) return;
        arrive(flight, particle, flight.goal);
    }
}

/// Where the leg ends if nothing is met: rounded to float before it is tested.
Vector3d FlightPath::goal_of(const Flight& flight, const Particle& particle) const
{
    const Vector3d way = flight.displaced ? flight.displacement : duration_ * (1 - flight.fraction) * Vector3d(particle.velocity);
    Vector3d goal = rounded(flight.place + way);
    keep_inside_unless_outbound(flight.place, goal);
    return goal;
}

/// Whether the leg as rounded leads away from the facet just left, by more than rounding can undo; else the facet carries the particle.
bool FlightPath::parts_from_facet(const Flight& flight) const
{
    const double end = end_of_leg(flight);
    const Vector3d carried = weighted(tree_.corners(flight.facet, end), flight.left.weight) -
                             weighted(tree_.corners(flight.facet, flight.fraction), flight.left.weight);
    return dot(flight.goal - flight.place - carried, flight.left.normal) > 0.25 * push_;
}

/// The nearest float position; a place in the domain stays in it.
Vector3d FlightPath::rounded(const Vector3d& point) const
{
    Vector3d nearest = single(point);
    for (int axis = 0; axis < 3; ++axis) {
        if (point[axis] >= domain_.box.lower[axis]) nearest[axis] = std::max(nearest[axis], inside_.lower[axis]);
        if (point[axis] <= domain_.box.upper[axis]) nearest[axis] = std::min(nearest[axis], inside_.upper[axis]);
    }
    return nearest;
}

/// A particle a rounding error outside the domain that does not move outward is brought inside, not bounced.
void FlightPath::keep_inside_unless_outbound(const Vector3d& place, Vector3d& goal) const
{
    for (int axis = 0; axis < 3; ++axis) {
        if (goal[axis] < domain_.box.lower[axis] && goal[axis] >= place[axis]) goal[axis] = inside_.lower[axis];
        if (goal[axis] > domain_.box.upper[axis] && goal[axis] <= place[axis]) goal[axis] = inside_.upper[axis];
    }
}

/// Begins the next leg a little before the meeting: there the particle is still on its side of every facet beyond rounding errors.
void FlightPath::step_back(Flight& flight) const
{
    const double t = flight.met_at - std::min(0.5 * flight.met_at, stepped_back);
    flight.place += t * (flight.goal - flight.place);
    flight.fraction += t * (end_of_leg(flight) - flight.fraction);
    flight.displacement *= 1 - t;
    ++flight.meetings;
}

void FlightPath::leave_facet(Flight& flight) const
{
    step_back(flight);
    flight.facet = flight.hit.facet;
    flight.left = {flight.hit.weight, flight.hit.normal};
    flight.displacement = mirrored(flight.displacement, flight.hit.normal);
}

void FlightPath::leave_face(Flight& flight) const
{
    step_back(flight);
    flight.facet = -1;
    flight.displacement[flight.face / 2] = -flight.displacement[flight.face / 2];
}

void FlightPath::settle_on_facet(Flight& flight) const
{
    leave_facet(flight);
    flight.state = Flight::State::settling;
}

/// Ends a leg: the displacement is followed by the flight proper, and that by the end of the step.
void FlightPath::arrive(Flight& flight, Particle& particle, const Vector3d& at) const
{
    particle.position = Vector3f(at);
    flight.place = at;
    flight.facet = -1;
    flight.state = flight.displaced ? Flight::State::moving : Flight::State::arrived;
    flight.displaced = false;
    flight.displacement = {};
    flight.fraction = static_cast<double>(flight.start);
}

/// Puts the particle where the point of the facet it met ends the leg, off the facet on its own side. Where that is not free (in a
/// crease, or beyond a face of the domain) it is put farther off or nearer to the facet's middle.
void FlightPath::settle(Flight& flight, Particle& particle) const
{
    const std::array<Vector3d, 3> then = tree_.corners(flight.facet, flight.fraction),
                                  corners = tree_.corners(flight.facet, end_of_leg(flight));
    const double side = dot(unit_normal(then), flight.left.normal) < 0 ? -1 : 1;
    const Vector3d normal = side * unit_normal(corners);
    for (const double inward : {0.0, 0.001, 0.01, 0.1, 0.5, 1.0}) {
        std::array<double, 3> weight = flight.left.weight;
        for (double& w : weight) w += inward * (1.0 / 3 - w);
        for (const double off : {1.0, 4.0, 32.0}) {
            const Vector3d place = rounded(weighted(corners, weight) + off * push_ * normal);
            if (is_free(flight, place, corners[0], normal)) return arrive(flight, particle, place);
        }
    }
    flight.trapped = true;
    arrive(flight, particle, rounded(weighted(corners, flight.left.weight) + push_ * normal));
}

/// Whether a place lies in the domain, on the particle's side of the facet it left, and behind no other.
bool FlightPath::is_free(const Flight& flight, const Vector3d& place, const Vector3d& corner, const Vector3d& normal) const
{
    if (!inside_.contains(place) || !(dot(place - corner, normal) > 0.25 * push_)) return false;
    return tree_.first_hit(flight.place, place, flight.fraction, end_of_leg(flight), flight.facet).facet < 0;
}

}  // namespace corpuscle
