#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "input/case/case_description.hpp"

namespace corpuscle {

/// Kinds of presets, each a folder of TOML files, one a preset, named after it.
enum class PresetKind { explosives, gases, materials };

[[nodiscard]] std::string folder_name(PresetKind kind);

/// A preset as a list shows it.
struct PresetEntry {
    std::string name;
    std::string title;
    std::string summary;  ///< its main values
    std::string status;
    std::filesystem::path file;
};

/// Folders to look in, first come first served: $CORPUSCLE_SHARE, `share` beside the case, the user's own
/// (~/.config/corpuscle), then the installed ones.
[[nodiscard]] std::vector<std::filesystem::path> preset_folders(const std::filesystem::path& case_folder,
                                                                const std::vector<std::filesystem::path>& installed);

/// Every preset of a kind, by name; where two folders have the same name, the first folder's. Errors: InputError for a broken file.
[[nodiscard]] std::vector<PresetEntry> list_presets(PresetKind kind, const std::vector<std::filesystem::path>& folders);

/// Gives every preset that the case names its values. Errors: InputError or InputProblems: unknown name with the nearest and all names.
void resolve_presets(CaseDescription& description, const std::vector<std::filesystem::path>& folders);

}  // namespace corpuscle
