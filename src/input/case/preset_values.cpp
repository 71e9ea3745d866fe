#include "input/case/preset_values.hpp"

#include "schema/table_builder.hpp"

namespace corpuscle {
namespace {

/// What `status` means, of every preset.
constexpr const char* how_sure =
    "How sure the values are: S read in the source, R not read there but repeated by independent works that cite it, M recalled and "
    "not read again; +CJ: in accord with the Chapman-Jouguet condition.";

}  // namespace

template <>
const Table& table_of<JwlValues>()
{
    static const Table table =
        TableBuilder<JwlValues>(
            "jwl", "The law of Jones, Wilkins and Lee: p = A (1 - omega/(R1 V)) exp(-R1 V) + B (1 - omega/(R2 V)) exp(-R2 V) + omega E/V.")
            .need("A", &JwlValues::a, {"Pa", at_least(0), "First pressure constant.", "\"371.2 GPa\""})
            .need("B", &JwlValues::b, {"Pa", any_number(), "Second pressure constant.", "\"3.231 GPa\""})
            .need("R1", &JwlValues::r1, {"", above(0), "First exponent.", "4.15"})
            .need("R2", &JwlValues::r2, {"", above(0), "Second exponent.", "0.95"})
            .need("omega", &JwlValues::omega,
                  {"", {0, 2.0 / 3.0, false, true}, "Grueneisen constant: the heat capacity ratio of the particles is 1 + omega.", "0.30"})
            .table();
    return table;
}

template <>
const Table& table_of<IdealValues>()
{
    static const Table table =
        TableBuilder<IdealValues>("ideal", "Ideal gas: p = (gamma - 1) E/V.")
            .need("gamma", &IdealValues::gamma, {"", {1, 5.0 / 3.0 + 1e-3, false, true}, "Heat capacity ratio; 1.667 is 5/3.", "1.4"})
            .table();
    return table;
}

template <>
const Table& table_of<NobleAbelValues>()
{
    static const Table table =
        TableBuilder<NobleAbelValues>("noble_abel", "Noble-Abel gas: p (V - b) = (gamma - 1) E.")
            .need("gamma", &NobleAbelValues::gamma, {"", {1, 5.0 / 3.0 + 1e-3, false, true}, "Heat capacity ratio; 1.667 is 5/3.", "1.3"})
            .need("co_volume", &NobleAbelValues::co_volume,
                  {"", {0, 1, true, false}, "Co-volume b as a fraction of the volume at the reference density.", "0.3"})
            .row("reference_density", &NobleAbelValues::reference_density,
                 {"kg/m3", above(0), "Density at which the co-volume is that fraction; the unreacted density if not given.",
                  "\"1630 kg/m3\""})
            .table();
    return table;
}

template <>
const Table& table_of<LawValues>()
{
    static const Table table =
        TableBuilder<LawValues>("law", "The equation of state of a gas.")
            .row("jwl", &LawValues::jwl, {"", {}, "Jones-Wilkins-Lee, for products of explosives.", ""})
            .row("ideal", &LawValues::ideal, {"", {}, "Ideal gas.", "{ gamma = 1.4 }"})
            .row("noble_abel", &LawValues::noble_abel, {"", {}, "Gas with a co-volume.", "{ gamma = 1.3, co_volume = 0.3 }"})
            .one_of({"jwl", "ideal", "noble_abel"})
            .table();
    return table;
}

template <>
const Table& table_of<ExplosiveValues>()
{
    static const Table table =
        TableBuilder<ExplosiveValues>("explosive", "An explosive and the gas its products are.")
            .row("name", &ExplosiveValues::name, {"", {}, "As a case names it.", "\"tnt\""})
            .row("title", &ExplosiveValues::title, {"", {}, "For people.", "\"TNT, cast\""})
            .need("law", &ExplosiveValues::law,
                  {"", {}, "Equation of state of the products.", "{ noble_abel = { gamma = 1.3, co_volume = 0.3 } }"})
            .need("density", &ExplosiveValues::density, {"kg/m3", above(0), "Unreacted density.", "\"1630 kg/m3\""})
            .need("energy_density", &ExplosiveValues::energy_density,
                  {"J/m3", above(0), "Energy released per unreacted volume.", "\"7.0 GJ/m3\""})
            .need("detonation_velocity", &ExplosiveValues::detonation_velocity,
                  {"m/s", above(0), "Speed of the detonation front.", "\"6930 m/s\""})
            .row("detonation_pressure", &ExplosiveValues::detonation_pressure,
                 {"Pa", above(0), "Chapman-Jouguet pressure, for the record; nothing is computed from it.", "\"21 GPa\""})
            .row("source", &ExplosiveValues::source, {"", {}, "Where the values are from.", ""})
            .row("status", &ExplosiveValues::status, {"", {}, how_sure, ""})
            .row("note", &ExplosiveValues::note, {"", {}, "A remark.", ""})
            .table();
    return table;
}

template <>
const Table& table_of<GasValues>()
{
    static const Table table =
        TableBuilder<GasValues>("gas", "A gas: its law (or in short its gamma, with or without a co-volume) and its usual state.")
            .row("name", &GasValues::name, {"", {}, "As a case names it.", "\"air\""})
            .row("title", &GasValues::title, {"", {}, "For people.", "\"Dry air\""})
            .row("law", &GasValues::law, {"", {}, "Equation of state.", "{ ideal = { gamma = 1.4 } }"})
            .row("gamma", &GasValues::gamma,
                 {"", {1, 5.0 / 3.0 + 1e-3, false, true}, "Heat capacity ratio, in place of a law; 1.667 is 5/3.", "1.4"})
            .row("co_volume", &GasValues::co_volume,
                 {"", {0, 1, true, false}, "Co-volume as a fraction of the volume at the reference density, beside gamma.", "0.3"})
            .row("reference_density", &GasValues::reference_density,
                 {"kg/m3", above(0), "Density at which the co-volume is that fraction.", "\"1630 kg/m3\""})
            .row("density", &GasValues::density, {"kg/m3", above(0), "Density of its usual state.", "\"1.2 kg/m3\""})
            .row("temperature", &GasValues::temperature, {"K", above(0), "Temperature of its usual state.", "\"20 degC\""})
            .row("pressure", &GasValues::pressure, {"Pa", above(0), "Pressure of its usual state.", "\"101.325 kPa\""})
            .row("molar_mass", &GasValues::molar_mass,
                 {"kg/mol", above(0), "Molar mass: turns temperatures into pressures.", "\"28.96 g/mol\""})
            .row("source", &GasValues::source, {"", {}, "Where the values are from.", ""})
            .row("status", &GasValues::status, {"", {}, how_sure, ""})
            .row("note", &GasValues::note, {"", {}, "A remark.", ""})
            .one_of({"law", "gamma"})
            .table();
    return table;
}

template <>
const Table& table_of<MaterialValues>()
{
    static const Table table =
        TableBuilder<MaterialValues>("material", "A material of the structure.")
            .row("name", &MaterialValues::name, {"", {}, "As a case names it.", "\"rha_steel\""})
            .row("title", &MaterialValues::title, {"", {}, "For people.", ""})
            .need("density", &MaterialValues::density, {"kg/m3", above(0), "Density.", "\"7838 kg/m3\""})
            .need("young_modulus", &MaterialValues::young_modulus, {"Pa", above(0), "Young's modulus.", "\"212 GPa\""})
            .need("poisson_ratio", &MaterialValues::poisson_ratio, {"", {0, 0.5, true, false}, "Poisson's ratio.", "0.28"})
            .need("strength", &MaterialValues::strength, {"", {}, "How it resists beyond elasticity.", "{ elastic = {} }"})
            .row("source", &MaterialValues::source, {"", {}, "Where the values are from.", ""})
            .row("status", &MaterialValues::status, {"", {}, how_sure, ""})
            .row("note", &MaterialValues::note, {"", {}, "A remark.", ""})
            .table();
    return table;
}

}  // namespace corpuscle
