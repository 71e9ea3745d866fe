#include "euler/cut.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace corpuscle {

namespace {

/// Least room of a cell between walls that face each other, over its volume without walls.
constexpr double least_room = 0.2;
/// Least part of a neighbour that a cell begins with on its new side, if its neighbours have had no room in it.
constexpr double least_lent = 0.05;
/// The part of its neighbours that a cell of a hollow begins with.
constexpr double drawn_in = 0.5;

/// The faces of a cell: six, lower and upper along each axis. Whether each is open.
using OpenFaces = std::array<bool, 6>;

void make_arrays(EulerGrid& grid)
{
    EulerWalls& walls = grid.walls;
    if (walls.any()) return;
    walls.room.assign(grid.cells(), 1.0);
    walls.room_next = walls.room;
    walls.source_of.assign(grid.cells(), -1);
    for (int d = 0; d < 3; ++d) {
        std::array<std::size_t, 3> end{grid.axes[0].cells(), grid.axes[1].cells(), grid.axes[2].cells()};
        ++end[static_cast<std::size_t>(d)];
        walls.open[static_cast<std::size_t>(d)].assign(end[0] * end[1] * end[2], 1.0);
        walls.shut[static_cast<std::size_t>(d)].assign(end[0] * end[1] * end[2], -1);
    }
}

/// The shut face that some crossings between the same two cells make; `near_lower` and `near_upper` are the outermost of them.
WallFace make_face(const EulerGrid& grid, const WallCrossing& near_lower, const WallCrossing& near_upper)
{
    const int d = near_lower.axis;
    const EulerAxis& axis = grid.axes[static_cast<std::size_t>(d)];
    WallFace face{near_lower, near_upper, no_cell, no_cell, place_of_face(grid, d, near_lower.face), 0, 0, 0, {}, {}, false};
    const std::size_t at = face.place[static_cast<std::size_t>(d)];
    std::array<std::size_t, 3> below = face.place;
    if (at > 0) below[static_cast<std::size_t>(d)] = at - 1, face.lower = grid.cell(below[0], below[1], below[2]);
    if (at < axis.cells()) face.upper = grid.cell(face.place[0], face.place[1], face.place[2]);
    const double plane = axis.faces[at];
    face.lower_length = near_lower.place - (at > 0 ? axis.middle(at - 1) : plane);
    face.upper_length = (at < axis.cells() ? axis.middle(at) : plane) - near_upper.place;
    const bool inside = face.lower != no_cell && face.upper != no_cell;
    face.shift = inside ? 0.5 * (near_lower.place + near_upper.place) - plane : 0;
    face.normal = normalized(near_lower.normal + near_upper.normal);
    double breadth = 1;
    for (int e = 0; e < 3; ++e) {
        if (e != d)
            breadth *= grid.axes[static_cast<std::size_t>(e)].width(
                std::min(face.place[static_cast<std::size_t>(e)], grid.axes[static_cast<std::size_t>(e)].cells() - 1));
    }
    face.area[d] = breadth;
    return face;
}

/// Opens all faces again.
void clear(EulerWalls& walls)
{
    for (const WallFace& face : walls.faces) walls.shut[face.near_lower.axis][face.near_lower.face] = -1;
    for (const std::size_t cell : walls.touched) walls.room_next[cell] = 1;
    for (const auto& [axis, face] : walls.widened) walls.open[axis][face] = 1;
    walls.faces.clear();
    walls.widened.clear();
}

void shut_faces(EulerGrid& grid, const std::vector<WallCrossing>& crossings)
{
    EulerWalls& walls = grid.walls;
    for (std::size_t first = 0; first < crossings.size();) {
        std::size_t last = first;
        const auto same = [&](const WallCrossing& other) {
            return other.axis == crossings[first].axis && other.face == crossings[first].face;
        };
        while (last + 1 < crossings.size() && same(crossings[last + 1])) ++last;
        walls.shut[crossings[first].axis][crossings[first].face] = static_cast<std::int32_t>(walls.faces.size());
        walls.faces.push_back(make_face(grid, crossings[first], crossings[last]));
        walls.faces.back().beyond_rim =
            std::all_of(crossings.begin() + static_cast<std::ptrdiff_t>(first), crossings.begin() + static_cast<std::ptrdiff_t>(last + 1),
                        [](const WallCrossing& c) { return c.beyond_rim; });
        first = last + 1;
    }
}

/// Whether the two cells of a shut face are joined all the same, by three open faces around one of its edges.
bool joined_around(const EulerGrid& grid, const WallFace& face)
{
    const std::size_t d = face.near_lower.axis;
    std::array<std::size_t, 3> lower = face.place;
    --lower[d];
    const auto open = [&](std::size_t axis, const std::array<std::size_t, 3>& above) {
        return grid.walls.shut[axis][grid.face_number(static_cast<int>(axis), above)] < 0;
    };
    for (std::size_t e = 0; e < 3; ++e) {
        for (const std::size_t side : {0u, 1u}) {
            if (e == d || (side == 0 ? lower[e] == 0 : lower[e] + 1 == grid.axes[e].cells())) continue;
            auto from = lower, to = face.place, beside = face.place;  // the faces from both cells to those beside, and between these
            from[e] += side, to[e] += side;
            beside[e] = side == 0 ? beside[e] - 1 : beside[e] + 1;
            if (open(e, from) && open(e, to) && open(d, beside)) return true;
        }
    }
    return false;
}

/// Opens again what only a rim's reach has shut and no slit asks for: faces whose cells are joined around them anyway, so that no two cells
/// come together that were apart. Else the rim of a wall that lies almost along the grid would stand up as a dam of a cell's height.
void open_beside_rims(EulerGrid& grid)
{
    EulerWalls& walls = grid.walls;
    std::vector<std::uint8_t> opens(walls.faces.size(), 0);
    for (std::size_t n = 0; n < walls.faces.size(); ++n) {
        const WallFace& face = walls.faces[n];
        opens[n] = face.beyond_rim && face.lower != no_cell && face.upper != no_cell && joined_around(grid, face) ? 1 : 0;
    }
    std::size_t kept = 0;
    for (std::size_t n = 0; n < walls.faces.size(); ++n) {
        const WallCrossing& at = walls.faces[n].near_lower;
        walls.shut[at.axis][at.face] = opens[n] != 0 ? -1 : static_cast<std::int32_t>(kept);
        if (opens[n] == 0) walls.faces[kept++] = walls.faces[n];
    }
    walls.faces.resize(kept);
}

/// Each shut face moves the cells' common boundary to the wall, by the square of the normal's part along the axis: with a plane wall the
/// room on each side, and what a moving wall sweeps, are then exact in sum, and every cell keeps half its volume or more.
void find_room(EulerGrid& grid)
{
    EulerWalls& walls = grid.walls;
    std::vector<std::size_t> touched;
    for (const WallFace& face : walls.faces) {
        if (face.lower == no_cell || face.upper == no_cell) continue;
        for (const std::size_t side : {0u, 1u}) {
            const std::size_t cell = side == 0 ? face.lower : face.upper;
            if (walls.is_solid(cell)) continue;
            walls.room_next[cell] += lent_room(grid, face, side);
            touched.push_back(cell);
        }
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const std::size_t cell : touched) walls.room_next[cell] = std::max(walls.room_next[cell], least_room);
    walls.touched = std::move(touched);
}

/// The faces of a cell that are open, the cells beyond, and how much of this cell's volume the cell beyond a shut face has had.
struct Around {
    OpenFaces open{};
    std::array<std::size_t, 6> cell{};
    std::array<double, 6> lent{};
};
double lent_beyond(const EulerGrid& grid, std::size_t d, std::size_t side, std::size_t number)
{
    const std::int32_t wall = grid.walls.shut[d][number];
    if (wall < 0) return 0;
    const WallFace& face = grid.walls.faces[static_cast<std::size_t>(wall)];
    return (side == 0 ? face.lower : face.upper) == no_cell ? 0 : lent_room(grid, face, side);
}
Around around(const EulerGrid& grid, std::size_t cell)
{
    Around found;
    const auto at = grid.place(cell);
    for (std::size_t d = 0; d < 3; ++d) {
        for (std::size_t side = 0; side < 2; ++side) {
            auto face = at, next = at;
            face[d] += side;
            const bool edge = side == 0 ? at[d] == 0 : at[d] + 1 == grid.axes[d].cells();
            if (!edge) next[d] = side == 0 ? at[d] - 1 : at[d] + 1;
            found.cell[2 * d + side] = edge ? no_cell : grid.cell(next[0], next[1], next[2]);
            const std::size_t number = grid.face_number(static_cast<int>(d), face);
            found.open[2 * d + side] = !edge && grid.walls.shut[d][number] < 0;
            found.lent[2 * d + side] = edge ? 0 : lent_beyond(grid, d, side, number);
        }
    }
    return found;
}

/// Cells that change sides.
class SideChange {
public:
    SideChange(EulerGrid& grid, const std::vector<SweptCell>& swept) : grid_(grid), arrays_(numbers_per_volume(grid.now))
    {
        for (const SweptCell& s : swept) {
            const bool was_solid = grid.walls.is_solid(s.cell);
            cells_.push_back({s.cell, s.normal, around(grid, s.cell), {}, {}, false, false, was_solid, s.solid ? s.within : was_solid, 0});
        }
    }

