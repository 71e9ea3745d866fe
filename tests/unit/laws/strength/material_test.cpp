#include "laws/strength/material.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "base/error.hpp"

namespace corpuscle {
namespace {

using testing::HasSubstr;

Material good()
{
    return {"rha", 7838.0, 212e9, 0.28, BilinearPlastic{1200e6, 6500e6, 300, 5, 0}};
}

std::string complaint(const Material& material)
{
    try {
        check(material);
    } catch (const InputError& e) {
        EXPECT_FALSE(e.remedy().empty());
        return e.problem();
    }
    return "";
}

TEST(Material, GoodOnesPass)
{
    EXPECT_EQ(complaint(good()), "");
    Material elastic = good();
    elastic.strength = Elastic{};
    EXPECT_EQ(complaint(elastic), "");
}

TEST(Material, ImpossibleValuesAreNamed)
{
    const auto broken = [](auto&& change) {
        Material m = good();
        change(m, std::get<BilinearPlastic>(m.strength));
        return complaint(m);
    };
    using L = BilinearPlastic;
    EXPECT_THAT(broken([](Material& m, L&) { m.density = 0; }), HasSubstr("'rha': the density is 0"));
    EXPECT_THAT(broken([](Material& m, L&) { m.young_modulus = -1; }), HasSubstr("Young's modulus"));
    EXPECT_THAT(broken([](Material& m, L&) { m.poisson_ratio = 0.5; }), HasSubstr("Poisson's ratio is 0.5"));
    EXPECT_THAT(broken([](Material& m, L&) { m.density = std::numeric_limits<double>::quiet_NaN(); }), HasSubstr("density"));
    EXPECT_THAT(broken([](Material&, L& l) { l.yield_stress = 0; }), HasSubstr("yield stress"));
    EXPECT_THAT(broken([](Material&, L& l) { l.hardening_modulus = -5; }), HasSubstr("hardening"));
    EXPECT_THAT(broken([](Material&, L& l) { l.rate_constant = -1; }), HasSubstr("rate constant"));
    EXPECT_THAT(broken([](Material&, L& l) { l.rate_exponent = 0.5; }), HasSubstr("rate exponent"));
    EXPECT_THAT(broken([](Material&, L& l) { l.kinematic_fraction = 1.5; }), HasSubstr("kinematic"));
}

}  // namespace
}  // namespace corpuscle
