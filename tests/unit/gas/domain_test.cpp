#include "gas/domain.hpp"

#include <gtest/gtest.h>

#include "gas/faces.hpp"
#include "gas_samples.hpp"

namespace corpuscle {
namespace {

const Box box{{0, 0, 0}, {1, 2, 4}};

Gas gas_with(const std::array<Edge, face_count>& edges)
{
    Gas gas;
    gas.domain = {box, edges};
    gas.species.push_back(species_of(IdealGas{1.4}, 0.5));
    return gas;
}
constexpr Edge R = Edge::rigid, O = Edge::open, A = Edge::ambient;

TEST(Domain, finds_the_first_face_that_a_path_leaves_by)
{
    const Domain domain{box, {}};
    EXPECT_EQ(domain.first_exit({0.5, 1, 2}, {0.9, 0, 4}).face, -1);
    const auto by_x = domain.first_exit({0.5, 1, 2}, {1.5, 2.5, 2});
    EXPECT_EQ(by_x.face, 1);
    EXPECT_DOUBLE_EQ(by_x.fraction, 0.5);
    const auto by_y = domain.first_exit({0.5, 1, 2}, {1.5, 3.5, 2});
    EXPECT_EQ(by_y.face, 3);
    EXPECT_DOUBLE_EQ(by_y.fraction, 0.4);
    const auto by_z = domain.first_exit({0.5, 1, 1}, {-0.1, 1, -3});
    EXPECT_EQ(by_z.face, 4);
    EXPECT_DOUBLE_EQ(by_z.fraction, 0.25);
    EXPECT_EQ(domain.first_exit({-0.5, 1, 1}, {-0.5, 1, 1}).fraction, 0);
    EXPECT_EQ(domain.first_exit({-0.5, 1, 1}, {-0.7, 1, 1}).face, 0);
}

TEST(Faces, rigid_ones_make_the_mirror_image)
{
    const Gas gas = gas_with({R, R, R, R, R, R});
    FacePassages passages;
    Particle p{{1.25f, -0.5f, 3}, 7, {10, -20, 5}, 0};
    keep_in_domain(gas, p, passages);
    EXPECT_EQ(p.position, (Vector3f{0.75f, 0.5f, 3}));
    EXPECT_EQ(p.velocity, (Vector3f{-10, 20, 5}));
    EXPECT_EQ(p.energy, 7);
    EXPECT_EQ(passages.face[1].momentum, (Vector3d{2 * 0.5 * 10, 0, 0}));
    EXPECT_EQ(passages.face[2].momentum, (Vector3d{0, 2 * 0.5 * -20, 0}));
    for (const Passage& passage : passages.face) EXPECT_EQ(passage.mass, 0);
    for (const Passage& passage : passages.face) EXPECT_EQ(passage.energy, 0);
}

/// A path longer than the box: every crossing turns the velocity, and the impulses add up.
TEST(Faces, rigid_ones_turn_a_long_path_again_and_again)
{
    const Gas gas = gas_with({R, R, R, R, R, R});
    FacePassages passages;
    Particle p{{3.25f, 1, 1}, 0, {10, 0, 0}, 0};  // 1 -> mirrored to -1.25, to 1.25, to 0.75: three bounces
    keep_in_domain(gas, p, passages);
    EXPECT_EQ(p.position.x, 0.75f);
    EXPECT_EQ(p.velocity.x, -10);
    EXPECT_EQ(passages.face[1].momentum.x, 2 * 0.5 * 10 * 2);
    EXPECT_EQ(passages.face[0].momentum.x, -2 * 0.5 * 10);
}

TEST(Faces, open_and_ambient_ones_let_go_with_all_that_is_carried)
{
    for (const Edge edge : {O, A}) {
        const Gas gas = gas_with({R, R, R, R, R, edge});
        FacePassages passages;
        Particle p{{0.5f, 1, 4.25f}, 7, {1, 2, 3}, 0};
        keep_in_domain(gas, p, passages);
        EXPECT_TRUE(p.tag & particle_tag::gone);
        EXPECT_EQ(passages.face[5].mass, 0.5);
        EXPECT_EQ(passages.face[5].momentum, (Vector3d{0.5, 1, 1.5}));
        EXPECT_EQ(passages.face[5].energy, 0.25 * 14 + 7);
    }
}

TEST(Faces, in_a_corner_the_wall_reflects_and_the_opening_takes)
{
    const Gas gas = gas_with({R, R, O, O, R, R});
    FacePassages passages;
    Particle p{{-0.25f, 2.25f, 1}, 0, {-4, 4, 0}, 0};
    keep_in_domain(gas, p, passages);
    EXPECT_TRUE(p.tag & particle_tag::gone);
    EXPECT_EQ(passages.face[0].momentum.x, 2 * 0.5 * -4);
    EXPECT_EQ(passages.face[3].momentum, (Vector3d{0.5 * 4, 0.5 * 4, 0}));
    EXPECT_EQ(passages.face[3].mass, 0.5);
}

/// What the noise of a face's impulse is known by: the squares of its parts.
TEST(Faces, add_up_the_squares_of_impulses)
{
    const Gas gas = gas_with({R, R, R, R, R, R});
    FacePassages passages;
    for (const float speed : {-4.0f, -1.0f}) {
        Particle p{{-0.25f, 1, 1}, 0, {speed, 4, 0}, 0};
        keep_in_domain(gas, p, passages);
    }
    EXPECT_EQ(passages.squares[0], 4.0 * 4.0 + 1.0);
    FacePassages twice = passages;
    twice += passages;
    EXPECT_EQ(twice.squares[0], 2 * passages.squares[0]);
    EXPECT_EQ(passages.squares[1], 0);
}

TEST(Faces, leave_alone_what_is_inside)
{
    const Gas gas = gas_with({R, O, A, R, O, A});
    FacePassages passages;
    Particle p{{0.5f, 1, 2}, 7, {1, 2, 3}, 0};
    const auto before = bits(p);
    keep_in_domain(gas, p, passages);
    EXPECT_EQ(bits(p), before);
    for (const Passage& passage : passages.face) EXPECT_TRUE(same_bits(passage, Passage{}));
}

}  // namespace
}  // namespace corpuscle
