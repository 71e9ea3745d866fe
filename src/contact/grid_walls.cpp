#include "contact/grid_walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "euler/cut.hpp"
#include "euler/wall_crossings.hpp"
#include "euler/wall_flux.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

GridWalls::GridWalls(EulerGrid& grid, Structure& structure)
    : grid_(grid), structure_(structure), facet_impulse_(structure.surface.facets.size())
{
}

bool GridWalls::any() const
{
    return grid_.cells() > 0 && !structure_.surface.facets.empty();
}

void GridWalls::begin()
{
    if (!any()) return;
    free_ = free_edges(structure_.surface);
    hidden_ = structure_.surface.hidden;
    cut_first(grid_, find_crossings(grid_, structure_.surface, free_, structure_.nodes.path().end));
}

/// Cuts the grid where the step has moved the surface.
void GridWalls::follow()
{
    if (free_.size() != structure_.surface.facets.size() || hidden_ != structure_.surface.hidden) {
        free_ = free_edges(structure_.surface);
        hidden_ = structure_.surface.hidden;
        grid_.walls.voids = !grid_.walls.solid.empty();  // where elements of solids have gone
    }
    const std::vector<WallCrossing> crossings = find_crossings(grid_, structure_.surface, free_, structure_.nodes.path().end);
    cut(grid_, crossings, swept_cells(grid_, structure_.surface, structure_.nodes.path()));
}

std::vector<Transfer> GridWalls::apply(const Clock& clock)
{
    Transfer given{"gas", "structure", 0, {}, 0};
    if (!any()) return {given};
    follow();
    const double duration = clock.duration();
    find_pushes(duration);
    for (const Push& push : pushes_) {
        const auto& node = structure_.surface.facets[push.crossing->facet].node;
        for (std::size_t i = 0; i < 3; ++i) structure_.nodes.push(node[i], push.crossing->weight[i] * push.impulse);
        facet_impulse_[push.crossing->facet] += push.impulse;
        given.momentum += push.impulse;
    }
    for_each(pushes_.size(), [&](std::size_t p) {
        Push& push = pushes_[p];
        push.work = 0.5 * dot(push.impulse, push.velocity + wall_velocity(*push.crossing));
    });
    for (const Push& push : pushes_) given.energy += push.work;
    give_sources(duration);
    return {given};
}

Vector3d GridWalls::wall_velocity(const WallCrossing& crossing) const
{
    const auto& node = structure_.surface.facets[crossing.facet].node;
    Vector3d velocity;
    for (std::size_t i = 0; i < 3; ++i) velocity += crossing.weight[i] * structure_.nodes.contact_velocity(node[i]);
    return velocity;
}

/// What the gas on each side of each wall presses on it in the step.
void GridWalls::find_pushes(double duration)
{
    const std::vector<WallFace>& faces = grid_.walls.faces;
    pushes_.assign(2 * faces.size(), {});
    for_each(faces.size(), [&](std::size_t f) {
        find_push(pushes_[2 * f], faces[f], true, duration);
        find_push(pushes_[2 * f + 1], faces[f], false, duration);
    });
    std::erase_if(pushes_, [](const Push& push) { return push.cell == no_cell; });
}

void GridWalls::find_push(Push& push, const WallFace& face, bool lower, double duration) const
{
    push.cell = lower ? face.lower : face.upper;
    if (push.cell != no_cell && grid_.walls.is_solid(push.cell)) push.cell = no_cell;
    if (push.cell == no_cell) return;
    push.crossing = lower ? &face.near_lower : &face.near_upper;
    const Vector3d area = lower ? face.area : -face.area;
    const double size = norm(area);
    push.velocity = wall_velocity(*push.crossing);
    const EulerCell cell = look(grid_, push.cell);
    const double pressure = wall_pressure(cell, size > 0 ? dot(cell.velocity - push.velocity, area) / size : 0.0);
    push.impulse = duration * pressure * area;
    push.swept = dot(push.velocity, area);
}

/// What walls and corners give to the cells beside them.
void GridWalls::give_sources(double duration)
{
    EulerWalls& walls = grid_.walls;
    for (const std::size_t cell : walls.source_cells) walls.source_of[cell] = -1;
    walls.source_cells.clear();
    walls.sources.clear();
    const auto source = [&](std::size_t cell) {
        std::int32_t& number = walls.source_of[cell];
        if (number < 0) {
            number = static_cast<std::int32_t>(walls.sources.size());
            walls.sources.emplace_back();
            walls.source_cells.push_back(cell);
        }
        return static_cast<std::size_t>(number);
    };
    for (const Push& push : pushes_) {
        WallSource& given = walls.sources[source(push.cell)];
        const CellState cell = cell_state(grid_, push.cell);
        given.momentum -= push.impulse / duration;
        given.energy -= push.work / duration;
        for (std::size_t m = 0; m < grid_.materials.size(); ++m)
            given.part[m] -= cell.mixture.share[m] * cell.mixture.pressure * push.swept;
    }
    for (const WallCorner& corner : walls.corners) {
        if (walls.is_solid(corner.from) || walls.is_solid(corner.to)) continue;
        const std::size_t from = source(corner.from), to = source(corner.to);
        flow_through(cell_state(grid_, corner.from), cell_state(grid_, corner.to), corner.area, walls.sources[from], walls.sources[to]);
    }
}

double GridWalls::stable_step() const
{
    if (!any()) return std::numeric_limits<double>::infinity();
    constexpr double part = 0.4;
    double least = std::numeric_limits<double>::infinity();
    for (const EulerAxis& axis : grid_.axes) {
        for (std::size_t c = 0; c < axis.cells() && !axis.inert(); ++c) least = std::min(least, axis.width(c));
    }
    const std::vector<Vector3d>& velocity = structure_.nodes.velocity;
    const double fastest = -minimum(velocity.size(), 0.0, [&](std::size_t n) { return -norm(velocity[n]); });
    return fastest > 0 ? part * least / fastest : std::numeric_limits<double>::infinity();
}

FieldSet GridWalls::state()
{
    if (!any()) return {name(), {}};
    FieldSet set{name(), {stored_field("facet_impulse", "N s", "impulse of the grid's gas on each facet since the start", facet_impulse_)}};
    set.fields.push_back(stored_field("solid", "1", "cells within solids", grid_.walls.solid));
    return set;
}

}  // namespace corpuscle
