#include "input/case/part_input.hpp"

#include "schema/table_builder.hpp"

namespace corpuscle {

template <>
const std::vector<std::pair<std::string, PlainElement>>& words_of<PlainElement>()
{
    static const std::vector<std::pair<std::string, PlainElement>> words{{"rigid", PlainElement::rigid}, {"solid", PlainElement::solid}};
    return words;
}

template <>
const std::vector<std::pair<std::string, Held>>& words_of<Held>()
{
    static const std::vector<std::pair<std::string, Held>> words{
        {"all", Held::all}, {"translation", Held::translation}, {"rotation", Held::rotation}, {"x", Held::x}, {"y", Held::y},
        {"z", Held::z},     {"symmetry", Held::symmetry}};
    return words;
}

template <>
const std::vector<std::pair<std::string, BurstInput>>& words_of<BurstInput>()
{
    static const std::vector<std::pair<std::string, BurstInput>> words{{"spherical", BurstInput::spherical},
                                                                       {"hemispherical", BurstInput::hemispherical}};
    return words;
}

template <>
const std::vector<std::pair<std::string, ShadowInput>>& words_of<ShadowInput>()
{
    static const std::vector<std::pair<std::string, ShadowInput>> words{{"nothing", ShadowInput::nothing},
                                                                        {"incident", ShadowInput::incident}};
    return words;
}

template <>
const std::vector<std::pair<std::string, DrivenAxis>>& words_of<DrivenAxis>()
{
    static const std::vector<std::pair<std::string, DrivenAxis>> words{{"x", DrivenAxis::x}, {"y", DrivenAxis::y}, {"z", DrivenAxis::z}};
    return words;
}

template <>
const Table& table_of<DriveInput>()
{
    static const Table table =
        TableBuilder<DriveInput>("drive", "A motion along an axis that nodes, or the whole of a rigid part, are made to follow.")
            .need("where", &DriveInput::where, {"", {}, "Nodes: `all`, a set of the mesh, or a plane (`x=0`).", "\"end\""})
            .need("dof", &DriveInput::dof, {"", {}, "The axis.", "\"x\""})
            .row("displacement", &DriveInput::displacement,
                 {"m", {}, "How far from where it was meshed, over time; 0 at time 0.", "[[0, 0], [\"1 ms\", \"5 mm\"]]"})
            .row("velocity", &DriveInput::velocity, {"m/s", {}, "How fast, over time.", "\"10 m/s\""})
            .row("acceleration", &DriveInput::acceleration,
                 {"m/s2", {}, "Its acceleration over time, from the velocity of the start.", "[[0, 0], [\"2 ms\", 5e4]]"})
            .one_of({"displacement", "velocity", "acceleration"})
            .table();
    return table;
}

template <>
const Table& table_of<StartInput>()
{
    static const Table table =
        TableBuilder<StartInput>("start", "Velocity at the start of some of the nodes.")
            .need("where", &StartInput::where, {"", {}, "Nodes: `all`, a set of the mesh, or a plane (`x=0`).", "\"end\""})
            .need("velocity", &StartInput::velocity, {"m/s", {}, "Their velocity.", "[0, 0, 10]"})
            .table();
    return table;
}

template <>
const Table& table_of<DiskInput>()
{
    static const Table table =
        TableBuilder<DiskInput>("disk", "A disk in z = 0 about the origin, facing +z. Node set: `rim`.")
            .need("radius", &DiskInput::radius, {"m", above(0), "Its radius.", "\"500 mm\""})
            .need("element_size", &DiskInput::element_size, {"m", above(0), "Edge of its quadrilaterals.", "\"20 mm\""})
            .row("quarter", &DiskInput::quarter, {"", {}, "Only the quarter x >= 0, y >= 0.", "true"})
            .table();
    return table;
}

template <>
const Table& table_of<RingInput>()
{
    static const Table table =
        TableBuilder<RingInput>(
            "ring", "A flat ring in z = 0 about the origin, facing +z; flush with a disk of its inner radius. Node sets: `inner`, `outer`.")
            .need("inner_radius", &RingInput::inner_radius, {"m", above(0), "Its inner radius.", "\"500 mm\""})
            .need("outer_radius", &RingInput::outer_radius, {"m", above(0), "Its outer radius.", "\"1700 mm\""})
            .need("element_size", &RingInput::element_size, {"m", above(0), "Edge of its quadrilaterals.", "\"50 mm\""})
            .row("quarter", &RingInput::quarter, {"", {}, "Only the quarter x >= 0, y >= 0.", "true"})
            .table();
    return table;
}

template <>
const Table& table_of<RectangleInput>()
{
    static const Table table =
        TableBuilder<RectangleInput>("rectangle",
                                     "A parallelogram, facing edge_1 x edge_2. Node sets: `rim`, `start_1`, `end_1`, `start_2`, `end_2`.")
            .row("origin", &RectangleInput::origin, {"m", {}, "A corner.", "[0, 0, 0]"})
            .need("edge_1", &RectangleInput::edge_1, {"m", {}, "From the corner along one edge.", "[\"1 m\", 0, 0]"})
            .need("edge_2", &RectangleInput::edge_2, {"m", {}, "From the corner along the other edge.", "[0, \"1 m\", 0]"})
            .need("element_size", &RectangleInput::element_size, {"m", above(0), "Edge of its quadrilaterals.", "\"20 mm\""})
            .table();
    return table;
}

template <>
const Table& table_of<BoxMeshInput>()
{
    static const Table table =
        TableBuilder<BoxMeshInput>("box", "A hollow closed box, facing outward. Element sets: `x_min`, `x_max`, ... `z_max`.")
            .need("box", &BoxMeshInput::box, {"m", {}, "Its lower and upper x, y, z.", "[[0, 1], [0, 1], [0, 1]]"})
            .need("element_size", &BoxMeshInput::element_size, {"m", above(0), "Edge of its quadrilaterals.", "\"20 mm\""})
            .table();
    return table;
}

template <>
const std::vector<std::pair<std::string, BrickRule>>& words_of<BrickRule>()
{
    static const std::vector<std::pair<std::string, BrickRule>> words{{"one_point", BrickRule::one_point}, {"full", BrickRule::full}};
    return words;
}

template <>
const Table& table_of<ExtrudeInput>()
{
    static const Table table =
        TableBuilder<ExtrudeInput>(
            "extrude",
            "Sweeps the surface along +z (a rectangle along edge_1 x edge_2) into hexahedra. Node sets: those of the "
            "surface, `start`, `end`.")
            .need("height", &ExtrudeInput::height, {"m", above(0), "How far.", "\"20 mm\""})
            .row("layers", &ExtrudeInput::layers, {"", from_to(1, 10000), "Hexahedra over the height.", "4"})
            .table();
    return table;
}

template <>
const Table& table_of<MeshInput>()
{
    static const Table table =
        TableBuilder<MeshInput>("mesh", "The mesh of a part: made from a few numbers, or read from a file.")
            .row("disk", &MeshInput::disk, {"", {}, "A disk.", "{ radius = \"500 mm\", element_size = \"20 mm\", quarter = true }"})
            .row("ring", &MeshInput::ring,
                 {"",
                  {},
                  "A flat ring.",
                  "{ inner_radius = \"500 mm\", outer_radius = \"1700 mm\", element_size = \"50 mm\", quarter = true }"})
            .row("rectangle", &MeshInput::rectangle,
                 {"", {}, "A parallelogram.", "{ edge_1 = [1, 0, 0], edge_2 = [0, 1, 0], element_size = \"20 mm\" }"})
            .row("box", &MeshInput::box, {"", {}, "A hollow closed box.", "{ box = [[0, 1], [0, 1], [0, 1]], element_size = \"20 mm\" }"})
            .row("extrude", &MeshInput::extrude,
                 {"",
                  {},
                  "Sweeps a disk, ring, rectangle or file of quadrilaterals into a solid of hexahedra.",
                  "{ height = \"20 mm\", layers = 4 }"})
            .row("file", &MeshInput::file,
                 {"",
                  {},
                  "A mesh file, beside the case or with its full path: .msh (gmsh 2.2, 4.1), .inp (Abaqus), .k (LS-DYNA) or .stl.",
                  "\"hull.msh\""})
            .row("unit", &MeshInput::unit, {"", {}, "Unit of the coordinates in the file.", "\"mm\""})
            .row("group", &MeshInput::group,
                 {"",
                  {},
                  "The physical group, Abaqus element set or instance, LS-DYNA part (its title, or `part_7`) or solid of an STL file that "
                  "is "
                  "this part; the whole file if not given.",
                  "\"plate\""})
            .row("move", &MeshInput::move, {"m", {}, "Added to every node.", "[0, 0, \"100 mm\"]"})
            .row("closed", &MeshInput::closed, {"", {}, "Refuse the mesh if it has a hole.", "true"})
            .one_of({"disk", "ring", "rectangle", "box", "file"})
            .table();
    return table;
}

template <>
const Table& table_of<ThicknessInput>()
{
    static const Table table = TableBuilder<ThicknessInput>("sets", "Another thickness of some of the shells.")
                                   .need("set", &ThicknessInput::set, {"", {}, "A set of elements of the mesh.", "\"girders\""})
                                   .need("thickness", &ThicknessInput::thickness, {"m", above(0), "Their thickness.", "\"6 mm\""})
                                   .table();
    return table;
}

template <>
const Table& table_of<ShellInputSection>()
{
    static const Table table =
        TableBuilder<ShellInputSection>("shell", "Belytschko-Lin-Tsay shells.")
            .need("thickness", &ShellInputSection::thickness, {"m", above(0), "Thickness; the mesh is its middle.", "\"20 mm\""})
            .row("sets", &ShellInputSection::sets,
                 {"", {}, "Sets of elements with a thickness of their own.", "[{ set = \"girders\", thickness = \"6 mm\" }]"})
            .row("points", &ShellInputSection::points, {"", from_to(3, 10), "Integration points through the thickness.", "5"})
            .table();
    return table;
}

template <>
const Table& table_of<MembraneSection>()
{
    static const Table table =
        TableBuilder<MembraneSection>(
            "membrane", "Shells that do not bend, of triangles; quadrilaterals are cut in two. For cloth with the law `fabric`.")
            .need("thickness", &MembraneSection::thickness, {"m", above(0), "Thickness; the mesh is its middle.", "\"0.3 mm\""})
            .table();
    return table;
}

template <>
const Table& table_of<SolidSection>()
{
    static const Table table =
        TableBuilder<SolidSection>("solid", "Eight-node bricks, or four-node tetrahedra whose growth of volume is averaged at the nodes.")
            .row("bricks", &SolidSection::bricks,
                 {"",
                  {},
                  "Points of a brick: `one_point` with Flanagan-Belytschko hourglass control; `full`, eight, several times slower, without "
                  "hourglass modes.",
                  "\"full\""})
            .row("hourglass", &SolidSection::hourglass,
                 {"", from_to(0, 0.5), "Stiffness of one-point bricks against hourglass modes.", "0.05"})
            .table();
    return table;
}

template <>
const Table& table_of<RigidSection>()
{
    static const Table table =
        TableBuilder<RigidSection>(
            "rigid",
            "A body that does not deform. Held wholly it is a wall; else it moves with the mass, center and inertia of its "
            "elements (a material, and for surfaces a thickness), or those given here.")
            .row("mass", &RigidSection::mass, {"kg", above(0), "Its mass, spread over its elements.", "\"20 kg\""})
            .row("inertia", &RigidSection::inertia, {"kg m2", above(0), "About x, y, z through its center.", "[1.2, 1.2, 2.0]"})
            .row("center", &RigidSection::center, {"m", {}, "Its center of mass.", "[0, 0, \"100 mm\"]"})
            .row("thickness", &RigidSection::thickness, {"m", above(0), "Thickness of its surface, with a material.", "\"10 mm\""})
            .table();
    return table;
}

template <>
const Table& table_of<PointMassInput>()
{
    static const Table table =
        TableBuilder<PointMassInput>("point_masses", "Mass that rides on nodes, in equal parts, without stiffness.")
            .need("where", &PointMassInput::where, {"", {}, "Nodes: `all`, a node set of the mesh, or a plane (`x=0`).", "\"end\""})
            .need("mass", &PointMassInput::mass, {"kg", above(0), "Of all these nodes together.", "\"2 kg\""})
            .table();
    return table;
}

template <>
const Table& table_of<ErosionInput>()
{
    static const Table table =
        TableBuilder<ErosionInput>("erosion",
                                   "Limits beyond which an element is taken out, a shell when all its points are: its mass and energy are "
                                   "booked as `eroded`, and gas passes where it was. Johnson-Cook failure needs no limit here.")
            .row("plastic_strain", &ErosionInput::plastic_strain, {"", above(0), "Equivalent plastic strain.", "0.3"})
            .row("principal_stress", &ErosionInput::principal_stress,
                 {"Pa", above(0), "Largest principal stress, in tension.", "\"4 MPa\""})
            .row("tension", &ErosionInput::tension, {"Pa", above(0), "Mean tension: minus the pressure.", "\"2 GPa\""})
            .row("step", &ErosionInput::step, {"s", above(0), "Stable step below which an element goes.", "\"10 ns\""})
            .table();
    return table;
}

template <>
const Table& table_of<ElementInput>()
{
    static const Table table =
        TableBuilder<ElementInput>("element", "What the elements of a part are.")
            .row("plain", &ElementInput::plain,
                 {"", {}, "`rigid`: a wall, held wholly, without material; `solid`: solids as `{ solid = {} }`.", "\"rigid\""})
            .row("shell", &ElementInput::shell, {"", {}, "Shells.", "{ thickness = \"20 mm\", points = 5 }"})
            .row("membrane", &ElementInput::membrane, {"", {}, "Shells that do not bend.", "{ thickness = \"0.3 mm\" }"})
            .row("solid", &ElementInput::solid, {"", {}, "Bricks or tetrahedra.", "{ bricks = \"one_point\" }"})
            .row("rigid", &ElementInput::rigid, {"", {}, "A body that moves without deforming.", "{ mass = \"20 kg\" }"})
            .one_of({"plain", "shell", "membrane", "solid", "rigid"})
            .shorthand("plain")
            .table();
    return table;
}

template <>
const Table& table_of<FixInput>()
{
    static const Table table =
        TableBuilder<FixInput>("fix", "A support.")
            .need("where", &FixInput::where,
                  {"", {}, "Nodes: `all`, a node set of the mesh (`rim`), or a plane (`x=0`, `z=-20 mm`).", "\"rim\""})
            .need("dof", &FixInput::dof,
                  {"", {}, "What it holds; `symmetry` holds what a plane of symmetry does (only with a plane).", "\"all\""})
            .table();
    return table;
}

template <>
const Table& table_of<PartInput>()
{
    static const Table table =
        TableBuilder<PartInput>("part", "A part of the structure.")
            .need("name", &PartInput::name, {"", {}, "Its name: for loads, gauges and results.", "\"plate\""})
            .need("mesh", &PartInput::mesh,
                  {"", {}, "Its mesh.", "{ disk = { radius = \"500 mm\", element_size = \"20 mm\", quarter = true } }"})
            .need("element", &PartInput::element, {"", {}, "Its elements.", "{ shell = { thickness = \"20 mm\", points = 5 } }"})
            .row("material", &PartInput::material,
                 {"", {}, "What it is made of (`corpuscle list materials`), unless rigid.", "\"rha_steel\""})
            .row("erosion", &PartInput::erosion, {"", {}, "When its elements are taken out.", "{ plastic_strain = 0.3 }"})
            .row("fix", &PartInput::fix, {"", {}, "Its supports.", "[{ where = \"rim\", dof = \"all\" }]"})
            .row("drive", &PartInput::drive,
                 {"", {}, "Motions its nodes are made to follow.", "[{ where = \"x=0\", dof = \"x\", velocity = \"10 m/s\" }]"})
            .row("point_masses", &PartInput::point_masses,
                 {"", {}, "Mass besides that of the elements.", "[{ where = \"end\", mass = \"2 kg\" }]"})
            .row("spin", &PartInput::spin, {"rad/s", {}, "Angular velocity at the start, about the part's center of mass.", "[0, 0, 100]"})
            .row("velocity", &PartInput::velocity, {"m/s", {}, "Velocity at the start.", "[0, 0, 10]"})
            .row("start", &PartInput::start,
                 {"", {}, "Velocities at the start of some of its nodes.", "[{ where = \"end\", velocity = [0, 0, 10] }]"})
            .table();
    return table;
}

template <>
const Table& table_of<ConwepInput>()
{
    static const Table table =
        TableBuilder<ConwepInput>("conwep", "Blast load after Kingery and Bulmash with the angle rule of ConWep.")
            .need("mass", &ConwepInput::mass, {"kg", above(0), "Mass of TNT.", "\"15 kg\""})
            .need("center", &ConwepInput::center, {"m", {}, "Center of the charge.", "[0, 0, \"700 mm\"]"})
            .row("burst", &ConwepInput::burst, {"", {}, "In free air, or on the ground.", "\"spherical\""})
            .row("time", &ConwepInput::time, {"s", at_least(0), "When it detonates.", "0"})
            .row("shadow", &ConwepInput::shadow,
                 {"", {}, "What faces get that look away from the charge, or that facets of any part hide from it.", "\"incident\""})
            .table();
    return table;
}

template <>
const Table& table_of<LoadInput>()
{
    static const Table table =
        TableBuilder<LoadInput>("load", "A load on a part that is not gas.")
            .row("conwep", &LoadInput::conwep,
                 {"", {}, "Empirical blast load.", "{ mass = \"15 kg\", center = [0, 0, \"700 mm\"], burst = \"spherical\" }"})
            .row("pressure", &LoadInput::pressure,
                 {"Pa",
                  {},
                  "Pressure over time: on solids from outside, on shells against their normals. It stays at the last value.",
                  "[[0, \"5 bar\"], [\"2 ms\", 0]]"})
            .row("force", &LoadInput::force,
                 {"N", {}, "Force over time, in equal parts on the nodes. It stays at the last value.", "[[0, 0], [\"1 ms\", \"3 kN\"]]"})
            .need("part", &LoadInput::part, {"", {}, "The part it acts on.", "\"plate\""})
            .row("where", &LoadInput::where,
                 {"",
                  {},
                  "Nodes with the force, or whose facets have the pressure: `all`, a set of the mesh, or a plane (`z=0`).",
                  "\"top\""})
            .row("direction", &LoadInput::direction, {"", {}, "Of the force.", "[0, 0, -1]"})
            .one_of({"conwep", "pressure", "force"})
            .table();
    return table;
}

}  // namespace corpuscle
