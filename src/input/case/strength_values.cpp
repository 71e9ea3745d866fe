#include "input/case/preset_values.hpp"
#include "schema/table_builder.hpp"

namespace corpuscle {

template <>
const Table& table_of<ElasticValues>()
{
    static const Table table = TableBuilder<ElasticValues>("elastic", "Linear elastic: no yield.").table();
    return table;
}

template <>
const Table& table_of<BilinearValues>()
{
    static const Table table =
        TableBuilder<BilinearValues>("bilinear",
                                     "Von Mises plasticity, sigma_y = (yield_stress + hardening_modulus * eps_p) * (1 + (rate/C)^(1/p)).")
            .need("yield_stress", &BilinearValues::yield_stress, {"Pa", above(0), "Yield stress at rest.", "\"1200 MPa\""})
            .row("hardening_modulus", &BilinearValues::hardening_modulus,
                 {"Pa", at_least(0), "Plastic hardening modulus: slope of yield stress against plastic strain.", "\"6500 MPa\""})
            .row("rate_c", &BilinearValues::rate_c,
                 {"1/s", at_least(0), "C of Cowper and Symonds; 0: no effect of the strain rate.", "\"300 1/s\""})
            .row("rate_p", &BilinearValues::rate_p, {"", at_least(0), "p of Cowper and Symonds.", "5"})
            .row("kinematic", &BilinearValues::kinematic, {"", from_to(0, 1), "Share of the hardening that is kinematic.", "0"})
            .table();
    return table;
}

template <>
const Table& table_of<CurveLine>()
{
    static const Table table =
        TableBuilder<CurveLine>("curves", "Yield stress over plastic strain: straight between its points, level beyond the last.")
            .row("rate", &CurveLine::rate,
                 {"1/s", at_least(0), "Plastic strain rate of this curve, where there are several.", "\"100 1/s\""})
            .need("plastic_strain", &CurveLine::plastic_strain, {"", at_least(0), "Plastic strains, from 0 upward.", "[0, 0.05, 0.3]"})
            .need("stress", &CurveLine::stress,
                  {"Pa", above(0), "True stress at each, not falling.", "[\"300 MPa\", \"400 MPa\", \"500 MPa\"]"})
            .table();
    return table;
}

template <>
const Table& table_of<CurveValues>()
{
    static const Table table =
        TableBuilder<CurveValues>("curve", "Von Mises plasticity along curves; between the curves of two rates evenly in log(rate).")
            .need("curves", &CurveValues::curves,
                  {"", {}, "One curve, or one for each rate, slowest first.", "[{ plastic_strain = [0, 0.3], stress = [3e8, 5e8] }]"})
            .row("rate_c", &CurveValues::rate_c,
                 {"1/s", at_least(0), "C of Cowper and Symonds, by which curves are raised; 0: not.", "\"40.4 1/s\""})
            .row("rate_p", &CurveValues::rate_p, {"", at_least(0), "p of Cowper and Symonds.", "5"})
            .table();
    return table;
}

template <>
const Table& table_of<JohnsonCookValues>()
{
    using V = JohnsonCookValues;
    static const Table table =
        TableBuilder<V>(
            "johnson_cook",
            "sigma_y = (A + B eps_p^n) (1 + C ln(rate/reference_rate)) (1 - T*^m); failure strain = (D1 + D2 exp(D3 mean/mises)) "
            "(1 + D4 ln(rate/reference_rate)) (1 + D5 T*).")
            .need("A", &V::a, {"Pa", above(0), "Yield stress.", "\"490 MPa\""})
            .row("B", &V::b, {"Pa", at_least(0), "Hardening.", "\"383 MPa\""})
            .row("n", &V::n, {"", above(0), "Exponent of hardening.", "0.45"})
            .row("C", &V::c, {"", at_least(0), "Effect of the rate; none below the reference rate.", "0.0123"})
            .row("reference_rate", &V::reference_rate, {"1/s", above(0), "Plastic strain rate of A, B, n.", "\"5e-4 1/s\""})
            .row("m", &V::m, {"", above(0), "Exponent of softening by heat.", "0.94"})
            .row("room_temperature", &V::room_temperature, {"K", above(0), "At the start.", "\"293 K\""})
            .row("melting_temperature", &V::melting_temperature, {"K", above(0), "Where strength ends.", "\"1800 K\""})
            .row("specific_heat", &V::specific_heat, {"J/(kg K)", at_least(0), "0: plastic work does not heat.", "\"452 J/(kg K)\""})
            .row("heat_share", &V::heat_share, {"", from_to(0, 1), "Share of plastic work that heats (Taylor and Quinney).", "0.9"})
            .row("D1", &V::d1, {"", any_number(), "Failure; with all five 0 nothing fails.", "0.0705"})
            .row("D2", &V::d2, {"", any_number(), "Failure.", "1.732"})
            .row("D3", &V::d3, {"", any_number(), "Failure; mean stress is tension positive.", "-0.54"})
            .row("D4", &V::d4, {"", any_number(), "Failure.", "-0.0123"})
            .row("D5", &V::d5, {"", any_number(), "Failure.", "0"})
            .table();
    return table;
}

template <>
const Table& table_of<HydroValues>()
{
    static const Table table =
        TableBuilder<HydroValues>("hydro",
                                  "Pressure after Mie and Grueneisen about the Hugoniot Us = c0 + s up; von Mises deviator. Soft solids, "
                                  "strong shocks. Poisson's ratio and Young's modulus give the shear modulus.")
            .need("yield_stress", &HydroValues::yield_stress, {"Pa", above(0), "Yield stress.", "\"90 MPa\""})
            .row("hardening_modulus", &HydroValues::hardening_modulus, {"Pa", at_least(0), "Plastic hardening modulus.", "\"100 MPa\""})
            .need("sound_speed", &HydroValues::sound_speed, {"m/s", above(0), "c0.", "\"3940 m/s\""})
            .row("slope", &HydroValues::slope, {"", at_least(0), "s.", "1.489"})
            .row("grueneisen", &HydroValues::grueneisen, {"", at_least(0), "Grueneisen's constant.", "1.99"})
            .row("tension_limit", &HydroValues::tension_limit, {"Pa", above(0), "Largest mean tension (spall).", "\"1.2 GPa\""})
            .table();
    return table;
}

template <>
const Table& table_of<FabricValues>()
{
    static const Table table = TableBuilder<FabricValues>("fabric", "Cloth: no compression (tension field).").table();
    return table;
}

template <>
const Table& table_of<StrengthValues>()
{
    static const Table table =
        TableBuilder<StrengthValues>("strength", "How a material resists.")
            .row("elastic", &StrengthValues::elastic, {"", {}, "Linear elastic.", "{}"})
            .row("bilinear", &StrengthValues::bilinear, {"", {}, "Von Mises plasticity with linear hardening and rate effect.", ""})
            .row("curve", &StrengthValues::curve, {"", {}, "Von Mises plasticity along curves, for one or several rates.", ""})
            .row("johnson_cook", &StrengthValues::johnson_cook, {"", {}, "Strength and failure after Johnson and Cook.", ""})
            .row("hydro", &StrengthValues::hydro, {"", {}, "Pressure by an equation of state; for solids.", ""})
            .row("fabric", &StrengthValues::fabric, {"", {}, "Cloth: elastic in tension, slack in compression; for membranes.", "{}"})
            .one_of({"elastic", "bilinear", "curve", "johnson_cook", "hydro", "fabric"})
            .table();
    return table;
}

}  // namespace corpuscle
