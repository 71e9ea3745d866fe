#include "input/build.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "input/grid_gauges.hpp"
#include "input/known_blast.hpp"
#include "input/placed.hpp"

namespace corpuscle {

namespace {

std::uint32_t part_index(const Structure& structure, const std::string& name)
{
    const auto found = std::find_if(structure.parts.begin(), structure.parts.end(), [&](const Part& part) { return part.name == name; });
    return static_cast<std::uint32_t>(found - structure.parts.begin());
}

/// The node nearest to a point; of equals one of a part that can move.
std::uint32_t probed_node(const Structure& structure, const Vector3d& point)
{
    std::uint32_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (const bool rigid : {false, true}) {
        for (const Part& part : structure.parts) {
            if (part.rigid() != rigid) continue;
            for (std::uint32_t node = part.first_node; node < part.first_node + part.node_count; ++node) {
                const double distance = norm(structure.nodes.reference[node] - point);
                if (distance < least) {
                    least = distance;
                    nearest = node;
                }
            }
        }
    }
    return nearest;
}

bool has(const ProbeInput& input, ProbeQuantity quantity)
{
    return std::find(input.quantities.begin(), input.quantities.end(), quantity) != input.quantities.end();
}

Probe make_probe(const ProbeInput& input, const Structure& structure, double end_time, std::vector<std::string>& warnings)
{
    Probe probe{input.name,
                probed_node(structure, input.node_at),
                has(input, ProbeQuantity::displacement),
                has(input, ProbeQuantity::velocity),
                interval_of(input.every, end_time),
                {}};
    if (input.reference)
        probe.reference = Reference{input.reference->value, static_cast<int>(input.reference->component), input.reference->label};
    Box bounds;
    for (const Vector3d& place : structure.nodes.reference) bounds.include(place);
    const double away = norm(structure.nodes.reference[probe.node] - input.node_at);
    if (away > 0.05 * norm(bounds.size()))
        warnings.push_back(fmt::format("probe '{}': the nearest node is {:.3g} m away", input.name, away));
    return probe;
}

/// The region of the gas that a gauge sees; a point is a ball of `point_radius`.
Shape shape_of(const GaugeInput& input, double point_radius)
{
    if (input.point) return Shape::sphere(*input.point, point_radius);
    if (input.sphere) return Shape::sphere(input.sphere->center, input.sphere->radius);
    return Shape::box(box_of(*input.box));
}

RegionGauge region_of(const Shape& shape, const Domain& domain, const GaugeInput& input)
{
    const double volume = shape.volume_within(domain.box);
    if (!(volume > 0) || (input.point && !domain.box.contains(*input.point)))
        throw InputError(fmt::format("gauge '{}' lies outside the gas box", input.name), "expected it within the box of [gas]",
                         input.places.own);
    return {shape, volume};
}

Gauge make_gauge(const GaugeInput& input, const Model& model, double point_radius)
{
    const double every = interval_of(input.every, model.end_time);
    const Place& place = input.places.own;
    const Domain& domain = model.gas.domain;
    return at_place(place, [&]() -> Gauge {
        if (input.facets) return {input.name, PartGauge{part_index(model.structure, *input.facets)}, every};
        if (!input.face) return {input.name, region_of(shape_of(input, point_radius), domain, input), every};
        const int face = static_cast<int>(*input.face);
        if (domain.edges[static_cast<std::size_t>(face)] != Edge::rigid)
            throw InputError(fmt::format("gauge '{}' is on a face of the gas box that is not rigid", input.name),
                             "expected a face whose edge is \"rigid\"", input.places.of("face"));
        return {input.name, FaceGauge{face}, every};
    });
}

void add_conwep(Model& model, const LoadInput& input)
{
    const ConwepInput& conwep = *input.conwep;
    const Burst burst = conwep.burst == BurstInput::spherical ? Burst::spherical : Burst::hemispherical;
    const Shadow shadow = conwep.shadow == ShadowInput::nothing ? Shadow::nothing : Shadow::incident;
    add_conwep(model, part_index(model.structure, input.part), {conwep.mass, conwep.center, burst, conwep.time, shadow});
}

void add_load(Model& model, const LoadInput& input, const PlannedLoad& planned)
{
    at_place(input.places.own, [&] {
        if (input.conwep) return add_conwep(model, input);
        if (input.pressure)
            model.loads.push_back(std::make_unique<PressureLoad>(model.structure, planned.where, planned.curve));
        else
            model.loads.push_back(std::make_unique<ForceLoad>(model.structure, planned.where, *input.direction, planned.curve));
    });
}

/// Gases that a wall divides are not mixed in the cells that it cuts.
void divide_by_walls(Model& model, const EulerPlan& plan)
{
    if (!model.grid_walls.any()) return;
    model.grid_walls.begin();
    std::vector<std::size_t> cells;
    for (const WallFace& face : model.euler.walls.faces) {
        for (const std::size_t cell : {face.lower, face.upper})
            if (cell != no_cell) cells.push_back(cell);
    }
    if (!plan.start) fill_at_middles(model.euler, plan.fills, cells);
}

OutputSettings make_output(const CaseDescription& description)
{
    const OutputInput& input = description.output;
    OutputSettings output;
    output.fields_every = input.fields_every.value_or(description.end_time / 30);
    output.history_every = input.energies_every.value_or(description.end_time / 300);
    output.restart_every = input.restart_every;
    output.particles_shown = input.particles_shown;
    output.averages = input.averages;
    output.compress = input.compress;
    return output;
}

}  // namespace

std::unique_ptr<Model> build(const CaseDescription& description, CaseSurvey& survey)
{
    const double start_time = survey.gas && survey.gas->start       ? survey.gas->start->time
                              : survey.euler && survey.euler->start ? survey.euler->start->time
                                                                    : 0;
    const double point_radius = survey.gas ? survey.gas->point_radius() : 0;
    Gas gas = survey.gas ? at_place(description.gas->places.own, [&] { return fill_gas(std::move(*survey.gas)); }) : Gas{};
    auto model = std::make_unique<Model>(std::move(gas), std::move(survey.structure));
    model->title = description.title;
    model->start_time = start_time;
    model->end_time = description.end_time;
    model->output = make_output(description);
    for (std::size_t i = 0; i < description.loads.size(); ++i) add_load(*model, description.loads[i], survey.loads[i]);
    if (norm(description.gravity) > 0) model->loads.push_back(std::make_unique<GravityLoad>(model->structure, description.gravity));
    let_sleep_beside_structure(*model);
    for (const ProbeInput& probe : description.probes)
        model->probes.push_back(make_probe(probe, model->structure, model->end_time, survey.warnings));
    if (survey.euler) model->euler = at_place(description.euler->places.own, [&] { return fill_grid(*survey.euler); });
    if (survey.euler) divide_by_walls(*model, *survey.euler);
    for (const GaugeInput& gauge : description.gauges)
        model->gauges.push_back(survey.euler && !gauge.facets ? make_grid_gauge(gauge, model->euler, model->end_time)
                                                              : make_gauge(gauge, *model, point_radius));
    model->known_blast = known_blast(description);
    return model;
}

std::unique_ptr<Model> build(const CaseDescription& description)
{
    CaseSurvey survey = survey_case(description);
    return build(description, survey);
}

}  // namespace corpuscle
