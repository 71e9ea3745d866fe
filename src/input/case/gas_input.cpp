#include "input/case/gas_input.hpp"

#include "schema/table_builder.hpp"

namespace corpuscle {

namespace {

constexpr double most_particles = 4.0e9;

}  // namespace

template <>
const std::vector<std::pair<std::string, Edge>>& words_of<Edge>()
{
    static const std::vector<std::pair<std::string, Edge>> words{{"rigid", Edge::rigid}, {"open", Edge::open}, {"ambient", Edge::ambient}};
    return words;
}

template <>
const std::vector<std::pair<std::string, CollisionRule>>& words_of<CollisionRule>()
{
    static const std::vector<std::pair<std::string, CollisionRule>> words{{"displaced", CollisionRule::displaced},
                                                                          {"hard_spheres", CollisionRule::hard_spheres}};
    return words;
}

template <>
const std::vector<std::pair<std::string, StartRule>>& words_of<StartRule>()
{
    static const std::vector<std::pair<std::string, StartRule>> words{{"detonation", StartRule::detonation},
                                                                      {"spherical", StartRule::spherical}};
    return words;
}

template <>
const Table& table_of<DetonationInput>()
{
    static const Table table =
        TableBuilder<DetonationInput>("detonation", "A point where the charge is lit; the front runs from it at the detonation velocity.")
            .need("point", &DetonationInput::point, {"m", {}, "Where.", "[0, 0, \"700 mm\"]"})
            .row("time", &DetonationInput::time, {"s", at_least(0), "When.", "\"10 us\""})
            .table();
    return table;
}

template <>
const Table& table_of<ChargeInput>()
{
    static const Table table =
        TableBuilder<ChargeInput>("charge",
                                  "A charge of explosive. Give its form with its center and its mass or radius (a cylinder may have both), "
                                  "or a shape with its size.")
            .need("explosive", &ChargeInput::explosive, {"", {}, "What it is made of (`corpuscle list explosives`).", "\"tnt\""})
            .row("shape", &ChargeInput::shape, {"", {}, "Its form alone, or its whole shape.", "\"sphere\""})
            .row("mass", &ChargeInput::mass,
                 {"kg", above(0), "Mass of the whole charge, also where planes of symmetry cut it.", "\"15 kg\""})
            .row("radius", &ChargeInput::radius,
                 {"m", above(0), "Radius of its form; the explosive's density gives the mass.", "\"130 mm\""})
            .row("center", &ChargeInput::center, {"m", {}, "Its center (of a hemisphere: of the whole ball).", "[0, 0, \"700 mm\"]"})
            .row("axis", &ChargeInput::axis,
                 {"", {}, "Axis of a cylinder; of a hemisphere, from the flat face into the dome.", "[0, 0, 1]"})
            .row("length_over_diameter", &ChargeInput::length_over_diameter,
                 {"", above(0), "Proportions of a cylinder that is given by its mass or its radius alone.", "1"})
            .row("detonation", &ChargeInput::detonation,
                 {"", {}, "Where and when it is lit; at its center at time 0 if not given.", "[{ point = [0, 0, \"700 mm\"], time = 0 }]"})
            .table();
    return table;
}

template <>
const Table& table_of<ParticleCounts>()
{
    static const Table table =
        TableBuilder<ParticleCounts>("particles", "How many particles the gas starts with.")
            .row("total", &ParticleCounts::total,
                 {"", from_to(1, most_particles), "In all, shared over the gases so that particle masses balance.", "200_000"})
            .row("products", &ParticleCounts::products, {"", from_to(1, most_particles), "Of the charges.", "100_000"})
            .row("air", &ParticleCounts::air, {"", from_to(1, most_particles), "Of all other gas.", "100_000"})
            .shorthand("total")
            .at_most_one_of({"total", "products"})
            .at_most_one_of({"total", "air"})
            .table();
    return table;
}

template <>
const Table& table_of<EdgesInput>()
{
    const std::string meaning =
        "Lower and upper face: `rigid` (a wall, also a plane of symmetry), `open` (gas leaves) or `ambient` (gas leaves, undisturbed gas "
        "flows in).";
    static const Table table = TableBuilder<EdgesInput>("edges", "What the faces of the gas box do.")
                                   .row("x", &EdgesInput::x, {"", {}, meaning, "[\"rigid\", \"ambient\"]"})
                                   .row("y", &EdgesInput::y, {"", {}, meaning, "[\"rigid\", \"ambient\"]"})
                                   .row("z", &EdgesInput::z, {"", {}, meaning, "[\"ambient\", \"ambient\"]"})
                                   .table();
    return table;
}

template <>
const Table& table_of<GasInput>()
{
    static const Table table =
        TableBuilder<GasInput>("gas", "The gas of particles.")
            .need("box", &GasInput::box,
                  {"m",
                   {},
                   "The box that holds the gas: lower and upper x, y, z.",
                   "[[0, \"1200 mm\"], [0, \"1200 mm\"], [\"-200 mm\", \"1400 mm\"]]"})
            .row("edges", &GasInput::edges,
                 {"", {}, "What its faces do.", "{ x = [\"rigid\", \"ambient\"], y = [\"rigid\", \"ambient\"] }"})
            .need("particles", &GasInput::particles, {"", {}, "How many particles it starts with.", "200_000"})
            .row("fill", &GasInput::fill,
                 {"", {}, "The gas all around, at its usual state; vacuum if not given (`corpuscle list gases`).", "\"air\""})
            .row("seed", &GasInput::seed,
                 {"", from_to(0, 9e15), "Of the random numbers: another seed, another sample of the same gas.", "2"})
            .row("mean_free_path", &GasInput::mean_free_path,
                 {"", from_to(0.05, 100),
                  "In local particle spacings, of a thin gas; a dense one, p_v near p_k, keeps at least one over 1 + p_v/p_k.", "1"})
            .row("cell_limit", &GasInput::cell_limit,
                 {"", from_to(4, 64), "Most particles in a cell, in which partners are drawn: smaller cells, sharper fronts.", "8"})
            .row("partners", &GasInput::partners,
                 {"", from_to(1, 8), "Drawn for each collision, of which the nearest is taken: more, sharper fronts.", "4"})
            .row(
                "collision", &GasInput::collision,
                {"",
                 {},
                 "How particles collide: `displaced` draws pairs within cells and displaces them for co-volume and JWL pressure; "
                 "`hard_spheres` "
                 "lets spheres of finite radius bounce where they touch (ideal and Noble-Abel gases only; `mean_free_path` has no effect).",
                 "\"hard_spheres\""})
            .row("packing", &GasInput::packing,
                 {"", from_to(1e-4, 0.1),
                  "With `hard_spheres`: share of the volume that spheres of a gas without co-volume fill where it is densest at the start. "
                  "Its pressure is too high by about 4 times this share.",
                  "0.01"})
            .row("start", &GasInput::start,
                 {"",
                  {},
                  "How the particles begin: `detonation` at time 0 with unburnt explosive; `spherical` when the blast of one ball of "
                  "explosive, lit at "
                  "its center and solved in one dimension until then, nears the first thing it meets.",
                  "\"spherical\""})
            .row("relaxation", &GasInput::relaxation,
                 {"", from_to(1, 1000), "Collisions between two exchanges of translational and internal energy.", "2"})
            .row("cfl", &GasInput::cfl,
                 {"",
                  {0, 1, false, true},
                  "Time step, in the time the thermal speed takes through a local spacing; of hard spheres in the time between two "
                  "meetings, or "
                  "the whole speed takes through a spacing.",
                  "0.4"})
            .row("sleep", &GasInput::sleep,
                 {"",
                  {},
                  "Undisturbed gas sleeps, at no cost, until the blast may have come near; `false` computes it from the start.",
                  "false"})
            .table();
    return table;
}

template <>
const Table& table_of<FillInput>()
{
    static const Table table =
        TableBuilder<FillInput>(
            "fill",
            "A gas state in a shape: shock tubes, vessels, rooms. Later fills cut earlier ones. Give two of density, pressure and "
            "temperature, or density and energy_density; with none of them it is the gas's usual state.")
            .need("gas", &FillInput::gas, {"", {}, "Which gas (`corpuscle list gases`), or its law in place.", "\"air\""})
            .need("shape", &FillInput::shape, {"", {}, "Where.", "{ box = [[0, 0.5], [0, 0.1], [0, 0.1]] }"})
            .row("density", &FillInput::density, {"kg/m3", above(0), "Density.", "\"1.2 kg/m3\""})
            .row("pressure", &FillInput::pressure, {"Pa", above(0), "Pressure.", "\"101.325 kPa\""})
            .row("temperature", &FillInput::temperature, {"K", above(0), "Temperature; the gas then needs a molar mass.", "\"20 degC\""})
            .row("energy_density", &FillInput::energy_density, {"J/m3", above(0), "Internal energy per volume.", "\"0.253 MJ/m3\""})
            .row("velocity", &FillInput::velocity, {"m/s", {}, "Bulk velocity.", "[100, 0, 0]"})
            .table();
    return table;
}

}  // namespace corpuscle
