#include "schema/codec.hpp"

#include <cmath>

#include <fmt/format.h>

#include "schema/nearest.hpp"
#include "schema/units.hpp"

namespace corpuscle {

namespace {

bool in_range(double number, const Value& value, const Parameter& parameter, Problems& problems)
{
    if (parameter.range.holds(number)) return true;
    const std::string limits = parameter.range.unlimited() ? "finite" : parameter.range.text();
    const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
    problems.add(fmt::format("{} = {} is out of range", parameter.key, inline_toml(value)),
                 fmt::format("expected a number {}{}", limits, unit), value.place);
    return false;
}

/// A text as a number: converted from its unit, the message completed with key and place.
std::optional<double> from_text(const Value& value, const Parameter& parameter, Problems& problems)
{
    try {
        return convert(value.text, parameter.unit.empty() ? "1" : parameter.unit);
    } catch (const InputError& error) {
        std::string remedy = error.remedy();
        if (!parameter.example.empty()) remedy += fmt::format("; for example {} = {}", parameter.key, parameter.example);
        problems.add(fmt::format("{}: {}", parameter.key, error.problem()), remedy, value.place);
        return std::nullopt;
    }
}

}  // namespace

void report_kind(const Value& value, const Parameter& parameter, Problems& problems)
{
    std::string remedy = "expected " + expectation(parameter);
    if (!parameter.choices.empty()) remedy += " " + listed(parameter.choices);
    if (!parameter.example.empty()) remedy += fmt::format(", such as {} = {}", parameter.key, parameter.example);
    problems.add(fmt::format("'{}' is {}", parameter.key, value.kind_name()), remedy, value.place);
}

std::optional<double> read_number(const Value& value, const Parameter& parameter, Problems& problems)
{
    std::optional<double> number;
    switch (value.kind) {
        case ValueKind::integer: number = static_cast<double>(value.integer); break;
        case ValueKind::number: number = value.number; break;
        case ValueKind::text: number = from_text(value, parameter, problems); break;
        default: report_kind(value, parameter, problems);
    }
    if (!number || !in_range(*number, value, parameter, problems)) return std::nullopt;
    return number;
}

std::optional<std::int64_t> read_integer(const Value& value, const Parameter& parameter, Problems& problems)
{
    const bool whole = value.kind == ValueKind::number && std::nearbyint(value.number) == value.number && std::abs(value.number) < 9e15;
    if (value.kind != ValueKind::integer && !whole) {
        report_kind(value, parameter, problems);
        return std::nullopt;
    }
    const std::int64_t integer = whole ? static_cast<std::int64_t>(value.number) : value.integer;
    if (!in_range(static_cast<double>(integer), value, parameter, problems)) return std::nullopt;
    return integer;
}

std::optional<bool> read_boolean(const Value& value, const Parameter& parameter, Problems& problems)
{
    if (value.kind == ValueKind::boolean) return value.boolean;
    report_kind(value, parameter, problems);
    return std::nullopt;
}

std::optional<std::string> read_text(const Value& value, const Parameter& parameter, Problems& problems)
{
    if (value.kind == ValueKind::text) return value.text;
    report_kind(value, parameter, problems);
    return std::nullopt;
}

std::optional<std::size_t> read_choice(const Value& value, const Parameter& parameter, Problems& problems)
{
    if (value.kind != ValueKind::text) {
        report_kind(value, parameter, problems);
        return std::nullopt;
    }
    for (std::size_t i = 0; i < parameter.choices.size(); ++i)
        if (parameter.choices[i] == value.text) return i;
    const std::string hint = nearest_names(value.text, parameter.choices).empty() ? "" : suggestion(value.text, parameter.choices) + " ";
    problems.add(fmt::format("{} = \"{}\" is not known", parameter.key, value.text), hint + "expected one of " + listed(parameter.choices),
                 value.place);
    return std::nullopt;
}

bool is_list_of(std::size_t count, const Value& value, const Parameter& parameter, Problems& problems)
{
    if (value.kind != ValueKind::array) {
        report_kind(value, parameter, problems);
        return false;
    }
    if (value.items.size() == count) return true;
    const std::string remedy = parameter.example.empty()
                                   ? "expected " + expectation(parameter)
                                   : fmt::format("expected {} of them, such as {} = {}", count, parameter.key, parameter.example);
    problems.add(fmt::format("'{}' has a list of {} here", parameter.key, value.items.size()), remedy, value.place);
    return false;
}

Value write_number(double number, const Parameter& parameter)
{
    return parameter.unit.empty() || parameter.unit == "1" ? Value::of_number(number) : Value::of_text(with_unit(number, parameter.unit));
}

}  // namespace corpuscle
