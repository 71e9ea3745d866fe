#include "euler/fill.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "euler/burn.hpp"
#include "euler/flow.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

/// Specific energy of a sample.
double energy_of(const EulerGrid& grid, const EulerSample& sample)
{
    return sample.energy > 0 ? sample.energy : grid.laws[sample.material].energy(sample.density, sample.pressure);
}

void check_sample(const EulerGrid& grid, const EulerSample& sample, const Vector3d& place)
{
    const bool known = sample.material < grid.materials.size();
    const bool right = known && sample.density > 0 && (sample.energy > 0 || sample.pressure > 0);
    if (right && !(sample.unburnt && !grid.materials[sample.material].explosive.burns())) return;
    throw InputError(fmt::format("no gas can be in the state at ({:g}, {:g}, {:g}) of the Euler grid", place.x, place.y, place.z),
                     "give a density and a pressure above 0, and a detonation velocity to what waits to burn");
}

/// Adds a sample that stands for the share `part` of a cell.
void add_sample(EulerGrid& grid, std::size_t cell, const EulerSample& sample, double part)
{
    EulerState& now = grid.now;
    const double mass = part * sample.density;
    now.mass[sample.material][cell] += mass;
    if (sample.material < now.share.size()) now.share[sample.material][cell] += part;
    for (int d = 0; d < 3; ++d) now.motion[d][cell] += mass * sample.velocity[d];
    now.energy[cell] += mass * (energy_of(grid, sample) + 0.5 * norm_squared(sample.velocity));
    if (sample.unburnt) now.unburnt[sample.material][cell] += mass;
}

/// Empties all cells.
void clear(EulerGrid& grid)
{
    const auto zero = [](std::vector<double>& values) { std::fill(values.begin(), values.end(), 0.0); };
    std::for_each(grid.now.mass.begin(), grid.now.mass.end(), zero);
    std::for_each(grid.now.motion.begin(), grid.now.motion.end(), zero);
    std::for_each(grid.now.share.begin(), grid.now.share.end(), zero);
    zero(grid.now.energy);
    for (std::size_t m = 0; m < grid.materials.size(); ++m) {
        grid.now.unburnt[m].assign(grid.materials[m].explosive.burns() ? grid.cells() : 0, 0.0);
    }
}

/// Where the n-th of `samples` points between two faces lies: at equal parts of the volume that the axis gives.
double point_between(const EulerAxis& axis, std::size_t cell, std::size_t n, std::size_t samples)
{
    const double share = (static_cast<double>(n) + 0.5) / static_cast<double>(samples), low = axis.faces[cell], high = axis.faces[cell + 1];
    if (!axis.curved) return low + share * (high - low);
    const double power = axis.area[cell + 1] == high ? 2 : 3;  // the area is the radius, or its square
    const double a = std::pow(low, power), b = std::pow(high, power);
    return std::pow(a + share * (b - a), 1 / power);
}

/// visit(point) for the points of a cell.
template <class Visit>
void for_points(const EulerGrid& grid, std::size_t cell, std::size_t samples, const Visit& visit)
{
    const auto at = grid.place(cell);
    std::array<std::size_t, 3> counts{};
    for (int d = 0; d < 3; ++d) counts[d] = grid.axes[d].inert() ? 1 : samples;
    for (std::size_t c = 0; c < counts[2]; ++c) {
        for (std::size_t b = 0; b < counts[1]; ++b) {
            for (std::size_t a = 0; a < counts[0]; ++a) {
                const auto point = [&](int d, std::size_t n) {
                    return counts[d] == 1 ? grid.axes[d].middle(at[d]) : point_between(grid.axes[d], at[d], n, counts[d]);
                };
                visit(Vector3d{point(0, a), point(1, b), point(2, c)});
            }
        }
    }
}

std::size_t point_count(const EulerGrid& grid, std::size_t samples)
{
    std::size_t count = 1;
    for (const EulerAxis& axis : grid.axes) count *= axis.inert() ? 1 : samples;
    return count;
}

/// Takes what burning adds from the state in which explosive waits, and the pressure floor from the least pressure laid out.
void note_state(EulerGrid& grid, const EulerSample& sample)
{
    if (sample.unburnt) {
        EulerExplosive& explosive = grid.materials[sample.material].explosive;
        explosive.held_energy = explosive.energy - energy_of(grid, sample);
    }
}

