#include "mesh/facet_tree.hpp"

#include <gtest/gtest.h>

#include "facet_tree_surfaces.hpp"

namespace corpuscle {
namespace {

using Real = long double;
using Point = Vector3<Real>;

/// A path and a facet in long double: everything again, straight from the definition.
struct ReferencePath {
    Vector3d start, end;
    double from = 0, to = 1;

    [[nodiscard]] Point corner(const MovingSurface& s, std::uint32_t node, Real t) const
    {
        const Real fraction = from + t * (Real(to) - from);
        return Point(s.start[node]) + fraction * (Point(s.end[node]) - Point(s.start[node]));
    }
    [[nodiscard]] Point place(Real t) const { return Point(start) + t * (Point(end) - Point(start)); }
    [[nodiscard]] Real side(const MovingSurface& s, const Facet& f, Real t) const
    {
        const Point a = corner(s, f.node[0], t), b = corner(s, f.node[1], t), c = corner(s, f.node[2], t);
        return dot(place(t) - a, cross(b - a, c - a));
    }
    /// Smallest of the weights of the facet's corners at the place of time t.
    [[nodiscard]] Real least_weight(const MovingSurface& s, const Facet& f, Real t) const
    {
        const Point a = corner(s, f.node[0], t), b = corner(s, f.node[1], t), c = corner(s, f.node[2], t), x = place(t);
        const Point n = cross(b - a, c - a);
        return std::min({dot(n, cross(b - x, c - x)), dot(n, cross(c - x, a - x)), dot(n, cross(a - x, b - x))}) / norm_squared(n);
    }
};

/// Times at which the path crosses the plane of the facet: the cubic through four samples gives the turning points, halving the roots.
std::vector<Real> crossings(const ReferencePath& path, const MovingSurface& s, const Facet& f)
{
    const Real y0 = path.side(s, f, 0), y1 = path.side(s, f, Real(1) / 3), y2 = path.side(s, f, Real(2) / 3), y3 = path.side(s, f, 1);
    const Real c3 = 4.5L * (y3 - 3 * y2 + 3 * y1 - y0), c2 = 4.5L * (y0 - 2 * y1 + y2) - c3, c1 = y3 - y0 - c2 - c3;
    std::vector<Real> ends{0};
    const Real root = c2 * c2 - 3 * c1 * c3;
    if (root > 0 && c3 != 0) {
        Real first = (-c2 - std::sqrt(root)) / (3 * c3), second = (-c2 + std::sqrt(root)) / (3 * c3);
        if (first > second) std::swap(first, second);
        for (const Real t : {first, second}) {
            if (t > 0 && t < 1) ends.push_back(t);
        }
    }
    ends.push_back(1);
    std::vector<Real> found;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        Real low = ends[i], high = ends[i + 1];
        const bool below = path.side(s, f, low) < 0;
        if (below == (path.side(s, f, high) < 0)) continue;
        for (int step = 0; step < 70; ++step) {
            const Real middle = (low + high) / 2;
            ((path.side(s, f, middle) < 0) == below ? low : high) = middle;
        }
        found.push_back((low + high) / 2);
    }
    return found;
}

/// What first_hit should find, and whether a crossing is so close to an edge that either answer is right.
struct Expected {
    std::int64_t facet = -1;
    Real fraction = 2;
    bool doubtful = false;
};

Expected brute_force(const ReferencePath& path, const MovingSurface& s)
{
    Expected expected;
    for (std::size_t f = 0; f < s.surface.facets.size(); ++f) {
        for (const Real t : crossings(path, s, s.surface.facets[f])) {
            const Real weight = path.least_weight(s, s.surface.facets[f], t);
            expected.doubtful |= std::abs(weight) < 1e-7L && t < expected.fraction;
            if (weight < 0 || t >= expected.fraction) continue;
            expected.facet = static_cast<std::int64_t>(f);
            expected.fraction = t;
        }
    }
    return expected;
}

/// Compares first_hit with the brute force on random paths; returns hits found.
int compare_random_paths(const MovingSurface& s, int paths, double length, bool frozen)
{
    FacetTree tree(s.surface);
    tree.follow(s.path());
    Random random(7, Purpose::contact, 1, 0);
    int hits = 0, doubtful = 0;
    for (int i = 0; i < paths; ++i) {
        ReferencePath path;
        path.start = 1.2 * uniform_vector(random);
        path.end = path.start + length * uniform_vector(random);
        path.from = random.uniform_double();
        path.to = frozen ? path.from : path.from + (1 - path.from) * random.uniform_double();
        const Expected expected = brute_force(path, s);
        const FacetTree::Hit hit = tree.first_hit(path.start, path.end, path.from, path.to, -1);
        if (expected.doubtful && hit.facet != expected.facet) {
            ++doubtful;
            continue;
        }
        EXPECT_EQ(hit.facet, expected.facet) << "path " << i;
        if (hit.facet < 0 || hit.facet != expected.facet) continue;
        ++hits;
        EXPECT_NEAR(hit.fraction, static_cast<double>(expected.fraction), 1e-9);
        Vector3d point;
        const std::array<Vector3d, 3> at = tree.corners(hit.facet, path.from + hit.fraction * (path.to - path.from));
        for (int n = 0; n < 3; ++n) point += hit.weight[n] * at[n];
        EXPECT_LT(norm(point - (path.start + hit.fraction * (path.end - path.start))), 1e-9);
        EXPECT_NEAR(norm(hit.normal), 1, 1e-12);
        const Vector3d own_normal = cross(at[1] - at[0], at[2] - at[0]);
        const Real before = path.side(s, s.surface.facets[hit.facet], std::max(0.0, hit.fraction - 1e-6));
        EXPECT_GT(static_cast<double>(before) * dot(own_normal, hit.normal), 0);
    }
    EXPECT_LE(doubtful, paths / 500);
    return hits;
}

TEST(FacetTree, first_hit_agrees_with_brute_force_on_moving_facets)
{
    EXPECT_GT(compare_random_paths(random_surface(150, 0.3, 1), 1500, 0.5, false), 250);
}

TEST(FacetTree, first_hit_agrees_with_brute_force_on_short_paths_among_small_facets)
{
    EXPECT_GT(compare_random_paths(random_surface(400, 0.02, 2), 1500, 0.05, false), 50);
}

TEST(FacetTree, first_hit_agrees_with_brute_force_on_facets_at_rest)
{
    EXPECT_GT(compare_random_paths(random_surface(150, 0.3, 3), 2000, 1.0, true), 500);
}

/// A sphere that turns, grows and moves in one step.
MovingSurface turning_sphere()
{
    MovingSurface sphere = sphere_surface(0.5, 3);
    for (std::size_t n = 0; n < sphere.start.size(); ++n) {
        const Vector3d p = sphere.start[n];
        sphere.end[n] = 1.1 * Vector3d{0.96 * p.x - 0.28 * p.y, 0.28 * p.x + 0.96 * p.y, p.z} + Vector3d{0.03, -0.02, 0.04};
    }
    return sphere;
}

TEST(FacetTree, paths_aimed_at_edges_and_corners_always_hit)
{
    const MovingSurface sphere = turning_sphere();
    FacetTree tree(sphere.surface);
    tree.follow(sphere.path());
    Random random(3, Purpose::contact, 2, 0);
    for (const Facet& facet : sphere.surface.facets) {
        for (int i = 0; i < 12; ++i) {
            const double t = 0.05 + 0.9 * random.uniform_double();
            const double along = i < 2 ? 0 : random.uniform_double();
            const NodePath path = sphere.path();
            const Vector3d aim = (1 - along) * path.at(facet.node[i % 3], t) + along * path.at(facet.node[(i + 1) % 3], t);
            const Vector3d start = 0.2 * uniform_vector(random);
            const FacetTree::Hit hit = tree.first_hit(start, start + (aim - start) / t, 0, 1, -1);
            ASSERT_GE(hit.facet, 0);
            EXPECT_NEAR(hit.fraction, t, 1e-7);
        }
    }
}

TEST(FacetTree, paths_that_graze_along_a_facet_do_not_leave_the_box)
{
    const MovingSurface sphere = sphere_surface(0.5, 2);
    FacetTree tree(sphere.surface);
    tree.follow(sphere.path());
    Random random(4, Purpose::contact, 3, 0);
    for (const Facet& facet : sphere.surface.facets) {
        const Vector3d a = sphere.start[facet.node[0]], b = sphere.start[facet.node[1]], c = sphere.start[facet.node[2]];
        const Vector3d inward = -normalized(cross(b - a, c - a));
        for (const double height : {1e-6, 1e-9, 1e-11, 1e-13}) {
            const Vector3d start = (a + b + c) / 3.0 + height * inward;
            const Vector3d along = normalized(a - b) + (random.uniform_double() - 0.5) * height * inward;
            ASSERT_GE(tree.first_hit(start, start + along, 0, 1, -1).facet, 0) << height;
        }
    }
}

TEST(FacetTree, a_facet_overtakes_a_point_at_rest)
{
    MovingSurface wall;
    wall.start = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    wall.end = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    wall.surface.facets = {{{0, 1, 2}, 0, 0}};
    FacetTree tree(wall.surface);
    tree.follow(wall.path());
    const Vector3d rest{0.25, 0.25, 0.25};
    const FacetTree::Hit hit = tree.first_hit(rest, rest, 0, 1, -1);
    EXPECT_EQ(hit.facet, 0);
    EXPECT_DOUBLE_EQ(hit.fraction, 0.25);
    EXPECT_DOUBLE_EQ(hit.normal.z, 1);
    EXPECT_EQ(tree.first_hit(rest, rest, 0, 0.2, -1).facet, -1);
    EXPECT_EQ(tree.first_hit(rest, rest, 0.3, 1, -1).facet, -1);
    EXPECT_EQ(tree.first_hit(rest, rest, 0.5, 0.5, -1).facet, -1);
}

TEST(FacetTree, what_starts_on_a_facet_meets_it_only_again)
{
    MovingSurface wall;
    wall.start = {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}};
    wall.end = {{-9, -9, 0}, {9, -9, 0}, {0, 9, 2}};
    wall.surface.facets = {{{0, 1, 2}, 0, 0}};
    FacetTree tree(wall.surface);
    tree.follow(wall.path());
    const Vector3d start{0, 0, 0};
    EXPECT_EQ(tree.first_hit(start, {0, 0, 3}, 0, 1, 0).facet, -1);
    EXPECT_EQ(tree.first_hit(start, {0, 0, -3}, 0, 1, 0).facet, -1);
    const FacetTree::Hit again = tree.first_hit(start, {0, 8.5, 1.2}, 0, 1, 0);  // z = 1.2 t meets the rising z = (y + 9) t/9 at y = 1.8
    EXPECT_EQ(again.facet, 0);
    EXPECT_NEAR(again.fraction, 1.8 / 8.5, 1e-12);
    EXPECT_GT(again.normal.z, 0);
    EXPECT_EQ(tree.first_hit(start, {0, 0, 3}, 0, 1, -1).facet, -1);
    EXPECT_EQ(tree.first_hit({0, 0, 1e-9}, {0, 0, -3}, 0, 0, -1).facet, 0);
}