    /// The walls have been moved: what the cells held goes to those beside them on the side they leave, and they share what those on the
    /// other side have. Cells without such neighbours wait for others that change sides with them.
    void carry_over()
    {
        for (Cell& cell : cells_) {
            cell.after = around(grid_, cell.cell).open;
            if (const std::optional<bool> now = within_solid(cell.cell)) cell.is_solid = *now;
            for (const std::vector<double>* array : arrays_) cell.held.push_back((*array)[cell.cell]);
            cell.room = grid_.walls.room[cell.cell];
            cell.given = cell.was_solid;
        }
        for (int round = 0; round < 4; ++round) {
            for (Cell& cell : cells_) {
                if (!cell.given) give(cell);
            }
        }
        for (Cell& cell : cells_) {
            if (!cell.given) keep(cell);
            if (cell.is_solid || cell.was_solid) change_solid(cell);
        }
        for (int round = 0; round < 4; ++round) {
            for (Cell& cell : cells_) {
                if (cell.given && !cell.taken) take(cell);
            }
        }
        for (Cell& cell : cells_) {
            if (cell.given && !cell.taken) cell.was_solid ? close(cell) : bare(cell);
        }
    }

    /// Where elements of solids have gone: of the cells that are no longer `within` solids those open to gas take from it, layer by layer
    /// from step to step; the others wait as if they were solid.
    void open_hollows(const std::vector<std::uint8_t>& within)
    {
        const std::vector<std::uint8_t>& solid = grid_.walls.solid;
        std::vector<Cell> opened;
        grid_.walls.voids = false;
        for (std::size_t c = 0; c < solid.size(); ++c) {
            if (solid[c] == 0 || (!within.empty() && within[c] != 0) || changing(c) != nullptr) continue;
            const Around beside = around(grid_, c);
            if (open_to_gas(beside))
                opened.push_back({c, Vector3d{1, 1, 1} / std::sqrt(3.0), beside, {}, {}, false, false, true, false, 0, true});
            else
                grid_.walls.voids = true;
        }
        cells_.insert(cells_.end(), opened.begin(), opened.end());
        std::sort(cells_.begin(), cells_.end(), [](const Cell& a, const Cell& b) { return a.cell < b.cell; });
    }

