#include "input/presets.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>

#include <fmt/format.h>

#include "input/case/toml_source.hpp"
#include "schema/nearest.hpp"

namespace corpuscle {

namespace {

using std::filesystem::path;

/// The files of a kind, by name; the first folder's where names meet.
std::map<std::string, path> preset_files(PresetKind kind, const std::vector<path>& folders)
{
    std::map<std::string, path> files;
    for (const path& folder : folders) {
        std::error_code error;
        for (const auto& entry : std::filesystem::directory_iterator(folder / folder_name(kind), error))
            if (entry.path().extension() == ".toml") files.emplace(entry.path().stem().string(), entry.path());
    }
    return files;
}

template <class Values>
Values read_preset(const path& file)
{
    const Value document = read_toml(file.string());
    Values values;
    Problems problems;
    read_table(&values, table_of<Values>(), document, problems);
    problems.raise();
    if (values.name.empty()) values.name = file.stem().string();
    return values;
}

/// "an explosive" of the kind, for messages.
std::string one_of_kind(PresetKind kind)
{
    switch (kind) {
        case PresetKind::explosives: return "explosive";
        case PresetKind::gases: return "gas";
        case PresetKind::materials: break;
    }
    return "material";
}

/// Looks presets of one kind up; the folder is read once.
template <class Values>
class Library {
public:
    Library(PresetKind kind, const std::vector<path>& folders, Problems& problems)
        : kind_(kind), files_(preset_files(kind, folders)), problems_(problems)
    {
    }

    void resolve(Preset<Values>& preset)
    {
        if (preset.values) return;
        const auto found = files_.find(preset.name);
        if (found == files_.end()) return report(preset);
        try {
            preset.values = read_preset<Values>(found->second);
        } catch (const InputError& error) {
            problems_.add(error);
        }
    }

private:
    void report(const Preset<Values>& preset)
    {
        std::vector<std::string> names;
        for (const auto& [name, file] : files_) names.push_back(name);
        const bool near = !nearest_names(preset.name, names).empty();
        std::string remedy = near ? suggestion(preset.name, names) + " " : "";
        remedy += names.empty() ? "no folder of presets was found: set CORPUSCLE_SHARE"
                                : fmt::format("known {}: {}", folder_name(kind_), listed(names, 60));
        problems_.add(fmt::format("unknown {} '{}'", one_of_kind(kind_), preset.name), remedy, preset.place);
    }

    PresetKind kind_;
    std::map<std::string, path> files_;
    Problems& problems_;
};

/// A table's first values, as a case would write them, for people to choose by.
std::string summary_of(const Value& document)
{
    std::string text;
    for (const char* key : {"density", "energy_density", "detonation_velocity", "young_modulus", "pressure"}) {
        const Value* value = document.find(key);
        if (value == nullptr) continue;
        text += (text.empty() ? "" : ", ") + (value->kind == ValueKind::text ? value->text : inline_toml(*value));
    }
    for (const char* key : {"law", "strength"}) {
        const Value* value = document.find(key);
        if (value != nullptr && !value->keys.empty()) text = value->keys[0].name + (text.empty() ? "" : ", ") + text;
    }
    return text;
}

std::string text_of(const Value& document, const char* key)
{
    const Value* value = document.find(key);
    return value != nullptr && value->kind == ValueKind::text ? value->text : "";
}

}  // namespace

std::string folder_name(PresetKind kind)
{
    switch (kind) {
        case PresetKind::explosives: return "explosives";
        case PresetKind::gases: return "gases";
        case PresetKind::materials: break;
    }
    return "materials";
}

std::vector<path> preset_folders(const path& case_folder, const std::vector<path>& installed)
{
    std::vector<path> folders;
    if (const char* own = std::getenv("CORPUSCLE_SHARE"); own != nullptr && *own != '\0') folders.emplace_back(own);
    if (!case_folder.empty()) folders.push_back(case_folder / "share");
    if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') folders.push_back(path(home) / ".config" / "corpuscle");
    folders.insert(folders.end(), installed.begin(), installed.end());
    return folders;
}

std::vector<PresetEntry> list_presets(PresetKind kind, const std::vector<path>& folders)
{
    std::vector<PresetEntry> entries;
    for (const auto& [name, file] : preset_files(kind, folders)) {
        const Value document = read_toml(file.string());
        entries.push_back({name, text_of(document, "title"), summary_of(document), text_of(document, "status"), file});
    }
    return entries;
}

void resolve_presets(CaseDescription& description, const std::vector<path>& folders)
{
    Problems problems;
    Library<ExplosiveValues> explosives(PresetKind::explosives, folders, problems);
    Library<GasValues> gases(PresetKind::gases, folders, problems);
    Library<MaterialValues> materials(PresetKind::materials, folders, problems);
    for (ChargeInput& charge : description.charges) explosives.resolve(charge.explosive);
    if (description.gas && description.gas->fill) gases.resolve(*description.gas->fill);
    if (description.euler && description.euler->fill) gases.resolve(*description.euler->fill);
    for (FillInput& fill : description.fills) gases.resolve(fill.gas);
    for (PartInput& part : description.parts)
        if (part.material) materials.resolve(*part.material);
    problems.raise();
}

}  // namespace corpuscle
