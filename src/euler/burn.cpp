#include "euler/burn.hpp"

#include <algorithm>

#include "euler/relaxation.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

/// Materials with less than this share of a cell are not pushed aside by what burns there.
constexpr double least_pushed = 1e-8;
/// Cells that the front of a detonation is spread over.
constexpr double front_cells = 2.5;

/// How long the front takes to pass a cell [s].
double passing_time(const EulerGrid& grid, const EulerExplosive& explosive, std::size_t cell)
{
    const auto at = grid.place(cell);
    double width = 0;
    for (std::size_t d = 0; d < 3; ++d) {
        if (!grid.axes[d].inert()) width = std::max(width, grid.axes[d].width(at[d]));
    }
    return front_cells * width / explosive.detonation_velocity;
}

/// Share of the explosive at a cell that has burnt when the front, spread over some cells, has come so far.
double burnt_share(const EulerGrid& grid, const EulerExplosive& explosive, std::size_t cell, double time)
{
    if (time >= explosive.burnt_out) return 1;
    return std::clamp((time - burn_time(grid, explosive, cell)) / passing_time(grid, explosive, cell), 0.0, 1.0);
}

/// Gives heat to one material of a cell [J/m3]; where others are in the cell, it pushes them aside until all are in one pressure again.
void heat(EulerGrid& grid, std::size_t material, std::size_t c, double energy)
{
    const double pressure = look(grid, c).pressure;
    const auto part = [&](std::size_t m) {
        const MieGrueneisen& law = grid.laws[m];
        const double share = share_of(grid.now, m, c), mass = grid.now.mass[m][c], density = phase_density(law, mass, share);
        const double cold = law.cold ? law.cold_terms(density).q : 0;
        return PhasePart{&law, share, mass, share * (law.inverse_gamma(density) * pressure - cold)};
    };
    PhasePart own = part(material);
    own.energy += energy;
    grid.now.energy[c] += energy;
    for (std::size_t m = 0; m < grid.materials.size(); ++m) {
        const PhasePart other = part(m);
        if (m == material || other.share < least_pushed || own.share < least_pushed || !(other.mass > 0)) continue;
        const double share = relaxed_share(own, other), rest = own.share + other.share - share;
        if (material < grid.now.share.size()) grid.now.share[material][c] = share;
        if (m < grid.now.share.size()) grid.now.share[m][c] = rest;
        own.share = share;
    }
}

/// Burns one material.
EulerAmount burn_material(EulerGrid& grid, std::size_t material, double time)
{
    const EulerExplosive& explosive = grid.materials[material].explosive;
    std::vector<double>& waits = grid.now.unburnt[material];
    return sum_chunks<EulerAmount>(grid.cells(), [&](std::size_t begin, std::size_t end) {
        EulerAmount released;
        for (std::size_t c = begin; c < end; ++c) {
            if (waits[c] == 0) continue;
            const double left = std::min(waits[c], (1 - burnt_share(grid, explosive, c, time)) * grid.now.mass[material][c]);
            const double burnt = waits[c] - std::max(0.0, left);
            if (burnt == 0) continue;
            waits[c] -= burnt;
            heat(grid, material, c, burnt * explosive.held_energy);
            released.mass[material] += burnt * grid.volume(c);
            released.energy += burnt * explosive.energy * grid.volume(c);
        }
        return released;
    });
}

/// Whether anything of a material waits.
bool waits(const EulerGrid& grid, std::size_t material)
{
    const std::vector<double>& values = grid.now.unburnt[material];
    return sum<std::size_t>(values.size(), [&](std::size_t c) { return values[c] != 0 ? 1u : 0u; }) > 0;
}

}  // namespace

void plan_burning(EulerGrid& grid)
{
    for (std::size_t m = 0; m < grid.materials.size(); ++m) {
        EulerExplosive& explosive = grid.materials[m].explosive;
        const std::vector<double>& waiting = grid.now.unburnt[m];
        explosive.burnt_out = -minimum(waiting.size(), 0.0, [&](std::size_t c) {
            return waiting[c] > 0 ? -burn_time(grid, explosive, c) - passing_time(grid, explosive, c) : 0.0;
        });
    }
}

EulerAmount burn(EulerGrid& grid, double time)
{
    EulerAmount released;
    for (std::size_t m = 0; m < grid.materials.size(); ++m) {
        if (grid.now.unburnt[m].empty()) continue;
        released += burn_material(grid, m, time);
        if (!waits(grid, m)) {  // burnt out: nothing to carry along any more
            grid.now.unburnt[m].clear();
            grid.next.unburnt[m].clear();
        }
    }
    return released;
}

}  // namespace corpuscle
