#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <toml++/toml.h>

#include "laws/eos/chapman_jouguet.hpp"
#include "schema/units.hpp"

namespace corpuscle {
namespace {

const std::filesystem::path share = std::filesystem::path(CORPUSCLE_SOURCE_DIR) / "share";

/// Every file of a folder of share/, by name.
std::map<std::string, toml::table> presets(const char* folder)
{
    std::map<std::string, toml::table> found;
    for (const auto& entry : std::filesystem::directory_iterator(share / folder)) {
        found.emplace(entry.path().stem().string(), toml::parse_file(entry.path().string()));
    }
    return found;
}

/// A number in SI, written as a number or with its unit; NaN if it is not there.
double number(toml::node_view<const toml::node> node, const char* unit)
{
    if (const auto text = node.value<std::string>()) return convert(*text, unit);
    return node.value<double>().value_or(std::nan(""));
}

EquationOfState law_of(const toml::table& preset)
{
    const auto law = preset["law"];
    const double density = number(preset["density"], "kg/m3");
    if (const auto jwl = law["jwl"]) {
        return Jwl{number(jwl["A"], "Pa"), number(jwl["B"], "Pa"),    number(jwl["R1"], "1"),
                   number(jwl["R2"], "1"), number(jwl["omega"], "1"), density};
    }
    if (const auto gas = law["noble_abel"]) {
        return NobleAbel{number(gas["gamma"], "1"), number(gas["co_volume"], "1"), number(gas["reference_density"], "kg/m3")};
    }
    return IdealGas{number(law["ideal"]["gamma"], "1")};
}

/// What the Chapman-Jouguet state of each set of JWL constants ought to be, from the table the constants were taken from: the detonation
/// velocity [km/s] and how far the constants miss it [%], the pressure they give [GPa], and the factor C of their isentrope [GPa].
struct Expected {
    double velocity, miss, pressure, c;
};

const std::map<std::string, Expected> expected{
    {"tnt", {6.93, -0.01, 21.00, 1.0452}},           {"c4", {8.193, 0.00, 28.00, 1.0433}},       {"petn", {8.30, 0.01, 33.51, 0.6987}},
    {"hmx", {9.11, -1.26, 39.95, 1.1009}},           {"comp_a3", {8.30, 0.00, 30.00, 1.0856}},   {"comp_b", {7.98, 0.00, 29.50, 1.0819}},
    {"cyclotol_77_23", {8.25, 0.00, 32.00, 1.0753}}, {"lx_10", {8.82, 0.00, 37.50, 1.2957}},     {"lx_14", {8.80, 0.00, 37.00, 1.2958}},
    {"octol_78_22", {8.48, 0.07, 34.23, 1.1827}},    {"pentolite", {7.53, 0.00, 25.50, 1.0332}}, {"petn_1500", {7.45, 0.05, 22.00, 1.1515}},
    {"petn_1260", {6.54, -0.25, 14.00, 1.2661}},     {"petn_880", {5.17, -1.85, 6.18, 0.9423}},  {"tetryl", {7.91, 0.04, 28.53, 0.7880}},
    {"nitromethane", {6.28, -0.29, 12.50, 0.7705}}};

TEST(Presets, explosives_reproduce_their_detonation)
{
    const auto explosives = presets("explosives");
    EXPECT_EQ(explosives.size(), expected.size() + 1);
    for (const auto& [name, wanted] : expected) {
        ASSERT_TRUE(explosives.contains(name)) << name;
        const toml::table& preset = explosives.at(name);
        const double density = number(preset["density"], "kg/m3");
        const ChapmanJouguet front = chapman_jouguet(law_of(preset), density, number(preset["energy_density"], "J/m3") / density);
        EXPECT_NEAR(number(preset["detonation_velocity"], "m/s"), 1000 * wanted.velocity, 1e-6) << name;
        EXPECT_NEAR(100 * (front.detonation_velocity / (1000 * wanted.velocity) - 1), wanted.miss, 0.006) << name;
        EXPECT_NEAR(front.pressure / 1e9, wanted.pressure, 0.006) << name;
        EXPECT_LT(std::abs(number(preset["detonation_pressure"], "Pa") / front.pressure - 1), 0.06) << name;
    }
}

TEST(Presets, isentropes_of_the_explosives_have_their_published_factor)
{
    const auto explosives = presets("explosives");
    for (const auto& [name, wanted] : expected) {
        const toml::table& preset = explosives.at(name);
        const double density = number(preset["density"], "kg/m3");
        const Jwl law = std::get<Jwl>(law_of(preset));
        const ChapmanJouguet front = chapman_jouguet(law, density, number(preset["energy_density"], "J/m3") / density);
        const double v = density / front.density;
        const double c = (front.pressure - law.a * std::exp(-law.r1 * v) - law.b * std::exp(-law.r2 * v)) * std::pow(v, 1 + law.omega);
        EXPECT_NEAR(c / 1e9, wanted.c, 0.0006 * wanted.c) << name;
    }
}

TEST(Presets, the_papers_set_is_as_printed)
{
    const auto explosives = presets("explosives");
    const toml::table& preset = explosives.at("tnt_paper");
    const NobleAbel law = std::get<NobleAbel>(law_of(preset));
    EXPECT_EQ(law.gamma, 1.3);
    EXPECT_EQ(law.co_volume, 0.3);
    EXPECT_EQ(law.reference_density, 1630);
    EXPECT_EQ(number(preset["density"], "kg/m3"), 1630);
    EXPECT_NEAR(number(preset["energy_density"], "J/m3"), 7e9, 1e-3);
    EXPECT_EQ(number(preset["detonation_velocity"], "m/s"), 6930);
}

TEST(Presets, gases_obey_the_ideal_gas_law)
{
    for (const auto& [name, preset] : presets("gases")) {
        const double density = number(preset["density"], "kg/m3"), molar_mass = number(preset["molar_mass"], "kg/mol");
        const double pressure = density / molar_mass * 8.314462618 * number(preset["temperature"], "K");
        EXPECT_NEAR(pressure / number(preset["pressure"], "Pa"), 1, 2e-4) << name;
        EXPECT_NO_THROW(check(law_of(preset), name));
    }
    const auto gases = presets("gases");
    const toml::table& air = gases.at("air");
    EXPECT_NEAR(energy(law_of(air), 1.2, number(air["pressure"], "Pa")) * 1.2, 0.253e6, 0.0005e6);
}

TEST(Presets, materials_are_within_what_solids_are)
{
    for (const auto& [name, preset] : presets("materials")) {
        const double density = number(preset["density"], "kg/m3"), young = number(preset["young_modulus"], "Pa");
        if (preset["strength"]["fabric"]) continue;  // cloth is much softer
        EXPECT_GT(density, 1000) << name;
        EXPECT_LT(density, 20000) << name;
        EXPECT_GT(std::sqrt(young / density), 3000) << name;  // speed of a wave in a bar of metal
        EXPECT_LT(std::sqrt(young / density), 6000) << name;
        EXPECT_GE(number(preset["poisson_ratio"], "1"), 0.2) << name;
        EXPECT_LT(number(preset["poisson_ratio"], "1"), 0.4) << name;
        const toml::table& strength = *preset["strength"].as_table();
        ASSERT_EQ(strength.size(), 1U) << name;
        if (const auto bilinear = preset["strength"]["bilinear"]) {
            EXPECT_GT(number(bilinear["yield_stress"], "Pa"), 1e-4 * young) << name;
            EXPECT_LT(number(bilinear["yield_stress"], "Pa"), 1e-2 * young) << name;
            EXPECT_GE(number(bilinear["hardening_modulus"], "Pa"), 0) << name;
            EXPECT_LT(number(bilinear["hardening_modulus"], "Pa"), 0.1 * young) << name;
        }
        if (const auto law = preset["strength"]["johnson_cook"]) {
            EXPECT_GT(number(law["A"], "Pa"), 5e-4 * young) << name;
            EXPECT_LT(number(law["A"], "Pa"), 1e-2 * young) << name;
            EXPECT_LT(number(law["B"], "Pa"), 1e-2 * young) << name;
            EXPECT_GT(number(law["melting_temperature"], "K"), 800) << name;
            const double heat = density * number(law["specific_heat"], "J/(kg K)");
            EXPECT_GT(heat, 2e6) << name;  // metals hold 2 to 4 MJ/(m3 K): Dulong and Petit
            EXPECT_LT(heat, 4e6) << name;
        }
    }
}

TEST(Presets, the_papers_plate_is_as_printed)
{
    const auto materials = presets("materials");
    const toml::table& steel = materials.at("rha_steel");
    const auto law = steel["strength"]["bilinear"];
    EXPECT_EQ(number(steel["density"], "kg/m3"), 7838);
    EXPECT_NEAR(number(steel["young_modulus"], "Pa"), 212e9, 1);
    EXPECT_EQ(number(steel["poisson_ratio"], "1"), 0.28);
    EXPECT_NEAR(number(law["yield_stress"], "Pa"), 1200e6, 1e-3);
    EXPECT_NEAR(number(law["hardening_modulus"], "Pa"), 6500e6, 1e-3);
    EXPECT_EQ(number(law["rate_c"], "1/s"), 300);
    EXPECT_EQ(number(law["rate_p"], "1"), 5);
}

TEST(Presets, each_names_itself_its_source_and_how_sure_it_is)
{
    for (const char* folder : {"explosives", "gases", "materials"}) {
        for (const auto& [name, preset] : presets(folder)) {
            EXPECT_EQ(preset["name"].value<std::string>(), name);
            EXPECT_FALSE(preset["title"].value_or<std::string>("").empty()) << name;
            EXPECT_FALSE(preset["source"].value_or<std::string>("").empty()) << name;
            const std::string status = preset["status"].value_or<std::string>("");
            EXPECT_TRUE(status == "S" || status == "S (part)" || status == "R" || status == "M" || status == "M+CJ")
                << name << ": " << status;
        }
    }
}

}  // namespace
}  // namespace corpuscle
