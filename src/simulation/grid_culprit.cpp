#include "simulation/grid_culprit.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "model/grid_books.hpp"

namespace corpuscle {

namespace {

std::string cell_text(const EulerGrid& grid, std::size_t cell)
{
    const auto at = grid.place(cell);
    const Vector3d middle = in_space(grid.space, grid.middle(cell));
    const EulerCell state = look(grid, cell);
    return fmt::format(
        "({}, {}, {}) of the grid, around ({:.4g}, {:.4g}, {:.4g}) m: density {:.4g} kg/m3, pressure {:.4g} Pa, speed {:.4g} m/s", at[0],
        at[1], at[2], middle.x, middle.y, middle.z, state.density, state.pressure, norm(state.velocity));
}

bool is_finite(const EulerState& state, std::size_t cell)
{
    const auto good = [cell](const std::vector<double>& values) { return values.empty() || std::isfinite(values[cell]); };
    return good(state.energy) && std::all_of(state.mass.begin(), state.mass.end(), good) &&
           std::all_of(state.motion.begin(), state.motion.end(), good) && std::all_of(state.share.begin(), state.share.end(), good);
}

}  // namespace

std::string not_finite_cell(const EulerGrid& grid)
{
    for (std::size_t c = 0; c < grid.cells(); ++c)
        if (!is_finite(grid.now, c)) return ": cell " + cell_text(grid, c);
    return "";
}

std::string fastest_cell(const EulerGrid& grid)
{
    std::size_t fastest = 0;
    double most = -1;
    for (std::size_t c = 0; c < grid.cells(); ++c) {
        const EulerCell state = look(grid, c);
        const double speed = norm(state.velocity) + state.sound_speed;
        if (speed > most) fastest = c, most = speed;
    }
    return grid.cells() > 0 ? "the fastest cell is " + cell_text(grid, fastest) : "";
}

}  // namespace corpuscle
