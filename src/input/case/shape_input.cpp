#include "input/case/shape_input.hpp"

#include "schema/table_builder.hpp"

namespace corpuscle {

Box box_of(const BoxRanges& ranges)
{
    Box box;
    box.lower = {ranges[0][0], ranges[1][0], ranges[2][0]};
    box.upper = {ranges[0][1], ranges[1][1], ranges[2][1]};
    return box;
}

template <>
const std::vector<std::pair<std::string, ChargeForm>>& words_of<ChargeForm>()
{
    static const std::vector<std::pair<std::string, ChargeForm>> words{
        {"sphere", ChargeForm::sphere}, {"hemisphere", ChargeForm::hemisphere}, {"cylinder", ChargeForm::cylinder}};
    return words;
}

template <>
const Table& table_of<SphereInput>()
{
    static const Table table = TableBuilder<SphereInput>("sphere", "A ball.")
                                   .need("center", &SphereInput::center, {"m", {}, "Its center.", "[0, 0, \"700 mm\"]"})
                                   .need("radius", &SphereInput::radius, {"m", above(0), "Its radius.", "\"130 mm\""})
                                   .table();
    return table;
}

template <>
const Table& table_of<HemisphereInput>()
{
    static const Table table =
        TableBuilder<HemisphereInput>("hemisphere", "Half a ball.")
            .need("center", &HemisphereInput::center, {"m", {}, "Center of the whole ball, in the flat face.", "[0, 0, 0]"})
            .need("radius", &HemisphereInput::radius, {"m", above(0), "Its radius.", "\"164 mm\""})
            .row("axis", &HemisphereInput::axis, {"", {}, "Direction from the flat face into the dome.", "[0, 0, 1]"})
            .table();
    return table;
}

template <>
const Table& table_of<CylinderInput>()
{
    static const Table table = TableBuilder<CylinderInput>("cylinder", "A cylinder with flat ends.")
                                   .need("center", &CylinderInput::center, {"m", {}, "Middle of its axis.", "[0, 0, \"-100 mm\"]"})
                                   .need("radius", &CylinderInput::radius, {"m", above(0), "Its radius.", "\"120 mm\""})
                                   .need("length", &CylinderInput::length, {"m", above(0), "Its length along the axis.", "\"80 mm\""})
                                   .row("axis", &CylinderInput::axis, {"", {}, "Direction of its axis.", "[0, 0, 1]"})
                                   .table();
    return table;
}

template <>
const Table& table_of<EllipsoidInput>()
{
    static const Table table = TableBuilder<EllipsoidInput>("ellipsoid", "An ellipsoid with its axes along x, y, z.")
                                   .need("center", &EllipsoidInput::center, {"m", {}, "Its center.", "[0, 0, 0]"})
                                   .need("semi_axes", &EllipsoidInput::semi_axes,
                                         {"m", above(0), "Half its lengths along x, y, z.", "[\"200 mm\", \"200 mm\", \"50 mm\"]"})
                                   .table();
    return table;
}

template <>
const Table& table_of<FileInput>()
{
    static const Table table =
        TableBuilder<FileInput>("surface", "A closed surface read from a mesh file.")
            .need("file", &FileInput::file,
                  {"", {}, "The file, beside the case or with its full path: .msh (gmsh) or .stl.", "\"charge.stl\""})
            .row("unit", &FileInput::unit, {"", {}, "Unit of the coordinates in the file.", "\"mm\""})
            .shorthand("file")
            .table();
    return table;
}

template <>
const Table& table_of<ShapeInput>()
{
    static const Table table =
        TableBuilder<ShapeInput>("shape", "A region of space.")
            .row("form", &ShapeInput::form, {"", {}, "Only the form, for a charge: its mass and center give the rest.", "\"sphere\""})
            .row("box", &ShapeInput::box, {"m", {}, "A box along the axes: its lower and upper x, y, z.", "[[0, 0.5], [0, 0.1], [0, 0.1]]"})
            .row("sphere", &ShapeInput::sphere, {"", {}, "A ball.", "{ center = [0, 0, \"700 mm\"], radius = \"130 mm\" }"})
            .row("hemisphere", &ShapeInput::hemisphere,
                 {"", {}, "Half a ball.", "{ center = [0, 0, 0], radius = \"164 mm\", axis = [0, 0, 1] }"})
            .row("cylinder", &ShapeInput::cylinder,
                 {"", {}, "A cylinder.", "{ center = [0, 0, 0], radius = \"120 mm\", length = \"80 mm\" }"})
            .row("ellipsoid", &ShapeInput::ellipsoid, {"", {}, "An ellipsoid.", "{ center = [0, 0, 0], semi_axes = [0.2, 0.2, 0.05] }"})
            .row("surface", &ShapeInput::surface, {"", {}, "The inside of a closed surface from a mesh file.", "\"charge.stl\""})
            .one_of({"form", "box", "sphere", "hemisphere", "cylinder", "ellipsoid", "surface"})
            .shorthand("form")
            .table();
    return table;
}

}  // namespace corpuscle
