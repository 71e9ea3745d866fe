#include "schema/units.hpp"

#include <array>
#include <charconv>
#include <memory>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <udunits2.h>

#include "base/error.hpp"
#include "schema/nearest.hpp"

namespace corpuscle {

namespace {

/// A dimension with a name: its SI unit and what people write for it.
struct Dimension {
    const char* unit;
    const char* name;
    const char* usual;
};

constexpr std::array<Dimension, 22> dimensions{{
    {"m", "length", "mm, cm, m, in, ft"},
    {"kg", "mass", "g, kg, t, lb"},
    {"s", "time", "ns, us, ms, s, min, h"},
    {"K", "temperature", "K, degC"},
    {"m2", "area", "mm2, cm2, m2"},
    {"m3", "volume", "mm3, cm3, L, m3"},
    {"m/s", "velocity", "mm/ms, m/s, km/s, ft/s, km/h"},
    {"m/s2", "acceleration", "m/s2"},
    {"kg/m3", "density", "kg/m3, g/cm3, lb/ft3"},
    {"Pa", "pressure", "Pa, kPa, MPa, GPa, bar, atm, psi"},
    {"J", "energy", "J, kJ, MJ"},
    {"J/kg", "energy per mass", "J/kg, kJ/kg, MJ/kg, J/g"},
    {"J/m3", "energy per volume", "J/m3, MJ/m3, GJ/m3, J/cm3"},
    {"W", "power", "W, kW"},
    {"N", "force", "N, kN, lbf"},
    {"N s", "impulse", "N s, kN s"},
    {"Pa s", "impulse per area", "Pa s, kPa ms, MPa ms"},
    {"kg/mol", "molar mass", "kg/mol, g/mol"},
    {"1/s", "rate", "1/s, 1/ms"},
    {"radian", "angle", "radian, degree"},
    {"J/(kg K)", "specific heat", "J/(kg K)"},
    {"1", "pure number", "percent"},
}};

/// Names that a misspelt unit may have meant.
const std::vector<std::string>& common_units()
{
    static const std::vector<std::string> names{
        "m",    "mm",   "cm",    "km",   "um",     "in",     "inch",   "ft",     "foot",  "yard", "kg",    "g",     "mg",
        "t",    "lb",   "oz",    "s",    "ms",     "us",     "ns",     "min",    "h",     "hour", "day",   "K",     "degC",
        "Pa",   "kPa",  "MPa",   "GPa",  "bar",    "mbar",   "atm",    "psi",    "J",     "kJ",   "MJ",    "GJ",    "N",
        "kN",   "MN",   "lbf",   "W",    "kW",     "Hz",     "kHz",    "mol",    "L",     "m2",   "m3",    "cm3",   "mm3",
        "m/s",  "km/s", "mm/ms", "ft/s", "km/h",   "kg/m3",  "g/cm3",  "kg/mol", "g/mol", "J/kg", "kJ/kg", "MJ/kg", "GJ/m3",
        "J/m3", "1/s",  "N s",   "Pa s", "kPa ms", "degree", "radian", "percent"};
    return names;
}

struct Free {
    void operator()(ut_system* system) const { ut_free_system(system); }
    void operator()(ut_unit* unit) const { ut_free(unit); }
    void operator()(cv_converter* converter) const { cv_free(converter); }
};
using System = std::unique_ptr<ut_system, Free>;
using Unit = std::unique_ptr<ut_unit, Free>;

/// The database of units, read once. UDUNITS-2 is not thread-safe: reading input is one thread's work.
ut_system* unit_system()
{
    static const System system = [] {
        ut_set_error_message_handler(ut_ignore);
        System read{ut_read_xml(nullptr)};
        if (!read)
            throw InputError("the unit database of UDUNITS-2 cannot be read",
                             "install libudunits2-0 and libudunits2-data, or set UDUNITS2_XML_PATH");
        return read;
    }();
    return system.get();
}

Unit parse_unit(const std::string& text)
{
    return Unit{ut_parse(unit_system(), text.empty() ? "1" : text.c_str(), UT_ASCII)};
}

/// Are the two the same but for a number? (UDUNITS-2 itself also takes s for 1/s.)
bool same_dimension(const ut_unit* a, const ut_unit* b)
{
    const Unit ratio{ut_divide(a, b)};
    const Unit one = parse_unit("1");
    return ratio && ut_are_convertible(ratio.get(), one.get()) != 0;
}

/// The row of `dimensions` a unit belongs to, or null: the row of that very unit, else the first of its dimension.
const Dimension* dimension_of(const std::string& unit)
{
    for (const Dimension& dimension : dimensions)
        if (unit == dimension.unit) return &dimension;
    const Unit parsed = parse_unit(unit);
    if (!parsed) return nullptr;
    for (const Dimension& dimension : dimensions)
        if (same_dimension(parsed.get(), parse_unit(dimension.unit).get())) return &dimension;
    return nullptr;
}

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

/// Converts with UDUNITS-2; the dimensions are known to agree.
double convert_between(double value, ut_unit* from, ut_unit* to)
{
    const std::unique_ptr<cv_converter, Free> converter{ut_get_converter(from, to)};
    return cv_convert_double(converter.get(), value);
}

[[noreturn]] void refuse_unknown_unit(const std::string& text, const std::string& written, const std::string& unit)
{
    const std::vector<std::string> near = nearest_names(written, common_units());
    const std::string hint = near.empty() ? "" : suggestion(written, common_units()) + " ";
    throw InputError(fmt::format("unknown unit '{}' in \"{}\"", written, text),
                     fmt::format("{}expected a {}: {}", hint, dimension_name(unit), usual_units(unit)));
}

}  // namespace

double convert(const std::string& text, const std::string& unit)
{
    std::string_view rest = trimmed(text);
    if (!rest.empty() && rest.front() == '+') rest.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    const std::string expected = fmt::format("expected a {}: a number and its unit ({})", dimension_name(unit), usual_units(unit));
    if (error != std::errc()) throw InputError(fmt::format("\"{}\" does not begin with a number", text), expected);
    const std::string written{trimmed(rest.substr(static_cast<std::size_t>(end - rest.data())))};
    const Unit from = parse_unit(written), to = parse_unit(unit);
    if (!from) refuse_unknown_unit(text, written, unit);
    if (!same_dimension(from.get(), to.get())) {
        const std::string what =
            written.empty() ? fmt::format("\"{}\" has no unit", text) : fmt::format("\"{}\" is a {}", text, dimension_name(written));
        throw InputError(what, expected);
    }
    return convert_between(value, from.get(), to.get());
}

std::string dimension_name(const std::string& unit)
{
    const Dimension* dimension = dimension_of(unit);
    return dimension != nullptr ? dimension->name : "quantity in " + unit;
}

std::string usual_units(const std::string& unit)
{
    const Dimension* dimension = dimension_of(unit);
    return dimension != nullptr ? dimension->usual : unit;
}

std::string with_unit(double value, const std::string& unit)
{
    return fmt::format("{} {}", value, unit);
}

}  // namespace corpuscle
