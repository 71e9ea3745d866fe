#include "mesh/facet_grid.hpp"

#include <gtest/gtest.h>

#include "facet_tree_surfaces.hpp"
#include "mesh/facet_tree.hpp"
#include "parallel/loops.hpp"

namespace corpuscle {
namespace {

/// A ball that flies past a plate at rest, which later moves off, too.
struct BallAndPlate {
    BallAndPlate()
    {
        const MovingSurface ball = sphere_surface(0.2, 2);
        surface = ball;
        balls_nodes = ball.start.size();
        for (int j = 0; j <= 20; ++j) {
            for (int i = 0; i <= 20; ++i) surface.start.push_back({0.1 * i - 1, 0.1 * j - 1, -0.5});
        }
        for (std::uint32_t j = 0; j < 20; ++j) {
            for (std::uint32_t i = 0; i < 20; ++i) {
                const std::uint32_t a = static_cast<std::uint32_t>(balls_nodes) + 21 * j + i;
                surface.surface.facets.push_back({{a, a + 1, a + 22}, 0, 0});
                surface.surface.facets.push_back({{a, a + 22, a + 21}, 0, 0});
            }
        }
        surface.end = surface.start;
        surface.surface.hidden.assign(surface.surface.facets.size(), 0);
    }

    /// Makes a step: the ball flies and turns, the plate moves by so much.
    void step(const Vector3d& plates_way)
    {
        surface.start = surface.end;
        for (std::size_t n = 0; n < surface.end.size(); ++n) {
            Vector3d& p = surface.end[n];
            p = n < balls_nodes ? Vector3d{p.x - 0.01 * p.z, p.y, p.z + 0.01 * p.x} + Vector3d{0.02, 0, 0} : p + plates_way;
        }
    }

    [[nodiscard]] std::size_t balls_facets() const { return surface.surface.facets.size() - 800; }

