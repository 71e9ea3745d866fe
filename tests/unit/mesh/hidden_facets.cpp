#include <gtest/gtest.h>

#include "mesh/facet_tree.hpp"

namespace corpuscle {
namespace {

TEST(FacetTree, HiddenFacetsAreNotMet)
{
    Surface surface;
    const std::vector<Vector3d> nodes{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    surface.facets = {{{0, 1, 2}, 0, 0}, {{3, 4, 5}, 1, 0}};
    FacetTree tree(surface);
    const auto first = [&](std::vector<std::uint8_t> hidden) {
        tree.follow({nodes, nodes}, hidden);
        return tree.first_hit({0.2, 0.2, -1}, {0.2, 0.2, 2}, 0, 1, -1).facet;
    };
    EXPECT_EQ(first({}), 0);
    EXPECT_EQ(first({1, 0}), 1);
    EXPECT_EQ(first({1, 1}), -1);
    EXPECT_EQ(first({0, 1}), 0);
}

}  // namespace
}  // namespace corpuscle
