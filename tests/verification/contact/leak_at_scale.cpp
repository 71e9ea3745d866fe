#include <gtest/gtest.h>

#include <cstdio>

#include "honeycomb.hpp"

namespace corpuscle {
namespace {

/// Rooms with folded walls in T and cross joints, folded at 67 degrees, which move by half a facet a step and erode in the second half: no
/// particle is ever in a room it could not come to.
TEST(LeakAtScale, rooms_with_folded_walls_that_move_and_erode)
{
    Honeycomb rooms(20, 5, 1.5, 20000, 800);
    GasStructureContact contact(rooms.gas, rooms.structure);
    std::uint64_t hits = 0;
    for (int i = 0; i < 24; ++i) {
        if (i >= 12) rooms.erode(6);
        rooms.step(contact, 5e-5);
        hits = std::accumulate(contact.facet_hits().begin(), contact.facet_hits().end(), std::uint64_t{0});
        ASSERT_EQ(rooms.astray(), 0u) << "after " << hits << " hits, step " << i;
    }
    EXPECT_EQ(contact.trapped(), 0u);
    EXPECT_EQ(rooms.eroded(), 72u);
    std::printf("%zu facets, %zu eroded, %llu hits, none through\n", rooms.facets(), rooms.eroded(), static_cast<unsigned long long>(hits));
}

/// An opening between two rooms that is not booked as one is noticed: the test above can fail.
TEST(LeakAtScale, what_goes_through_is_noticed)
{
    Honeycomb rooms(8, 2, 1.5, 20000, 800);
    GasStructureContact contact(rooms.gas, rooms.structure);
    rooms.step(contact, 5e-5);
    EXPECT_EQ(rooms.astray(), 0u);
    rooms.structure.surface.hidden[2 * 8 * 8] = 1;  // the first facet of the plane between rooms across x
    for (int i = 0; i < 10; ++i) rooms.step(contact, 5e-5);
    EXPECT_GT(rooms.astray(), 0u);
}

}  // namespace
}  // namespace corpuscle
