#pragma once

#include <optional>
#include <string>

#include "schema/codec.hpp"

namespace corpuscle {

/// Something a case names ("tnt") or gives in place as a table; `values` are its numbers once they are known.
template <class Values>
struct Preset {
    std::string name;              ///< empty if given in place
    std::optional<Values> values;  ///< in place, or looked up
    Place place;
};

/// Presets are written with their values, so that a written case needs no library of presets.
template <class Values>
struct Codec<Preset<Values>> {
    static void describe(Parameter& parameter)
    {
        parameter.kind = "name of a preset, or a table with its values";
        parameter.table = &table_of<Values>;
    }
    static void read(Preset<Values>& target, const Value& value, const Parameter& parameter, Problems& problems)
    {
        target.place = value.place;
        if (value.kind == ValueKind::text) {
            target.name = value.text;
        } else if (value.kind == ValueKind::table) {
            read_table(&target.values.emplace(), table_of<Values>(), value, problems);
        } else {
            report_kind(value, parameter, problems);
        }
    }
    static std::optional<Value> write(const Preset<Values>& source, const Parameter&)
    {
        if (source.values) return write_table(&*source.values, table_of<Values>());
        if (source.name.empty()) return std::nullopt;
        return Value::of_text(source.name);
    }
};

}  // namespace corpuscle
