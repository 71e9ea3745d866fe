#include "gas/cells.hpp"

#include "parallel/loops.hpp"

namespace corpuscle {

namespace {

using Keys = std::vector<std::uint64_t>;

/// Depth of the cell whose first particle is i. It must not hold i - 1, and its parent would hold more than `limit`.
int depth_of_cell_from(const Keys& keys, std::size_t i, std::uint32_t limit)
{
    int depth = 0;
    if (i > 0) depth = CellCurve::common_depth(keys[i - 1], keys[i]) + 1;
    if (i + limit < keys.size()) depth = std::max(depth, CellCurve::common_depth(keys[i], keys[i + limit]) + 1);
    return std::min(depth, CellCurve::depth_limit);
}

/// Depth of the cell that holds particle i anywhere: one more than the deepest box that holds it with `limit` others.
int depth_of_cell_around(const Keys& keys, std::size_t i, std::uint32_t limit)
{
    int depth = 0;
    const std::size_t lowest = i < limit ? 0 : i - limit;
    for (std::size_t from = lowest; from <= i && from + limit < keys.size(); ++from) {
        depth = std::max(depth, CellCurve::common_depth(keys[from], keys[from + limit]) + 1);
    }
    return std::min(depth, CellCurve::depth_limit);
}

/// First particle after those of the box of this depth that holds particle i.
std::size_t end_of_cell(const Keys& keys, std::size_t i, int depth)
{
    if (depth == 0) return keys.size();
    const int shift = CellCurve::depth_limit - depth;
    const std::uint64_t prefix = keys[i] >> shift;
    std::size_t end = i + 1;
    while (end < keys.size() && keys[end] >> shift == prefix) ++end;
    return end;
}

/// First particle from i on that begins a cell.
std::size_t next_cell_start(const Keys& keys, std::size_t i, std::uint32_t limit)
{
    if (i == 0 || i >= keys.size()) return i;
    const int depth = depth_of_cell_around(keys, i, limit);
    const bool starts = depth > 0 && keys[i - 1] < CellCurve::first_key(keys[i], depth);
    return starts ? i : end_of_cell(keys, i, depth);
}

}  // namespace

std::vector<Cell> cut(const Keys& keys, std::uint32_t limit)
{
    const std::size_t parts = part_count(keys.size(), 4096);
    std::vector<std::vector<Cell>> pieces(parts);
    for_each_part(keys.size(), parts, [&](std::size_t part, std::size_t begin, std::size_t end) {
        std::vector<Cell>& own = pieces[part];
        own.reserve(2 * (end - begin) / limit + 16);
        for (std::size_t i = next_cell_start(keys, begin, limit); i < end;) {
            const int depth = depth_of_cell_from(keys, i, limit);
            const std::size_t next = end_of_cell(keys, i, depth);
            Cell cell;
            cell.first = static_cast<std::uint32_t>(i);
            cell.count = static_cast<std::uint32_t>(next - i) & 0xFFFFFFu;
            cell.depth = static_cast<std::uint32_t>(depth) & 0xFFu;
            own.push_back(cell);
            i = next;
        }
    });
    std::vector<Cell> cells = std::move(pieces[0]);
    for (std::size_t part = 1; part < parts; ++part) cells.insert(cells.end(), pieces[part].begin(), pieces[part].end());
    return cells;
}

}  // namespace corpuscle
