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

/// Numbers of the particles that have not gone, in the order of their keys: what the sort must find.
std::vector<float> numbers_by_key(const Gas& gas)
{
    const CellCurve curve(box);
    std::vector<std::pair<std::uint64_t, float>> list;
    for (const Particle& p : gas.particles) {
        if (!(p.tag & particle_tag::gone)) list.emplace_back(curve.key(p.position), p.energy);
    }
    std::sort(list.begin(), list.end());
    std::vector<float> numbers;
    for (const auto& entry : list) numbers.push_back(entry.second);
    return numbers;
}

/// Every particle in one cell, within its box; no cell too full; groups hold whole cells.
void expect_cells_fit(const Gas& gas)
{
    const Cells& cells = gas.cells;
    std::uint32_t next = 0;
    std::size_t group = 0;
    for (const Cell& cell : cells.cells) {
        ASSERT_EQ(cell.first, next);
        next = cell.end();
        ASSERT_LE(cell.count, gas.settings.cell_limit);
        Box room = cells.curve.cell(cells.keys[cell.first], static_cast<int>(cell.depth));
        room.grow(1e-6);  // floats near 3.5 are 2.4e-7 apart
        for (std::uint32_t i = cell.first; i < cell.end(); ++i) ASSERT_TRUE(room.contains(Vector3d(gas.particles[i].position)));
        while (cells.groups[group].end() <= cell.first) ++group;
        ASSERT_GE(cell.first, cells.groups[group].first);
        ASSERT_LE(cell.end(), cells.groups[group].end());
    }
    ASSERT_EQ(next, gas.particles.size());
}

/// Sorts and compares with a plain sort of the same.
void expect_sorted(Gas& gas)
{
    const std::vector<float> expected = numbers_by_key(gas);
    sort(gas);
    ASSERT_EQ(gas.particles.size(), expected.size());
    ASSERT_EQ(gas.cells.keys.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        ASSERT_EQ(gas.particles[i].energy, expected[i]) << "place " << i;
        ASSERT_EQ(gas.cells.keys[i], gas.cells.curve.key(gas.particles[i].position));
    }
    expect_cells_fit(gas);
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

TEST(Sort, is_the_order_of_keys_through_repeated_motion)
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

/// 32 bytes of a particle, 8 of its key, 8 for each cell; cells are at least half full on average, groups and buckets are fewer.
TEST(Sort, keeps_memory_small)
{
    const Gas gas = stirred(3, 2, false);
    const auto count = static_cast<double>(gas.cells.keys.size());
    EXPECT_LT(static_cast<double>(resident_bytes(gas)) / count, 32 + 8 + 8 / 8.0 + 8 / 32.0 + 16 / 512.0 + 1);
    EXPECT_GT(gas.cells.sort_bytes, 0u);
    EXPECT_LT(static_cast<double>(resident_bytes(gas) + gas.cells.sort_bytes) / count, 64);  // two bare copies of the state
}

}  // namespace
}  // namespace corpuscle
