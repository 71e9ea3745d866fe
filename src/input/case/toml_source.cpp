#include "input/case/toml_source.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <toml++/toml.h>

namespace corpuscle {

namespace {

Place place_of(const toml::source_region& source, const std::string& file)
{
    return {file, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

Value converted(const toml::node& node, const std::string& file);

Value converted_table(const toml::table& table, const std::string& file)
{
    struct Row {
        Key key;
        const toml::node* node;
    };
    std::vector<Row> rows;
    for (const auto& [key, node] : table) rows.push_back({{std::string(key.str()), place_of(key.source(), file)}, &node});
    // toml++ keeps keys sorted by name; people expect the order of the file.
    std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
        return std::pair(a.key.place.line, a.key.place.column) < std::pair(b.key.place.line, b.key.place.column);
    });
    Value value;
    for (const Row& row : rows) {
        value.keys.push_back(row.key);
        value.items.push_back(converted(*row.node, file));
    }
    return value;
}

Value converted_array(const toml::array& array, const std::string& file)
{
    Value value = Value::of_array();
    for (const toml::node& node : array) value.items.push_back(converted(node, file));
    return value;
}

Value converted(const toml::node& node, const std::string& file)
{
    Value value;
    switch (node.type()) {
        case toml::node_type::table: value = converted_table(*node.as_table(), file); break;
        case toml::node_type::array: value = converted_array(*node.as_array(), file); break;
        case toml::node_type::string: value = Value::of_text(node.as_string()->get()); break;
        case toml::node_type::integer: value = Value::of_integer(node.as_integer()->get()); break;
        case toml::node_type::floating_point: value = Value::of_number(node.as_floating_point()->get()); break;
        case toml::node_type::boolean: value = Value::of_boolean(node.as_boolean()->get()); break;
        default: value.kind = ValueKind::other;
    }
    value.place = place_of(node.source(), file);
    return value;
}

/// Gives a value and all within it one place.
void put_at(Value& value, const Place& place)
{
    value.place = place;
    for (Key& key : value.keys) key.place = place;
    for (Value& item : value.items) put_at(item, place);
}

/// The right side of a setting: TOML if it is, else the words themselves.
Value setting_value(const std::string& text, const Place& place)
{
    Value value = Value::of_text(text);
    try {
        const toml::table table = toml::parse("value = " + text);
        if (table.size() == 1) value = converted(*table.get("value"), place.file);
    } catch (const toml::parse_error&) {
        value = Value::of_text(text);
    }
    put_at(value, place);
    return value;
}

std::vector<std::string> words_of_path(const std::string& path)
{
    std::vector<std::string> words;
    std::stringstream stream(path);
    for (std::string word; std::getline(stream, word, '.');) words.push_back(word);
    return words;
}

bool is_index(const std::string& word, std::size_t& index)
{
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    return error == std::errc() && end == word.data() + word.size();
}

/// The item of a list that a word of a path means; one past the last adds a table.
Value& list_item(Value& list, const std::string& word, const Place& place)
{
    std::size_t index = 0;
    if (!is_index(word, index))
        throw InputError(fmt::format("'{}' is no index of a list", word), fmt::format("expected 0 to {}", list.items.size()), place);
    if (index > list.items.size())
        throw InputError(fmt::format("there is no entry {}: the list has {}, counted from 0", index, list.items.size()),
                         fmt::format("expected 0 to {}", list.items.size()), place);
    if (index == list.items.size()) {
        list.items.emplace_back();
        list.items.back().place = place;
    }
    return list.items[index];
}

/// The value under a word of a path; made where there is none.
Value& inner_value(Value& value, const std::string& word, bool next_is_index, const Place& place)
{
    if (value.kind == ValueKind::array) return list_item(value, word, place);
    if (value.kind != ValueKind::table) {
        // A plain value where a longer form is meant: the longer form takes its place.
        value = Value{};
        value.place = place;
    }
    if (Value* present = value.find(word)) return *present;
    Value made = next_is_index ? Value::of_array() : Value{};
    made.place = place;
    return value.put(word, std::move(made), place);
}

}  // namespace

Value parse_toml(const std::string& text, const std::string& file)
{
    try {
        const toml::table table = toml::parse(text, file);
        Value value = converted(table, file);
        value.place = {file, 1, 1};
        return value;
    } catch (const toml::parse_error& error) {
        throw InputError(std::string(error.description()), "expected TOML: key = value, [table] or [[list of tables]]",
                         place_of(error.source(), file));
    }
}

Value read_toml(const std::string& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::stringstream text;
    if (stream) text << stream.rdbuf();
    if (!stream) throw InputError(fmt::format("the file '{}' cannot be read", file), "check its name and permissions");
    return parse_toml(text.str(), file);
}

void apply_setting(Value& document, const std::string& setting)
{
    const std::size_t equals = setting.find('=');
    const std::string path = setting.substr(0, equals);
    const Place place{"--set " + path, 0, 0};
    if (equals == std::string::npos || equals == 0)
        throw InputError(fmt::format("--set {} has no key and value", setting),
                         "expected key=value, such as --set charge.0.mass=\"20 kg\"");
    const std::vector<std::string> words = words_of_path(path);
    Value* value = &document;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        std::size_t index = 0;
        value = &inner_value(*value, words[i], is_index(words[i + 1], index), place);
    }
    inner_value(*value, words.back(), false, place) = setting_value(setting.substr(equals + 1), place);
    for (auto& key : value->keys)
        if (key.name == words.back()) key.place = place;
}

}  // namespace corpuscle