void finish(EulerGrid& grid)
{
    grid.pressure_floor = 0;
    double least = minimum(grid.cells(), std::numeric_limits<double>::max(), [&](std::size_t c) { return look(grid, c).pressure; });
    grid.pressure_floor = 1e-6 * std::max(least, std::numeric_limits<double>::min());
    grid.passages = {};
    grid.worked = 0;
    plan_burning(grid);
    prepare(grid);
}

/// The place in space of a point of the grid.
Vector3d in_space(const EulerGrid& grid, const Vector3d& point)
{
    if (grid.space == EulerSpace::planar) return point;
    if (grid.space == EulerSpace::axisymmetric) return {point.x, 0, point.y};
    return {point.x, 0, 0};
}

/// The cell as a box in space; in round grids, the part of the plane y = 0 that it is.
Box cell_box(const EulerGrid& grid, std::size_t cell)
{
    const auto at = grid.place(cell);
    Vector3d lower, upper;
    for (int d = 0; d < 3; ++d) lower[d] = grid.axes[d].faces[at[d]], upper[d] = grid.axes[d].faces[at[d] + 1];
    return {in_space(grid, lower), in_space(grid, upper)};
}

/// All of the space that the grid stands for.
Box whole_box(const EulerGrid& grid)
{
    const auto& axes = grid.axes;
    const double reach = axes[0].faces.back();
    if (grid.space == EulerSpace::planar) {
        return {{axes[0].faces[0], axes[1].faces[0], axes[2].faces[0]}, {reach, axes[1].faces.back(), axes[2].faces.back()}};
    }
    if (grid.space == EulerSpace::axisymmetric) return {{-reach, -reach, axes[1].faces[0]}, {reach, reach, axes[1].faces.back()}};
    return {{-reach, -reach, -reach}, {reach, reach, reach}};
}

/// What share of each cell each fill takes.
class Shares {
public:
    Shares(const EulerGrid& grid, const std::vector<EulerFill>& fills, std::size_t samples)
        : grid_(grid), fills_(fills), samples_(samples), of_cell_(grid.cells())
    {
        for (const EulerFill& fill : fills) bounds_.push_back(fill.shape.bounds());
        for_each_dynamic(grid.cells(), 1024, [&](std::size_t c) { of_cell_[c] = shares_in(c); });
        for (std::size_t c = 0; c < grid.cells(); ++c) {
            if (of_cell_[c].only == none) refuse(c);
        }
    }

    /// Shares of a cell: one number, the fill it lies in, or a share for each fill.
    struct Cell {
        std::size_t only = 0;
        std::vector<double> shares;
    };
    [[nodiscard]] const Cell& of(std::size_t cell) const { return of_cell_[cell]; }

    /// Moves the boundary of a fill within the cells it crosses so that its volume is exact: by as much of a (1 - a) as is needed, which
    /// leaves every share a between 0 and 1.
    void correct(std::size_t fill, double exact)
    {
        double volume = 0, room = 0;
        for (std::size_t c = 0; c < of_cell_.size(); ++c) {
            const Cell& cell = of_cell_[c];
            if (cell.shares.empty()) {
                if (cell.only == fill) volume += grid_.volume(c);
                continue;
            }
            const double share = cell.shares[fill];
            volume += share * grid_.volume(c);
            room += share * (1 - share) * grid_.volume(c);
        }
        if (room == 0) return;
        const double factor = std::clamp((exact - volume) / room, -0.9, 0.9);
        for (Cell& cell : of_cell_) {
            if (cell.shares.empty()) continue;
            const double share = cell.shares[fill], wanted = share + factor * share * (1 - share);
            const double rest = share < 1 ? (1 - wanted) / (1 - share) : 1;
            for (double& other : cell.shares) other *= rest;
            cell.shares[fill] = wanted;
        }
    }