    /// The cells that change, in ascending order.
    [[nodiscard]] std::vector<std::size_t> cells() const
    {
        std::vector<std::size_t> all;
        for (const Cell& cell : cells_) all.push_back(cell.cell);
        return all;
    }

private:
    struct Cell {
        std::size_t cell;
        Vector3d normal;
        Around before;
        OpenFaces after;
        std::vector<double> held;  ///< its numbers before
        bool given, taken;
        bool was_solid, is_solid;
        double room;
        bool hollow = false;
    };

    /// Whether a cell lies in a solid, as a facet that shuts one of its faces tells, else a cell it is open to; nothing if neither can.
    [[nodiscard]] std::optional<bool> within_solid(std::size_t cell)
    {
        for (std::size_t d = 0; d < 3; ++d) {
            for (const std::size_t side : {0u, 1u}) {
                auto at = grid_.place(cell);
                at[d] += side;
                const std::int32_t number = grid_.walls.shut[d][grid_.face_number(static_cast<int>(d), at)];
                if (number < 0) continue;
                const WallFace& face = grid_.walls.faces[static_cast<std::size_t>(number)];
                const WallCrossing& near = side == 1 ? face.near_lower : face.near_upper;
                if (near.solid) return near.enters == (side == 0);
            }
        }
        const Around beside = around(grid_, cell);
        for (std::size_t f = 0; f < 6; ++f) {
            if (beside.open[f] && changing(beside.cell[f]) == nullptr) return grid_.walls.is_solid(beside.cell[f]);
        }
        return std::nullopt;
    }

