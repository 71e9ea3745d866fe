#include "input/build.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "input/case/read_case.hpp"
#include "input/gas_states.hpp"
#include "input/memory.hpp"
#include "input/presets.hpp"
#include "mesh/generators.hpp"

using namespace corpuscle;
using ::testing::HasSubstr;
using ::testing::SizeIs;

namespace {

const std::filesystem::path source = CORPUSCLE_SOURCE_DIR;

/// The example of the plate, with changes.
CaseDescription plate(const std::vector<std::string>& settings = {})
{
    CaseDescription description = read_case(source / "examples/01_plate/case.toml", settings);
    resolve_presets(description, {source / "share"});
    return description;
}

std::string refusal(const CaseDescription& description)
{
    try {
        static_cast<void>(build(description));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

double particle_mass(const Gas& gas, std::uint32_t species)
{
    double mass = 0;
    for (const Particle& particle : gas.particles)
        if (particle_tag::species(particle.tag) == species) mass += gas.species[species].particle_mass;
    return mass;
}

}  // namespace

TEST(Build, ThePlateHasItsMassesAndCounts)
{
    const auto model = build(plate({"gas.particles=10_000"}));
    ASSERT_THAT(model->gas.species, SizeIs(2));
    EXPECT_NEAR(static_cast<double>(model->gas.particles.size()), 10'000, 1);
    EXPECT_NEAR(particle_mass(model->gas, 1), 15.0 / 4, 1e-9);  // a quarter of the charge
    const double air = 1.2 * (1.2 * 1.2 * 1.6 - 15.0 / 4 / 1630);
    EXPECT_NEAR(particle_mass(model->gas, 0), air, 1e-6 * air);
    // Shared so that masses balance.
    EXPECT_NEAR(model->gas.species[0].particle_mass / model->gas.species[1].particle_mass, 1, 1e-3);
    double steel = 0;
    for (std::uint32_t n = 0; n < model->structure.parts[0].node_count; ++n) steel += model->structure.nodes.mass[n];
    EXPECT_NEAR(steel, 7838 * 0.02 * std::numbers::pi / 4 * 0.25, 0.002 * steel);
    EXPECT_DOUBLE_EQ(model->end_time, 3e-3);
    ASSERT_THAT(model->probes, SizeIs(1));
    EXPECT_DOUBLE_EQ(norm(model->structure.nodes.reference[model->probes[0].node]), 0.0);
    ASSERT_THAT(model->gauges, SizeIs(1));
    EXPECT_DOUBLE_EQ(model->output.fields_every, 1e-4);
}

TEST(Build, TheFrameIsFlushWithThePlate)
{
    const CaseDescription description = plate();
    const Mesh disk = make_mesh(description.parts[0], description);
    const Mesh ring = make_mesh(description.parts[1], description);
    const auto& rim = disk.node_sets.at("rim");
    const auto& inner = ring.node_sets.at("inner");
    ASSERT_EQ(rim.size(), inner.size());
    for (const std::uint32_t node : inner) {
        const bool met = std::any_of(rim.begin(), rim.end(), [&](std::uint32_t other) { return disk.nodes[other] == ring.nodes[node]; });
        EXPECT_TRUE(met) << node;
    }
}

TEST(Build, UnburntGasHasTheExplosivesEnergy)
{
    const auto model = build(plate({"gas.particles=10_000"}));
    double energy = 0;
    for (const Particle& particle : model->gas.particles)
        if ((particle.tag & particle_tag::unburnt) != 0)
            energy += particle.energy + 0.5 * model->gas.species[1].particle_mass * norm_squared(Vector3d(particle.velocity));
    EXPECT_NEAR(energy, 15.0 / 4 / 1630 * 7e9, 1e-5 * energy);
}

TEST(Build, FormsOfChargesHaveTheirMass)
{
    for (const char* form : {"sphere", "hemisphere", "cylinder"}) {
        const CaseDescription description = plate({std::string("charge.0.shape=") + form, "gas.edges.x=[\"rigid\", \"rigid\"]"});
        const CaseSurvey survey = survey_case(description);
        EXPECT_NEAR(survey.gas->charge_shapes[0].volume() * 1630, 15, 1e-9) << form;
    }
}

TEST(Build, AChargeMayHaveAShapeOfItsOwn)
{
    CaseDescription description = plate({"charge.0.shape={ cylinder = { center = [0, 0, 0.7], radius = 0.1, length = 0.2 } }"});
    EXPECT_THAT(refusal(description), HasSubstr("both a mass and a shape"));
    description.charges[0].mass.reset();
    const CaseSurvey survey = survey_case(description);
    EXPECT_NEAR(survey.gas->masses.back(), 1630 * std::numbers::pi * 0.01 * 0.2 / 4, 1e-6);
}

/// By radius, by mass, by both for a cylinder: the explosive's density joins them.
TEST(Build, AChargesFormMayHaveItsRadius)
{
    const auto volume = [](CaseDescription description) { return survey_case(description).gas->charge_shapes[0].volume(); };
    CaseDescription description = plate({"charge.0.radius=100 mm", "gas.edges.x=[\"rigid\", \"rigid\"]"});
    EXPECT_THAT(refusal(description), HasSubstr("both a mass and a radius"));
    description.charges[0].shape.form = ChargeForm::cylinder;
    EXPECT_NEAR(volume(description) * 1630, 15, 1e-9);
    EXPECT_NEAR(survey_case(description).gas->charge_shapes[0].bounds().size().x, 0.2, 1e-12);
    description.charges[0].mass.reset();
    EXPECT_NEAR(volume(description), std::numbers::pi * 0.01 * 0.2, 1e-12);  // as long as wide
    description.charges[0].shape.form = ChargeForm::sphere;
    EXPECT_NEAR(volume(description), 4 * std::numbers::pi / 3 * 1e-3, 1e-12);
    description.charges[0].shape.form = ChargeForm::hemisphere;
    EXPECT_NEAR(volume(description), 2 * std::numbers::pi / 3 * 1e-3, 1e-12);
    description.charges[0].radius.reset();
    EXPECT_THAT(refusal(description), HasSubstr("neither mass nor radius"));
    description.charges[0].radius = 0.1;
    description.charges[0].center.reset();
    EXPECT_THAT(refusal(description), HasSubstr("no center"));
}

/// The ball of a gauge at a point has three spacings of the ambient gas, of a vacuum those of all particles spread over the box.
TEST(Build, AGaugeAtAPointSeesABall)
{
    CaseDescription description = plate();
    GaugeInput gauge;
    gauge.name = "g";
    gauge.point = Vector3d{0.3, 0.3, 0.3};
    description.gauges = {gauge};
    const auto model = build(description);
    const AmbientGas& air = model->gas.ambient;
    const double radius = 3 * std::cbrt(model->gas.species[air.species].particle_mass / air.density);
    const RegionGauge& ball = std::get<RegionGauge>(model->gauges[0].place);
    EXPECT_NEAR(ball.volume, 4 * std::numbers::pi / 3 * std::pow(radius, 3), 1e-9 * ball.volume);
    EXPECT_DOUBLE_EQ(model->gauges[0].every, 3e-6);  // a thousandth of the run
    description.gas->fill.reset();
    const auto empty = build(description);
    const double room = empty->gas.domain.box.volume() / static_cast<double>(empty->gas.particles.size());
    EXPECT_NEAR(std::get<RegionGauge>(empty->gauges[0].place).shape.bounds().size().x, 6 * std::cbrt(room), 1e-9);
    description.gauges[0].point = Vector3d{0.3, 0.3, 9};
    EXPECT_THAT(refusal(description), HasSubstr("outside the gas box"));
}

TEST(Build, ParticlesOfEitherKind)
{
    const CaseSurvey survey = survey_case(plate({"gas.particles={ products = 3000, air = 1000 }"}));
    EXPECT_EQ(survey.gas->counts[0], 1000u);
    EXPECT_EQ(survey.gas->counts[1], 3000u);
}

TEST(Build, FillsHaveTheirState)
{
    const std::string text = R"(end_time = 1e-3
[gas]
box = [[0, 1], [0, 0.1], [0, 0.1]]
edges = { x = ["rigid", "rigid"], y = ["rigid", "rigid"], z = ["rigid", "rigid"] }
particles = 9000
[[fill]]
gas = { gamma = 1.4 }
shape = { box = [[0, 1], [0, 0.1], [0, 0.1]] }
density = 0.125
pressure = 0.1
[[fill]]
gas = { gamma = 1.4 }
shape = { box = [[0, 0.5], [0, 0.1], [0, 0.1]] }
density = 1.0
pressure = 1.0
velocity = [3, 0, 0]
)";
    CaseDescription description = read_case_text(text, "tube.toml");
    const CaseSurvey survey = survey_case(description);
    ASSERT_THAT(survey.gas->masses, SizeIs(2));
    EXPECT_NEAR(survey.gas->masses[0], 0.125 * 0.5 * 0.01, 1e-12);  // the later fill cut it
    EXPECT_NEAR(survey.gas->masses[1], 1.0 * 0.5 * 0.01, 1e-12);
    EXPECT_EQ(survey.gas->counts[1], 8000u);
    const auto model = build(description);
    double momentum = 0;
    for (const Particle& particle : model->gas.particles)
        momentum += model->gas.species[particle_tag::species(particle.tag)].particle_mass * static_cast<double>(particle.velocity.x);
    EXPECT_NEAR(momentum, 3 * 0.005, 1e-6);
}

FillInput fill_of(std::optional<double> density, std::optional<double> pressure, std::optional<double> temperature = {},
                  std::optional<double> energy_density = {})
{
    FillInput fill;
    GasValues nitrogen;
    nitrogen.name = "nitrogen";
    nitrogen.gamma = 1.4;
    nitrogen.density = 1.2;
    nitrogen.pressure = 1e5;
    nitrogen.molar_mass = 0.028;
    fill.gas.values = nitrogen;
    fill.density = density;
    fill.pressure = pressure;
    fill.temperature = temperature;
    fill.energy_density = energy_density;
    return fill;
}

/// A fill's state from each pair that gives it, with R T/M of nitrogen at 300 K: the same gas each time; with none its usual state.
TEST(Build, AFillIsGivenByTwoOfItsState)
{
    const double thermal = 8.31446261815324 * 300 / 0.028, p = 2e7, rho = p / thermal, e = thermal / 0.4;
    for (const FillInput& fill : {fill_of(rho, p), fill_of(rho, {}, 300), fill_of({}, p, 300), fill_of(rho, {}, {}, rho * e)}) {
        const GasState state = state_of(fill);
        EXPECT_NEAR(state.density, rho, 1e-12 * rho);
        EXPECT_NEAR(state.pressure, p, 1e-12 * p);
        EXPECT_NEAR(state.energy_per_mass, e, 1e-12 * e);
    }
    const GasState usual = state_of(fill_of({}, {}));
    EXPECT_EQ(usual.density, 1.2);
    EXPECT_EQ(usual.pressure, 1e5);
    for (const FillInput& fill : {fill_of(rho, {}), fill_of({}, p), fill_of({}, p, {}, 1e6), fill_of(rho, p, 300)})
        EXPECT_THROW(static_cast<void>(state_of(fill)), InputError);
}

/// Noble-Abel: p (1/rho - b) = R T/M.
TEST(Build, PressureAndTemperatureGiveTheDensityOfADenseGas)
{
    const double thermal = 8.31446261815324 * 300 / 0.028, p = 2e8;
    FillInput fill = fill_of({}, p, 300);
    fill.gas.values->co_volume = 0.5;
    fill.gas.values->reference_density = 1000;
    const GasState state = state_of(fill);
    EXPECT_NEAR(state.density, p / (thermal + p * 0.5 / 1000), 1e-9);
    EXPECT_NEAR(state.pressure, p, 1e-9 * p);
    fill.gas.values->reference_density.reset();
    fill.gas.values->density.reset();
    EXPECT_THROW(static_cast<void>(state_of(fill)), InputError);  // a share of what?
}

/// 1.667 is how people write 5/3.
TEST(Build, AGasOfSingleAtomsMayBeRounded)
{
    FillInput fill = fill_of(0.2, 1e5);
    fill.gas.values->gamma = 1.667;
    EXPECT_EQ(heat_capacity_ratio(state_of(fill).law), 5.0 / 3);
}

TEST(Build, ConwepAloneNeedsNoGas)
{
    const std::string text = R"(end_time = 1e-3
[[part]]
name = "plate"
mesh = { rectangle = { edge_1 = [1, 0, 0], edge_2 = [0, 1, 0], element_size = 0.1 } }
element = { shell = { thickness = 0.02 } }
material = { density = 7800, young_modulus = 2e11, poisson_ratio = 0.3, strength = { elastic = {} } }
fix = [{ where = "rim", dof = "all" }]
[[load]]
conwep = { mass = 1, center = [0.5, 0.5, 1] }
part = "plate"
)";
    const auto model = build(read_case_text(text, "conwep.toml"));
    EXPECT_THAT(model->loads, SizeIs(1));
    EXPECT_TRUE(model->gas.particles.empty());
}

TEST(Build, MeaningIsChecked)
{
    EXPECT_THAT(refusal(plate({"charge.0.center=[0, 0, 0.05]"})), HasSubstr("overlaps part 'plate'"));
    EXPECT_THAT(refusal(plate({"charge.0.center=[0, 0, 9]"})), HasSubstr("outside the gas box"));
    EXPECT_THAT(refusal(plate({"charge.0.center=[0, 0, 1.3]"})), HasSubstr("sticks"));
    EXPECT_THAT(refusal(plate({"gauge.0.facets=plat"})), HasSubstr("did you mean 'plate'"));
    EXPECT_THAT(refusal(plate({"part.0.fix.0.where=rmi"})), HasSubstr("'rim'"));
    EXPECT_THAT(refusal(plate({"part.1.fix=[]"})), HasSubstr("frame"));
    EXPECT_THAT(refusal(plate({"gas.particles=1"})), HasSubstr("gets no particles"));
}

TEST(Build, ExpectedStepsFollowTheStructureWithoutGas)
{
    CaseDescription description = plate();
    description.gas.reset();
    description.charges.clear();
    description.gauges.clear();
    const CaseSurvey survey = survey_case(description);
    EXPECT_NEAR(expected_steps(survey, 3e-3), 3e-3 / stable_step(survey.structure), 1);
}

TEST(Memory, TooMuchIsRefusedAtItsPlace)
{
    const MachineMemory machine{1'000'000'000, 500'000'000};
    EXPECT_NO_THROW(static_cast<void>(check_memory({1'000'000, 1000, 0}, {}, machine)));
    try {
        check_memory({100'000'000, 1000, 0}, {"case.toml", 3, 4}, machine);
        FAIL() << "nothing was thrown";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("case.toml:3:4: 100000000 particles"));
        EXPECT_THAT(error.remedy(), HasSubstr("at most"));
    }
    EXPECT_GT(machine_memory().total, 0u);
    EXPECT_EQ(bytes_text(3'200'000'000), "3.2 GB");
}

/// Gas may sleep about shells and what stands still; beside solids, and where something moves from the start, it must not.
TEST(Build, GasSleepsOnlyWhereNothingMovesOrPressesFromOneSide)
{
    const auto at_rest = build(plate());
    EXPECT_THAT(at_rest->gas.sleeping.disturbances, SizeIs(1));  // the charge
    ASSERT_TRUE(at_rest->gas.sleeping.movable);
    EXPECT_GT(at_rest->gas.sleeping.movable->upper.x, 0.45);  // the plate within its rim,
    EXPECT_LT(at_rest->gas.sleeping.movable->upper.x, 0.5);   // not its rigid frame
    EXPECT_FALSE(at_rest->gas.sleeping.movable_woken);
    EXPECT_THAT(build(plate({"gas.sleep=false"}))->gas.sleeping.disturbances, SizeIs(0));
    EXPECT_THAT(build(plate({"gas.edges.z=[\"ambient\",\"open\"]"}))->gas.sleeping.disturbances, SizeIs(2));

    CaseDescription moving = plate();
    moving.parts.front().velocity = {0, 0, 1};
    EXPECT_TRUE(build(moving)->gas.sleeping.movable_woken);
    EXPECT_THAT(build(moving)->gas.sleeping.disturbances, SizeIs(2));

    CaseDescription thick = plate();
    thick.parts.front().element = {};
    thick.parts.front().element.plain = PlainElement::solid;
    thick.parts.front().mesh.extrude = ExtrudeInput{0.02, 2};
    EXPECT_THAT(build(thick)->gas.sleeping.disturbances, SizeIs(2));
}
