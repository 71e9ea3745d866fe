#include "contact/conwep_load.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "contact/push.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

/// Area times normal of a triangle [m2].
Vector3d area_vector(const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
    return 0.5 * cross(b - a, c - a);
}

/// Whether a facet stands on the straight line from a facet's centroid to the charge; what lies on the facet itself does not count.
bool is_hidden_from(const FacetTree& tree, const Vector3d& centroid, const Vector3d& charge, std::uint32_t facet)
{
    constexpr double aside = 1e-6;  // of the distance
    return tree.first_hit(centroid + aside * (charge - centroid), charge, 0, 0, facet).facet >= 0;
}

}  // namespace

ConwepLoad::ConwepLoad(Structure& structure, std::uint32_t part, const ConwepCharge& charge)
    : structure_(structure),
      part_name_(part < structure.parts.size() ? structure.parts[part].name : fmt::format("number {}", part)),
      detonation_time_(charge.time)
{
    FacetTree tree(structure.surface);
    tree.follow({structure.nodes.reference, structure.nodes.reference}, structure.surface.hidden);
    try {
        for (std::uint32_t i = 0; i < structure.surface.facets.size(); ++i) {
            if (structure.surface.facets[i].part == part && !structure.surface.is_hidden(i)) add_facet(i, charge, tree);
        }
    } catch (const InputError& error) {
        throw InputError(fmt::format("ConWep load on part '{}': {}", part_name_, error.problem()), error.remedy());
    }
    if (facets_.empty())
        throw InputError(fmt::format("ConWep load on part '{}': it shows no surface that sees the charge", part_name_),
                         "name a part made of shells or solids that faces the charge, with nothing between");
    specific_impulse_.assign(facets_.size(), 0.0);
    pressure_.assign(facets_.size(), 0.0);
    push_.resize(facets_.size());
    facet_impulse_.resize(structure.surface.facets.size());
}

void ConwepLoad::add_facet(std::uint32_t facet, const ConwepCharge& charge, const FacetTree& tree)
{
    const auto& node = structure_.surface.facets[facet].node;
    const std::vector<Vector3d>& at = structure_.nodes.reference;
    const Vector3d centroid = (at[node[0]] + at[node[1]] + at[node[2]]) / 3.0, ray = centroid - charge.center;
    const double distance = norm(ray);
    const double cosine = dot(normalized(area_vector(at[node[0]], at[node[1]], at[node[2]])), ray) / distance;
    const bool solid = structure_.surface.facets[facet].solid;
    const bool shadowed = (solid && cosine > 0) || is_hidden_from(tree, centroid, charge.center, facet);
    if (shadowed && charge.shadow == Shadow::nothing) return;
    const BlastWave wave = kingery_bulmash(charge.burst, charge.mass, distance);
    facets_.push_back(facet);
    loads_.emplace_back(wave, shadowed ? -1.0 : std::abs(cosine));
    side_.push_back(solid || cosine < 0 ? -1.0 : 1.0);
}

void ConwepLoad::find_pushes(const Clock& clock)
{
    const Nodes& nodes = structure_.nodes;
    const double start = clock.time() - detonation_time_, end = clock.end() - detonation_time_;
    for_each(facets_.size(), [&](std::size_t i) {
        const double impulse = structure_.surface.is_hidden(facets_[i]) ? 0.0 : loads_[i].impulse(start, end);
        const auto& node = structure_.surface.facets[facets_[i]].node;
        push_[i] = impulse * side_[i] * middle_area(nodes, node);
        specific_impulse_[i] += impulse;
        pressure_[i] = clock.duration() > 0 ? impulse / clock.duration() : 0.0;
    });
}

std::vector<Transfer> ConwepLoad::apply(const Clock& clock)
{
    find_pushes(clock);
    Transfer given;
    given.from = "conwep";
    given.to = "structure";
    for (std::size_t i = 0; i < facets_.size(); ++i) {
        for (const std::uint32_t node : structure_.surface.facets[facets_[i]].node)
            given.energy += push_node(structure_.nodes, node, push_[i] / 3.0, clock.duration());
        given.momentum += push_[i];
        facet_impulse_[facets_[i]] += push_[i];
    }
    return {given};
}

FieldSet ConwepLoad::state()
{
    return {name(),
            {stored_field("specific_impulse", "Pa s", "what the blast has given, per area", specific_impulse_),
             stored_field("facet_impulse", "N s", "impulse of the blast on each facet since the start", facet_impulse_)}};
}

FieldSet ConwepLoad::facet_fields()
{
    const std::size_t count = facets_.size();
    FieldSet set{name() + " facets", {}};
    set.fields.push_back(derived_field<float>("specific_impulse", "Pa s", "what the blast has given, per area", count,
                                              [this](std::size_t i) { return static_cast<float>(specific_impulse_[i]); }));
    set.fields.push_back(derived_field<float>("pressure", "Pa", "blast pressure, mean over the last step", count,
                                              [this](std::size_t i) { return static_cast<float>(pressure_[i]); }));
    set.fields.push_back(derived_field<float>("peak_pressure", "Pa", "highest blast pressure of the pulse", count,
                                              [this](std::size_t i) { return static_cast<float>(loads_[i].peak()); }));
    set.fields.push_back(derived_field<float>("arrival", "s", "when the blast arrives", count, [this](std::size_t i) {
        return static_cast<float>(loads_[i].arrival() + detonation_time_);
    }));
    return set;
}

}  // namespace corpuscle
