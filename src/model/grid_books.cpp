#include "model/grid_books.hpp"

#include <numeric>

namespace corpuscle {

namespace {

/// Momentum as a vector in space: what points away from an axis or a center all round is nothing in sum.
Vector3d summed_round(EulerSpace space, const Vector3d& momentum)
{
    if (space == EulerSpace::planar) return momentum;
    return {0, 0, space == EulerSpace::axisymmetric ? momentum.y : 0.0};
}

double extent(const EulerAxis& axis)
{
    return std::accumulate(axis.volume.begin(), axis.volume.end(), 0.0);
}

}  // namespace

Vector3d in_space(EulerSpace space, const Vector3d& vector)
{
    if (space == EulerSpace::planar) return vector;
    return {vector.x, 0, space == EulerSpace::axisymmetric ? vector.y : 0.0};
}

Holding held(const EulerGrid& grid)
{
    const EulerContents inside = contents(grid);
    return {inside.gas.whole_mass() + inside.explosive.whole_mass(), summed_round(grid.space, inside.gas.momentum),
            inside.gas.energy + inside.explosive.energy};
}

std::vector<Transfer> given_to_edges(const EulerGrid& grid, const EulerPassages& before)
{
    std::vector<Transfer> given;
    for (std::size_t face = 0; face < euler_face_count; ++face) {
        if (grid.axes[face / 2].cells() < 2) continue;  // nothing flows there
        const EulerAmount &now = grid.passages[face], &then = before[face];
        given.push_back({"gas", grid.edges[face] == EulerEdge::rigid ? "rigid edge" : "open edge", now.whole_mass() - then.whole_mass(),
                         summed_round(grid.space, now.momentum - then.momentum), now.energy - then.energy});
    }
    return given;
}

Transfer given_by_burning(const EulerAmount& released)
{
    return {"explosive", "gas", released.whole_mass(), {}, released.energy};
}

double face_area(const EulerGrid& grid, int face)
{
    const int d = face / 2;
    const EulerAxis& axis = grid.axes[static_cast<std::size_t>(d)];
    const double own = face % 2 == 0 ? axis.area.front() : axis.area.back();
    return grid.round() * own * extent(grid.axes[static_cast<std::size_t>((d + 1) % 3)]) *
           extent(grid.axes[static_cast<std::size_t>((d + 2) % 3)]);
}

}  // namespace corpuscle
