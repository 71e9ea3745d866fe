#include "schema/manual.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.hpp"
#include "schema/nearest.hpp"
#include "schema/units.hpp"

namespace corpuscle {

namespace {

void gather(const Table& table, const std::string& prefix, std::vector<NamedParameter>& found)
{
    for (const Parameter& row : table.rows) {
        const std::string path = prefix + row.key;
        found.push_back({path, &table, &row});
        if (row.table != nullptr) gather(row.table(), path + ".", found);
    }
}

bool is_called(const std::string& path, const std::string& key)
{
    return path == key || (path.size() > key.size() && path.compare(path.size() - key.size() - 1, std::string::npos, "." + key) == 0);
}

/// "number > 0 in kg or with a unit (...)", "one of a, b", "table".
std::string takes(const Parameter& parameter)
{
    std::string text = expectation(parameter);
    if (!parameter.choices.empty()) text += " " + listed(parameter.choices);
    return text;
}

std::string default_of(const NamedParameter& named)
{
    if (named.parameter->required) return "must be given";
    const std::string text = default_text(*named.table, *named.parameter);
    return text.empty() ? "none" : text;
}

std::string explained(const NamedParameter& named)
{
    const Parameter& p = *named.parameter;
    std::string text = fmt::format("{}\n    {}\n    takes    {}\n    default  {}\n", named.path, p.meaning, takes(p), default_of(named));
    if (!p.example.empty()) text += fmt::format("    example  {} = {}\n", p.key, p.example);
    if (p.table != nullptr) {
        const Table& inner = p.table();
        text += fmt::format("    keys     {}\n", listed(inner.keys(), 40));
        if (!inner.shorthand.empty()) text += fmt::format("    in short {} = ... alone gives its '{}'\n", p.key, inner.shorthand);
    }
    return text;
}

/// A bar would end the column of a Markdown table.
std::string cell(std::string text)
{
    for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.replace(at, 1, "\\|");
    return text;
}

std::string table_section(const std::string& heading, const Table& table)
{
    std::string text = fmt::format("\n## {}\n\n{}\n", heading, table.meaning);
    if (!table.shorthand.empty()) text += fmt::format("A plain value in place of the table gives its `{}`.\n", table.shorthand);
    for (const Alternative& alternative : table.alternatives)
        text += fmt::format("{} one of: {}.\n", alternative.required ? "Exactly" : "At most", listed(alternative.keys));
    text += "\n| key | takes | default | meaning | example |\n|---|---|---|---|---|\n";
    for (const Parameter& row : table.rows) {
        const NamedParameter named{row.key, &table, &row};
        const std::string fallback = row.required || default_of(named) == "none" ? default_of(named) : "`" + default_of(named) + "`";
        const std::string example = row.example.empty() ? "" : "`" + row.example + "`";
        text += fmt::format("| `{}` | {} | {} | {} | {} |\n", row.key, cell(takes(row)), cell(fallback), cell(row.meaning), cell(example));
    }
    return text;
}

}  // namespace

std::vector<NamedParameter> all_parameters(const Table& root)
{
    std::vector<NamedParameter> found;
    gather(root, "", found);
    return found;
}

std::string explain(const Table& root, const std::string& key)
{
    const std::vector<NamedParameter> all = all_parameters(root);
    std::string text;
    for (const NamedParameter& named : all)
        if (is_called(named.path, key)) text += (text.empty() ? "" : "\n") + explained(named);
    if (!text.empty()) return text;
    std::vector<std::string> names;
    for (const NamedParameter& named : all) {
        names.push_back(key.find('.') == std::string::npos ? named.parameter->key : named.path);
    }
    const std::vector<std::string> near = nearest_names(key, names);
    throw InputError(fmt::format("no parameter of a case is called '{}'", key),
                     near.empty() ? "the tables are " + listed(root.keys()) : suggestion(key, names));
}

std::string reference_page(const Table& root)
{
    std::string text = fmt::format("# The case file\n\n{}\n", root.meaning);
    text +=
        "\nMade from the program's own table of parameters by `corpuscle explain --markdown`; `corpuscle explain KEY` shows one of them.\n"
        "A number is SI; a text carries its unit (\"15 kg\"), as UDUNITS-2 knows it.\n";
    text += table_section("The case itself", root);
    for (const NamedParameter& named : all_parameters(root)) {
        if (named.parameter->table == nullptr) continue;
        const bool top = named.path.find('.') == std::string::npos;
        const char* form = !top ? "{}" : named.parameter->many ? "[[{}]]" : "[{}]";
        text += table_section(fmt::format(fmt::runtime(form), named.path), named.parameter->table());
    }
    return text;
}

}  // namespace corpuscle
