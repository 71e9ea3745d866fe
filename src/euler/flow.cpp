#include "euler/flow.hpp"

#include <algorithm>
#include <numeric>

#include "euler/block_flow.hpp"
#include "euler/burn.hpp"
#include "euler/cut.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

/// visit(first cell, number of cells) for each row of a block.
template <class Visit>
void for_rows(const EulerGrid& grid, const EulerBlock& block, const Visit& visit)
{
    for (std::size_t k = block.begin[2]; k < block.end[2]; ++k) {
        for (std::size_t j = block.begin[1]; j < block.end[1]; ++j) visit(grid.cell(block.begin[0], j, k), block.end[0] - block.begin[0]);
    }
}

/// visit(array) for each array of a state, as long as it says true.
template <class Visit>
bool all_arrays(const EulerState& state, const Visit& visit)
{
    const auto each = [&](const auto& arrays) { return std::all_of(arrays.begin(), arrays.end(), visit); };
    return each(state.mass) && each(state.motion) && visit(state.energy) && each(state.share);
}

/// Whether two cells are in the same state, to the bit.
bool alike(const EulerState& state, std::size_t a, std::size_t b)
{
    return all_arrays(state, [&](const std::vector<double>& values) { return values[a] == values[b]; });
}

bool explosive_waits(const EulerState& state, std::size_t cell)
{
    return std::any_of(state.unburnt.begin(), state.unburnt.end(), [&](const auto& values) { return !values.empty() && values[cell] > 0; });
}

std::size_t first_cell(const EulerGrid& grid, const EulerBlock& block)
{
    return grid.cell(block.begin[0], block.begin[1], block.begin[2]);
}

/// Whether a block's cells are all in the state of its first one, at rest, with nothing to burn.
bool is_quiet(const EulerGrid& grid, const EulerBlock& block)
{
    const EulerState& now = grid.now;
    const std::size_t first = first_cell(grid, block);
    bool quiet = !explosive_waits(now, first) && now.motion[0][first] == 0 && now.motion[1][first] == 0 && now.motion[2][first] == 0;
    for_rows(grid, block, [&](std::size_t row, std::size_t count) {
        quiet = quiet && all_arrays(now, [&](const std::vector<double>& values) {
                    return std::all_of(values.begin() + static_cast<std::ptrdiff_t>(row),
                                       values.begin() + static_cast<std::ptrdiff_t>(row + count),
                                       [&](double value) { return value == values[first]; });
                });
    });
    return quiet;
}

std::uint32_t materials_in(const EulerGrid& grid, const EulerBlock& block)
{
    std::uint32_t found = 0;
    for_rows(grid, block, [&](std::size_t row, std::size_t count) {
        for (std::size_t m = 0; m < grid.materials.size(); ++m) {
            if (found >> m & 1) continue;
            for (std::size_t c = row; c < row + count; ++c) {
                if (grid.now.mass[m][c] > 0 || share_of(grid.now, m, c) > 1e-12) found |= 1u << m;
            }
        }
    });
    return found;
}

/// visit(neighbour) for the blocks around a block, itself too.
template <class Visit>
void for_neighbours(const EulerGrid& grid, std::size_t block, const Visit& visit)
{
    const auto& counts = grid.block_counts;
    const std::array<std::size_t, 3> at{block % counts[0], block / counts[0] % counts[1], block / counts[0] / counts[1]};
    std::array<std::size_t, 3> low{}, high{};
    for (int d = 0; d < 3; ++d) {
        low[d] = at[d] > 0 ? at[d] - 1 : 0;
        high[d] = std::min(at[d] + 1, counts[d] - 1);
    }
    for (std::size_t k = low[2]; k <= high[2]; ++k) {
        for (std::size_t j = low[1]; j <= high[1]; ++j) {
            for (std::size_t i = low[0]; i <= high[0]; ++i) visit(grid.blocks[i + counts[0] * (j + counts[1] * k)]);
        }
    }
}

/// A block must be computed if it, or one beside it, is not quiet, or is quiet in another state.
void find_active(EulerGrid& grid)
{
    for_each(grid.blocks.size(), [&](std::size_t b) {
        EulerBlock& block = grid.blocks[b];
        bool active = !grid.settings.skip_quiet;
        const std::size_t own = first_cell(grid, block);
        for_neighbours(grid, b, [&](const EulerBlock& other) { active |= !other.quiet || !alike(grid.now, own, first_cell(grid, other)); });
        block.active = active;
    });
}

std::vector<std::size_t> numbers_in_sight(const EulerGrid& grid, std::size_t block)
{
    std::uint32_t seen = 0;
    for_neighbours(grid, block, [&](const EulerBlock& other) { seen |= other.materials; });
    std::vector<std::size_t> numbers;
    for (std::size_t m = 0; m < grid.materials.size(); ++m) {
        if (seen >> m & 1) numbers.push_back(m);
    }
    return numbers;
}

