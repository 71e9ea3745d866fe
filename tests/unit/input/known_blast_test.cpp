#include "input/known_blast.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "input/case/read_case.hpp"
#include "input/presets.hpp"

namespace corpuscle {
namespace {

/// A charge in a box of air whose floor, z = 0, is rigid.
std::optional<KnownBlast> blast_of(const std::string& charges, const std::string& fill = "\"air\"")
{
    CaseDescription description = read_case_text("title = \"t\"\nend_time = \"1 ms\"\n" + charges +
                                                     "[gas]\nbox = [[-2, 2], [-2, 2], [0, 3]]\nedges = { z = [\"rigid\", \"ambient\"] }\n"
                                                     "particles = 1000\nfill = " +
                                                     fill + "\n",
                                                 "case.toml", {});
    resolve_presets(description, {std::filesystem::path(CORPUSCLE_SOURCE_DIR) / "share"});
    return known_blast(description);
}

std::string charge(const std::string& explosive, const std::string& more)
{
    return "[[charge]]\nexplosive = \"" + explosive + "\"\nmass = \"2 kg\"\n" + more + "\n";
}

TEST(KnownBlast, IsThatOfABallOfTnt)
{
    const auto blast = blast_of(charge("tnt", R"(shape = "sphere"
center = [0, 0, 1]
detonation = [{ point = [0, 0, 1], time = "20 us" }, { point = [0, 0.01, 1], time = "10 us" }])"));
    ASSERT_TRUE(blast);
    EXPECT_NEAR(blast->mass, 2, 1e-9);
    EXPECT_EQ(blast->center, (Vector3d{0, 0, 1}));
    EXPECT_EQ(blast->burst, Burst::spherical);
    EXPECT_DOUBLE_EQ(blast->time, 1e-5);
    EXPECT_NEAR(blast->ambient, 101325, 50);
}

/// C-4: 9.0 GJ/m3 at 1601 kg/m3 beside 7.0 at 1630 (share/explosives).
TEST(KnownBlast, CountsAnotherExplosiveByItsEnergy)
{
    const auto blast = blast_of(charge("c4", "shape = \"sphere\"\ncenter = [0, 0, 1]"));
    ASSERT_TRUE(blast);
    EXPECT_NEAR(blast->mass, 2 * (9.0 / 1601) / (7.0 / 1630), 1e-3);
}

TEST(KnownBlast, OfAHemisphereOnTheGroundIsASurfaceBurst)
{
    const auto ground = blast_of(charge("tnt", "shape = \"hemisphere\"\ncenter = [0, 0, 0]"));
    ASSERT_TRUE(ground);
    EXPECT_EQ(ground->burst, Burst::hemispherical);
    EXPECT_NEAR(ground->mass, 2, 1e-9);
    EXPECT_FALSE(blast_of(charge("tnt", "shape = \"hemisphere\"\ncenter = [0, 0, 1]")));
}

TEST(KnownBlast, IsNoneWhereTheCurvesDoNotApply)
{
    const std::string ball = charge("tnt", "shape = \"sphere\"\ncenter = [0, 0, 1]");
    EXPECT_FALSE(blast_of(charge("tnt", "shape = \"cylinder\"\ncenter = [0, 0, 1]")));
    EXPECT_FALSE(blast_of(ball + charge("tnt", "shape = \"sphere\"\ncenter = [1, 0, 1]")));
    EXPECT_FALSE(blast_of(ball, "{ gamma = 1.4, density = 0.6, pressure = \"50 kPa\" }"));
}

}  // namespace
}  // namespace corpuscle
