#pragma once

#include <array>
#include <optional>
#include <string>

#include "math/box.hpp"
#include "math/vector3.hpp"
#include "schema/codec.hpp"

// Shapes as a case gives them. Lengths in m.

namespace corpuscle {

/// [[x_min, x_max], [y_min, y_max], [z_min, z_max]] [m]
using BoxRanges = std::array<std::array<double, 2>, 3>;

[[nodiscard]] Box box_of(const BoxRanges& ranges);

struct SphereInput {
    Vector3d center;
    double radius = 0;
};

struct HemisphereInput {
    Vector3d center;
    double radius = 0;
    Vector3d axis{0, 0, 1};
};

struct CylinderInput {
    Vector3d center;
    double radius = 0;
    double length = 0;
    Vector3d axis{0, 0, 1};
};

struct EllipsoidInput {
    Vector3d center;
    Vector3d semi_axes;
};

/// A mesh file and the unit its coordinates are in.
struct FileInput {
    std::string file;
    std::string unit = "m";
};

/// Forms whose size follows from the charge's mass.
enum class ChargeForm { sphere, hemisphere, cylinder };

/// A shape with its size and place, or (charges only) just its form.
struct ShapeInput {
    std::optional<ChargeForm> form;
    std::optional<BoxRanges> box;
    std::optional<SphereInput> sphere;
    std::optional<HemisphereInput> hemisphere;
    std::optional<CylinderInput> cylinder;
    std::optional<EllipsoidInput> ellipsoid;
    std::optional<FileInput> surface;
    Places places;
};

template <>
const std::vector<std::pair<std::string, ChargeForm>>& words_of<ChargeForm>();
template <>
const Table& table_of<SphereInput>();
template <>
const Table& table_of<HemisphereInput>();
template <>
const Table& table_of<CylinderInput>();
template <>
const Table& table_of<EllipsoidInput>();
template <>
const Table& table_of<FileInput>();
template <>
const Table& table_of<ShapeInput>();

}  // namespace corpuscle
