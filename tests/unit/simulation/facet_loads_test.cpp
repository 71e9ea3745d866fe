#include <gtest/gtest.h>

#include "mesh/generators.hpp"
#include "simulation/facet_loads.hpp"
#include "structure/builder.hpp"

namespace corpuscle {
namespace {

std::vector<float> values_of(const FieldSet& set, const char* name)
{
    const Field* field = set.find(name);
    std::vector<float> values(field->count);
    field->gather(values.data());
    return values;
}

/// A held plate of 2 x 2 shells over 1 m2 in a box of gas that holds no particles but those given.
std::unique_ptr<Model> plate_and(const std::vector<Particle>& particles)
{
    PartDescription plate;
    plate.name = "plate";
    plate.mesh = rectangle_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.5);
    plate.element = ElementKind::rigid;
    std::vector<std::uint32_t> all(plate.mesh.nodes.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    plate.holds = {clamp(all)};
    Structure structure;
    add_part(structure, plate);
    Gas gas;
    gas.domain.box = {{-2, -2, -2}, {2, 2, 2}};
    gas.species.push_back({"gas", IdealGas{1.4}, 0.5, internal_freedoms(1.4)});
    gas.particles = particles;
    return std::make_unique<Model>(std::move(gas), std::move(structure));
}

/// A particle of 0.5 kg and 100 m/s gives 100 N s, over a quarter of a square meter 400 Pa s, within 1 ms 400 kPa; the next picture shows
/// what has come since, and a restart does not forget the last one.
TEST(FacetLoads, ShowsImpulseAndPressureOfBothSides)
{
    const auto model = plate_and(
        {{{0.3f, 0.2f, 0.05f}, 0, {0, 0, -100}, particle_tag::make(0)}, {{0.8f, 0.7f, -0.05f}, 0, {0, 0, 80}, particle_tag::make(0)}});
    FacetLoads loads(*model);
    Clock clock;
    clock.begin_step(1e-3);
    model->gas_structure.follow();
    for (std::uint32_t i = 0; i < 2; ++i) model->gas.pending.push_back({i, 0.0f, {}});
    model->gas_structure.apply(clock);
    const FieldSet first = loads.picture(1e-3);
    double upper = 0, lower = 0;
    for (std::size_t e = 0; e < 4; ++e) {
        upper += values_of(first, "load_impulse_upper")[e];
        lower += values_of(first, "load_impulse_lower")[e];
        EXPECT_NEAR(values_of(first, "load_pressure_upper")[e], 1e3 * values_of(first, "load_impulse_upper")[e], 0.1);
    }
    EXPECT_NEAR(upper, 400, 1e-3);
    EXPECT_NEAR(lower, 320, 1e-3);

    FacetLoads resumed(*model);
    const FieldSet saved = loads.state(), taken = resumed.state();
    for (std::size_t f = 0; f < saved.fields.size(); ++f) {
        std::vector<double> values(saved.fields[f].count);
        saved.fields[f].gather(values.data());
        taken.fields[f].restore(values.data(), values.size());
    }
    for (FacetLoads* each : {&loads, &resumed}) {
        const FieldSet second = each->picture(2e-3);
        for (std::size_t e = 0; e < 4; ++e) EXPECT_EQ(values_of(second, "load_pressure_upper")[e], 0);
        EXPECT_NEAR(values_of(second, "load_impulse_upper")[0] + values_of(second, "load_impulse_upper")[1] +
                        values_of(second, "load_impulse_upper")[2] + values_of(second, "load_impulse_upper")[3],
                    400, 1e-3);
    }
}

}  // namespace
}  // namespace corpuscle
