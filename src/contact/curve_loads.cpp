#include "contact/curve_loads.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "contact/push.hpp"

namespace corpuscle {

GravityLoad::GravityLoad(Structure& structure, const Vector3d& acceleration)
    : structure_(structure), acceleration_(acceleration), facet_impulse_(structure.surface.facets.size())
{
}

std::vector<Transfer> GravityLoad::apply(const Clock& clock)
{
    Transfer given{"gravity", "structure", 0, {}, 0};
    Nodes& nodes = structure_.nodes;
    const Vector3d fall = clock.duration() * acceleration_;
    for (std::uint32_t node = 0; node < nodes.size(); ++node) {
        if (!(nodes.mass[node] > 0)) continue;
        given.momentum += nodes.mass[node] * fall;
        given.energy += push_node(nodes, node, nodes.mass[node] * fall, clock.duration());
    }
    for (RigidBody& body : nodes.bodies) {
        const Vector3d before = body.center_velocity();
        body.push(body.center, body.mass * fall);
        given.momentum += body.mass * fall;
        given.energy += 0.5 * body.mass * dot(fall, before + body.center_velocity());
    }
    return {given};
}

PressureLoad::PressureLoad(Structure& structure, const LoadedNodes& where, TimeCurve pressure)
    : structure_(structure), name_(where.name), pressure_(std::move(pressure)), facet_impulse_(structure.surface.facets.size())
{
    const auto loaded = [&](std::uint32_t node) { return std::binary_search(where.nodes.begin(), where.nodes.end(), node); };
    const std::vector<Facet>& facets = structure.surface.facets;
    for (std::uint32_t f = 0; f < facets.size(); ++f)
        if (facets[f].part == where.part && std::all_of(facets[f].node.begin(), facets[f].node.end(), loaded)) facets_.push_back(f);
    if (facets_.empty())
        throw InputError(fmt::format("{}: no facet of the part has all its nodes there", where.name),
                         "give a set of nodes that covers whole elements, or \"all\"");
}

std::vector<Transfer> PressureLoad::apply(const Clock& clock)
{
    Transfer given{"pressure", "structure", 0, {}, 0};
    const double impulse = pressure_.integral(clock.time(), clock.end());
    for (const std::uint32_t f : facets_) {
        if (structure_.surface.is_hidden(f)) continue;
        const auto& node = structure_.surface.facets[f].node;
        const Vector3d push = -impulse * middle_area(structure_.nodes, node);
        for (const std::uint32_t n : node) given.energy += push_node(structure_.nodes, n, push / 3.0, clock.duration());
        given.momentum += push;
        facet_impulse_[f] += push;
    }
    return {given};
}

FieldSet PressureLoad::state()
{
    return {name(), {stored_field("facet_impulse", "N s", "impulse of the pressure on each facet since the start", facet_impulse_)}};
}

ForceLoad::ForceLoad(Structure& structure, LoadedNodes where, const Vector3d& direction, TimeCurve force)
    : structure_(structure), where_(std::move(where)), force_(std::move(force)), facet_impulse_(structure.surface.facets.size())
{
    if (!(norm(direction) > 0))
        throw InputError(fmt::format("{}: its direction has no length", where_.name), "give a direction such as [0, 0, 1]");
    if (where_.nodes.empty()) throw InputError(fmt::format("{}: it acts on no node", where_.name), "give nodes of the part");
    direction_ = normalized(direction);
}

std::vector<Transfer> ForceLoad::apply(const Clock& clock)
{
    Transfer given{"force", "structure", 0, {}, 0};
    const Vector3d share = force_.integral(clock.time(), clock.end()) / static_cast<double>(where_.nodes.size()) * direction_;
    for (const std::uint32_t node : where_.nodes) {
        given.energy += push_node(structure_.nodes, node, share, clock.duration());
        given.momentum += share;
    }
    given_.front() += given.momentum;
    return {given};
}

Vector3d ForceLoad::impulse_beside_facets(std::uint32_t part) const
{
    return part == where_.part ? given_.front() : Vector3d{};
}

FieldSet ForceLoad::state()
{
    return {name(), {stored_field("given", "N s", "impulse of the force since the start", given_)}};
}

}  // namespace corpuscle
