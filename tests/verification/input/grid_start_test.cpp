#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "input/build.hpp"
#include "input/survey.hpp"
#include "model/grid_books.hpp"
#include "unit/input/euler_case.hpp"

using namespace corpuscle;
using ::testing::HasSubstr;

/// Masses, momentum and energy are those of the one-dimensional blast's part and of the still gas around it, in every symmetry.
TEST(GridStart, KeepsMassMomentumAndEnergy)
{
    struct Part {
        const std::string& grid;
        double share;
        Vector3d direction;  ///< mean outward direction in that part of the sphere
    };
    for (const Part& part : {Part{octant_grid, 0.125, {0.5, 0.5, 0.5}}, Part{ring_grid, 0.5, {0, 0, 0.5}}, Part{shell_grid, 1, {}}}) {
        const CaseDescription description = grid_case(part.grid, "", {"euler.start=spherical"});
        CaseSurvey survey = survey_case(description);
        const FreeBlast blast = *survey.euler->start;
        EXPECT_GE(blast.front, 0.95 * 0.4);
        EXPECT_LE(blast.front, 0.4);
        const auto model = build(description, survey);
        EXPECT_EQ(model->start_time, blast.time);
        const EulerContents held = contents(model->euler);
        double volume = 0;
        for (std::size_t c = 0; c < model->euler.cells(); ++c) volume += model->euler.volume(c);
        const double still = 1.2 * (volume - part.share * 4 * std::numbers::pi / 3 * std::pow(blast.front, 3));
        const double air = part.share * blast.gas[1].mass + still;
        EXPECT_NEAR(held.gas.mass[1], part.share * blast.gas[0].mass, 1e-13);
        EXPECT_NEAR(blast.gas[0].mass, 1, 1e-12);
        EXPECT_NEAR(held.gas.mass[0], air, 1e-12 * air);
        const double released = part.share * (blast.gas[0].energy + blast.gas[1].energy);
        EXPECT_NEAR(held.gas.energy, released + still / 1.2 * 101325 / 0.4, 1e-12 * released);
        const Vector3d momentum = part.share * (blast.gas[0].momentum + blast.gas[1].momentum) * part.direction;
        EXPECT_LT(norm(corpuscle::held(model->euler).momentum - momentum), 1e-12 * norm(momentum) + 1e-9 * part.share);
        EXPECT_EQ(held.explosive.whole_mass(), 0);
    }
}

/// Sampling alone errs little: the profile in the cells is that of the flow. The last cell before the front has felt nothing yet, and the
/// greatest pressure is behind it.
TEST(GridStart, TheProfileIsThatOfTheFlow)
{
    const CaseDescription description = grid_case(shell_grid, "", {"euler.start=spherical", "euler.cells=[200]"});
    CaseSurvey survey = survey_case(description);
    const FreeBlast blast = *survey.euler->start;
    const auto model = build(description, survey);
    const EulerGrid& grid = model->euler;
    for (const std::size_t c : {20u, 60u, 100u, 150u}) {
        const double inner = grid.axes[0].faces[c], outer = grid.axes[0].faces[c + 1];
        double mass = 0;  // of the layers within the cell
        for (const RadialFill& fill : blast.gas) {
            for (const RadialLayer& layer : fill.layers) {
                const double a = std::clamp(layer.inner, inner, outer), b = std::clamp(layer.outer, inner, outer);
                mass += layer.density * (b * b * b - a * a * a) / 3;
            }
        }
        const double mean = 3 * mass / (outer * outer * outer - inner * inner * inner);
        // 64 points a cell against exact layers: a point more or less in the layer where the density jumps.
        EXPECT_NEAR(look(grid, c).density, mean, 0.02 * mean) << c;
    }
    EXPECT_NEAR(look(grid, 199).density, 1.2, 1e-13);  // a sum of 64 points
    EXPECT_EQ(norm(look(grid, 199).velocity), 0);
}

/// A cell that held both a part of the blast and of the fill it meets could not be made exact.
TEST(GridStart, WantsCellsThatFitBetweenTheBlastAndAFill)
{
    try {
        static_cast<void>(survey_case(grid_case(octant_grid, R"([[fill]]
gas = "air"
shape = { box = [[0.3, 0.4], [0, 0.4], [0, 0.4]] }
density = 2
pressure = 2e5
)",
                                                {"euler.start=spherical"})));
        FAIL() << "nothing was thrown";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("cells wider than what is left"));
        EXPECT_TRUE(error.place().known());
    }
}
