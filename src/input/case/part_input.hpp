#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input/case/curve_input.hpp"
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

/// A way along which a surface mesh sweeps a solid.
struct ExtrudeInput {
    double height = 0;  ///< along +z, or along edge_1 x edge_2 of a rectangle [m]
    int layers = 1;
};

/// Where the mesh of a part comes from, and where it is put.
struct MeshInput {
    std::optional<DiskInput> disk;
    std::optional<RingInput> ring;
    std::optional<RectangleInput> rectangle;
    std::optional<BoxMeshInput> box;
    std::optional<ExtrudeInput> extrude;
    std::optional<std::string> file;
    std::string unit = "m";  ///< of the file's coordinates
    std::string group;       ///< element set of the file; all if empty
    Vector3d move;           ///< [m]
    bool closed = false;     ///< it must have no hole
    Places places;
};

/// Another thickness of some of a part's shells.
struct ThicknessInput {
    std::string set;       ///< of elements
    double thickness = 0;  ///< [m]
    Places places;
};

struct ShellInputSection {
    double thickness = 0;  ///< [m]
    std::vector<ThicknessInput> sets;
    int points = 5;
};

struct MembraneSection {
    double thickness = 0;  ///< [m]
};

/// Points of a brick: one with hourglass control, or eight.
enum class BrickRule { one_point, full };

struct SolidSection {
    BrickRule bricks = BrickRule::one_point;
    double hourglass = 0.02;  ///< stiffness of one-point bricks against hourglass modes
};

/// A rigid part that moves; without any of these it must be held wholly.
struct RigidSection {
    std::optional<double> mass;       ///< [kg]
    std::optional<Vector3d> inertia;  ///< [kg m2]
    std::optional<Vector3d> center;   ///< [m]
    std::optional<double> thickness;  ///< of surfaces, with a material [m]
};

/// Mass on nodes besides that of the elements.
struct PointMassInput {
    std::string where = "all";
    double mass = 0;  ///< [kg]
    Places places;
};

enum class PlainElement { rigid, solid };

/// What the part's elements are: shells or membranes with a thickness, solids, or rigid.
struct ElementInput {
    std::optional<PlainElement> plain;
    std::optional<ShellInputSection> shell;
    std::optional<MembraneSection> membrane;
    std::optional<SolidSection> solid;
    std::optional<RigidSection> rigid;

    [[nodiscard]] bool is_solid() const { return solid || plain == PlainElement::solid; }
    [[nodiscard]] bool is_rigid() const { return rigid || plain == PlainElement::rigid; }
};

/// When elements of a part are taken out.
struct ErosionInput {
    std::optional<double> plastic_strain;
    std::optional<double> principal_stress;  ///< [Pa]
    std::optional<double> tension;           ///< [Pa]
    std::optional<double> step;              ///< [s]
};

/// Directions a support holds.
enum class Held { all, translation, rotation, x, y, z, symmetry };

struct FixInput {
    std::string where = "all";
    Held dof = Held::all;
    Places places;
};

/// Axes along which motion is prescribed.
enum class DrivenAxis { x, y, z };

/// A motion that nodes are made to follow.
struct DriveInput {
    std::string where = "all";
    DrivenAxis dof = DrivenAxis::z;
    std::optional<CurveInput> displacement;  ///< [m]
    std::optional<CurveInput> velocity;      ///< [m/s]
    std::optional<CurveInput> acceleration;  ///< [m/s2]
    Places places;
};

/// Velocity at the start of some of a part's nodes.
struct StartInput {
    std::string where = "all";
    Vector3d velocity;  ///< [m/s]
    Places places;
};

struct PartInput {
    std::string name;
    MeshInput mesh;
    ElementInput element;
    std::optional<Preset<MaterialValues>> material;
    std::optional<ErosionInput> erosion;
    std::vector<FixInput> fix;
    std::vector<DriveInput> drive;
    std::vector<PointMassInput> point_masses;
    std::vector<StartInput> start;
    Vector3d velocity;  ///< at the start [m/s]
    Vector3d spin;      ///< at the start, about the center of mass [rad/s]
    Places places;
};

/// Where a charge stands, for the empirical load.
enum class BurstInput { spherical, hemispherical };

/// What faces get that do not see the charge.
enum class ShadowInput { nothing, incident };

struct ConwepInput {
    double mass = 0;  ///< of TNT [kg]
    Vector3d center;  ///< [m]
    BurstInput burst = BurstInput::spherical;
    double time = 0;  ///< of the detonation [s]
    ShadowInput shadow = ShadowInput::nothing;
};

struct LoadInput {
    std::optional<ConwepInput> conwep;
    std::optional<CurveInput> pressure;  ///< [Pa]
    std::optional<CurveInput> force;     ///< [N]
    std::string part;
    std::string where = "all";
    std::optional<Vector3d> direction;  ///< of the force
    Places places;
};

template <>
const std::vector<std::pair<std::string, PlainElement>>& words_of<PlainElement>();
template <>
const std::vector<std::pair<std::string, Held>>& words_of<Held>();
template <>
const std::vector<std::pair<std::string, BurstInput>>& words_of<BurstInput>();
template <>
const std::vector<std::pair<std::string, ShadowInput>>& words_of<ShadowInput>();
template <>
const std::vector<std::pair<std::string, DrivenAxis>>& words_of<DrivenAxis>();
template <>
const Table& table_of<DriveInput>();
template <>
const Table& table_of<StartInput>();
template <>
const Table& table_of<DiskInput>();
template <>
const Table& table_of<RingInput>();
template <>
const Table& table_of<RectangleInput>();
template <>
const Table& table_of<BoxMeshInput>();
template <>
const std::vector<std::pair<std::string, BrickRule>>& words_of<BrickRule>();
template <>
const Table& table_of<ExtrudeInput>();
template <>
const Table& table_of<MembraneSection>();
template <>
const Table& table_of<SolidSection>();
template <>
const Table& table_of<RigidSection>();
template <>
const Table& table_of<PointMassInput>();
template <>
const Table& table_of<ErosionInput>();
template <>
const Table& table_of<MeshInput>();
template <>
const Table& table_of<ThicknessInput>();
template <>
const Table& table_of<ShellInputSection>();
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
