#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "schema/codec.hpp"

// A quantity over time as a case gives it.

namespace corpuscle {

/// A table of two columns beside the case.
struct CurveFileInput {
    std::string file;
    std::string time_unit = "s";
    std::string unit;  ///< of the values; empty: the SI unit of the quantity
    double scale = 1;  ///< of the values
    Places places;
};

/// Points of a quantity over time: one number is constant.
struct CurveInput {
    std::vector<std::pair<double, double>> points;  ///< [s], the quantity's SI unit
    std::optional<CurveFileInput> file;             ///< whose points are read when the case is built
    Place place;
};

template <>
const Table& table_of<CurveFileInput>();

/// Reads a number, a list of [time, value], or a table that names a file.
template <>
struct Codec<CurveInput> {
    static void describe(Parameter& parameter)
    {
        parameter.kind = "number, list of [time, number], or table with a file, numbers";
        parameter.table = &table_of<CurveFileInput>;
    }
    static void read(CurveInput& target, const Value& value, const Parameter& parameter, Problems& problems);
    static std::optional<Value> write(const CurveInput& source, const Parameter& parameter);
};

}  // namespace corpuscle
