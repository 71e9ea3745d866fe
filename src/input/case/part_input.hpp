#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input/case/preset_values.hpp"
#include "input/case/shape_input.hpp"
#include "schema/preset.hpp"

// The structure as a case gives it: parts with their mesh, element, material and supports; loads on them.

namespace corpuscle {

struct DiskInput {
    double radius = 0;        ///< [m]
    double element_size = 0;  ///< [m]
    bool quarter = false;
};

struct RingInput {
    double inner_radius = 0;  ///< [m]
    double outer_radius = 0;  ///< [m]
    double element_size = 0;  ///< [m]
    bool quarter = false;
};

struct RectangleInput {
    Vector3d origin;
    Vector3d edge_1, edge_2;  ///< [m]
    double element_size = 0;  ///< [m]
};

struct BoxMeshInput {
    BoxRanges box{};          ///< [m]
    double element_size = 0;  ///< [m]
};

/// Where the mesh of a part comes from, and where it is put.
struct MeshInput {
    std::optional<DiskInput> disk;
    std::optional<RingInput> ring;
    std::optional<RectangleInput> rectangle;
    std::optional<BoxMeshInput> box;
    std::optional<std::string> file;
    std::string unit = "m";  ///< of the file's coordinates
    std::string group;       ///< element set of the file; all if empty
    Vector3d move;           ///< [m]
    bool closed = false;     ///< it must have no hole
    Places places;
};

struct ShellSection {
    double thickness = 0;  ///< [m]
    int points = 5;
};

enum class PlainElement { rigid };

/// What the part's elements are: shells with a thickness, or rigid.
struct ElementInput {
    std::optional<PlainElement> plain;
    std::optional<ShellSection> shell;
};

/// Directions a support holds.
enum class Held { all, translation, rotation, x, y, z, symmetry };

struct FixInput {
    std::string where = "all";
    Held dof = Held::all;
    Places places;
};

struct PartInput {
    std::string name;
    MeshInput mesh;
    ElementInput element;
    std::optional<Preset<MaterialValues>> material;
    std::vector<FixInput> fix;
    Vector3d velocity;  ///< at the start [m/s]
    Places places;
};

/// Where a charge stands, for the empirical load.
enum class BurstInput { spherical, hemispherical };

struct ConwepInput {
    double mass = 0;  ///< of TNT [kg]
    Vector3d center;  ///< [m]
    BurstInput burst = BurstInput::spherical;
    double time = 0;  ///< of the detonation [s]
};

struct LoadInput {
    std::optional<ConwepInput> conwep;
    std::string part;
    Places places;
};

template <>
const std::vector<std::pair<std::string, PlainElement>>& words_of<PlainElement>();
template <>
const std::vector<std::pair<std::string, Held>>& words_of<Held>();
template <>
const std::vector<std::pair<std::string, BurstInput>>& words_of<BurstInput>();
template <>
const Table& table_of<DiskInput>();
template <>
const Table& table_of<RingInput>();
template <>
const Table& table_of<RectangleInput>();
template <>
const Table& table_of<BoxMeshInput>();
template <>
const Table& table_of<MeshInput>();
template <>
const Table& table_of<ShellSection>();
template <>
const Table& table_of<ElementInput>();
template <>
const Table& table_of<FixInput>();
template <>
const Table& table_of<PartInput>();
template <>
const Table& table_of<ConwepInput>();
template <>
const Table& table_of<LoadInput>();

}  // namespace corpuscle
