#include "structure/erosion.hpp"

#include <cmath>

#include "parallel/loops.hpp"
#include "structure/structure.hpp"

namespace corpuscle {

namespace {

bool has_failed(const Erosion& limits, const ElementValues& v, double transit)
{
    return v.least_plastic_strain >= limits.plastic_strain || v.principal_stress >= limits.principal_stress ||
           -v.pressure >= limits.tension || v.damage >= 1.0 || (limits.step > 0 && !(0.9 * transit >= limits.step));
}

/// The elements beyond their limits, in order.
template <class Kind>
std::vector<std::size_t> failed_elements(const Kind& elements, const Erosion& limits)
{
    std::vector<std::uint8_t> failed(elements.size());
    for_each(elements.size(), [&](std::size_t e) {
        failed[e] = elements.is_left(e) && has_failed(limits, elements.values(e), elements.transit(e)) ? 1 : 0;
    });
    std::vector<std::size_t> list;
    for (std::size_t e = 0; e < failed.size(); ++e)
        if (failed[e]) list.push_back(e);
    return list;
}

/// 1 over the mass where the direction is free.
Vector3d inverse(const Vector3d& before, double mass)
{
    const double value = mass > 0 ? 1.0 / mass : 0.0;
    return {before.x != 0 ? value : 0.0, before.y != 0 ? value : 0.0, before.z != 0 ? value : 0.0};
}

/// Takes mass off a node at the velocity it has with its waiting impulse; what stays keeps that velocity. A node left without mass rests.
void lighten(Nodes& nodes, std::uint32_t node, const CornerMass& share, Transfer& gone)
{
    const Vector3d velocity = nodes.contact_velocity(node), spin = nodes.angular_velocity[node];
    const double before = nodes.mass[node];
    constexpr double nothing = 1e-9;  // of the mass: what rounding leaves
    const bool last = before - share.mass <= nothing * before;
    const double mass = last ? before : share.mass, inertia = last ? nodes.inertia[node] : share.inertia;
    gone.mass += mass;
    gone.momentum += mass * velocity;
    gone.energy += 0.5 * (mass * norm_squared(velocity) + inertia * norm_squared(spin));
    nodes.mass[node] = last ? 0.0 : before - mass;
    nodes.inertia[node] = last ? 0.0 : nodes.inertia[node] - inertia;
    for (int a = 0; a < 3; ++a) {
        const bool held = nodes.inverse_mass[node][a] == 0;
        if (last && held) gone.momentum[a] += nodes.impulse[node][a];
        if (last || !held) nodes.impulse[node][a] *= nodes.mass[node] / before;
    }
    nodes.inverse_mass[node] = inverse(nodes.inverse_mass[node], nodes.mass[node]);
    nodes.inverse_inertia[node] = inverse(nodes.inverse_inertia[node], nodes.inertia[node]);
    if (last) nodes.velocity[node] = nodes.angular_velocity[node] = {};
}

/// Half a step's work of an element's loads, which the books count already: it goes, too. [J]
double half_step_work(const Nodes& nodes, std::uint32_t node, const CornerLoad& load, double duration)
{
    return 0.5 * duration * (dot(load.force, nodes.contact_velocity(node)) + dot(load.moment, nodes.angular_velocity[node]));
}

template <class Kind>
void take_out(Structure& structure, const Part& part, Kind& elements, std::size_t element, double duration, Transfer& gone)
{
    const ElementEnergy energy = elements.energy(element);
    const CornerMass share = elements.corner_mass(element);
    const int corners = elements.corner_count();
    for (int c = 0; c < corners; ++c) {
        CornerLoad& load = structure.corner_loads[part.first_corner + element * corners + c];
        gone.energy += half_step_work(structure.nodes, elements.node(element, c), load, duration);
        load = {};
    }
    for (int c = 0; c < corners; ++c) lighten(structure.nodes, elements.node(element, c), share, gone);
    gone.energy += energy.internal + energy.hourglass;
    structure.eroded.internal += energy.internal + energy.hourglass;
    structure.eroded.elements += 1;
    elements.remove(element);
}

}  // namespace

Transfer erode(Structure& structure, Part& part, const Clock& clock)
{
    Transfer gone{"structure", "eroded", 0.0, {}, 0.0};
    const std::size_t count = std::visit(
        [&](auto& elements) {
            const std::vector<std::size_t> failed = failed_elements(elements, part.erosion);
            for (const std::size_t e : failed) take_out(structure, part, elements, e, clock.duration(), gone);
            return failed.size();
        },
        part.elements);
    structure.eroded.mass += gone.mass;
    if (count > 0) hide_facets(structure);
    return gone;
}

void hide_facets(Structure& structure)
{
    Surface& surface = structure.surface;
    surface.hidden.resize(surface.facets.size());
    surface.turned.resize(surface.facets.size());
    for_each(surface.facets.size(), [&](std::size_t f) {
        const Facet& facet = surface.facets[f];
        const Part& part = structure.parts[facet.part];
        const auto is_left = [&](std::uint32_t element) {
            return element != Facet::no_element &&
                   std::visit([&](const auto& elements) { return elements.is_left(element - part.first_element); }, part.elements);
        };
        const bool own = is_left(facet.element), other = is_left(facet.other);
        surface.hidden[f] = own == other ? 1 : 0;
        surface.turned[f] = other && !own ? 1 : 0;
    });
}

}  // namespace corpuscle
