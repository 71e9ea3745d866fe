#include "simulation/run_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <vector>

#include "base/error.hpp"

namespace corpuscle {

namespace fs = std::filesystem;

namespace {

/// Whether a file in fields/ or restart/ was written by a run.
bool is_dump(const fs::path& path)
{
    const std::string name = path.filename().string();
    return name.ends_with(".hdf") || name.ends_with(".hdf.series") || name.ends_with(".part") || name == "view.py";
}

/// Removes a run's files from one of its subfolders, and the subfolder if nothing else is in it.
void remove_dumps(const fs::path& folder)
{
    if (!fs::is_directory(folder)) return;
    std::vector<fs::path> dumps;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.is_regular_file() && is_dump(entry.path())) dumps.push_back(entry.path());
    }
    for (const fs::path& dump : dumps) fs::remove(dump);
    if (fs::is_empty(folder)) fs::remove(folder);
}

/// The folder itself or the nearest one above it that exists.
fs::path existing_ancestor(fs::path path)
{
    path = fs::absolute(path).lexically_normal();
    if (!path.has_filename()) path = path.parent_path();
    while (!fs::exists(path) && path.has_relative_path()) path = path.parent_path();
    return path;
}

[[noreturn]] void refuse(const fs::path& path, const std::string& reason)
{
    throw InputError(fmt::format("cannot write results to '{}': {}", path.string(), reason), "choose another folder with --out");
}

}  // namespace

RunFolder::RunFolder(fs::path path) : path_(std::move(path)) {}

bool RunFolder::has_results() const
{
    if (fs::is_directory(fields()) && !fs::is_empty(fields())) return true;
    if (fs::is_directory(restart()) && !fs::is_empty(restart())) return true;
    for (const fs::path& file : {resolved_case(), log(), summary(), history(), report()}) {
        if (fs::exists(file)) return true;
    }
    return false;
}

void RunFolder::check(Existing existing) const
{
    if (path_.empty()) refuse(path_, "it has no name");
    const fs::path present = existing_ancestor(path_);
    if (!fs::is_directory(present)) refuse(path_, fmt::format("'{}' is a file", present.string()));
    if (::access(present.c_str(), W_OK | X_OK) != 0) refuse(path_, fmt::format("'{}': {}", present.string(), std::strerror(errno)));
    if (existing == Existing::refuse && has_results()) {
        throw InputError(fmt::format("'{}' holds the results of an earlier run", path_.string()),
                         "choose another folder with --out, or replace them with --force");
    }
}

void RunFolder::create(Existing existing) const
{
    check(existing);
    try {
        fs::create_directories(path_);
        remove_results();
        fs::create_directories(fields());
        fs::create_directories(restart());
    } catch (const fs::filesystem_error& problem) {
        refuse(path_, problem.code().message());
    }
}

void RunFolder::remove_results() const
{
    for (const fs::path& file : {resolved_case(), log(), summary(), history(), report()}) fs::remove(file);
    remove_dumps(fields());
    remove_dumps(restart());
}

FolderRequest RunFolder::take_request() const
{
    std::error_code ignored;
    if (fs::remove(path_ / "stop", ignored)) return FolderRequest::stop;
    if (fs::remove(path_ / "save", ignored)) return FolderRequest::save;
    return FolderRequest::none;
}

}  // namespace corpuscle