    /// A cell that a solid moves into holds no gas any more; its numbers are those of gas at rest, which nobody sees.
    void change_solid(Cell& cell)
    {
        std::vector<std::uint8_t>& solid = grid_.walls.solid;
        if (cell.is_solid && !cell.was_solid) {
            const auto other = static_cast<std::size_t>(std::find(solid.begin(), solid.end(), 1) - solid.begin());
            for (auto* array : arrays_) (*array)[cell.cell] = other < solid.size() ? (*array)[other] : (*array)[cell.cell];
            for (auto& motion : grid_.now.motion) motion[cell.cell] = 0;
            if (solid.empty()) solid.assign(grid_.cells(), 0);
        }
        solid[cell.cell] = cell.is_solid ? 1 : 0;
        grid_.walls.room[cell.cell] = 1;
        cell.taken = cell.is_solid;
    }

    /// Nobody to take gas from: it goes on as a solid's cell, in a hollow.
    void close(Cell& cell)
    {
        grid_.walls.solid[cell.cell] = 1;
        grid_.walls.voids = true;
        cell.taken = true;
    }
    [[nodiscard]] bool open_to_gas(const Around& beside)
    {
        for (std::size_t f = 0; f < 6; ++f) {
            if (beside.open[f] && !grid_.walls.is_solid(beside.cell[f]) && changing(beside.cell[f]) == nullptr) return true;
        }
        return false;
    }

    [[nodiscard]] Cell* changing(std::size_t cell)
    {
        const auto found = std::lower_bound(cells_.begin(), cells_.end(), cell, [](const Cell& c, std::size_t n) { return c.cell < n; });
        return found != cells_.end() && found->cell == cell ? &*found : nullptr;
    }
    [[nodiscard]] static double weight(const Cell& cell, std::size_t face)
    {
        const double n = cell.normal[static_cast<int>(face / 2)];
        return n * n + 1e-6;
    }

    /// Puts an amount of gas, with the numbers `held` in `room`, into a cell.
    void put(std::size_t to, const std::vector<double>& held, double room)
    {
        double& own = grid_.walls.room[to];
        const double whole = own + room;
        for (std::size_t a = 0; a < arrays_.size(); ++a) {
            double& value = (*arrays_[a])[to];
            value = (value * own + held[a] * room) / whole;
        }
        own = whole;
    }

    /// Gives what a cell held to those beside it on its old side.
    void give(Cell& cell)
    {
        double whole = 0;
        const auto takes = [&](std::size_t f) {
            return cell.before.open[f] && !changing(cell.before.cell[f]) && !grid_.walls.is_solid(cell.before.cell[f]);
        };
        for (std::size_t f = 0; f < 6; ++f) whole += takes(f) ? weight(cell, f) : 0.0;
        if (whole > 0) {
            for (std::size_t f = 0; f < 6; ++f) {
                if (takes(f))
                    put(cell.before.cell[f], cell.held, cell.room * weight(cell, f) * volume_ratio(cell.cell, cell.before.cell[f]) / whole);
            }
            cell.given = true;
            return;
        }
        for (std::size_t f = 0; f < 6; ++f) {  // by way of another that changes sides too
            Cell* other = cell.before.open[f] ? changing(cell.before.cell[f]) : nullptr;
            if (other == nullptr || other->given || !has_way(*other)) continue;
            const double room = cell.room * volume_ratio(cell.cell, other->cell), all = other->room + room;
            for (std::size_t a = 0; a < cell.held.size(); ++a) other->held[a] = (other->held[a] * other->room + cell.held[a] * room) / all;
            other->room = all;
            cell.given = true;
            return;
        }
    }
    [[nodiscard]] bool has_way(const Cell& cell)
    {
        for (std::size_t f = 0; f < 6; ++f) {
            if (cell.before.open[f] && !changing(cell.before.cell[f]) && !grid_.walls.is_solid(cell.before.cell[f])) return true;
        }
        return false;
    }
    [[nodiscard]] double volume_ratio(std::size_t from, std::size_t to) const { return grid_.whole_volume(from) / grid_.whole_volume(to); }

