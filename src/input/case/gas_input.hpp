#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gas/gas.hpp"
#include "input/case/preset_values.hpp"
#include "input/case/shape_input.hpp"
#include "schema/preset.hpp"

// The gas as a case gives it: charges, the box, further fills.

namespace corpuscle {

/// A point where a charge is lit.
struct DetonationInput {
    Vector3d point;   ///< [m]
    double time = 0;  ///< [s]
};

struct ChargeInput {
    Preset<ExplosiveValues> explosive;
    ShapeInput shape{ChargeForm::sphere, {}, {}, {}, {}, {}, {}, {}};
    std::optional<double> mass;      ///< of the whole charge, beyond planes of symmetry too [kg]
    std::optional<double> radius;    ///< of its form [m]
    std::optional<Vector3d> center;  ///< [m]
    Vector3d axis{0, 0, 1};
    double length_over_diameter = 1;  ///< of a cylinder given by its mass or its radius
    std::vector<DetonationInput> detonation;
    Places places;
};

/// How many particles: in all, or of either kind.
struct ParticleCounts {
    std::optional<std::uint64_t> total;
    std::optional<std::uint64_t> products;
    std::optional<std::uint64_t> air;
};

struct EdgesInput {
    std::array<Edge, 2> x{Edge::ambient, Edge::ambient};
    std::array<Edge, 2> y{Edge::ambient, Edge::ambient};
    std::array<Edge, 2> z{Edge::ambient, Edge::ambient};
};

/// How the particles begin: at time 0 with the explosive unburnt, or from the blast solved in one dimension.
enum class StartRule { detonation, spherical };

struct GasInput {
    BoxRanges box{};  ///< [m]
    EdgesInput edges;
    ParticleCounts particles;
    std::optional<Preset<GasValues>> fill;
    std::uint64_t seed = GasSettings{}.seed;
    double mean_free_path = GasSettings{}.mean_free_path;  ///< in local spacings
    std::uint32_t cell_limit = GasSettings{}.cell_limit;
    std::uint32_t partners = GasSettings{}.partners;
    CollisionRule collision = CollisionRule::displaced;
    double packing = 0.01;  ///< of gas without co-volume, as hard spheres
    StartRule start = StartRule::detonation;
    double relaxation = GasSettings{}.relaxation;
    double cfl = GasSettings{}.cfl;
    bool sleep = true;
    Places places;
};

/// A gas state in a shape.
struct FillInput {
    Preset<GasValues> gas;
    ShapeInput shape;
    std::optional<double> density;         ///< [kg/m3]
    std::optional<double> pressure;        ///< [Pa]
    std::optional<double> temperature;     ///< [K]
    std::optional<double> energy_density;  ///< [J/m3]
    Vector3d velocity;                     ///< [m/s]
    Places places;
};

template <>
const std::vector<std::pair<std::string, Edge>>& words_of<Edge>();
template <>
const std::vector<std::pair<std::string, CollisionRule>>& words_of<CollisionRule>();
template <>
const std::vector<std::pair<std::string, StartRule>>& words_of<StartRule>();
template <>
const Table& table_of<DetonationInput>();
template <>
const Table& table_of<ChargeInput>();
template <>
const Table& table_of<ParticleCounts>();
template <>
const Table& table_of<EdgesInput>();
template <>
const Table& table_of<GasInput>();
template <>
const Table& table_of<FillInput>();

}  // namespace corpuscle
