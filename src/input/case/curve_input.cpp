#include "input/case/curve_input.hpp"

#include <fmt/format.h>

#include "schema/table_builder.hpp"

namespace corpuscle {

namespace {

/// The row that reads times of a curve.
Parameter time_of(const Parameter& parameter)
{
    Parameter time;
    time.key = parameter.key;
    time.unit = "s";
    time.kind = "number";
    time.example = parameter.example;
    return time;
}

/// Reads a list of points, each a time and a value, times ascending.
void read_points(CurveInput& target, const Value& value, const Parameter& parameter, Problems& problems)
{
    const Parameter time = time_of(parameter);
    if (value.items.empty())
        problems.add(fmt::format("'{}' has no points", parameter.key), "expected at least one [time, value]", value.place);
    for (const Value& item : value.items) {
        if (!is_list_of(2, item, parameter, problems)) return;
        const auto at = read_number(item.items[0], time, problems), of = read_number(item.items[1], parameter, problems);
        if (!at || !of) return;
        if (!target.points.empty() && !(*at > target.points.back().first))
            return problems.add(
                fmt::format("the times of '{}' do not rise: {:.6g} s after {:.6g} s", parameter.key, *at, target.points.back().first),
                "expected each time later than the one before", item.place);
        target.points.emplace_back(*at, *of);
    }
}

}  // namespace

template <>
const Table& table_of<CurveFileInput>()
{
    static const Table table =
        TableBuilder<CurveFileInput>(
            "curve", "A table of two columns, time and value, between commas, semicolons or blanks; `#` and a heading are skipped.")
            .need("file", &CurveFileInput::file, {"", {}, "The file, beside the case or with its full path.", "\"pulse.csv\""})
            .row("time_unit", &CurveFileInput::time_unit, {"", {}, "Unit of the times.", "\"ms\""})
            .row("unit", &CurveFileInput::unit, {"", {}, "Unit of the values; that of SI if not given.", "\"bar\""})
            .row("scale", &CurveFileInput::scale, {"", {}, "Multiplies the values.", "0.5"})
            .table();
    return table;
}

void Codec<CurveInput>::read(CurveInput& target, const Value& value, const Parameter& parameter, Problems& problems)
{
    target = {};
    target.place = value.place;
    if (value.kind == ValueKind::table) {
        CurveFileInput& file = target.file.emplace();
        return read_table(&file, table_of<CurveFileInput>(), value, problems);
    }
    if (value.kind == ValueKind::array) return read_points(target, value, parameter, problems);
    if (const auto constant = read_number(value, parameter, problems)) target.points = {{0.0, *constant}};
}

std::optional<Value> Codec<CurveInput>::write(const CurveInput& source, const Parameter& parameter)
{
    if (source.file) return write_table(&*source.file, table_of<CurveFileInput>());
    const Parameter time = time_of(parameter);
    std::vector<Value> points;
    for (const auto& [at, of] : source.points) points.push_back(Value::of_array({write_number(at, time), write_number(of, parameter)}));
    return Value::of_array(std::move(points));
}

}  // namespace corpuscle