    /// Gets from the cells on its new side the room that they have had in it, with what that room holds.
    void take(Cell& cell)
    {
        const auto gives = [&](std::size_t f) {
            if (!cell.after[f] || grid_.walls.is_solid(cell.before.cell[f])) return false;
            const Cell* other = changing(cell.before.cell[f]);
            return other == nullptr || other->taken;
        };
        std::array<double, 6> part{};
        const double least = cell.hollow ? drawn_in : least_lent;
        double whole = 0, lent = 0;
        for (std::size_t f = 0; f < 6; ++f) {
            if (!gives(f)) continue;
            whole += weight(cell, f);
            part[f] = std::clamp(cell.before.lent[f], 0.0, 0.5 * grid_.walls.room[cell.before.cell[f]]);
            lent += part[f];
        }
        if (!(whole > 0)) return;
        std::vector<double> sum(arrays_.size(), 0.0);
        double room = 0;
        for (std::size_t f = 0; f < 6; ++f) {
            if (!gives(f)) continue;
            if (lent < least) part[f] = least * weight(cell, f) / whole * grid_.walls.room[cell.before.cell[f]];
            const std::size_t from = cell.before.cell[f];
            const double ratio = volume_ratio(from, cell.cell);
            for (std::size_t a = 0; a < arrays_.size(); ++a) sum[a] += (*arrays_[a])[from] * part[f] * ratio;
            grid_.walls.room[from] -= part[f];
            room += part[f] * ratio;
        }
        for (std::size_t a = 0; a < arrays_.size(); ++a) (*arrays_[a])[cell.cell] = sum[a] / room;
        grid_.walls.room[cell.cell] = room;
        cell.taken = true;
    }

    /// No way out: the gas stays in its cell, and so passes the wall.
    void keep(Cell& cell)
    {
        for (std::size_t a = 0; a < arrays_.size(); ++a) (*arrays_[a])[cell.cell] = cell.held[a];
        grid_.walls.room[cell.cell] = cell.room;
        cell.given = cell.taken = true;
        ++grid_.walls.squeezed;
    }
    /// Nobody on its new side: takes back a thousandth of what it gave, so that the cell holds something.
    void bare(Cell& cell)
    {
        for (std::size_t f = 0; f < 6; ++f) {
            if (!cell.before.open[f] || changing(cell.before.cell[f])) continue;
            double& own = grid_.walls.room[cell.before.cell[f]];
            const double part = 1e-3 * own;
            for (auto* array : arrays_) (*array)[cell.cell] = (*array)[cell.before.cell[f]];
            own -= part;
            grid_.walls.room[cell.cell] = part * volume_ratio(cell.before.cell[f], cell.cell);
            cell.taken = true;
            ++grid_.walls.squeezed;
            return;
        }
        ++grid_.walls.squeezed;
    }

