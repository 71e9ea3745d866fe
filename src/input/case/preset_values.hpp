#pragma once

#include <optional>
#include <string>
#include <vector>

#include "schema/codec.hpp"

// What the files in share/ hold, and what a case may give in place of their names.

namespace corpuscle {

/// Constants of the Jones-Wilkins-Lee law.
struct JwlValues {
    double a = 0;  ///< [Pa]
    double b = 0;  ///< [Pa]
    double r1 = 0, r2 = 0, omega = 0;
};

struct IdealValues {
    double gamma = 1.4;
};

struct NobleAbelValues {
    double gamma = 1.3;
    double co_volume = 0;                     ///< fraction of the volume at the reference density
    std::optional<double> reference_density;  ///< [kg/m3]; that of the substance if not given
};

/// The law of a gas: exactly one of them.
struct LawValues {
    std::optional<JwlValues> jwl;
    std::optional<IdealValues> ideal;
    std::optional<NobleAbelValues> noble_abel;
};

struct ExplosiveValues {
    std::string name, title;
    LawValues law;
    double density = 0;                         ///< unreacted [kg/m3]
    double energy_density = 0;                  ///< released, per unreacted volume [J/m3]
    double detonation_velocity = 0;             ///< [m/s]
    std::optional<double> detonation_pressure;  ///< Chapman-Jouguet [Pa], for the record
    std::string source, status, note;
    Places places;
};

struct GasValues {
    std::string name, title;
    std::optional<LawValues> law;
    std::optional<double> gamma, co_volume;
    std::optional<double> reference_density;  ///< [kg/m3]
    std::optional<double> density;            ///< [kg/m3]
    std::optional<double> temperature;        ///< [K]
    std::optional<double> pressure;           ///< [Pa]
    std::optional<double> molar_mass;         ///< [kg/mol]
    std::string source, status, note;
    Places places;
};

struct ElasticValues {};

struct BilinearValues {
    double yield_stress = 0;       ///< [Pa]
    double hardening_modulus = 0;  ///< plastic [Pa]
    double rate_c = 0;             ///< Cowper-Symonds [1/s]; 0: no rate effect
    double rate_p = 0;
    double kinematic = 0;  ///< share of kinematic hardening
};

/// Yield stress over plastic strain, at a rate if there are several.
struct CurveLine {
    double rate = 0;                     ///< [1/s]
    std::vector<double> plastic_strain;  ///< from 0 upward
    std::vector<double> stress;          ///< [Pa]
};

struct CurveValues {
    std::vector<CurveLine> curves;
    double rate_c = 0;  ///< Cowper-Symonds [1/s]; 0: no such factor
    double rate_p = 0;
};

/// Strength and failure after Johnson and Cook.
struct JohnsonCookValues {
    double a = 0, b = 0;  ///< [Pa]
    double n = 1, c = 0, m = 1;
    double reference_rate = 1;                                 ///< [1/s]
    double room_temperature = 293, melting_temperature = 1e9;  ///< [K]
    double specific_heat = 0;                                  ///< [J/(kg K)]
    double heat_share = 0.9;
    double d1 = 0, d2 = 0, d3 = 0, d4 = 0, d5 = 0;
};

/// Deviator with linear hardening, pressure after Mie and Grueneisen.
struct HydroValues {
    double yield_stress = 0;       ///< [Pa]
    double hardening_modulus = 0;  ///< [Pa]
    double sound_speed = 0;        ///< c0 [m/s]
    double slope = 0, grueneisen = 0;
    std::optional<double> tension_limit;  ///< [Pa]
};

struct FabricValues {};

struct StrengthValues {
    std::optional<ElasticValues> elastic;
    std::optional<BilinearValues> bilinear;
    std::optional<CurveValues> curve;
    std::optional<JohnsonCookValues> johnson_cook;
    std::optional<HydroValues> hydro;
    std::optional<FabricValues> fabric;
};

struct MaterialValues {
    std::string name, title;
    double density = 0;        ///< [kg/m3]
    double young_modulus = 0;  ///< [Pa]
    double poisson_ratio = 0;
    StrengthValues strength;
    std::string source, status, note;
    Places places;
};

template <>
const Table& table_of<JwlValues>();
template <>
const Table& table_of<IdealValues>();
template <>
const Table& table_of<NobleAbelValues>();
template <>
const Table& table_of<LawValues>();
template <>
const Table& table_of<ExplosiveValues>();
template <>
const Table& table_of<GasValues>();
template <>
const Table& table_of<ElasticValues>();
template <>
const Table& table_of<BilinearValues>();
template <>
const Table& table_of<CurveLine>();
template <>
const Table& table_of<CurveValues>();
template <>
const Table& table_of<JohnsonCookValues>();
template <>
const Table& table_of<HydroValues>();
template <>
const Table& table_of<FabricValues>();
template <>
const Table& table_of<StrengthValues>();
template <>
const Table& table_of<MaterialValues>();

}  // namespace corpuscle