std::vector<std::size_t> active_blocks(const EulerGrid& grid)
{
    std::vector<std::size_t> numbers;
    for (std::size_t b = 0; b < grid.blocks.size(); ++b) {
        if (grid.blocks[b].active || grid.blocks[b].walled) numbers.push_back(b);
    }
    return numbers;
}

/// Room for each thread that is worth waking for so many cells.
std::vector<EulerTile> make_tiles(const EulerGrid& grid, std::size_t blocks)
{
    constexpr std::size_t worth_a_thread = 2048;
    const std::size_t cells = grid.cells() / std::max<std::size_t>(1, grid.blocks.size()) * blocks;
    return std::vector<EulerTile>(std::min(blocks + 1, part_count(cells, worth_a_thread)));
}

/// What gas at rest in a block that is not computed presses on the grid's edges in a step.
void press_edges(EulerGrid& grid, const EulerBlock& block, double length)
{
    const auto extent = [&](int d) {
        const std::vector<double>& volume = grid.axes[d].volume;
        return std::accumulate(volume.begin() + static_cast<std::ptrdiff_t>(block.begin[d]),
                               volume.begin() + static_cast<std::ptrdiff_t>(block.end[d]), 0.0);
    };
    for (int d = 0; d < 3; ++d) {
        const EulerAxis& axis = grid.axes[d];
        if (axis.inert()) continue;
        const double push =
            length * grid.round() * look(grid, first_cell(grid, block)).pressure * extent((d + 1) % 3) * extent((d + 2) % 3);
        if (block.begin[d] == 0) grid.passages[2 * d].momentum[d] -= push * axis.area.front();
        if (block.end[d] == axis.cells()) grid.passages[2 * d + 1].momentum[d] += push * axis.area.back();
    }
}

/// Finds what changed in the blocks that were computed: whether they are quiet still, what is in them, how fast waves run.
void survey(EulerGrid& grid, const std::vector<std::size_t>& blocks, bool first, std::vector<EulerTile>& tiles)
{
    for_each_with(tiles, blocks.size(), [&](EulerTile& tile, std::size_t n) {
        EulerBlock& block = grid.blocks[blocks[n]];
        if (first || block.quiet) block.quiet = !block.walled && is_quiet(grid, block);
        block.materials = materials_in(grid, block);
        lay_tile(tile, grid, block);
        tile.materials.clear();
        for (std::size_t m = 0; m < grid.materials.size(); ++m) {
            if (block.materials >> m & 1) tile.materials.push_back(m);
        }
        block.signal = find_signal(tile, grid, block);
    });
    find_active(grid);
    double signal = 0;
    for (const EulerBlock& block : grid.blocks) signal = std::max(signal, block.signal);
    grid.step_limit = grid.settings.cfl / signal;
}

}  // namespace

void prepare(EulerGrid& grid)
{
    grid.next = grid.now;
    std::vector<std::size_t> all(grid.blocks.size());
    for (std::size_t b = 0; b < all.size(); ++b) all[b] = b;
    std::vector<EulerTile> tiles = make_tiles(grid, all.size());
    survey(grid, all, true, tiles);
}

EulerAmount flow(EulerGrid& grid, const Clock& clock)
{
    const std::vector<std::size_t> blocks = active_blocks(grid);
    std::vector<EulerTile> tiles = make_tiles(grid, blocks.size());
    std::vector<EulerPassages> passed(blocks.size());
    for_each_with(tiles, blocks.size(), [&](EulerTile& tile, std::size_t n) {
        const EulerBlock& block = grid.blocks[blocks[n]];
        lay_tile(tile, grid, block);
        tile.materials = numbers_in_sight(grid, blocks[n]);
        passed[n] = flow_block(tile, grid, block, clock.duration());
    });
    for (const EulerPassages& part : passed) {
        for (std::size_t f = 0; f < euler_face_count; ++f) grid.passages[f] += part[f];
    }
    for (const EulerBlock& block : grid.blocks) {
        if (!block.active && !block.walled) press_edges(grid, block, clock.duration());
    }
    std::swap(grid.now, grid.next);
    if (grid.walls.any()) end_cut(grid);
    const EulerAmount released = burn(grid, clock.end());
    survey(grid, blocks, false, tiles);
    grid.worked += active_cells(grid);
    return released;
}

double stable_step(const EulerGrid& grid)
{
    return grid.step_limit;
}

std::size_t active_cells(const EulerGrid& grid)
{
    std::size_t cells = 0;
    for (const EulerBlock& block : grid.blocks) {
        if (block.active) cells += (block.end[0] - block.begin[0]) * (block.end[1] - block.begin[1]) * (block.end[2] - block.begin[2]);
    }
    return cells;
}

}  // namespace corpuscle