    EulerGrid& grid_;
    std::vector<std::vector<double>*> arrays_;
    std::vector<Cell> cells_;
};

/// Marks the blocks that see a wall, or one that was there before the step: they are computed with it, and never quiet.
void mark_blocks(EulerGrid& grid, const std::vector<WallFace>& gone, const std::vector<std::size_t>& changed)
{
    for (EulerBlock& block : grid.blocks) block.walled = false;
    constexpr std::size_t sight = 3;
    const auto mark = [&](const std::array<std::size_t, 3>& at) {
        std::array<std::size_t, 3> low{}, high{};
        for (std::size_t d = 0; d < 3; ++d) {
            const std::size_t cells = grid.axes[d].cells(), count = grid.block_counts[d];
            const auto block_of = [&](std::size_t cell) {
                std::size_t n = cell * count / cells;
                while (n + 1 < count && cells * (n + 1) / count <= cell) ++n;
                return n;
            };
            low[d] = block_of(at[d] > sight ? at[d] - sight : 0);
            high[d] = block_of(std::min(at[d] + sight, cells - 1));
        }
        for (std::size_t k = low[2]; k <= high[2]; ++k) {
            for (std::size_t j = low[1]; j <= high[1]; ++j) {
                for (std::size_t i = low[0]; i <= high[0]; ++i) {
                    EulerBlock& block = grid.blocks[i + grid.block_counts[0] * (j + grid.block_counts[1] * k)];
                    block.walled = true;
                    block.quiet = false;
                }
            }
        }
    };
    for (const WallFace& face : gone) mark(face.place);
    for (const std::size_t cell : changed) mark(grid.place(cell));
    for (const WallFace& face : grid.walls.faces) mark(face.place);
    for (std::size_t c = 0; c < grid.walls.solid.size(); ++c) {
        if (grid.walls.solid[c] != 0) mark(grid.place(c));
    }
}

/// Nothing passes between gas and cells of hollows that wait for it, nor presses there; nor at the grid's edges out of solids.
void shut_hollows(EulerGrid& grid)
{
    EulerWalls& walls = grid.walls;
    for (std::size_t c = 0; c < walls.solid.size(); ++c) {
        if (walls.solid[c] == 0) continue;
        const Around beside = around(grid, c);
        const auto at = grid.place(c);
        for (std::size_t f = 0; f < 6; ++f) {
            const bool hollow = beside.open[f] && walls.solid[beside.cell[f]] == 0;
            if (beside.cell[f] != no_cell && !hollow) continue;
            auto face = at;
            face[f / 2] += f % 2;
            const std::size_t number = grid.face_number(static_cast<int>(f / 2), face);
            walls.open[f / 2][number] = 0;
            walls.widened.push_back({f / 2, number});
        }
    }
}

/// Shuts the faces that the walls cross now; returns those that were shut before.
std::vector<WallFace> shut_anew(EulerGrid& grid, const std::vector<WallCrossing>& crossings)
{
    std::vector<WallFace> gone = grid.walls.faces;
    clear(grid.walls);
    shut_faces(grid, crossings);
    open_beside_rims(grid);
    return gone;
}

/// Finds what the shut faces make of cells, open faces and blocks.
void shape_cut(EulerGrid& grid, const std::vector<WallFace>& gone, const std::vector<std::size_t>& changed)
{
    find_room(grid);
    shape_openings(grid);
    shut_hollows(grid);
    mark_blocks(grid, gone, changed);
}

/// At the start all cells within solids are solid; after a restart cells of hollows are, too.
void take_solid_cells(EulerWalls& walls, const std::vector<std::uint8_t>& within)
{
    if (walls.solid.empty()) walls.solid = within;
    walls.voids = within.empty() ? std::find(walls.solid.begin(), walls.solid.end(), 1) != walls.solid.end() : within != walls.solid;
}

}  // namespace

std::array<std::size_t, 3> place_of_face(const EulerGrid& grid, int d, std::size_t face)
{
    const std::size_t nx = grid.axes[0].cells() + (d == 0 ? 1 : 0), ny = grid.axes[1].cells() + (d == 1 ? 1 : 0);
    return {face % nx, face / nx % ny, face / nx / ny};
}

double lent_room(const EulerGrid& grid, const WallFace& face, std::size_t side)
{
    const std::size_t d = face.near_lower.axis, cell = side == 0 ? face.lower : face.upper;
    const double part = face.normal[static_cast<int>(d)], length = side == 0 ? face.lower_length : face.upper_length;
    return part * part * (length / grid.axes[d].width(grid.place(cell)[d]) - 0.5);
}

void cut(EulerGrid& grid, const std::vector<WallCrossing>& crossings, const std::vector<SweptCell>& swept)
{
    make_arrays(grid);
    SideChange change(grid, swept);
    const std::vector<WallFace> gone = shut_anew(grid, crossings);
    if (grid.walls.voids) change.open_hollows(cells_within(grid, crossings));
    change.carry_over();
    const std::vector<std::size_t> changed = change.cells();
    return_room(grid, gone, changed);
    shape_cut(grid, gone, changed);
}

void cut_first(EulerGrid& grid, const std::vector<WallCrossing>& crossings)
{
    if (crossings.empty() && !grid.walls.any()) return;
    take_solid_cells(grid.walls, cells_within(grid, crossings));
    make_arrays(grid);
    shape_cut(grid, shut_anew(grid, crossings), {});
    std::copy(grid.walls.room_next.begin(), grid.walls.room_next.end(), grid.walls.room.begin());
}

void end_cut(EulerGrid& grid)
{
    grid.walls.room = grid.walls.room_next;
    if (!grid.walls.solid.empty()) keep_solid_cells(grid);
    mix_small_cells(grid);
}

}  // namespace corpuscle
