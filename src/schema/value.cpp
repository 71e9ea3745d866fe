#include "schema/value.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/format.h>

namespace corpuscle {

namespace {

/// A key, quoted where TOML wants it.
std::string key_text(const std::string& key)
{
    const bool bare =
        !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; });
    return bare ? key : inline_toml(Value::of_text(key));
}

std::string quoted(const std::string& text)
{
    std::string out = "\"";
    for (const char c : text) {
        switch (c) {
            case '"': out += "\\\""; break;
            case '\\': out += "\\\\"; break;
            case '\n': out += "\\n"; break;
            case '\t': out += "\\t"; break;
            default:
                if (static_cast<unsigned char>(c) < 0x20)
                    out += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
                else
                    out += c;
        }
    }
    return out + '"';
}

/// A number that TOML reads as a float, shortest text with the same bits.
std::string number_text(double value)
{
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".einf") == std::string::npos) text += ".0";
    return text;
}

bool is_array_of_tables(const Value& value)
{
    return value.kind == ValueKind::array && !value.items.empty() &&
           std::all_of(value.items.begin(), value.items.end(), [](const Value& item) { return item.kind == ValueKind::table; });
}

/// "{ a = 1, b = 2 }" or "[1, 2]".
std::string inline_list(const Value& value)
{
    const bool table = value.kind == ValueKind::table;
    if (value.items.empty()) return table ? "{}" : "[]";
    std::string out = table ? "{ " : "[";
    for (std::size_t i = 0; i < value.items.size(); ++i) {
        if (i > 0) out += ", ";
        if (table) out += key_text(value.keys[i].name) + " = ";
        out += inline_toml(value.items[i]);
    }
    return out + (table ? " }" : "]");
}

std::string lines_of(const Value& table)
{
    std::string out;
    for (std::size_t i = 0; i < table.items.size(); ++i)
        out += fmt::format("{} = {}\n", key_text(table.keys[i].name), inline_toml(table.items[i]));
    return out;
}

}  // namespace

Value Value::of_boolean(bool value)
{
    Value result;
    result.kind = ValueKind::boolean;
    result.boolean = value;
    return result;
}

Value Value::of_integer(std::int64_t value)
{
    Value result;
    result.kind = ValueKind::integer;
    result.integer = value;
    return result;
}

Value Value::of_number(double value)
{
    Value result;
    result.kind = ValueKind::number;
    result.number = value;
    return result;
}

Value Value::of_text(std::string value)
{
    Value result;
    result.kind = ValueKind::text;
    result.text = std::move(value);
    return result;
}

Value Value::of_array(std::vector<Value> values)
{
    Value result;
    result.kind = ValueKind::array;
    result.items = std::move(values);
    return result;
}

const Value* Value::find(const std::string& key) const
{
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (keys[i].name == key) return &items[i];
    return nullptr;
}

Value* Value::find(const std::string& key)
{
    return const_cast<Value*>(std::as_const(*this).find(key));
}

Value& Value::put(const std::string& key, Value value, Place key_place)
{
    if (Value* present = find(key)) return *present = std::move(value);
    keys.push_back({key, std::move(key_place)});
    items.push_back(std::move(value));
    return items.back();
}

std::string Value::kind_name() const
{
    switch (kind) {
        case ValueKind::boolean: return "true or false";
        case ValueKind::integer: return "an integer";
        case ValueKind::number: return "a number";
        case ValueKind::text: return "a text";
        case ValueKind::array: return "a list";
        case ValueKind::table: return "a table";
        case ValueKind::other: break;
    }
    return "a date or time";
}

std::string inline_toml(const Value& value)
{
    switch (value.kind) {
        case ValueKind::boolean: return value.boolean ? "true" : "false";
        case ValueKind::integer: return fmt::format("{}", value.integer);
        case ValueKind::number: return number_text(value.number);
        case ValueKind::text: return quoted(value.text);
        case ValueKind::array:
        case ValueKind::table: return inline_list(value);
        case ValueKind::other: break;
    }
    return value.text;
}

std::string toml_document(const Value& table)
{
    std::string scalars, sections;
    for (std::size_t i = 0; i < table.items.size(); ++i) {
        const Value& item = table.items[i];
        const std::string key = key_text(table.keys[i].name);
        if (item.kind == ValueKind::table) {
            sections += fmt::format("\n[{}]\n{}", key, lines_of(item));
        } else if (is_array_of_tables(item)) {
            for (const Value& entry : item.items) sections += fmt::format("\n[[{}]]\n{}", key, lines_of(entry));
        } else {
            scalars += fmt::format("{} = {}\n", key, inline_toml(item));
        }
    }
    return scalars + sections;
}

}  // namespace corpuscle
