#include <fmt/format.h>

#include "app/commands/commands.hpp"
#include "app/terminal/table.hpp"
#include "base/error.hpp"
#include "gas/sample.hpp"
#include "input/presets.hpp"
#include "schema/nearest.hpp"
#include "structure/fields.hpp"

namespace corpuscle {

namespace {

void list_presets_of(PresetKind kind, const Options& options)
{
    TextTable table({"name", "what it is", "values", "status"});
    for (const PresetEntry& entry : list_presets(kind, preset_folders(std::filesystem::current_path(), options.installed_share())))
        table.row({entry.name, entry.title, entry.summary, entry.status});
    fmt::print("{}", table.text());
}

void add_fields(TextTable& table, const FieldSet& set)
{
    for (const Field& field : set.fields) table.row({field.name, field.unit, set.name, field.meaning});
}

void list_fields()
{
    Structure nothing;
    const Gas no_gas;
    const GasGrid no_grid;
    TextTable table({"field", "unit", "on", "meaning"});
    add_fields(table, particle_fields(no_gas));
    add_fields(table, fields(no_grid));
    add_fields(table, node_fields(nothing));
    add_fields(table, element_fields(nothing));
    fmt::print("{}", table.text());
}

}  // namespace

int list_command(const Options& options)
{
    const std::vector<std::string> kinds{"explosives", "materials", "gases", "fields"};
    if (options.subject == "explosives") {
        list_presets_of(PresetKind::explosives, options);
    } else if (options.subject == "materials") {
        list_presets_of(PresetKind::materials, options);
    } else if (options.subject == "gases") {
        list_presets_of(PresetKind::gases, options);
    } else if (options.subject == "fields") {
        list_fields();
    } else {
        throw InputError(fmt::format("there is no list of '{}'", options.subject), suggestion(options.subject, kinds));
    }
    return 0;
}

}  // namespace corpuscle
