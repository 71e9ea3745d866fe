#include "input/case/case_description.hpp"

#include "schema/table_builder.hpp"

namespace corpuscle {

template <>
const Table& table_of<CaseDescription>()
{
    static const Table table =
        TableBuilder<CaseDescription>("", "A case says all that is simulated and recorded, in TOML 1.0.")
            .row("title", &CaseDescription::title, {"", {}, "One line for people.", "\"15 kg TNT, 700 mm from a clamped RHA plate\""})
            .need("end_time", &CaseDescription::end_time, {"s", above(0), "Simulated time.", "\"3 ms\""})
            .row("ensemble", &CaseDescription::ensemble,
                 {"", from_to(1, 10'000),
                  "Runs, with seeds from gas.seed on; curves and results then are means with their 95 % confidence.", "8"})
            .row("gas", &CaseDescription::gas, {"", {}, "The gas of particles.", ""})
            .row("euler", &CaseDescription::euler, {"", {}, "Gases on a grid, in place of particles.", ""})
            .row("charge", &CaseDescription::charges, {"", {}, "Charges of explosive.", ""})
            .row("fill", &CaseDescription::fills, {"", {}, "Gas in shapes.", ""})
            .row("part", &CaseDescription::parts, {"", {}, "Parts of the structure.", ""})
            .row("load", &CaseDescription::loads, {"", {}, "Loads that are not gas.", ""})
            .row("gravity", &CaseDescription::gravity,
                 {"m/s2", {}, "Acceleration with which the structure falls. Gas is not heavy.", "[0, 0, -9.81]"})
            .row("probe", &CaseDescription::probes, {"", {}, "Nodes whose motion is recorded.", ""})
            .row("gauge", &CaseDescription::gauges, {"", {}, "Where pressure and impulse are recorded.", ""})
            .row("output", &CaseDescription::output, {"", {}, "Files for pictures and for going on.", ""})
            .table();
    return table;
}

}  // namespace corpuscle
