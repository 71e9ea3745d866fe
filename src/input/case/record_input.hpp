#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input/case/shape_input.hpp"

// What a run records, as a case asks for it: probes, gauges, files.

namespace corpuscle {

enum class ProbeQuantity { displacement, velocity };

/// Components of a vector.
enum class Component { x, y, z };

/// A value to draw beside a probe's displacement.
struct ReferenceInput {
    double value = 0;  ///< [m]
    Component component = Component::z;
    std::string label;
};

struct ProbeInput {
    std::string name;
    Vector3d node_at;  ///< [m]
    std::vector<ProbeQuantity> quantities;
    std::optional<double> every;  ///< [s]
    std::optional<ReferenceInput> reference;
    Places places;
};

struct GaugeSphereInput {
    Vector3d center;    ///< [m]
    double radius = 0;  ///< [m]
};

/// Faces of the gas box.
enum class FaceInput { x_lower, x_upper, y_lower, y_upper, z_lower, z_upper };

struct GaugeInput {
    std::string name;
    std::optional<std::string> facets;
    std::optional<Vector3d> point;  ///< [m]
    std::optional<GaugeSphereInput> sphere;
    std::optional<BoxRanges> box;
    std::optional<FaceInput> face;
    std::optional<double> every;  ///< [s]
    Places places;
};

/// Interval of a probe or gauge: its own, or a thousandth of the run. [s]
[[nodiscard]] inline double interval_of(const std::optional<double>& every, double end_time)
{
    return every.value_or(end_time / 1000);
}

struct OutputInput {
    std::optional<double> fields_every;    ///< [s]
    std::optional<double> energies_every;  ///< [s]
    double restart_every = 600;            ///< of wall clock [s]
    std::size_t particles_shown = 200'000;
    int averages = 48;
    bool compress = false;
    Places places;
};

template <>
const std::vector<std::pair<std::string, ProbeQuantity>>& words_of<ProbeQuantity>();
template <>
const std::vector<std::pair<std::string, FaceInput>>& words_of<FaceInput>();
template <>
const std::vector<std::pair<std::string, Component>>& words_of<Component>();
template <>
const Table& table_of<ReferenceInput>();
template <>
const Table& table_of<ProbeInput>();
template <>
const Table& table_of<GaugeSphereInput>();
template <>
const Table& table_of<GaugeInput>();
template <>
const Table& table_of<OutputInput>();

}  // namespace corpuscle