    /// Whether nothing is laid over a fill.
    [[nodiscard]] bool uncut(std::size_t fill) const
    {
        for (std::size_t f = fill + 1; f < fills_.size(); ++f) {
            if (bounds_[f].overlaps(bounds_[fill])) return false;
        }
        return true;
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    [[noreturn]] void refuse(std::size_t c) const
    {
        const Vector3d place = in_space(grid_, grid_.middle(c));
        throw InputError(fmt::format("nothing fills the Euler grid near ({:g}, {:g}, {:g})", place.x, place.y, place.z),
                         "fill the whole grid first, then lay charges over it");
    }
    /// The last fill that holds a point; `none` if no fill does.
    [[nodiscard]] std::size_t fill_at(const Vector3d& place) const
    {
        for (std::size_t f = fills_.size(); f-- > 0;) {
            if (fills_[f].shape.contains(place)) return f;
        }
        return none;
    }
    /// Whether a shape that holds the corners of a box is sure to hold the box, or not to meet it: 1, 0; -1: not sure.
    [[nodiscard]] int certain(std::size_t fill, const Box& box) const
    {
        if (!bounds_[fill].overlaps(box)) return 0;
        for (int corner = 0; corner < 8; ++corner) {
            const Vector3d place{corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
                                 corner & 4 ? box.upper.z : box.lower.z};
            if (!fills_[fill].shape.contains(place)) return -1;
        }
        return 1;
    }
    [[nodiscard]] Cell shares_in(std::size_t c) const
    {
        const Box box = cell_box(grid_, c);
        for (std::size_t f = fills_.size(); f-- > 0;) {
            const int sure = certain(f, box);
            if (sure == 1) return {f, {}};
            if (sure == -1) break;
        }
        Cell cell{0, std::vector<double>(fills_.size(), 0.0)};
        const double part = 1.0 / static_cast<double>(point_count(grid_, samples_));
        for_points(grid_, c, samples_, [&](const Vector3d& point) {
            const std::size_t found = fill_at(in_space(grid_, point));
            if (found == none)
                cell.only = none;
            else
                cell.shares[found] += part;
        });
        if (cell.only == none) return cell;
        for (std::size_t f = 0; f < fills_.size(); ++f) {
            if (cell.shares[f] > 1 - 0.5 * part) return {f, {}};
        }
        return cell;
    }

    const EulerGrid& grid_;
    const std::vector<EulerFill>& fills_;
    std::size_t samples_;
    std::vector<Box> bounds_;
    std::vector<Cell> of_cell_;
};

}  // namespace

void fill(EulerGrid& grid, const std::function<EulerSample(const Vector3d&)>& sample, std::size_t samples)
{
    clear(grid);
    const double part = 1.0 / static_cast<double>(point_count(grid, samples));
    for (std::size_t c = 0; c < grid.cells(); ++c) {
        for_points(grid, c, samples, [&](const Vector3d& point) {
            const EulerSample state = sample(point);
            check_sample(grid, state, point);
            note_state(grid, state);
            add_sample(grid, c, state, part);
        });
    }
    finish(grid);
}

void fill(EulerGrid& grid, const std::vector<EulerFill>& fills, std::size_t samples)
{
    clear(grid);
    for (const EulerFill& fill : fills) {
        check_sample(grid, fill.state, fill.shape.bounds().center());
        note_state(grid, fill.state);
    }
    Shares shares(grid, fills, samples);
    for (std::size_t f = 0; f < fills.size(); ++f) {
        const auto same = [&](const EulerFill& other) { return other.state.material == fills[f].state.material; };
        const bool alone = fills[f].state.unburnt || std::count_if(fills.begin(), fills.end(), same) == 1;
        if (!alone || !shares.uncut(f)) continue;
        shares.correct(f, fills[f].shape.volume_within(whole_box(grid)));
    }
    for_each(grid.cells(), [&](std::size_t c) {
        const auto& cell = shares.of(c);
        if (cell.shares.empty()) return add_sample(grid, c, fills[cell.only].state, 1);
        for (std::size_t f = 0; f < fills.size(); ++f) {
            if (cell.shares[f] > 0) add_sample(grid, c, fills[f].state, cell.shares[f]);
        }
    });
    finish(grid);
}

void fill_at_middles(EulerGrid& grid, const std::vector<EulerFill>& fills, const std::vector<std::size_t>& cells)
{
    for (const std::size_t c : cells) {
        const auto waits = [&](const std::vector<double>& values) { return !values.empty() && values[c] > 0; };
        if (std::any_of(grid.now.unburnt.begin(), grid.now.unburnt.end(), waits)) continue;
        const Vector3d middle = in_space(grid, grid.middle(c));
        const auto last = std::find_if(fills.rbegin(), fills.rend(), [&](const EulerFill& fill) { return fill.shape.contains(middle); });
        if (last == fills.rend() || last->state.unburnt) continue;
        for (auto& mass : grid.now.mass) mass[c] = 0;
        for (auto& motion : grid.now.motion) motion[c] = 0;
        for (auto& share : grid.now.share) share[c] = 0;
        grid.now.energy[c] = 0;
        add_sample(grid, c, last->state, 1);
    }
}

}  // namespace corpuscle
