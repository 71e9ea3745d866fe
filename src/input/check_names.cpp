#include "input/check_names.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "schema/nearest.hpp"

namespace corpuscle {

namespace {

/// Names are columns of tables and words of files: none may be empty or given twice.
template <class Named>
void check_unique(const std::vector<Named>& things, const char* what, Problems& problems)
{
    for (std::size_t i = 0; i < things.size(); ++i) {
        const Place& place = things[i].places.of("name");
        if (things[i].name.empty()) problems.add(fmt::format("a {} has an empty name", what), "expected a word", place);
        const auto same = [&](const Named& earlier) { return earlier.name == things[i].name; };
        if (std::any_of(things.begin(), things.begin() + static_cast<std::ptrdiff_t>(i), same))
            problems.add(fmt::format("a second {} is called '{}'", what, things[i].name), "expected a name of its own", place);
    }
}

void check_part(const CaseDescription& description, const std::string& name, const Place& place, Problems& problems)
{
    std::vector<std::string> names;
    for (const PartInput& part : description.parts) names.push_back(part.name);
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    problems.add(fmt::format("there is no part '{}'", name), names.empty() ? "the case has no [[part]]" : suggestion(name, names), place);
}

/// A load is on a part that there is, and says no more than its kind needs.
void check_load(const CaseDescription& description, const LoadInput& load, Problems& problems)
{
    check_part(description, load.part, load.places.of("part"), problems);
    if (load.force && !load.direction)
        problems.add("a force has no direction", "expected direction = [0, 0, 1] or another", load.places.own);
    if (!load.force && load.direction)
        problems.add("only a force has a direction", "expected force, or no direction", load.places.of("direction"));
    if (load.conwep && load.where != "all")
        problems.add("the load of ConWep is on all of a part", "expected no 'where', or a part of its own", load.places.of("where"));
}

void check_gauges(const CaseDescription& description, Problems& problems)
{
    for (const GaugeInput& gauge : description.gauges) {
        if (gauge.facets) check_part(description, *gauge.facets, gauge.places.of("facets"), problems);
        if (!gauge.facets && !description.gas && !description.euler)
            problems.add(fmt::format("gauge '{}' measures gas, but there is none", gauge.name), "expected a [gas], or a gauge on facets",
                         gauge.places.own);
    }
}

/// The grid stands alone: no particles beside it, and parts only in space.
void check_grid(const CaseDescription& description, Problems& problems)
{
    if (!description.euler) return;
    if (description.gas)
        problems.add("there are both [gas] and [euler]: the same gas would be there twice",
                     "expected one of them: particles ([gas]) or a grid ([euler])", description.euler->places.own);
    const bool round = description.euler->symmetry != EulerSpace::planar;
    for (const PartInput& part : description.parts) {
        if (round)
            problems.add(fmt::format("part '{}' stands beside [euler] with a symmetry: parts meet grids in space only", part.name),
                         "expected [euler] without symmetry (planes of symmetry are rigid edges), or [gas] in its place", part.places.own);
    }
}

void check_whole(const CaseDescription& description, Problems& problems)
{
    if (!description.gas && !description.euler && description.parts.empty())
        problems.add("there is neither [gas] nor [euler] nor [[part]]: nothing to simulate",
                     "expected one of them; `corpuscle new plate` writes a case to start from", description.places.own);
    if (description.gas || description.euler) return;
    for (const ChargeInput& charge : description.charges)
        problems.add("there is a [[charge]] but no [gas] for its products", "expected a [gas] with box and particles", charge.places.own);
    for (const FillInput& fill : description.fills)
        problems.add("there is a [[fill]] but no [gas]", "expected a [gas] with box and particles", fill.places.own);
}

}  // namespace

void check_names(const CaseDescription& description)
{
    Problems problems;
    check_unique(description.parts, "part", problems);
    check_unique(description.probes, "probe", problems);
    check_unique(description.gauges, "gauge", problems);
    for (const LoadInput& load : description.loads) check_load(description, load, problems);
    for (const ProbeInput& probe : description.probes) {
        if (description.parts.empty())
            problems.add(fmt::format("probe '{}' needs a node, but the case has no [[part]]", probe.name), "expected a part, or no probe",
                         probe.places.own);
        if (probe.quantities.empty())
            problems.add(fmt::format("probe '{}' records nothing", probe.name), "expected quantities = [\"displacement\"]",
                         probe.places.of("quantities"));
    }
    check_gauges(description, problems);
    check_grid(description, problems);
    check_whole(description, problems);
    problems.raise();
}

}  // namespace corpuscle