TEST(FacetTree, a_path_that_ends_on_a_facet_hits_it)
{
    MovingSurface wall;
    wall.start = wall.end = {{0, 0, 0.7}, {1, 0, 0.7}, {0, 1, 0.7}};
    wall.surface.facets = {{{0, 1, 2}, 0, 0}};
    FacetTree tree(wall.surface);
    tree.follow(wall.path());
    const FacetTree::Hit hit = tree.first_hit({0.3, 0.3, 0.2}, {0.2, 0.3, 0.7}, 0, 1, -1);
    EXPECT_EQ(hit.facet, 0);
    EXPECT_DOUBLE_EQ(hit.fraction, 1);
    EXPECT_DOUBLE_EQ(hit.normal.z, -1);
}

TEST(FacetTree, separates_tells_inside_from_outside)
{
    MovingSurface sphere = sphere_surface(0.5, 3);
    for (Vector3d& p : sphere.end) p += Vector3d{0.4, 0, 0};
    FacetTree tree(sphere.surface);
    tree.follow(sphere.path());
    Random random(5, Purpose::contact, 4, 0);
    int apart = 0, together = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vector3d a = 0.6 * uniform_vector(random), b = a + 0.2 * uniform_vector(random);
        const bool near = std::abs(norm(a) - 0.49) < 0.015 || std::abs(norm(b) - 0.49) < 0.015;  // between the facets and the true sphere
        if (near) continue;
        const bool a_inside = norm(a) < 0.49, b_inside = norm(b) < 0.49;
        if (a_inside != b_inside) {
            EXPECT_TRUE(tree.separates(a, b));
            ++apart;
        } else if (a_inside) {
            EXPECT_FALSE(tree.separates(a, b));
            ++together;
        }
    }
    EXPECT_GT(apart, 500);
    EXPECT_GT(together, 2000);
}

