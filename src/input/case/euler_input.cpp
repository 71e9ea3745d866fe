#include "input/case/euler_input.hpp"

#include "schema/table_builder.hpp"

namespace corpuscle {

template <>
const std::vector<std::pair<std::string, EulerSpace>>& words_of<EulerSpace>()
{
    static const std::vector<std::pair<std::string, EulerSpace>> words{
        {"none", EulerSpace::planar}, {"axisymmetric", EulerSpace::axisymmetric}, {"spherical", EulerSpace::spherical}};
    return words;
}

template <>
const Table& table_of<EulerInput>()
{
    static const Table table =
        TableBuilder<EulerInput>("euler",
                                 "Gases on a grid that stands still, in place of particles: the same charges, fills and gauges. Only one "
                                 "of [gas] and [euler] can be given.")
            .row("symmetry", &EulerInput::symmetry,
                 {"",
                  {},
                  "`none`: boxes, in space (or, with one cell along an axis, in a plane or on a line); `axisymmetric`: rings about the z "
                  "axis; `spherical`: shells about the point 0.",
                  "\"axisymmetric\""})
            .need("box", &EulerInput::box,
                  {"m",
                   {},
                   "What the grid holds: lower and upper x, y, z; with `axisymmetric` the radius, from 0, and z; with `spherical` the "
                   "radius alone.",
                   "[[0, \"1200 mm\"], [0, \"1200 mm\"], [\"-200 mm\", \"1400 mm\"]]"})
            .row("cell_size", &EulerInput::cell_size,
                 {"m", above(0), "Width of the cells, about: each axis is cut in equal ones.", "\"10 mm\""})
            .row("cells", &EulerInput::cells,
                 {"", from_to(1, 1e6), "How many cells along each axis of the box; nothing flows along an axis with one.", "[400, 1, 1]"})
            .row("fine_box", &EulerInput::fine_box,
                 {"m",
                  {},
                  "Where the cells are of `cell_size`, written like `box`; beyond it they grow, each by the same ratio, towards "
                  "`edge_cell_size` at the faces of the box.",
                  "[[0, \"600 mm\"], [0, \"600 mm\"], [\"-100 mm\", \"900 mm\"]]"})
            .row("edge_cell_size", &EulerInput::edge_cell_size,
                 {"m", above(0), "Width of the cells at the faces of the box, about, where there is a `fine_box`.", "\"40 mm\""})
            .row("edges", &EulerInput::edges,
                 {"",
                  {},
                  "What its faces do: `rigid` (a wall, also a plane of symmetry), `open` or `ambient` (both: what comes leaves, and the "
                  "state goes on unchanged beyond). With `axisymmetric`, x is the radius.",
                  "{ x = [\"rigid\", \"open\"], y = [\"rigid\", \"open\"] }"})
            .row("fill", &EulerInput::fill, {"", {}, "The gas all around, at its usual state (`corpuscle list gases`).", "\"air\""})
            .row("start", &EulerInput::start,
                 {"",
                  {},
                  "How the gases begin: `detonation` at time 0 with unburnt explosive; `spherical` when the blast of one ball of "
                  "explosive, lit at its center and solved in one dimension until then, nears the first thing it meets.",
                  "\"spherical\""})
            .row("cfl", &EulerInput::cfl,
                 {"", {0, 1, false, false}, "Time step, in the time that waves along all axes together take through a cell.", "0.8"})
            .row("sleep", &EulerInput::sleep,
                 {"", {}, "Blocks of cells that nothing has reached cost nothing; `false` computes them all, to the same bits.", "false"})
            .one_of({"cell_size", "cells"})
            .table();
    return table;
}

}  // namespace corpuscle
