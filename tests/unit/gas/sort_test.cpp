#include "gas/sort.hpp"

#include <gtest/gtest.h>

#include "gas_samples.hpp"
#include "math/random.hpp"

namespace corpuscle {
namespace {

const Box box{{-1, 0, 2}, {2, 1, 3.5}};

Vector3f random_place(Random& random)
{
    Vector3d p;
    for (int a = 0; a < 3; ++a) p[a] = box.lower[a] + box.size()[a] * random.uniform_double();
    return Vector3f(p);
}

/// Particles at random places, each with a number of its own for its energy.
void add_particles(Gas& gas, std::size_t count, Random& random, int& number)
{
    for (std::size_t i = 0; i < count; ++i) gas.particles.push_back({random_place(random), static_cast<float>(number++), {}, 0});
}

using Keyed = std::vector<std::pair<std::uint64_t, float>>;

/// Keys and numbers of the particles that have not gone, in the order of both.
Keyed by_key(const Gas& gas)
{
    const CellCurve curve(box);
    Keyed list;
    for (const Particle& p : gas.particles) {
        if (!(p.tag & particle_tag::gone)) list.emplace_back(curve.key(p.position), p.energy);
    }
    std::sort(list.begin(), list.end());
    return list;
}

/// The cells of particles in the order of their keys, by halving: what the sort must find, from the definition.
void cut_plainly(const Keyed& list, std::size_t begin, std::size_t end, int depth, std::uint32_t limit, std::vector<Cell>& cells)
{
    if (begin == end) return;
    if (end - begin <= limit || depth == CellCurve::depth_limit) {
        Cell cell;
        cell.first = static_cast<std::uint32_t>(begin);
        cell.count = static_cast<std::uint32_t>(end - begin) & 0xFFFFFFu;
        cell.depth = static_cast<std::uint32_t>(depth) & 0xFFu;
        cells.push_back(cell);
        return;
    }
    std::size_t middle = begin;
    while (middle < end && !(list[middle].first >> (CellCurve::depth_limit - 1 - depth) & 1)) ++middle;
    cut_plainly(list, begin, middle, depth + 1, limit, cells);
    cut_plainly(list, middle, end, depth + 1, limit, cells);
}

void expect_same_cells(const std::vector<Cell>& found, const Keyed& list, std::uint32_t limit)
{
    std::vector<Cell> expected;
    cut_plainly(list, 0, list.size(), 0, limit, expected);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t c = 0; c < found.size(); ++c) {
        ASSERT_EQ(found[c].first, expected[c].first);
        ASSERT_EQ(found[c].count, expected[c].count);
        ASSERT_EQ(found[c].depth, expected[c].depth);
    }
}

/// Buckets fill the domain in the order of the curve.
void expect_whole_buckets(const Cells& cells)
{
    std::uint64_t key = 0;
    for (std::size_t b = 0; b + 1 < cells.buckets.size(); ++b) {
        ASSERT_EQ(cells.buckets[b].start_key, key);
        ASSERT_LE(cells.buckets[b].first, cells.buckets[b + 1].first);
        key += CellCurve::keys_of(static_cast<int>(cells.buckets[b].depth));
    }
    ASSERT_EQ(key, CellCurve::keys_of(0));
}

/// Sorts and compares with a plain sort of the same, cell by cell: within one any order will do.
void expect_sorted(Gas& gas)
{
    const Keyed expected = by_key(gas);
    sort(gas);
    ASSERT_EQ(gas.particles.size(), expected.size());
    expect_same_cells(gas.cells.cells, expected, gas.settings.cell_limit);
    expect_same_cells(gas.cells.groups, expected, gas.settings.group_limit);
    expect_whole_buckets(gas.cells);
    for (const Cell& cell : gas.cells.cells) {
        Keyed found;
        for (std::uint32_t i = cell.first; i < cell.end(); ++i)
            found.emplace_back(gas.cells.curve.key(gas.particles[i].position), gas.particles[i].energy);
        std::sort(found.begin(), found.end());
        for (std::uint32_t i = cell.first; i < cell.end(); ++i) ASSERT_EQ(found[i - cell.first], expected[i]);
    }
}

/// A step as motion makes it: most go a little way, some far, some leave for good, others come.
void stir(Gas& gas, Random& random, int& number, float reach)
{
    for (Particle& p : gas.particles) {
        p.position += (reach * random.uniform()) * random.direction();
        // Beyond the box places would pile up on its faces, with equal keys.
        if (random.below(50) == 0 || !box.contains(Vector3d(p.position))) p.position = random_place(random);
        if (random.below(100) == 0) p.tag |= particle_tag::gone;
    }
    add_particles(gas, random.below(400), random, number);
}

Gas stirred(int rounds, int threads, bool compare)
{
    const WithThreads with(threads);
    Gas gas;
    gas.domain.box = box;
    Random random(6, Purpose::fill, 0, 0);
    int number = 0;
    add_particles(gas, 20000, random, number);
    for (int i = 0; i < rounds; ++i) {
        if (compare) {
            expect_sorted(gas);
        } else {
            sort(gas);
        }
        stir(gas, random, number, i % 4 == 3 ? 1.0f : 0.01f);
    }
    return gas;
}

TEST(Sort, finds_the_cells_of_the_curve_through_repeated_motion)
{
    stirred(16, 1, true);
    stirred(16, 3, true);
}

TEST(Sort, threads_change_not_one_bit)
{
    const Gas one = stirred(12, 1, false);
    EXPECT_TRUE(same_bits(one.particles, stirred(12, 2, false).particles));
    EXPECT_TRUE(same_bits(one.particles, stirred(12, 3, false).particles));
}

TEST(Sort, survives_crowds_floods_and_emptiness)
{
    Gas gas;
    gas.domain.box = box;
    Random random(7, Purpose::fill, 0, 0);
    int number = 0;
    expect_sorted(gas);
    add_particles(gas, 5000, random, number);
    expect_sorted(gas);
    for (Particle& p : gas.particles) p.position = Vector3f{1.5f, 0.9f, 3.0f} + (0.05f * random.uniform()) * random.direction();
    expect_sorted(gas);  // all move into one corner
    add_particles(gas, 30000, random, number);
    expect_sorted(gas);  // more come than were there
    for (Particle& p : gas.particles) p.position = random_place(random);
    expect_sorted(gas);  // all move
    for (Particle& p : gas.particles) p.tag |= particle_tag::gone;
    expect_sorted(gas);  // all leave
    EXPECT_TRUE(gas.particles.empty());
    add_particles(gas, 3000, random, number);
    expect_sorted(gas);
}

/// More particles in one spot than a cell may hold cannot be parted, but none may be lost.
TEST(Sort, keeps_particles_in_one_spot)
{
    Gas gas;
    gas.domain.box = box;
    for (int i = 0; i < 3000; ++i) gas.particles.push_back({{0.5f, 0.5f, 2.5f}, static_cast<float>(i), {}, 0});
    for (int round = 0; round < 2; ++round) {
        sort(gas);
        ASSERT_EQ(gas.cells.cells.size(), 1u);
        EXPECT_EQ(gas.cells.cells[0].count, 3000u);
    }
    std::vector<float> numbers;
    for (const Particle& p : gas.particles) numbers.push_back(p.energy);
    std::sort(numbers.begin(), numbers.end());
    for (int i = 0; i < 3000; ++i) EXPECT_EQ(numbers[i], static_cast<float>(i));
}

/// A particle's own 32 bytes, 8 for each cell; cells are about half full, groups and buckets fewer.
TEST(Sort, keeps_memory_small)
{
    const Gas gas = stirred(3, 2, false);
    const auto count = static_cast<double>(gas.particles.capacity());
    EXPECT_LT(static_cast<double>(resident_bytes(gas)) / count, 32 + 8 / 6.0 + 8 / 24.0 + 16 / 256.0 + 1);
    EXPECT_GT(gas.cells.sort_bytes, 0u);
    EXPECT_LT(static_cast<double>(resident_bytes(gas) + gas.cells.sort_bytes) / count, 64);  // two bare copies of the state
}

}  // namespace
}  // namespace corpuscle
