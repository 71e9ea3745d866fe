#include "euler/mixed_cells.hpp"

#include <algorithm>
#include <cmath>

#include "euler/thinc.hpp"

namespace corpuscle {

namespace {

/// Shares below this one, or above one less it, leave a cell as none, or as all of it.
constexpr double least_leaving_share = 1e-8;
/// Most of a material of a cell that a step may take out of it.
constexpr double most_taken = 0.95;
/// Steepness of the smooth step at a face that lies across the interface's normal, and least one.
constexpr double interface_steepness = 2.3, least_steepness = 0.05;

/// How much of the difference to the cell's mean may leave through the faces so that a step does not take out more than there is of a
/// material [1].
double leave_to_take(const std::array<double, 6>& found, double share, const std::array<double, 6>& out)
{
    double volume = 0, taken = 0;
    for (std::size_t f = 0; f < 6; ++f) volume += out[f], taken += out[f] * found[f];
    const double mean = volume * share, most = most_taken * share;
    return taken > most && taken > mean ? std::max(0.0, (most - mean) / (taken - mean)) : 1.0;
}

}  // namespace

bool MixedCellFinder::is_mixed(std::size_t c) const
{
    for (std::size_t m = 0; m + 1 < materials; ++m) {
        if (share[m][c] >= least_leaving_share && share[m][c] <= 1 - least_leaving_share) return true;
    }
    return false;
}

std::size_t MixedCellFinder::place_in(int d, const std::array<std::ptrdiff_t, 3>& at) const
{
    return static_cast<std::size_t>(at[d] + static_cast<std::ptrdiff_t>(tile.axes[d].halo));
}

/// Share of the cell's volume that leaves through each face in the step.
MixedCellFinder::Shares MixedCellFinder::leaving_volumes(std::size_t c, const std::array<std::ptrdiff_t, 3>& at) const
{
    Shares out{};
    for (int d = 0; d < 3; ++d) {
        const TileAxis& axis = tile.axes[d];
        if (!axis.live) continue;
        const double* u = velocity[d] + c;
        const double crossing = length * axis.larger_face[place_in(d, at)];
        out[2 * d] = std::clamp(-0.5 * (u[0] + *(u - axis.stride)) * crossing, 0.0, 1.0);
        out[2 * d + 1] = std::clamp(0.5 * (u[0] + u[axis.stride]) * crossing, 0.0, 1.0);
    }
    return out;
}

MixedCell MixedCellFinder::mixed_cell(std::size_t c, const std::array<std::ptrdiff_t, 3>& at) const
{
    const Shares out = leaving_volumes(c, at);
    MixedCell cell;
    const std::size_t drawn = materials > 2 ? materials : 1;  // of two gases the second takes what the first leaves
    for (std::size_t m = 0; m < drawn; ++m) cell.face_share[m] = leaving_shares(c, at, share[m], out);
    complete(cell, drawn);
    bound(cell, c, out);
    return cell;
}

MixedCell MixedCellFinder::even_cell(std::size_t c) const
{
    MixedCell cell;
    for (std::size_t m = 0; m < materials; ++m) cell.face_share[m].fill(share[m][c]);
    return cell;
}

/// Draws what leaves towards the cell's mean where a step would take out more than there is of a material.
void MixedCellFinder::bound(MixedCell& cell, std::size_t c, const Shares& out) const
{
    double keep = 1;
    for (std::size_t m = 0; m < materials; ++m) keep = std::min(keep, leave_to_take(cell.face_share[m], share[m][c], out));
    if (keep == 1) return;
    for (std::size_t m = 0; m < materials; ++m)
        for (double& face : cell.face_share[m]) face = share[m][c] + keep * (face - share[m][c]);
}

/// Shares of one material that leave through each face by the smooth step along each axis; the cell's own where it is no step.
MixedCellFinder::Shares MixedCellFinder::leaving_shares(std::size_t c, const std::array<std::ptrdiff_t, 3>& at, const double* of,
                                                        const Shares& out) const
{
    std::array<double, 3> rise{};
    double steepest = 0;
    for (int d = 0; d < 3; ++d) {
        const TileAxis& axis = tile.axes[d];
        if (!axis.live) continue;
        rise[d] = (of[c + axis.stride] - of[c - axis.stride]) * axis.inverse_width[place_in(d, at)];
        steepest += rise[d] * rise[d];
    }
    Shares found;
    found.fill(of[c]);
    for (int d = 0; d < 3; ++d) {
        const TileAxis& axis = tile.axes[d];
        if (!axis.live) continue;
        const double before = of[c - axis.stride], behind = of[c + axis.stride];
        if (!((of[c] - before) * (behind - of[c]) > 0)) continue;
        const double steepness = interface_steepness * std::abs(rise[d]) / std::sqrt(steepest) + least_steepness;
        const SmoothStep step(before, of[c], behind, steepness);
        found[2 * d] = step.mean_near(false, out[2 * d]);
        found[2 * d + 1] = step.mean_near(true, out[2 * d + 1]);
    }
    return found;
}

/// Makes the shares at each face add up to one: of two gases the second takes what the first leaves, of more each its part.
void MixedCellFinder::complete(MixedCell& cell, std::size_t drawn) const
{
    for (std::size_t f = 0; f < 6; ++f) {
        double sum = 0;
        for (std::size_t m = 0; m < drawn; ++m) sum += cell.face_share[m][f];
        if (drawn < materials) cell.face_share[materials - 1][f] = 1 - std::min(1.0, sum);
        for (std::size_t m = 0; drawn == materials && m < drawn; ++m) cell.face_share[m][f] /= sum;
    }
}

}  // namespace corpuscle
