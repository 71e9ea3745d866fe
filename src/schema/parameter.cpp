#include "schema/parameter.hpp"

#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "schema/nearest.hpp"
#include "schema/units.hpp"

namespace corpuscle {

namespace {

void note_places(void* description, const Table& table, const Value& value)
{
    Places* places = table.places ? table.places(description) : nullptr;
    if (places == nullptr) return;
    places->own = value.place;
    for (std::size_t i = 0; i < value.keys.size(); ++i) places->keys[value.keys[i].name] = value.items[i].place;
}

/// How a key of an inner table is written within this one, such as "shape = { sphere = { radius = ... } }"; shallow ones first.
std::vector<std::string> ways_to(const Table& table, const std::string& key, int depth = 3)
{
    std::vector<std::string> near, far;
    for (const Parameter& row : table.rows) {
        if (row.key == key) near.push_back(key + " = ...");
        if (depth == 0 || row.table == nullptr || row.kind.find("preset") != std::string::npos) continue;
        for (const std::string& way : ways_to(row.table(), key, depth - 1))
            far.push_back(fmt::format(fmt::runtime(row.many ? "{} = [{{ {} }}]" : "{} = {{ {} }}"), row.key, way));
    }
    std::stable_sort(far.begin(), far.end(), [](const auto& a, const auto& b) {
        return std::count(a.begin(), a.end(), '{') < std::count(b.begin(), b.end(), '{');
    });
    near.insert(near.end(), far.begin(), far.end());
    return near;
}

void report_unknown(const Table& table, const Key& key, Problems& problems)
{
    const std::string where = table.name.empty() ? "" : fmt::format(" in '{}'", table.name);
    std::vector<std::string> ways = ways_to(table, key.name);
    ways.resize(std::min<std::size_t>(ways.size(), 2));
    const bool within = !ways.empty() && nearest_names(key.name, table.keys()).empty();
    const std::string remedy = within ? fmt::format("did you mean {}?", fmt::join(ways, " or ")) : suggestion(key.name, table.keys());
    problems.add(fmt::format("unknown key '{}'{}", key.name, where), remedy, key.place);
}

/// A word that is none of those that may stand for the table; the name of one of its keys wants more than the word.
void report_word(const Table& table, const Parameter& plain, const Value& value, Problems& problems)
{
    const Parameter* meant = table.find(value.text);
    const std::vector<std::string> near = nearest_names(value.text, plain.choices);
    std::string remedy = near.empty() ? "" : suggestion(value.text, plain.choices) + " ";
    remedy += "expected one of " + listed(plain.choices);
    if (meant != nullptr) remedy = fmt::format("expected a table, such as {} = {{ {} = {} }}", table.name, meant->key, meant->example);
    problems.add(fmt::format("{} = \"{}\" is {}", table.name, value.text, meant != nullptr ? "not enough" : "not known"), remedy,
                 value.place);
}

void check_required(const Table& table, const Value& value, Problems& problems)
{
    for (const Parameter& row : table.rows) {
        if (!row.required || value.find(row.key) != nullptr) continue;
        const std::string where = table.name.empty() ? "the case" : fmt::format("'{}'", table.name);
        std::string remedy = "expected " + expectation(row);
        if (!row.example.empty()) remedy += fmt::format(", such as {} = {}", row.key, row.example);
        problems.add(fmt::format("{} has no '{}'", where, row.key), remedy, value.place);
    }
}

void check_alternatives(const Table& table, const Value& value, Problems& problems)
{
    for (const Alternative& alternative : table.alternatives) {
        std::vector<std::string> given;
        for (const std::string& key : alternative.keys)
            if (value.find(key) != nullptr) given.push_back(key);
        const std::string names = fmt::format("{}", fmt::join(alternative.keys, ", "));
        if (given.empty() && alternative.required)
            problems.add(fmt::format("'{}' has none of {}", table.name, names), "expected exactly one of them", value.place);
        if (given.size() > 1)
            problems.add(fmt::format("'{}' has {} at once", table.name, fmt::join(given, " and ")),
                         fmt::format("expected {} one of {}", alternative.required ? "exactly" : "at most", names), value.place);
    }
}

}  // namespace

const Place& Places::of(const std::string& key) const
{
    const auto found = keys.find(key);
    return found != keys.end() ? found->second : own;
}

const Parameter* Table::find(const std::string& key) const
{
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Parameter& row) { return row.key == key; });
    return found != rows.end() ? &*found : nullptr;
}

std::vector<std::string> Table::keys() const
{
    std::vector<std::string> names;
    for (const Parameter& row : rows) names.push_back(row.key);
    return names;
}

void read_table(void* description, const Table& table, const Value& value, Problems& problems)
{
    note_places(description, table, value);
    if (value.kind != ValueKind::table) {
        const Parameter* plain = table.find(table.shorthand);
        const bool word = plain != nullptr && !plain->choices.empty() && value.kind == ValueKind::text;
        if (word && std::find(plain->choices.begin(), plain->choices.end(), value.text) == plain->choices.end())
            return report_word(table, *plain, value, problems);
        if (plain != nullptr) return plain->read(description, value, problems);
        problems.add(fmt::format("'{}' is {}", table.name, value.kind_name()), "expected a table with the keys " + listed(table.keys()),
                     value.place);
        return;
    }
    for (std::size_t i = 0; i < value.keys.size(); ++i) {
        const Parameter* row = table.find(value.keys[i].name);
        if (row != nullptr)
            row->read(description, value.items[i], problems);
        else
            report_unknown(table, value.keys[i], problems);
    }
    check_required(table, value, problems);
    check_alternatives(table, value, problems);
}

Value write_table(const void* description, const Table& table)
{
    Value value;
    for (const Parameter& row : table.rows)
        if (std::optional<Value> member = row.write(description)) value.put(row.key, *std::move(member));
    const bool only_shorthand = value.items.size() == 1 && value.keys[0].name == table.shorthand;
    return only_shorthand ? value.items[0] : value;
}

std::string default_text(const Table& table, const Parameter& parameter)
{
    if (parameter.required) return "";
    const std::unique_ptr<void, std::function<void(void*)>> description{table.make_default(), table.drop_default};
    const std::optional<Value> value = parameter.write(description.get());
    if (!value || (parameter.table != nullptr && value->items.empty() && value->kind != ValueKind::text)) return "";
    return inline_toml(*value);
}

std::string expectation(const Parameter& parameter)
{
    std::string text = parameter.kind;
    const std::string range = parameter.range.text();
    if (!range.empty()) text += " " + range;
    if (!parameter.unit.empty()) text += fmt::format(" in {} or with a unit ({})", parameter.unit, usual_units(parameter.unit));
    return text;
}

}  // namespace corpuscle
