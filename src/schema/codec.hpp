#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "schema/parameter.hpp"

namespace corpuscle {

/// The rows of a description: each kind of description specialises it.
template <class Description>
const Table& table_of();

/// The words of an enumeration, in the order they are shown: each enumeration that a case can name specialises it.
template <class Enumeration>
const std::vector<std::pair<std::string, Enumeration>>& words_of();

/// The scalars a value can give; nothing, and a problem, where it is none or out of range.
[[nodiscard]] std::optional<double> read_number(const Value& value, const Parameter& parameter, Problems& problems);
[[nodiscard]] std::optional<std::int64_t> read_integer(const Value& value, const Parameter& parameter, Problems& problems);
[[nodiscard]] std::optional<bool> read_boolean(const Value& value, const Parameter& parameter, Problems& problems);
[[nodiscard]] std::optional<std::string> read_text(const Value& value, const Parameter& parameter, Problems& problems);
[[nodiscard]] std::optional<std::size_t> read_choice(const Value& value, const Parameter& parameter, Problems& problems);
/// A value of the wrong kind: "'mass' is a table; expected ...".
void report_kind(const Value& value, const Parameter& parameter, Problems& problems);
/// Refuses a list of another length than wanted.
[[nodiscard]] bool is_list_of(std::size_t count, const Value& value, const Parameter& parameter, Problems& problems);
/// A number as a value, with its unit if it has one.
[[nodiscard]] Value write_number(double number, const Parameter& parameter);

/// Anything with the components x, y, z.
template <class T>
concept ThreeComponents = requires(T v) {
    { v.x } -> std::convertible_to<double>;
    { v.y } -> std::convertible_to<double>;
    { v.z } -> std::convertible_to<double>;
};

/// How a member of a type is read, written and described. This one is for descriptions: inner tables.
template <class T>
struct Codec {
    static void describe(Parameter& parameter)
    {
        parameter.kind = "table";
        parameter.table = &table_of<T>;
    }
    /// A table that is given starts from its own defaults, whatever stands in the member when it is not given.
    static void read(T& target, const Value& value, const Parameter&, Problems& problems)
    {
        target = T{};
        read_table(&target, table_of<T>(), value, problems);
    }
    static std::optional<Value> write(const T& source, const Parameter&) { return write_table(&source, table_of<T>()); }
};

template <std::floating_point T>
struct Codec<T> {
    static void describe(Parameter& parameter) { parameter.kind = "number"; }
    static void read(T& target, const Value& value, const Parameter& parameter, Problems& problems)
    {
        if (const auto number = read_number(value, parameter, problems)) target = static_cast<T>(*number);
    }
    static std::optional<Value> write(const T& source, const Parameter& parameter)
    {
        return write_number(static_cast<double>(source), parameter);
    }
};

template <std::integral T>
struct Codec<T> {
    static void describe(Parameter& parameter) { parameter.kind = "integer"; }
    static void read(T& target, const Value& value, const Parameter& parameter, Problems& problems)
    {
        if (const auto integer = read_integer(value, parameter, problems)) target = static_cast<T>(*integer);
    }
    static std::optional<Value> write(const T& source, const Parameter&) { return Value::of_integer(static_cast<std::int64_t>(source)); }
};

template <>
struct Codec<bool> {
    static void describe(Parameter& parameter) { parameter.kind = "true or false"; }
    static void read(bool& target, const Value& value, const Parameter& parameter, Problems& problems)
    {
        if (const auto flag = read_boolean(value, parameter, problems)) target = *flag;
    }
    static std::optional<Value> write(const bool& source, const Parameter&) { return Value::of_boolean(source); }
};

template <>
struct Codec<std::string> {
    static void describe(Parameter& parameter) { parameter.kind = "text"; }
    static void read(std::string& target, const Value& value, const Parameter& parameter, Problems& problems)
    {
        if (auto text = read_text(value, parameter, problems)) target = *std::move(text);
    }
    static std::optional<Value> write(const std::string& source, const Parameter&)
    {
        return source.empty() ? std::nullopt : std::optional(Value::of_text(source));
    }
};

template <class T>
    requires std::is_enum_v<T>
struct Codec<T> {
    static void describe(Parameter& parameter)
    {
        parameter.kind = "one of";
        for (const auto& [word, choice] : words_of<T>()) parameter.choices.push_back(word);
    }
    static void read(T& target, const Value& value, const Parameter& parameter, Problems& problems)
    {
        if (const auto choice = read_choice(value, parameter, problems)) target = words_of<T>()[*choice].second;
    }
    static std::optional<Value> write(const T& source, const Parameter&)
    {
        for (const auto& [word, choice] : words_of<T>())
            if (choice == source) return Value::of_text(word);
        return std::nullopt;
    }
};

template <ThreeComponents T>
struct Codec<T> {
    static void describe(Parameter& parameter) { parameter.kind = "3 numbers [x, y, z], each"; }
    static void read(T& target, const Value& value, const Parameter& parameter, Problems& problems)
    {
        if (!is_list_of(3, value, parameter, problems)) return;
        const auto x = read_number(value.items[0], parameter, problems);
        const auto y = read_number(value.items[1], parameter, problems);
        const auto z = read_number(value.items[2], parameter, problems);
        if (x && y && z) target = T{*x, *y, *z};
    }
    static std::optional<Value> write(const T& source, const Parameter& parameter)
    {
        return Value::of_array({write_number(source.x, parameter), write_number(source.y, parameter), write_number(source.z, parameter)});
    }
};

template <class T>
struct Codec<std::optional<T>> {
    static void describe(Parameter& parameter) { Codec<T>::describe(parameter); }
    static void read(std::optional<T>& target, const Value& value, const Parameter& parameter, Problems& problems)
    {
        T inner{};
        Codec<T>::read(inner, value, parameter, problems);
        target = std::move(inner);
    }
    static std::optional<Value> write(const std::optional<T>& source, const Parameter& parameter)
    {
        return source ? Codec<T>::write(*source, parameter) : std::nullopt;
    }
};

template <class T, std::size_t count>
struct Codec<std::array<T, count>> {
    static void describe(Parameter& parameter)
    {
        Codec<T>::describe(parameter);
        parameter.kind = std::to_string(count) + " times: " + parameter.kind;
    }
    static void read(std::array<T, count>& target, const Value& value, const Parameter& parameter, Problems& problems)
    {
        if (!is_list_of(count, value, parameter, problems)) return;
        for (std::size_t i = 0; i < count; ++i) Codec<T>::read(target[i], value.items[i], parameter, problems);
    }
    static std::optional<Value> write(const std::array<T, count>& source, const Parameter& parameter)
    {
        std::vector<Value> items;
        for (const T& item : source) items.push_back(Codec<T>::write(item, parameter).value_or(Value::of_text("")));
        return Value::of_array(std::move(items));
    }
};

template <class T>
struct Codec<std::vector<T>> {
    static void describe(Parameter& parameter)
    {
        Codec<T>::describe(parameter);
        parameter.many = true;
        parameter.kind = "list of: " + parameter.kind;
    }
    static void read(std::vector<T>& target, const Value& value, const Parameter& parameter, Problems& problems)
    {
        if (value.kind != ValueKind::array) return report_kind(value, parameter, problems);
        target.assign(value.items.size(), T{});
        for (std::size_t i = 0; i < value.items.size(); ++i) Codec<T>::read(target[i], value.items[i], parameter, problems);
    }
    static std::optional<Value> write(const std::vector<T>& source, const Parameter& parameter)
    {
        if (source.empty()) return std::nullopt;
        std::vector<Value> items;
        for (const T& item : source) items.push_back(Codec<T>::write(item, parameter).value_or(Value::of_text("")));
        return Value::of_array(std::move(items));
    }
};

}  // namespace corpuscle