/// Squared distance from a point to a triangle (regions of the barycentric plane, then its edges).
double distance_squared(const Vector3d& p, const std::array<Vector3d, 3>& t)
{
    double least = norm_squared(p - t[0]);
    for (int i = 0; i < 3; ++i) {
        const Vector3d edge = t[(i + 1) % 3] - t[i];
        const double along = std::clamp(dot(p - t[i], edge) / norm_squared(edge), 0.0, 1.0);
        least = std::min(least, norm_squared(p - t[i] - along * edge));
    }
    const Vector3d n = cross(t[1] - t[0], t[2] - t[0]);
    bool within = true;
    for (int i = 0; i < 3; ++i) within = within && dot(cross(t[(i + 1) % 3] - t[i], p - t[i]), n) >= 0;
    return within ? std::min(least, std::pow(dot(p - t[0], n), 2) / norm_squared(n)) : least;
}

/// Checks clearance against distances at several moments of the step; returns the mean of clearance over distance.
double check_clearance(const FacetTree& tree, Random& random, double span)
{
    double ratio = 0;
    const int points = 300;
    for (int i = 0; i < points; ++i) {
        const Vector3f p(span * uniform_vector(random));
        double nearest = 1e30;
        for (std::size_t f = 0; f < tree.size(); ++f) {
            for (const double t : {0.0, 0.3, 0.7, 1.0}) {
                nearest = std::min(nearest, distance_squared(Vector3d(p), tree.corners(static_cast<std::int64_t>(f), t)));
            }
        }
        EXPECT_LE(tree.clearance(p), std::sqrt(nearest));
        ratio += tree.clearance(p) / std::sqrt(nearest) / points;
    }
    return ratio;
}

