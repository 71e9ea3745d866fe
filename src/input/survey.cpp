#include "input/survey.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "input/check_names.hpp"
#include "input/grid_start.hpp"
#include "input/memory.hpp"

namespace corpuscle {

namespace {

/// Refuses what this machine cannot hold. Called before the meshes are made, and again when the elements are counted.
std::size_t check_room(const CaseDescription& description, const CaseSurvey& survey)
{
    const Place& place = description.gas     ? description.gas->places.of("particles")
                         : description.euler ? description.euler->places.of(description.euler->cell_size ? "cell_size" : "cells")
                                             : description.places.own;
    ModelSize size;
    size.elements = survey.structure.element_count();
    if (survey.gas) size.particles = survey.gas->particles();
    if (survey.euler) {
        size.cells = survey.euler->cells();
        size.gases = survey.euler->materials.size();
        size.walls = !description.parts.empty();
    }
    return check_memory(size, place, machine_memory());
}

void warn_of_room(CaseSurvey& survey)
{
    const std::size_t free = machine_memory().available;
    if (free > 0 && survey.memory > free)
        survey.warnings.push_back(
            fmt::format("the run needs about {}, of which only {} are free now", bytes_text(survey.memory), bytes_text(free)));
}

void check_products(const CaseDescription& description)
{
    const ParticleCounts& counts = description.gas->particles;
    const Place& place = description.gas->places.of("particles");
    if (counts.total) return;
    if (!description.charges.empty() && !counts.products)
        throw InputError("there are charges but no particles for their products",
                         "expected particles = 200_000, or { products = 100_000, air = 100_000 }", place);
    if ((description.gas->fill || !description.fills.empty()) && !counts.air)
        throw InputError("there is gas besides the charges but no particles for it",
                         "expected particles = 200_000, or { products = 100_000, air = 100_000 }", place);
}

/// Runs can differ by their seed only if there is gas, and each needs a seed of its own.
void check_ensemble(const CaseDescription& description)
{
    if (description.ensemble == 1) return;
    const Place& place = description.places.of("ensemble");
    if (!description.gas)
        throw InputError("an ensemble without gas of particles would be the same run again and again", "expected [gas], or ensemble = 1",
                         place);
    constexpr std::uint64_t last = 9'000'000'000'000'000;  // as in the range of gas.seed
    if (description.gas->seed > last - static_cast<std::uint64_t>(description.ensemble))
        throw InputError("the ensemble runs out of seeds", "expected a smaller gas.seed", place);
}

/// Stable step and growth time of one fill: the spacing grows as the cloud spreads at its thermal speed.
struct GasPace {
    double first_step;   ///< [s]
    double growth_time;  ///< [s]
};

GasPace pace_of(const GasPlan& plan, std::size_t i)
{
    const Fill& fill = plan.fills[i];
    const Species& species = plan.gas.species[fill.species];
    const double spacing = std::cbrt(species.particle_mass / fill.density);
    const double speed = std::sqrt(3 * (heat_capacity_ratio(species.law) - 1) * fill.energy_per_mass);
    const double size = std::cbrt(plan.masses[i] / fill.density);
    return {plan.gas.settings.cfl * spacing / (1.8 * speed), fill.charge >= 0 ? size / speed : std::numeric_limits<double>::infinity()};
}

}  // namespace

CaseSurvey survey_case(const CaseDescription& description)
{
    check_names(description);
    check_ensemble(description);
    CaseSurvey survey;
    if (description.gas) {
        check_products(description);
        survey.gas = plan_gas(description, survey.warnings);
    }
    if (description.euler) survey.euler = plan_euler(description, survey.warnings);
    check_room(description, survey);
    StructureNotes notes;
    survey.structure = build_structure(description, notes);
    survey.warnings.insert(survey.warnings.end(), notes.warnings.begin(), notes.warnings.end());
    survey.parts = std::move(notes.parts);
    survey.loads = std::move(notes.loads);
    survey.memory = check_room(description, survey);
    warn_of_room(survey);
    if (survey.euler && description.euler->start == StartRule::spherical) plan_grid_start(*survey.euler, survey.structure, description);
    if (survey.gas) check_charges_apart(*survey.gas, survey.structure, description);
    if (survey.gas && description.gas->start == StartRule::spherical)
        survey.gas->start = solve_spherical_start(*survey.gas, survey.structure, description);
    return survey;
}

double expected_steps(const CaseSurvey& survey, double end_time)
{
    std::vector<GasPace> paces;
    if (survey.gas)
        for (std::size_t i = 0; i < survey.gas->fills.size(); ++i) paces.push_back(pace_of(*survey.gas, i));
    const double structure_step = stable_step(survey.structure);
    double steps = 0;
    constexpr int pieces = 1000;
    for (int piece = 0; piece < pieces; ++piece) {
        const double time = end_time * (piece + 0.5) / pieces;
        double step = structure_step;
        if (survey.euler) step = std::min(step, expected_grid_step(*survey.euler, time));
        for (const GasPace& pace : paces) step = std::min(step, pace.first_step * (1 + time / pace.growth_time));
        steps += end_time / pieces / std::min(step, end_time);
    }
    return std::ceil(steps);
}

}  // namespace corpuscle
