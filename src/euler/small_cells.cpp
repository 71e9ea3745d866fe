#include <algorithm>

#include "euler/cut.hpp"

namespace corpuscle {

namespace {

/// Cells with less room than this, over their volume without walls, are brought to one state with the cell beside them. A plane wall
/// leaves half a cell at least; less is left where walls meet or face each other.
constexpr double small_room = 0.45;
/// The most of its own room that a cell hands to the one beside it at once.
constexpr double most_handed = 0.5;

/// The cell with the most room of those that open faces join to a cell, no_cell if there is none.
std::size_t widest_beside(const EulerGrid& grid, std::size_t cell)
{
    const auto at = grid.place(cell);
    std::size_t widest = no_cell;
    for (std::size_t d = 0; d < 3; ++d) {
        for (const std::size_t side : {0u, 1u}) {
            if (side == 0 ? at[d] == 0 : at[d] + 1 == grid.axes[d].cells()) continue;
            auto face = at, beside = at;
            face[d] += side;
            beside[d] = side == 0 ? at[d] - 1 : at[d] + 1;
            const std::size_t other = grid.cell(beside[0], beside[1], beside[2]);
            if (grid.walls.shut[d][grid.face_number(static_cast<int>(d), face)] >= 0 || grid.walls.is_solid(other)) continue;
            if (widest == no_cell || grid.volume(other) > grid.volume(widest)) widest = other;
        }
    }
    return widest;
}

/// Takes part of a cell's room, over its volume without walls, with what that holds, and gives it to another.
void hand_over(EulerGrid& grid, const std::vector<std::vector<double>*>& numbers, std::size_t from, std::size_t to, double part)
{
    std::vector<double>& room = grid.walls.room;
    const double got = part * grid.whole_volume(from) / grid.whole_volume(to), whole = room[to] + got;
    for (std::vector<double>* number : numbers) (*number)[to] = ((*number)[to] * room[to] + (*number)[from] * got) / whole;
    room[from] -= part;
    room[to] = whole;
}

}  // namespace

std::vector<std::vector<double>*> numbers_per_volume(EulerState& state)
{
    std::vector<std::vector<double>*> numbers;
    for (auto& number : state.mass) numbers.push_back(&number);
    for (auto& number : state.motion) numbers.push_back(&number);
    numbers.push_back(&state.energy);
    for (auto& number : state.share) numbers.push_back(&number);
    for (auto& number : state.unburnt)
        if (!number.empty()) numbers.push_back(&number);
    return numbers;
}

void mix_small_cells(EulerGrid& grid)
{
    const auto numbers = numbers_per_volume(grid.now);
    for (const std::size_t cell : grid.walls.touched) {
        if (grid.walls.room[cell] >= small_room) continue;
        const std::size_t other = widest_beside(grid, cell);
        if (other == no_cell) continue;
        const double own = grid.volume(cell), whole = own + grid.volume(other);
        for (std::vector<double>* number : numbers) {
            const double mean = ((*number)[cell] * own + (*number)[other] * grid.volume(other)) / whole;
            (*number)[cell] = (*number)[other] = mean;
        }
    }
}

void return_room(EulerGrid& grid, const std::vector<WallFace>& gone, const std::vector<std::size_t>& swept)
{
    const auto numbers = numbers_per_volume(grid.now);
    const auto changes = [&](std::size_t cell) {
        return std::binary_search(swept.begin(), swept.end(), cell) || grid.walls.is_solid(cell);
    };
    const auto lend = [&](const WallFace& face, double sign) {
        if (face.lower == no_cell || face.upper == no_cell || changes(face.lower) || changes(face.upper)) return;
        const double lent_lower = sign * lent_room(grid, face, 0), lent_upper = sign * lent_room(grid, face, 1);
        const bool from_lower = lent_lower > 0;
        if (from_lower == (lent_upper > 0)) return;  // both have less or more than their own: the wall has taken up room itself
        const std::size_t from = from_lower ? face.lower : face.upper, to = from_lower ? face.upper : face.lower;
        const double part = std::min(std::abs(lent_lower), std::abs(lent_upper));
        hand_over(grid, numbers, from, to, std::min(part, most_handed * grid.walls.room[from]));
    };
    const auto place = [](const WallFace& face) { return std::pair(face.near_lower.axis, face.near_lower.face); };
    const auto less = [&](const WallFace& a, const WallFace& b) { return place(a) < place(b); };
    for (const WallFace& face : gone) {
        if (grid.walls.shut[face.near_lower.axis][face.near_lower.face] < 0) lend(face, 1);
    }
    for (const WallFace& face : grid.walls.faces) {
        if (!std::binary_search(gone.begin(), gone.end(), face, less)) lend(face, -1);
    }
}

}  // namespace corpuscle