TEST(FacetTree, clearance_is_a_lower_bound_through_many_steps_and_few_rebuilds)
{
    MovingSurface sphere = sphere_surface(0.5, 2);
    FacetTree tree(sphere.surface);
    Random random(6, Purpose::contact, 5, 0);
    for (int step = 0; step < 40; ++step) {
        sphere.start = sphere.end;
        for (Vector3d& p : sphere.end) p = 1.001 * Vector3d{p.x - 0.002 * p.y, p.y + 0.002 * p.x, p.z} + Vector3d{0.002, 0, 0};
        tree.follow(sphere.path());
        EXPECT_GT(check_clearance(tree, random, 1.0), 0.3);
    }
    EXPECT_GT(tree.grid().listings(), 1);
    EXPECT_LT(tree.grid().listings(), 10);
}

TEST(FacetTree, clearance_is_a_lower_bound_for_facets_of_very_unequal_size)
{
    const MovingSurface thrown = random_surface(300, 0.01, 8);
    FacetTree tree(thrown.surface);
    tree.follow(thrown.path());
    Random random(9, Purpose::contact, 6, 0);
    check_clearance(tree, random, 2.5);
}

TEST(FacetTree, clearance_next_to_a_flat_plate_is_nearly_the_distance)
{
    MovingSurface plate;
    for (int j = 0; j <= 20; ++j) {
        for (int i = 0; i <= 20; ++i) plate.start.push_back({0.05 * i, 0.05 * j, 0});
    }
    for (std::uint32_t j = 0; j < 20; ++j) {
        for (std::uint32_t i = 0; i < 20; ++i) {
            const std::uint32_t a = 21 * j + i;
            plate.surface.facets.push_back({{a, a + 1, a + 22}, 0, 0});
            plate.surface.facets.push_back({{a, a + 22, a + 21}, 0, 0});
        }
    }
    plate.end = plate.start;
    FacetTree tree(plate.surface);
    tree.follow(plate.path());
    for (const float z : {0.01f, 0.1f, -0.3f}) EXPECT_GT(tree.clearance({0.5f, 0.5f, z}), std::abs(z) - 0.005f);
    EXPECT_EQ(tree.clearance({0.5f, 0.5f, 0.001f}), 0);
    EXPECT_NEAR(tree.clearance({4.0f, 5.0f, 0.0f}), 5, 0.01);
}

TEST(FacetTree, a_restored_tree_gives_the_same_clearance)
{
    MovingSurface sphere = sphere_surface(0.5, 3);
    FacetTree tree(sphere.surface);
    for (int step = 0; step < 9; ++step) {
        sphere.start = sphere.end;
        for (Vector3d& p : sphere.end) p += p.x > 0 ? Vector3d{1e-3 * (step + 1), 0, 0} : Vector3d{};
        tree.follow(sphere.path());
    }
    EXPECT_GT(tree.grid().listings(), tree.grid().placings());
    FacetTree restored(sphere.surface), anew(sphere.surface);
    const FieldSet saved = tree.state();
    FieldSet taken = restored.state();
    for (std::size_t f = 0; f < saved.fields.size(); ++f) {
        const Field& field = saved.fields[f];
        std::vector<std::byte> values(field.count * static_cast<std::size_t>(field.components) * size_of(field.scalar));
        field.gather(values.data());
        taken.fields[f].restore(values.data(), field.count);
    }
    restored.follow(sphere.path());
    anew.follow(sphere.path());
    Random random(10, Purpose::contact, 7, 0);
    int unlike = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vector3f p(uniform_vector(random));
        EXPECT_EQ(tree.clearance(p), restored.clearance(p));
        unlike += tree.clearance(p) != anew.clearance(p);
    }
    EXPECT_GT(unlike, 0);
}

TEST(FacetTree, nothing_is_near_an_empty_surface)
{
    const Surface nothing;
    FacetTree tree(nothing);
    tree.follow({});
    EXPECT_EQ(tree.clearance({1, 2, 3}), std::numeric_limits<double>::infinity());
    EXPECT_FALSE(tree.separates({0, 0, 0}, {1, 1, 1}));
    EXPECT_EQ(tree.first_hit({0, 0, 0}, {1, 1, 1}, 0, 1, -1).facet, -1);
}

}  // namespace
}  // namespace corpuscle