    MovingSurface surface;
    std::size_t balls_nodes = 0;
};

/// Compares what the tree finds with what one made anew finds, on random paths; returns hits.
int compare_with_new(const FacetTree& tree, const BallAndPlate& bodies, Random& random)
{
    FacetTree anew(bodies.surface.surface);
    anew.follow(bodies.surface.path(), bodies.surface.surface.hidden);
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vector3d start = uniform_vector(random), end = start + 0.5 * uniform_vector(random);
        const FacetTree::Hit hit = tree.first_hit(start, end, 0, 1, -1), expected = anew.first_hit(start, end, 0, 1, -1);
        EXPECT_EQ(hit.facet, expected.facet);
        EXPECT_EQ(hit.fraction, expected.fraction);
        if (expected.facet >= 0) {
            ++hits;
            EXPECT_LE(tree.clearance(Vector3f(start)), norm(expected.fraction * (end - start)) * (1 + 1e-12));
        }
    }
    return hits;
}

TEST(FacetGrid, what_rests_is_listed_once_and_what_moves_is_found)
{
    BallAndPlate bodies;
    FacetTree tree(bodies.surface.surface);
    Random random(1, Purpose::contact, 8, 0);
    for (int step = 0; step < 20; ++step) {
        bodies.step({});
        tree.follow(bodies.surface.path());
        EXPECT_GT(compare_with_new(tree, bodies, random), 50);
    }
    EXPECT_GT(tree.grid().listings(), 4u);
    EXPECT_EQ(tree.grid().placings(), 1u);  // along the plate there is room, and across it the ball moves less than the 3 cells left free
}

TEST(FacetGrid, what_rests_is_found_where_it_went_when_it_moves_off)
{
    BallAndPlate bodies;
    FacetTree tree(bodies.surface.surface);
    Random random(2, Purpose::contact, 8, 0);
    for (int step = 0; step < 12; ++step) {
        bodies.step(step < 4 || step > 8 ? Vector3d{} : Vector3d{0, 0, 0.05});
        tree.follow(bodies.surface.path());
        EXPECT_GT(compare_with_new(tree, bodies, random), 50) << step;
    }
}

TEST(FacetGrid, what_rests_is_no_longer_met_once_hidden)
{
    BallAndPlate bodies;
    FacetTree tree(bodies.surface.surface);
    std::vector<std::uint8_t>& hidden = bodies.surface.surface.hidden;
    const auto facet = static_cast<std::int64_t>(bodies.balls_facets());
    const std::array<Vector3d, 3> at = [&] {
        std::array<Vector3d, 3> corners;
        for (int i = 0; i < 3; ++i)
            corners[i] = bodies.surface.start[bodies.surface.surface.facets[static_cast<std::size_t>(facet)].node[i]];
        return corners;
    }();
    const Vector3d middle = (at[0] + at[1] + at[2]) / 3.0, above{0, 0, 0.1};
    for (const bool gone : {false, true, false}) {
        hidden[static_cast<std::size_t>(facet)] = gone ? 1 : 0;
        bodies.step({});
        tree.follow(bodies.surface.path(), hidden);
        EXPECT_EQ(tree.first_hit(middle + above, middle - above, 0, 1, -1).facet, gone ? -1 : facet);
    }
}

/// Facets by cell, in the order in which the lists have them.
std::vector<std::uint32_t> all_listed(const FacetLists& lists)
{
    std::vector<std::uint32_t> facets;
    lists.visit(lists.block(), [&](std::uint32_t facet) { facets.push_back(facet); });
    return facets;
}

/// Places for lists: a cloud of triangles.
struct Cloud {
    explicit Cloud(std::uint32_t facets)
    {
        const MovingSurface thrown = random_surface(facets, 0, 3);
        corners = thrown.start;
        reach.assign(facets, {{-0.01, -0.002, -0.03}, {0.02, 0.005, 0.01}});
        for (std::uint32_t f = 0; f < facets; f += 2) numbers.push_back(f);
        lattice.lower = {-2.1, -2.1, -2.1};
        lattice.upper = {2.1, 2.1, 2.1};
        lattice.size = 0.1;
        lattice.inverse_size = 10;
        lattice.count = {42, 42, 42};
    }
    std::vector<Vector3d> corners;
    std::vector<Box> reach;
    std::vector<std::uint32_t> numbers;
    Lattice lattice;
};

TEST(FacetLists, are_the_same_for_any_number_of_threads)
{
    const Cloud cloud(40000);
    const int before = thread_count();
    std::vector<std::vector<std::uint32_t>> found;
    for (const int threads : {1, 2, 3, 7}) {
        set_thread_count(threads);
        FacetLists lists;
        lists.make(cloud.lattice, {cloud.corners, cloud.reach}, cloud.numbers);
        found.push_back(all_listed(lists));
    }
    set_thread_count(before);
    EXPECT_GT(found[0].size(), cloud.numbers.size());
    for (const auto& other : found) EXPECT_EQ(other, found[0]);
}

TEST(FacetLists, name_a_facet_in_every_cell_that_it_meets)
{
    const Cloud cloud(200);
    FacetLists lists;
    lists.make(cloud.lattice, {cloud.corners, cloud.reach}, cloud.numbers);
    Random random(4, Purpose::contact, 8, 0);
    for (const std::uint32_t facet : cloud.numbers) {
        for (int i = 0; i < 20; ++i) {
            const double u = random.uniform_double(), v = (1 - u) * random.uniform_double();
            const Vector3d* p = &cloud.corners[3 * static_cast<std::size_t>(facet)];
            std::array<Vector3d, 3> moved;
            for (int k = 0; k < 3; ++k) {
                const Vector3d share = 0.5 * (uniform_vector(random) + Vector3d{1, 1, 1});
                moved[k] = p[k] + cloud.reach[facet].lower + scaled(share, cloud.reach[facet].size());
            }
            const Vector3d at = (1 - u - v) * moved[0] + u * moved[1] + v * moved[2];
            Box point;
            point.include(at);
            bool named = false;
            lists.visit(cloud.lattice.block(point), [&](std::uint32_t f) { named = named || f == facet; });
            ASSERT_TRUE(named);
        }
    }
}

TEST(ClearanceMap, counts_cells_to_the_nearest_that_lists_facets)
{
    const Cloud cloud(12);
    const std::vector<std::uint32_t> first(cloud.numbers.begin(), cloud.numbers.begin() + 2),
        second(cloud.numbers.begin() + 2, cloud.numbers.begin() + 4), third(cloud.numbers.begin() + 4, cloud.numbers.end());
    FacetLists still, moving;
    still.make(cloud.lattice, {cloud.corners, cloud.reach}, first);
    moving.make(cloud.lattice, {cloud.corners, cloud.reach}, second);
    ClearanceMap map;
    map.measure(cloud.lattice, still, moving);
    moving.make(cloud.lattice, {cloud.corners, cloud.reach}, third);
    map.measure_moving(moving);
    std::vector<std::array<std::int32_t, 3>> named;
    for (std::int32_t z = 0; z < 42; ++z) {
        for (std::int32_t y = 0; y < 42; ++y) {
            for (std::int32_t x = 0; x < 42; ++x) {
                bool any = false;
                for (const FacetLists* lists : {&still, &moving}) lists->visit({{x, y, z}, {x, y, z}}, [&](std::uint32_t) { any = true; });
                if (any) named.push_back({x, y, z});
            }
        }
    }
    ASSERT_FALSE(named.empty());
    Random random(5, Purpose::contact, 8, 0);
    int beyond = 0;
    for (int i = 0; i < 3000; ++i) {
        const std::array<std::int32_t, 3> c{static_cast<std::int32_t>(random.below(42)), static_cast<std::int32_t>(random.below(42)),
                                            static_cast<std::int32_t>(random.below(42))};
        std::int32_t nearest = ClearanceMap::limit;
        for (const auto& n : named)
            nearest = std::min(nearest, std::max({std::abs(n[0] - c[0]), std::abs(n[1] - c[1]), std::abs(n[2] - c[2])}));
        ASSERT_EQ(map.cells_to_nearest(c), nearest);
        beyond += nearest == ClearanceMap::limit;
    }
    EXPECT_LT(beyond, 3000);
}

}  // namespace
}  // namespace corpuscle
