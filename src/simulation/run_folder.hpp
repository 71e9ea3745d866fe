#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace corpuscle {

/// What to do with results that are in the way.
enum class Existing { refuse, replace };

/// A file dropped into the folder asks a running job for something.
enum class FolderRequest { none, save, stop };

/// The folder a run leaves its results in, and the name of each.
class RunFolder {
public:
    /// Names only; touches nothing.
    explicit RunFolder(std::filesystem::path path);

    /// Refuses (InputError) what create() would refuse, as far as it can be seen without writing: results in the way, a file of that
    /// name, no right to write. For use before the long work of building a model.
    void check(Existing existing) const;

    /// Makes the folder, or empties it of an older run's results with Existing::replace (other files stay). Throws InputError.
    void create(Existing existing) const;

    /// Whether the folder holds results of a run.
    [[nodiscard]] bool has_results() const;

    /// What a file named "save" or "stop" in the folder asks for; it is removed.
    [[nodiscard]] FolderRequest take_request() const;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path resolved_case() const { return path_ / "case.resolved.toml"; }
    [[nodiscard]] std::filesystem::path log() const { return path_ / "run.log"; }
    [[nodiscard]] std::filesystem::path summary() const { return path_ / "summary.json"; }
    [[nodiscard]] std::filesystem::path history() const { return path_ / "history.csv"; }
    [[nodiscard]] std::filesystem::path report() const { return path_ / "report.html"; }
    [[nodiscard]] std::filesystem::path fields() const { return path_ / "fields"; }
    [[nodiscard]] std::filesystem::path restart() const { return path_ / "restart"; }

private:
    void remove_results() const;

    std::filesystem::path path_;
};

}  // namespace corpuscle
