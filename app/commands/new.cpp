#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "app/commands/commands.hpp"
#include "base/error.hpp"
#include "schema/nearest.hpp"

namespace corpuscle {

namespace {

/// The first folder of presets that has starters.
std::filesystem::path starters_folder(const Options& options)
{
    for (const std::filesystem::path& share : options.installed_share())
        if (std::filesystem::is_directory(share / "starters")) return share / "starters";
    throw InputError("the folder of starters was not found", "install the program with its share/ folder");
}

}  // namespace

int new_command(const Options& options)
{
    const std::filesystem::path folder = starters_folder(options);
    const std::filesystem::path starter = folder / (options.subject + ".toml");
    if (!std::filesystem::exists(starter)) {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().stem().string());
        throw InputError(fmt::format("there is no starter '{}'", options.subject), suggestion(options.subject, names));
    }
    const std::filesystem::path target = options.out.empty() ? options.subject + ".toml" : options.out;
    if (std::filesystem::exists(target) && !options.force)
        throw InputError(fmt::format("'{}' exists", target.string()), "give another name with --out, or --force to replace it");
    std::error_code error;
    if (!std::filesystem::copy_file(starter, target, std::filesystem::copy_options::overwrite_existing, error))
        throw InputError(fmt::format("'{}' cannot be written: {}", target.string(), error.message()),
                         "check the folder and its permissions");
    fmt::print("wrote {}; now: corpuscle run {}\n", target.string(), target.string());
    return 0;
}

}  // namespace corpuscle
