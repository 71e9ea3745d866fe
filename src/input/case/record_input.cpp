#include "input/case/record_input.hpp"

#include "schema/table_builder.hpp"

namespace corpuscle {

template <>
const std::vector<std::pair<std::string, ProbeQuantity>>& words_of<ProbeQuantity>()
{
    static const std::vector<std::pair<std::string, ProbeQuantity>> words{{"displacement", ProbeQuantity::displacement},
                                                                          {"velocity", ProbeQuantity::velocity}};
    return words;
}

template <>
const std::vector<std::pair<std::string, FaceInput>>& words_of<FaceInput>()
{
    static const std::vector<std::pair<std::string, FaceInput>> words{{"x-", FaceInput::x_lower}, {"x+", FaceInput::x_upper},
                                                                      {"y-", FaceInput::y_lower}, {"y+", FaceInput::y_upper},
                                                                      {"z-", FaceInput::z_lower}, {"z+", FaceInput::z_upper}};
    return words;
}

template <>
const std::vector<std::pair<std::string, Component>>& words_of<Component>()
{
    static const std::vector<std::pair<std::string, Component>> words{{"x", Component::x}, {"y", Component::y}, {"z", Component::z}};
    return words;
}

template <>
const Table& table_of<ReferenceInput>()
{
    static const Table table =
        TableBuilder<ReferenceInput>("reference",
                                     "A length the report draws as a dashed line beside the displacement: an experiment, another code.")
            .need("value", &ReferenceInput::value, {"m", {}, "The value, with its sign.", "\"-47 mm\""})
            .row("component", &ReferenceInput::component, {"", {}, "Of the displacement.", "\"z\""})
            .need("label", &ReferenceInput::label, {"", {}, "Where it is from.", "\"experiment\""})
            .table();
    return table;
}

template <>
const Table& table_of<ProbeInput>()
{
    static const Table table =
        TableBuilder<ProbeInput>("probe", "A node whose motion is written to history.csv.")
            .need("name", &ProbeInput::name, {"", {}, "Its name in the history.", "\"center\""})
            .need("node_at", &ProbeInput::node_at, {"m", {}, "The node nearest to this point is taken.", "[0, 0, 0]"})
            .need("quantities", &ProbeInput::quantities, {"", {}, "What is written.", "[\"displacement\", \"velocity\"]"})
            .row("every", &ProbeInput::every,
                 {"s", above(0), "Interval of the history; a thousandth of the end time if not given.", "\"10 us\""})
            .row("reference", &ProbeInput::reference,
                 {"", {}, "A value to compare with.", "{ value = \"-47 mm\", label = \"experiment\" }"})
            .table();
    return table;
}

template <>
const Table& table_of<GaugeSphereInput>()
{
    static const Table table = TableBuilder<GaugeSphereInput>("sphere", "A ball that gas moves through.")
                                   .need("center", &GaugeSphereInput::center, {"m", {}, "Its center.", "[0, 0, \"300 mm\"]"})
                                   .need("radius", &GaugeSphereInput::radius, {"m", above(0), "Its radius.", "\"30 mm\""})
                                   .table();
    return table;
}

template <>
const Table& table_of<GaugeInput>()
{
    static const Table table =
        TableBuilder<GaugeInput>("gauge", "Where gas or load is measured: pressure and impulse, written to history.csv.")
            .need("name", &GaugeInput::name, {"", {}, "Its name in the history.", "\"wall\""})
            .row("facets", &GaugeInput::facets, {"", {}, "All facets of a part.", "\"plate\""})
            .row("point", &GaugeInput::point,
                 {"m",
                  {},
                  "Gas at a point: of particles in a ball of three spacings of the undisturbed gas about it, of a grid in the cell around "
                  "it.",
                  "[0, 0, \"300 mm\"]"})
            .row("sphere", &GaugeInput::sphere, {"", {}, "Gas in a ball.", "{ center = [0, 0, \"300 mm\"], radius = \"30 mm\" }"})
            .row("box", &GaugeInput::box, {"m", {}, "Gas in a box.", "[[0, 0.1], [0, 0.1], [0, 0.1]]"})
            .row("face", &GaugeInput::face, {"", {}, "A rigid face of the gas box.", "\"z-\""})
            .row("every", &GaugeInput::every,
                 {"s", above(0),
                  "Interval of the history; pressures on facets and faces are means over it. A thousandth of the end time if not given.",
                  "\"5 us\""})
            .one_of({"facets", "point", "sphere", "box", "face"})
            .table();
    return table;
}

template <>
const Table& table_of<OutputInput>()
{
    static const Table table =
        TableBuilder<OutputInput>("output", "The files a run leaves.")
            .row("fields_every", &OutputInput::fields_every,
                 {"s", above(0), "Interval of the files for ParaView; a thirtieth of the end time if not given.", "\"100 us\""})
            .row("energies_every", &OutputInput::energies_every,
                 {"s", above(0), "Interval of the energies in history.csv; a 300th of the end time if not given.", "\"10 us\""})
            .row("restart_every", &OutputInput::restart_every, {"s", above(0), "Wall-clock time between two saved states.", "\"10 min\""})
            .row("particles_shown", &OutputInput::particles_shown,
                 {"", from_to(0, 4e9), "Most gas particles in a file for ParaView (every n-th is written); 0: none.", "200_000"})
            .row("averages", &OutputInput::averages,
                 {"", from_to(0, 1000), "Cells along the longest edge of the grid of averages of the gas; 0: no averages.", "48"})
            .row("compress", &OutputInput::compress, {"", {}, "Compress the files for ParaView: smaller, slower to write.", "true"})
            .table();
    return table;
}

}  // namespace corpuscle
